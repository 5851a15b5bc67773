#include "src/output/frame/field_units.hpp"

#include <algorithm>
#include <array>
#include <string_view>

#include "src/deck/units.hpp"

namespace percuss {
namespace {

struct FieldDimension {
  std::string_view field;
  Dimension dimension;
};

constexpr std::array field_dimensions{
    FieldDimension{"time", dimensions::time},
    FieldDimension{"Points", dimensions::length},
    FieldDimension{"displacement", dimensions::length},
    FieldDimension{"thickness", dimensions::length},
    FieldDimension{"velocity", dimensions::velocity},
    FieldDimension{"mass", dimensions::mass},
    FieldDimension{"contact_force", dimensions::force},
    FieldDimension{"contact_pressure", dimensions::stress},
    FieldDimension{"axial_force", dimensions::force},
    FieldDimension{"section_force", dimensions::force},
    FieldDimension{"section_moment", dimensions::energy},
    FieldDimension{"stress", dimensions::stress},
    FieldDimension{"pressure", dimensions::stress},
    FieldDimension{"von_mises", dimensions::stress},
    FieldDimension{"internal_energy", dimensions::stress},  // per volume
};

}  // namespace

std::string name_field_unit(const std::string& field, const std::string& units) {
  const auto system = find_units(units);
  if (!system) return "";
  if (field == "temperature") return system->temperature;
  const std::string_view name = field.starts_with("stress_") ? "stress" : std::string_view(field);
  const auto* found = std::find_if(field_dimensions.begin(), field_dimensions.end(),
                                   [name](const FieldDimension& f) { return f.field == name; });
  return found == field_dimensions.end() ? "" : system->name_of(found->dimension);
}

}  // namespace percuss
