#include "src/step/forces/force_sources.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "comm/all_reduce.hpp"
#include "comm/exact_reduction.hpp"
#include "kernels/core/host_copy.hpp"
#include "src/error.hpp"
#include "src/mesh/surface_nodes.hpp"
#include "src/step/model/impulses.hpp"
#include "src/step/model/whole_mesh.hpp"

namespace percuss {
namespace {

/// The listed entries whose node is marked.
std::vector<int> list_entries(const Array<int>& owned, const HeldDirections& held, const std::vector<char>& marked) {
  std::vector<int> entries;
  if (owned.extent(0) == 0) return entries;
  const auto listed = to_host(owned);
  const auto node = to_host(held.node);
  for (std::size_t i = 0; i < listed.extent(0); ++i) {
    const int entry = listed(i);
    if (marked[static_cast<std::size_t>(node(static_cast<std::size_t>(entry)))] != 0) entries.push_back(entry);
  }
  return entries;
}

void require_some(const Communicator& ranks, std::size_t own, const std::string& otherwise) {
  int some = own > 0 ? 1 : 0;
  all_reduce(ranks, Reduce::largest, some);
  if (some == 0) throw InputError(otherwise);
}

/// Rigid bodies that something may hold, and of which all nodes are marked. Collective.
std::vector<std::size_t> list_bodies(const ChunkedMesh& chunked, const Model& model, const std::vector<char>& marked) {
  const std::vector<RigidBody>& bodies = model.rigid.bodies;
  if (bodies.empty()) return {};
  std::vector<std::int64_t> counts(bodies.size(), 0);
  const auto body_of_node = to_host(model.rigid.body_of_node);
  for (std::size_t n = 0; n < marked.size(); ++n)
    if (marked[n] != 0 && body_of_node(n) >= 0 && owns_node(chunked, static_cast<int>(n)))
      ++counts[static_cast<std::size_t>(body_of_node(n))];
  all_reduce(model.ranks, Reduce::sum, counts);
  std::vector<std::size_t> found;
  for (std::size_t b = 0; b < bodies.size(); ++b) {
    const bool may_be_held =
        std::any_of(bodies[b].motion.begin(), bodies[b].motion.end(), [](int m) { return m != RigidBody::free; });
    if (may_be_held && counts[b] == bodies[b].nodes) found.push_back(b);
  }
  return found;
}

/// Mean place of the selected nodes at time 0, of all ranks.
Vec3 find_mean_place(const Deck& deck, const Selector& where, const ChunkedMesh& chunked, const Model& model) {
  std::array<ExactSum, 4> sums{};
  const auto start = to_host(model.start);
  for (const int node : select_nodes(chunked.mesh, deck, where)) {
    if (!owns_node(chunked, node)) continue;
    for (std::size_t k = 0; k < 3; ++k) sums[k].add(start(static_cast<std::size_t>(node), k));
    sums[3].add(1);
  }
  sum_over_ranks(model.ranks, sums);
  const double count = sums[3].round();
  return {sums[0].round() / count, sums[1].round() / count, sums[2].round() / count};
}

}  // namespace

SupportForce::SupportForce(const Deck& deck, const ForceDeck& force, const ChunkedMesh& chunked, const Model& model)
    : about_(force.about.value_or(Vec3{})) {
  marked_.assign(chunked.mesh.nodes.size(), 0);
  for (const int node : select_nodes(chunked.mesh, deck, force.where)) marked_[static_cast<std::size_t>(node)] = 1;
  list({model.held, model.held_spins, model.owned_held, model.owned_held_spins});
  bodies_ = list_bodies(chunked, model, marked_);
  require_some(model.ranks, held_.extent(0) + held_spins_.extent(0) + bodies_.size(),
               fmt::format("{}: error: force '{}' is of a support where no condition holds a node (conditions say "
                           "what is held)",
                           deck.where(force.place), force.name));
  if (model.ranks.rank() != 0) bodies_.clear();  // all ranks have the same reactions of bodies
}

void SupportForce::list(const Held& held) {
  held_ = to_view("percuss::support_entries", list_entries(held.owned, held.moves, marked_));
  held_spins_ = to_view("percuss::support_spin_entries", list_entries(held.owned_spins, held.spins, marked_));
}

void SupportForce::renew(const State& state) {
  list({state.held, state.held_spins, state.owned_held, state.owned_held_spins});
}

void SupportForce::add_bodies(const State& state, const std::vector<Wrench>& reactions, ImpulseSums& sums) const {
  for (const std::size_t b : bodies_) {
    const Wrench& reaction = reactions[b];
    const Vector3<double> r = state.bodies[b].center - to_vector(about_);
    const double arm[3] = {r.x, r.y, r.z}, j[3] = {reaction.impulse.x, reaction.impulse.y, reaction.impulse.z};
    add_impulse(arm, j, 0, [&](int k, double value) { sums[static_cast<std::size_t>(k)].add(value); });
    for (int k = 0; k < 3; ++k) sums[3 + static_cast<std::size_t>(k)].add(get(reaction.moment, k));
  }
}

ImpulseSums SupportForce::find_impulse(const State& state, double dt_mean, const std::vector<Wrench>& reactions) {
  ImpulseSums sums{};
  if (held_.extent(0) > 0) {
    const HeldReactions reactions = find_reactions(state, dt_mean);
    const auto entries = held_;
    const auto x = state.x;
    const double at[3] = {about_[0], about_[1], about_[2]};
    sums = sums_(
        ExecSpace(), static_cast<int>(entries.extent(0)), KOKKOS_LAMBDA(const int i, const ExactAdder& add) {
          const int n = reactions.held.node(entries(i));
          double j[3] = {0, 0, 0};
          j[reactions.held.direction(entries(i))] = reactions(entries(i));
          const double r[3] = {x(n, 0) - at[0], x(n, 1) - at[1], x(n, 2) - at[2]};
          add_impulse(r, j, 0, add);
        });
  }
  add_bodies(state, reactions, sums);
  if (held_spins_.extent(0) == 0) return sums;
  const HeldMoments moments = find_held_moments(state, dt_mean);
  const auto entries = held_spins_;
  const ImpulseSums spins = spin_sums_(
      ExecSpace(), static_cast<int>(entries.extent(0)), KOKKOS_LAMBDA(const int i, const ExactAdder& add) {
        add(3 + moments.held.direction(entries(i)), moments(entries(i)));
      });
  for (std::size_t k = 3; k < 6; ++k) sums[k].merge(spins[k]);
  return sums;
}

SectionForce::Slots SectionForce::list_cut(const Deck& deck, const ForceDeck& force, const ChunkedMesh& chunked,
                                           const Model& model) {
  const auto first_slot = to_host(model.chunks.first_slot), slots_to_nodes = to_host(model.chunks.slots_to_nodes);
  const auto start = to_host(model.start);
  const auto is_behind = [&](int node) {
    double ahead = 0;
    for (std::size_t k = 0; k < 3; ++k)
      ahead += (start(static_cast<std::size_t>(node), k) - force.point[k]) * force.normal[k];
    return ahead < 0;
  };
  Slots cut;
  for (std::size_t c = 0; c < chunked.chunks.size(); ++c) {
    const std::string& part = deck.parts[static_cast<std::size_t>(chunked.chunks[c].part)].name;
    if (!force.part.empty() && part != force.part) continue;
    const std::size_t before = cut.slots.size();
    for (int s = first_slot(c); s < first_slot(c + 1); ++s) {
      const int node = slots_to_nodes(static_cast<std::size_t>(s));
      if (!is_behind(node)) continue;
      cut.slots.push_back(s);
      cut.nodes.push_back(node);
    }
    if (static_cast<int>(cut.slots.size() - before) < first_slot(c + 1) - first_slot(c)) continue;
    cut.slots.resize(before);  // all of it is behind: nothing is cut
    cut.nodes.resize(before);
  }
  return cut;
}

SectionForce::Slots SectionForce::list_of_sets(const Deck& deck, const ForceDeck& force, const ChunkedMesh& chunked,
                                               const Model& model) {
  const Mesh& mesh = chunked.mesh;
  const std::vector<char> elements = mark_elements(mesh, deck, force.elements);
  std::vector<char> is_of_nodes(mesh.nodes.size(), 0);
  for (const int node : select_nodes(mesh, deck, *force.nodes)) is_of_nodes[static_cast<std::size_t>(node)] = 1;
  const auto first_slot = to_host(model.chunks.first_slot), slots_to_nodes = to_host(model.chunks.slots_to_nodes);
  Slots of;
  for (std::size_t c = 0; c < chunked.chunks.size(); ++c) {
    if (elements[static_cast<std::size_t>(chunked.chunks[c].first_element)] == 0) continue;
    for (int s = first_slot(c); s < first_slot(c + 1); ++s) {
      const int node = slots_to_nodes(static_cast<std::size_t>(s));
      if (is_of_nodes[static_cast<std::size_t>(node)] == 0) continue;
      of.slots.push_back(s);
      of.nodes.push_back(node);
    }
  }
  return of;
}

SectionForce::SectionForce(const Deck& deck, const ForceDeck& force, const ChunkedMesh& chunked, const Model& model)
    : about_(force.about.value_or(force.point)) {
  const Slots found = force.nodes ? list_of_sets(deck, force, chunked, model) : list_cut(deck, force, chunked, model);
  const std::string why = force.nodes
                              ? "whose elements have none of its nodes (they share none)"
                              : fmt::format("that cuts no element (its plane lies beside {})",
                                            force.part.empty() ? "all parts" : fmt::format("part '{}'", force.part));
  require_some(model.ranks, found.slots.size(),
               fmt::format("{}: error: force '{}' is of a section {}", deck.where(force.place), force.name, why));
  if (force.nodes && !force.about) about_ = find_mean_place(deck, *force.nodes, chunked, model);
  slots_ = to_view("percuss::section_slots", found.slots);
  nodes_ = to_view("percuss::section_nodes", found.nodes);
}

ImpulseSums SectionForce::find_impulse(const State& state, double dt_mean) {
  const auto slots = slots_, nodes = nodes_;
  const auto x = state.x, f = state.slot_force, m = state.slot_moment;
  const bool has_moments = m.extent(0) > 0;
  const double at[3] = {about_[0], about_[1], about_[2]};
  return sums_(
      ExecSpace(), static_cast<int>(slots.extent(0)), KOKKOS_LAMBDA(const int i, const ExactAdder& add) {
        const int s = slots(i), n = nodes(i);
        const double j[3] = {dt_mean * f(s, 0), dt_mean * f(s, 1), dt_mean * f(s, 2)};
        const double r[3] = {x(n, 0) - at[0], x(n, 1) - at[1], x(n, 2) - at[2]};
        add_impulse(r, j, 0, add);
        for (int k = 0; has_moments && k < 3; ++k) add(3 + k, dt_mean * m(s, k));
      });
}

}  // namespace percuss
