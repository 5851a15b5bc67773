#include "src/deck/laws/user_database.hpp"

#include <algorithm>

#include "kernels/material/user/user_call.hpp"
#include "src/deck/laws/material_properties.hpp"
#include "src/deck/laws/user_code.hpp"

namespace percuss {
namespace {

/// As Fortran compilers see `subroutine vexternaldb`.
extern "C" {
using DatabaseFunction = void (*)(const int* moment, int* integers, const int* integer_count, double* reals,
                                  const int* real_count);
}

std::vector<double> find_step_starts(const LawDeck& law) {
  const auto found = law.lists.find("step_starts");
  return found == law.lists.end() ? std::vector<double>() : found->second;
}

constexpr int status = 4;  // place among the integers: not 0 where the code requests the end

}  // namespace

UserDatabases::UserDatabases(const Deck& deck) {
  for (const MaterialDeck& material : deck.materials) {
    const std::string file = find_code_file(material.law);
    const bool is_known = std::any_of(all_.begin(), all_.end(), [&](const Entry& entry) { return entry.file == file; });
    if (material.law.model == "library" || file.empty() || is_known) continue;
    if (void* const place = find_user_entry(file, "vexternaldb"); place != nullptr)
      all_.push_back({file, place, find_step_starts(material.law)});
  }
}

std::string UserDatabases::call(RunMoment moment, const RunState& state) const {
  const int kind = static_cast<int>(moment), integer_count = 6, real_count = 3;
  std::string asked;
  for (const Entry& entry : all_) {
    const bool is_made = moment >= RunMoment::end_of_increment;  // else the step that begins now
    const auto next = is_made ? std::lower_bound(entry.step_starts.begin(), entry.step_starts.end(), state.time)
                              : std::upper_bound(entry.step_starts.begin(), entry.step_starts.end(), state.time);
    const auto steps = static_cast<int>(next - entry.step_starts.begin());
    int integers[6] = {static_cast<int>(state.nodes),
                       static_cast<int>(state.elements),
                       1 + steps,
                       static_cast<int>(state.increment),
                       0,
                       0};
    double reals[3] = {state.time, state.time - (steps > 0 ? *(next - 1) : 0), state.dt};
    const auto call = reinterpret_cast<DatabaseFunction>(entry.place);
    call_library(entry.file.c_str(), [&] { call(&kind, integers, &integer_count, reals, &real_count); });
    if (integers[status] != 0 && asked.empty()) asked = entry.file;
  }
  return asked;
}

}  // namespace percuss
