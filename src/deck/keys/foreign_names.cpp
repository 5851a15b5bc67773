#include "src/deck/keys/foreign_names.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>

#include "src/deck/text/nearest_name.hpp"

namespace percuss {
namespace {

/// `key` is what `foreign` is called here: a key of the same map, or a path from the top of the deck.
struct ForeignKey {
  const char *foreign, *key;
  const char* more = "";  // behind the name
};

constexpr ForeignKey foreign_keys[] = {
    // time
    {"endtim", "end"},
    {"t_end", "end"},
    {"tend", "end"},
    {"duration", "end"},
    {"tssfac", "step_scale"},
    {"dt2ms", "mass_scaling"},
    // materials
    {"ro", "density"},
    {"rho", "density"},
    {"e", "youngs_modulus"},
    {"nu", "poissons_ratio"},
    {"pr", "poissons_ratio"},
    {"sigy", "yield_stress"},
    {"sigma_y", "yield_stress"},
    {"etan", "hardening_modulus", " From a tangent modulus Et it is E Et / (E - Et)"},
    {"library", "vumat"},
    {"library", "vuhard"},
    {"library", "law"},
    // parts
    {"mid", "material"},
    {"mat", "material"},
    // contact and walls
    {"mu", "friction"},
    {"fs", "friction"},
    {"fd", "friction"},
    {"pairs", "surfaces", " A list of pairs: surfaces: [[a, b]]"},
    // output
    {"d3plot", "fields"},
    {"d3part", "field_outputs"},
    {"parts", "elements", " Parts and element sets: elements: [a, b]"},
    {"variables", "write"},
    {"d3thdt", "history"},
    {"glstat", "history"},
    {"matsum", "history"},
    {"d3dump", "checkpoint"},
    {"d3plot", "output.fields"},
    {"d3part", "output.field_outputs"},
    {"glstat", "output.history"},
    {"rcforc", "output.history.forces"},
    // the top of the deck
    {"gravity", "loads.gravity"},
    {"spc", "conditions"},
    {"boundary", "conditions"},
    {"boundaries", "conditions"},
    {"rigidwall", "walls"},
    {"rigidwalls", "walls"},
    {"rigid_walls", "walls"},
};

struct ForeignModel {
  const char *foreign, *instead;
};

constexpr ForeignModel foreign_models[] = {
    {"rigid", "a part is rigid, whatever its material: set parts.NAME.rigid: true"},
    {"plastic_kinematic", "try j2_plasticity or combined_hardening"},
    {"piecewise_linear_plasticity", "try tabulated_plasticity"},
};

std::string in_lower_case(std::string text) {
  for (char& c : text) c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  return text;
}

}  // namespace

std::string find_foreign_key(const std::string& key, const std::vector<std::string>& known) {
  constexpr std::size_t long_enough = 6;  // of a name, to be meant by one that differs by a letter
  const auto is_known = [&](const ForeignKey& row) {
    return std::string_view(row.key).find('.') != std::string_view::npos ||
           std::find(known.begin(), known.end(), row.key) != known.end();
  };
  std::string wanted = in_lower_case(key);
  std::vector<std::string> names;
  for (const ForeignKey& row : foreign_keys)
    if (is_known(row) && (row.foreign == wanted || std::string_view(row.foreign).size() >= long_enough))
      names.emplace_back(row.foreign);
  if (std::find(names.begin(), names.end(), wanted) == names.end()) wanted = nearest_name(wanted, names);
  for (const ForeignKey& row : foreign_keys)
    if (wanted == row.foreign && is_known(row)) return fmt::format(" (did you mean '{}'?{})", row.key, row.more);
  return {};
}

std::string find_foreign_model(const std::string& model) {
  const std::string wanted = in_lower_case(model);
  const auto* row = std::find_if(std::begin(foreign_models), std::end(foreign_models),
                                 [&](const ForeignModel& one) { return wanted == one.foreign; });
  return row == std::end(foreign_models) ? "" : row->instead;
}

}  // namespace percuss
