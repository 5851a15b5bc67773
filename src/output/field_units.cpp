#include "src/output/field_units.hpp"

#include <optional>
#include <string_view>

#include "src/deck/units.hpp"

namespace percuss {
namespace {

bool is_stress(std::string_view field) {
  return field == "pressure" || field == "von_mises" || field == "internal_energy" || field == "stress" ||
         field.starts_with("stress_");
}

std::optional<Dimension> find_dimension(std::string_view field) {
  if (field == "points" || field == "displacement" || field == "thickness") return dimensions::length;
  if (field == "time") return dimensions::time;
  if (field == "mass") return dimensions::mass;
  if (field == "velocity") return dimensions::velocity;
  if (field == "contact_force") return dimensions::force;
  if (is_stress(field)) return dimensions::stress;
  return std::nullopt;
}

}  // namespace

std::string name_field_unit(const std::string& field, const std::string& units) {
  const std::optional<Units> system = find_units(units);
  const std::optional<Dimension> dimension = find_dimension(field);
  if (system && field == "temperature") return system->temperature;
  return system && dimension ? system->name_of(*dimension) : "";
}

}  // namespace percuss
