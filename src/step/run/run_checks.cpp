#include "src/step/run/run_checks.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "comm/agreement.hpp"
#include "comm/all_reduce.hpp"
#include "kernels/core/host_copy.hpp"
#include "src/deck/laws/material_properties.hpp"
#include "src/deck/laws/user_code.hpp"
#include "src/error.hpp"
#include "src/mesh/hex_geometry.hpp"
#include "src/step/model/whole_mesh.hpp"
#include "src/step/results/fields/element_fields.hpp"

namespace percuss {
namespace {

ElementCorners find_corners(const CheckedRun& run, int element) {
  const auto x = to_host(run.state.x);
  return gather_corners(run.chunked.mesh.elements, static_cast<std::size_t>(element), [&](int node) {
    const auto n = static_cast<std::size_t>(node);
    return Vec3{x(n, 0), x(n, 1), x(n, 2)};
  });
}

/// "element 5 of part 'bar' at (2.75, 0.5, 0.5)", of an element of this rank.
std::string name_with_place(const CheckedRun& run, int element) {
  const Vec3 center = find_center(find_corners(run, element));
  return fmt::format("{} at ({:.6g}, {:.6g}, {:.6g})", name_element(run.chunked.mesh, element), center[0], center[1],
                     center[2]);
}

/// describe(element) in the words of the rank that has an element of the whole mesh. Collective.
template <class Describe>
std::string describe_there(const CheckedRun& run, std::int64_t number, const Describe& describe) {
  const int element = find_local_element(run.chunked, number);
  const std::string text = element < 0 ? "" : describe(element);
  return broadcast_text(run.model.ranks, text, run.chunked.numbering.find_element_owner(number));
}

std::string describe_element(const CheckedRun& run, std::int64_t number) {
  return describe_there(run, number, [&](int element) { return name_with_place(run, element); });
}

/// Where bodies meet faster than the step resolves; else empty.
std::string describe_fast_approach(const CheckedRun& run) {
  constexpr double resolved = 0.2;  // share of the step that approach allows: a tenth of a face
  const Approach* const approach = run.stepper.find_limiting_approach(run.state);
  if (approach == nullptr) return "";
  return fmt::format("; {} limits the step: try time.max_step: {:.1g}", describe_approach(*approach, run.chunked.mesh),
                     resolved * approach->travel_step);
}

/// "spring 'strap_3'" or the element, with its place: what limits the step.
std::string describe_controller(const CheckedRun& run) {
  const StepBound& bound = run.state.bound;
  const std::string spring = name_limiting_spring(run.model, bound.spring);
  return spring.empty() ? describe_element(run, bound.element) : spring;
}

std::string describe_failed_element(const CheckedRun& run) {
  return describe_there(run, run.state.bound.failed_element, [&](int element) {
    const ElementCorners corners = find_corners(run, element);
    const Topology& topology = run.chunked.mesh.topology_of(static_cast<std::size_t>(element));
    const bool shell = topology.is_surface();
    const double volume = topology.is_line() ? find_distance(corners[0], corners[1])
                          : shell            ? find_shell_area_size(corners)
                                             : find_solid_volume(topology, corners);
    const std::string name = name_with_place(run, element);
    if (std::isnan(volume)) return name + " has a corner whose position is not finite";
    if (shell) return fmt::format("{} has no area or no stable step any more (its area is {:.3g})", name, volume);
    if (topology.is_line())
      return fmt::format("{} has no length or no stable step any more (its length is {:.3g})", name, volume);
    if (volume <= 0) return fmt::format("{} has inverted (its volume is {:.3g})", name, volume);
    return fmt::format("{} has no stable step any more (its volume is {:.3g})", name, volume);
  });
}

/// " has a state variable 3 that is nan", of an element of this rank with a law of a user; empty: all are finite.
std::string describe_wrong_state(const CheckedRun& run, int element) {
  const std::vector<int> one{element};
  const ElementBlock& block = run.chunked.mesh.block_of(static_cast<std::size_t>(element));
  const int count = count_state_variables(run.deck.materials[static_cast<std::size_t>(block.material)]);
  for (int i = 0; i < count; ++i) {
    const double value = find_state_variables(run.model, run.state, i, one).front();
    if (!std::isfinite(value)) return fmt::format(" has a state variable {} that is {}", i + 1, value);
  }
  return "";
}

/// The first element of a chunk whose stress is not finite, or its first one.
std::string describe_broken_chunk(const CheckedRun& run) {
  const auto chunk = static_cast<std::size_t>(run.state.bound.broken_chunk);
  const std::int64_t number = run.chunked.numbering.first_element[chunk];
  return describe_there(run, number, [&](int first) {
    const auto count = static_cast<int>(run.chunked.numbering.first_element[chunk + 1] - number);
    for (int e = first; e < first + count; ++e) {
      const std::vector<int> one{e};
      for (const double stress : find_stresses(run.model, run.state, one)) {
        if (std::isfinite(stress)) continue;
        const std::string state = describe_wrong_state(run, e);
        return name_with_place(run, e) + (state.empty() ? " has a stress that is not finite" : state);
      }
    }
    return "the work of the elements from " + name_with_place(run, first) + " on is not finite";
  });
}

/// Element that an error of the elements names: of the whole mesh.
std::int64_t find_wrong_element(const CheckedRun& run) {
  const StepBound& bound = run.state.bound;
  if (bound.failed_element >= 0) return bound.failed_element;
  return run.chunked.numbering.first_element[static_cast<std::size_t>(bound.broken_chunk)];
}

/// "; its law is that of the library libs/rubber.so", with what is known of it: of an element of this rank.
std::string describe_user_law(const CheckedRun& run, int element) {
  const ElementBlock& block = run.chunked.mesh.block_of(static_cast<std::size_t>(element));
  const MaterialDeck& material = run.deck.materials[static_cast<std::size_t>(block.material)];
  const std::string library = find_code_file(material.law);
  if (library.empty()) return "";
  return fmt::format("; its law is that of the library {}{}", library,
                     has_written_outside(library) ? ", which has written outside its arrays" : "");
}

/// Empty if no contact node lies deep. Collective.
std::string describe_deepest_node(const CheckedRun& run) {
  const std::string node = name_deepest_node(run);
  return node.empty() ? node : "; the deepest contact node is " + node;
}

std::string describe_step(const State& state) {
  return fmt::format("in step {} at t = {:.6g}", state.step, state.time);
}

void check_energy(const CheckedRun& run, const EnergySummary& e) {
  const double bound = run.deck.audit.max_energy_error;
  if (std::abs(e.error) <= bound) return;  // false for NaN
  throw RunError(
      fmt::format("the energy balance is off by {:.3g} of the largest energy, more than audit.max_energy_error = {:g}, "
                  "{} (kinetic {:.6g}, internal {:.6g}, hourglass {:.6g}, contact {:.6g}; {} has the smallest step{}); "
                  "find the growing energy in history.csv, or try a smaller time.step_scale (now {})",
                  e.error, bound, describe_step(run.state), e.kinetic, e.internal(), e.hourglass(), e.contact,
                  describe_controller(run), describe_deepest_node(run), run.deck.time.step_scale));
}

void check_momentum(const CheckedRun& run, const char* which, double error) {
  const double bound = run.deck.audit.max_momentum_error;
  if (error <= bound) return;  // false for NaN
  throw RunError(fmt::format(
      "the {} momentum is off by {:.3g} of its largest magnitude, more than audit.max_momentum_error = {:g}, {} ({} "
      "has the smallest step{}); find its onset in history.csv; if the scene hardly moves, raise the limit",
      which, error, bound, describe_step(run.state), describe_controller(run), describe_deepest_node(run)));
}

}  // namespace

void check_elements(const CheckedRun& run) {
  const StepBound& bound = run.state.bound;
  if (bound.failed_element < 0 && bound.broken_chunk < 0) return;
  const std::string what = bound.failed_element >= 0 ? describe_failed_element(run) : describe_broken_chunk(run);
  const std::string law =
      describe_there(run, find_wrong_element(run), [&](int element) { return describe_user_law(run, element); });
  throw RunError(fmt::format(
      "{}{}, {} (the mesh is crushed beyond what it can follow, or the run is unstable{}); try a finer mesh there, a "
      "stronger material, or a smaller time.step_scale (now {}){}",
      what, law, describe_step(run.state), describe_deepest_node(run), run.deck.time.step_scale,
      describe_fast_approach(run)));
}

void check_step(const CheckedRun& run, double first_dt) {
  const double least = run.deck.time.collapse_ratio * first_dt;
  if (run.state.next_dt >= least || run.deck.time.step_scale * run.state.bound.step >= least) return;
  const bool is_spring = run.state.bound.spring != -1;
  throw RunError(
      fmt::format("the time step has collapsed to {:.3g} (it began at {:.3g}) {}; {} controls it; try {}, or lower "
                  "time.collapse_ratio (now {:g}) to continue",
                  run.state.next_dt, first_dt, describe_step(run.state), describe_controller(run),
                  is_spring ? "a softer spring or damper, or more mass at its ends" : "a coarser mesh there",
                  run.deck.time.collapse_ratio));
}

void check_balance(const CheckedRun& run, const AuditResult& audit) {
  check_energy(run, audit.energy);
  check_momentum(run, "linear", audit.momentum.linear_error);
  check_momentum(run, "angular", audit.momentum.angular_error);
}

std::string name_deepest_node(const CheckedRun& run) {
  const ContactReport& contact = run.stepper.contact_report();
  if (contact.deepest_node < 0) return "";
  const int node = find_local_node(run.chunked, contact.deepest_node);
  std::string text;
  if (node >= 0) {
    const auto x = to_host(run.state.x);
    const auto n = static_cast<std::size_t>(node);
    text = fmt::format("node {} at ({:.6g}, {:.6g}, {:.6g}), {:.3g} of a face edge", run.chunked.mesh.node_ids[n],
                       x(n, 0), x(n, 1), x(n, 2), contact.deepest);
  }
  return broadcast_text(run.model.ranks, text, run.chunked.numbering.find_node_owner(contact.deepest_node));
}

GainPlace find_gain_place(const CheckedRun& run) {
  GainPlace where{run.state.step, -1, {}, run.state.time};
  const std::int64_t node = run.stepper.contact_report().giving_node;
  if (node < 0) return where;
  constexpr double none = std::numeric_limits<double>::lowest();
  double id_and_place[4] = {none, none, none, none};  // of the rank that has it alone
  const bool is_here = run.chunked.numbering.find_node_owner(node) == run.model.ranks.rank();
  if (is_here) {
    const auto x = to_host(run.state.x);
    const auto n = static_cast<std::size_t>(find_local_node(run.chunked, node));
    id_and_place[0] = static_cast<double>(run.chunked.mesh.node_ids[n]);
    for (std::size_t k = 0; k < 3; ++k) id_and_place[k + 1] = x(n, k);
  }
  all_reduce(run.model.ranks, Reduce::largest, id_and_place);
  where.node = static_cast<std::int64_t>(id_and_place[0]);
  std::copy_n(id_and_place + 1, 3, where.place.begin());
  return where;
}

void refuse_gain(const CheckedRun& run, const std::string& gain) {
  throw RunError(fmt::format(
      "contact has added {}, more than audit.max_contact_gain = {:g}, {} (contact may only dissipate or store energy): "
      "check jumps of the columns contact and friction in history.csv, sliver elements and overlapping parts, or raise "
      "the limit",
      gain, *run.deck.audit.max_contact_gain, describe_step(run.state)));
}

bool has_finite_positions(const Model& model, const State& state) {
  const auto x = to_host(state.x);
  int finite = std::all_of(x.data(), x.data() + x.size(), [](double value) { return std::isfinite(value); }) ? 1 : 0;
  all_reduce(model.ranks, Reduce::least, finite);
  return finite != 0;
}

}  // namespace percuss
