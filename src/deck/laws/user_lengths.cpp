#include "src/deck/laws/user_lengths.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>

#include "kernels/material/material_axes.hpp"
#include "kernels/material/user/user_call.hpp"
#include "src/deck/laws/make_law.hpp"
#include "src/deck/laws/material_properties.hpp"
#include "src/deck/laws/user_code.hpp"
#include "src/error.hpp"

namespace percuss {
namespace {

constexpr const char* subroutine = "vucharlength";

/// As Fortran compilers see `subroutine vucharlength`. Arrays are [component][corner][element] of one element; axes are
/// [axis][component].
extern "C" {
using LengthFunction = void (*)(const int* elements, const int* fields, const int* constants, const int* components,
                                const int* dimensions, const int* corners, const int* states, const int* section_point,
                                const int* layer, const int* point, const int* kind, const int* element,
                                const double* total_time, const double* step_time, const double* dt, const char* name,
                                const double* place, const double* corner_places, const double* axes,
                                const double* turn, const double* constant, const double* field, const double* state,
                                double* lengths, std::size_t name_length);
}

double find_number(const LawDeck& law, const char* key) {
  const auto found = law.numbers.find(key);
  return found == law.numbers.end() ? 0 : found->second;
}

/// A subroutine of the library that a key requests.
void require_entry(const LawDeck& law, const char* key, const char* entry) {
  const std::string file = find_code_file(law);
  if (find_number(law, key) == 0 || find_user_entry(file, entry) != nullptr) return;
  refuse_library(file, fmt::format("its material has {}, and it has no entry {}_", key, entry),
                 "add that subroutine, or remove the key");
}

/// State variables at the start.
std::vector<double> list_states(const LawDeck& law) {
  std::vector<double> states(static_cast<std::size_t>(find_number(law, "state_variables")));
  if (const auto start = law.lists.find("start_states"); start != law.lists.end())
    std::copy_n(start->second.begin(), std::min(start->second.size(), states.size()), states.begin());
  const auto deletes = static_cast<std::size_t>(find_number(law, "delete_variable"));
  if (deletes > 0 && deletes <= states.size()) states[deletes - 1] = 1;
  return states;
}

/// Axes of the material in space, one behind the other.
std::array<double, 9> list_axes(const LawDeck& law) {
  double axis[2][3] = {{1, 0, 0}, {0, 0, 0}};
  for (std::size_t k = 0; k < 2; ++k) {
    const auto found = law.vectors.find(k == 0 ? "first_axis" : "second_axis");
    if (found != law.vectors.end()) std::copy_n(found->second.begin(), 3, axis[k]);
  }
  const Matrix3<double> rows = find_material_axes(axis[0], axis[1]);
  std::array<double, 9> all{};
  for (std::size_t i = 0; i < 3; ++i) {
    all[3 * i] = rows.row[i].x;
    all[3 * i + 1] = rows.row[i].y;
    all[3 * i + 2] = rows.row[i].z;
  }
  return all;
}

/// Places of corners by component, and their mean.
struct CornerPlaces {
  std::vector<double> corner;
  double middle[3] = {};
};
CornerPlaces list_places(const UserShape& shape) {
  CornerPlaces places;
  for (std::size_t d = 0; d < 3; ++d) {
    for (const Vec3& x : shape.corners) {
      places.corner.push_back(x[d]);
      places.middle[d] += x[d] / static_cast<double>(shape.corners.size());
    }
  }
  return places;
}

}  // namespace

int count_user_lengths(const LawDeck& law) { return static_cast<int>(find_number(law, "characteristic_lengths")); }

void require_user_entries(const LawDeck& law) {
  require_entry(law, "characteristic_lengths", subroutine);
  require_entry(law, "field_variables", "vusdfld");
}

std::vector<double> find_user_lengths(const LawDeck& law, const UserShape& shape) {
  const std::string file = find_code_file(law);
  const auto entry = reinterpret_cast<LengthFunction>(find_user_entry(file, subroutine));
  const int one = 1, none = 0, components = count_user_lengths(law), dimensions = 3,
            corners = static_cast<int>(shape.corners.size()), kind[3] = {shape.kind, 3, 0},
            element = static_cast<int>(shape.id);
  const double zero = 0, turn[9] = {1, 0, 0, 0, 1, 0, 0, 0, 1};
  std::vector<double> lengths(static_cast<std::size_t>(components)), states = list_states(law);
  const int state_count = static_cast<int>(states.size());
  states.push_back(0);  // code without states gets an array all the same
  std::vector<double> constants;
  if (const auto own = law.lists.find("length_constants"); own != law.lists.end()) constants = own->second;
  const int constant_count = static_cast<int>(constants.size());
  constants.push_back(0);
  lengths[0] = shape.length;
  const auto text = law.texts.find("vumat_name");
  const MaterialText name = make_word(text == law.texts.end() ? "" : text->second);
  const CornerPlaces places = list_places(shape);
  const std::array<double, 9> axes = list_axes(law);
  call_library(file.c_str(), [&] {
    entry(&one, &none, &constant_count, &components, &dimensions, &corners, &state_count, &one, &one, &one, kind,
          &element, &zero, &zero, &zero, name.text, places.middle, places.corner.data(), axes.data(), turn,
          constants.data(), &zero, states.data(), lengths.data(), MaterialText::most);
  });
  for (const double length : lengths) {
    if (std::isfinite(length)) continue;
    throw InputError(
        fmt::format("{}: error: its VUCHARLENGTH tells a length of {} (element {}): correct the code or the element",
                    file, length, shape.id));
  }
  return lengths;
}

}  // namespace percuss
