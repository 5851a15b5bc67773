#include "src/step/erosion.hpp"

#include <algorithm>
#include <limits>

#include "comm/all_reduce.hpp"
#include "comm/exact_reduction.hpp"
#include "comm/gather_items.hpp"
#include "kernels/core/host_copy.hpp"
#include "kernels/core/small_space.hpp"
#include "kernels/core/view_copy.hpp"
#include "kernels/element/element_records.hpp"
#include "kernels/element/failure.hpp"
#include "src/index.hpp"
#include "src/step/model/whole_mesh.hpp"
#include "src/step/sensors/held_directions.hpp"

namespace percuss {

namespace {

/// Numbers of the nodes of a face, ascending, each once; beyond the last the largest number.
using FaceKey = std::array<std::int64_t, 4>;

FaceKey make_key(const Mesh& mesh, const ElementFace& face) {
  const std::array<int, 4> nodes = mesh.elements.face_key(face);
  FaceKey key;
  key.fill(std::numeric_limits<std::int64_t>::max());
  for (std::size_t i = 0; i < 4 && nodes[i] != std::numeric_limits<int>::max(); ++i)
    key[i] = mesh.node_numbers[at(nodes[i])];
  return key;
}

/// Calls visit(element, lane among those that can fail) for the elements of chunks that can fail.
template <class Visit>
void visit_failing(const Model& model, const Visit& visit) {
  const auto list = to_host(model.failing.list), first_pack = to_host(model.failing.first_pack),
             first_element = to_host(model.chunks.first_element);
  for (std::size_t i = 0; i < list.extent(0); ++i) {
    const int c = list(i);
    for (int e = first_element(c); e < first_element(c + 1); ++e) {
      visit(e, first_pack(c) * pack_width + e - first_element(c));
    }
  }
}

/// Nodes that have vanished have no mass, or rotary inertia, and no velocity.
void empty_nodes(const std::vector<int>& nodes, const Array<double>& mass, const Rows3<double>& inverse,
                 const Rows3<double>& velocity) {
  const auto m = to_host(mass);
  const auto inverse_m = to_host(inverse), v = to_host(velocity);
  for (const int n : nodes) {
    m(at(n)) = 0;
    for (std::size_t k = 0; k < 3; ++k) inverse_m(at(n), k) = v(at(n), k) = 0;
  }
  copy_values(mass, m);
  copy_values(inverse, inverse_m);
  copy_values(velocity, v);
}

std::vector<int> list_loaded_elements(const Deck& deck, const Mesh& mesh) {
  std::vector<int> elements;
  for (const PressureDeck& pressure : deck.pressures) {
    for (const ElementFace& face : select_faces(mesh, deck, pressure.where)) elements.push_back(face.element);
  }
  return elements;
}

}  // namespace

Erosion::Erosion(const Deck& deck, ChunkedMesh& chunked, const Model& model, ContactStage& contact)
    : deck_(deck), chunked_(chunked), model_(model), contact_(contact) {
  if (!model.can_erode) return;
  halo_.emplace(model.ranks, model.halo);
  loaded_elements_ = list_loaded_elements(deck, chunked.mesh);
}

/// Notes who is dead; returns those that were not yet, ascending.
std::vector<int> Erosion::list_newly_dead(const State& state) {
  ErodedMesh& eroded = chunked_.mesh.eroded;
  eroded.any = true;
  eroded.dead.resize(chunked_.mesh.elements.size());
  eroded.nodes.resize(chunked_.mesh.nodes.size());
  const auto steps_left = to_host(state.lives.steps_left);
  std::vector<int> fresh;
  visit_failing(model_, [&](int e, int lane) {
    if (steps_left(at(lane)) != 0 || eroded.dead[at(e)] != 0) return;
    eroded.dead[at(e)] = 1;
    fresh.push_back(e);
  });
  return fresh;
}

void Erosion::find_neighbours() {
  const Mesh& mesh = chunked_.mesh;
  around_ = collect_buckets<int>(mesh.nodes.size(), [&](auto&& put) {
    for (std::size_t e = 0; e < mesh.elements.size(); ++e)
      for (const int node : mesh.corners(e)) put(at(node), static_cast<int>(e));
  });
}

/// The face of this rank with these nodes, of a solid other than `but`; without an element: none here.
ElementFace Erosion::find_across(const FaceKey& face, int but) const {
  constexpr ElementFace none{-1, 0};
  const Mesh& mesh = chunked_.mesh;
  const int node = find_local_node(chunked_, face[0]);
  if (node < 0) return none;
  for (int i = around_.first[at(node)]; i < around_.first[at(node) + 1]; ++i) {
    const int e = around_.items[at(i)];
    const Topology& topology = mesh.topology_of(at(e));
    if (!topology.is_solid()) continue;  // the faces of a surface are exterior as long as it lives
    for (int f = 0; e != but && f < topology.face_count; ++f)
      if (make_key(mesh, {e, f}) == face) return {e, f};
  }
  return none;
}

/// Faces between a dead element and a living one belong to the surface.
void Erosion::open_faces(const std::vector<int>& newly_dead) {
  Mesh& mesh = chunked_.mesh;
  if (!newly_dead.empty() && around_.items.empty()) find_neighbours();
  const auto open = [&](const ElementFace& face) {
    std::uint8_t& mask = mesh.exterior[at(face.element)];
    if (mesh.eroded.dead[at(face.element)] == 0) mask = static_cast<std::uint8_t>(mask | (1U << face.face));
  };
  std::vector<FaceKey> elsewhere;  // faces whose other element some other rank has
  for (const int e : newly_dead) {
    const Topology& topology = mesh.topology_of(at(e));
    for (int f = 0; f < topology.face_count && !topology.is_surface(); ++f) {
      if ((mesh.exterior[at(e)] >> f & 1) != 0) continue;
      const FaceKey key = make_key(mesh, {e, f});
      const ElementFace other = find_across(key, e);
      if (other.element < 0) elsewhere.push_back(key);
      if (other.element >= 0) open(other);
    }
  }
  for (const int e : newly_dead) mesh.exterior[at(e)] = 0;
  if (model_.ranks.size() == 1) return;
  const std::vector<FaceKey> asked = gather_items(model_.ranks, elsewhere);
  if (!asked.empty() && around_.items.empty()) find_neighbours();
  for (const FaceKey& key : asked) {
    const ElementFace other = find_across(key, -1);
    if (other.element >= 0) open(other);
  }
}

/// How many living elements of all ranks hold each node: summed as forces are.
void Erosion::count_holders(const State& state) {
  if (slot_holders_.extent(0) == 0) {
    slot_holders_ = Rows3<double>("percuss::slot_holders", at(model_.slot_count));
    holders_ = Rows3<double>("percuss::holders", at(model_.node_count));
  }
  const Rows3<double> slots = slot_holders_;
  const ElementChunks chunks = model_.chunks;
  const FailingChunks failing = model_.failing;
  const Array<int> steps_left = state.lives.steps_left;
  parallel_for(
      "percuss::count_holders", RangeOf(ExecSpace(), 0, chunks.count), KOKKOS_LAMBDA(const int c) {
        for (int s = chunks.first_slot(c); s < chunks.first_slot(c + 1); ++s) slots(s, 0) = 0;
        const int first_pack = failing.find_pack(c);
        for (int i = 0; i < count_elements(chunks, c); ++i) {
          if (first_pack >= 0 && steps_left(first_pack * pack_width + i) == 0) continue;
          for (int corner = 0; corner < 8; ++corner) slots(number_corner_slot(chunks, c, i, corner), 0) += 1;
        }
      });
  halo_->begin(ExecSpace(), slots);
  halo_->end();
  assemble_slots(ExecSpace(), model_.nodes_to_slots, slots, holders_);
}

/// Nodes that no element holds any more continue as particles or vanish. books: null: after a restart, nothing is
/// booked.
void Erosion::sort_nodes(State& state, Bookkeeper* books) {
  const bool removes = deck_.erosion.free_nodes == ErosionDeck::FreeNodes::remove;
  if (removes) own_masses(model_, state);
  count_holders(state);
  auto& nodes = chunked_.mesh.eroded.nodes;
  const auto holders = to_host(holders_);
  const auto body_of_node = to_host(model_.rigid.body_of_node);
  std::vector<int> vanished;
  for (std::size_t n = 0; n < nodes.size(); ++n) {
    if (nodes[n] != ErodedMesh::held || holders(n, 0) > 0) continue;
    const bool is_of_body = body_of_node.extent(0) > 0 && body_of_node(n) >= 0;  // which keeps its mass
    const bool vanishes = removes && !is_of_body;
    nodes[n] = vanishes ? ErodedMesh::vanished : ErodedMesh::particle;
    if (vanishes) vanished.push_back(static_cast<int>(n));
  }
  if (!removes) return;
  unload_nodes(vanished, state, books != nullptr);
  if (books != nullptr) books->book_vanished(chunked_, vanished, state);
  empty_nodes(vanished, state.mass, state.inverse_mass, state.v);
  if (model_.has_rotations) empty_nodes(vanished, state.inertia, state.inverse_inertia, state.w);
  drop_vanished_directions(state);
}

/// Loads on nodes go with them, and so does the half step's work of their force at n.
void Erosion::unload_nodes(const std::vector<int>& vanished, State& state, bool is_booked) const {
  NodalLoads& loads = state.nodal_loads;
  if (loads.count == 0) return;
  if (loads.share.extent(0) == 0) {
    loads.share = Array<double>("percuss::nodal_share", at(loads.count));
    set_values(loads.share, 1.0);
  }
  const auto share = to_host(loads.share);
  const auto node = to_host(loads.node);
  const auto v = to_host(state.v), w = to_host(state.w), slot_force = to_host(state.slot_force),
             slot_moment = to_host(state.slot_moment);
  for (std::size_t i = 0; i < share.extent(0); ++i) {
    if (share(i) == 0 || !std::binary_search(vanished.begin(), vanished.end(), node(i))) continue;
    share(i) = 0;
    if (!is_booked) continue;
    const std::size_t s = at(loads.first_slot) + i, n = at(node(i));
    double power = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      power += slot_force(s, k) * v(n, k);
      if (slot_moment.extent(0) > 0) power += slot_moment(s, k) * w(n, k);
    }
    state.books.external_work.add(-0.5 * state.dt * power);
  }
  state.books.external_work.normalize();
  copy_values(loads.share, share);
}

/// Pressure goes with the element that it acts on, and with it the half step's work of its force at n.
void Erosion::unload_faces(State& state, bool is_booked) const {
  PressureFaces& faces = state.pressure_faces;
  if (faces.count == 0) return;
  if (faces.share.extent(0) == 0) {
    faces.share = Array<double>("percuss::pressure_share", at(faces.count));
    set_values(faces.share, 1.0);
  }
  const auto share = to_host(faces.share);
  const auto nodes = to_host(faces.nodes);
  const auto v = to_host(state.v), slot_force = to_host(state.slot_force);
  for (std::size_t f = 0; f < loaded_elements_.size(); ++f) {
    if (dead()[at(loaded_elements_[f])] == 0 || share(f) == 0) continue;
    share(f) = 0;
    if (!is_booked) continue;
    double power = 0;
    for (std::size_t i = 0; i < 4; ++i) {
      const std::size_t s = at(faces.first_slot) + 4 * f + i;
      for (std::size_t k = 0; k < 3; ++k) power += slot_force(s, k) * v(at(nodes(f, i)), k);
    }
    state.books.external_work.add(-0.5 * state.dt * power);
  }
  state.books.external_work.normalize();
  copy_values(faces.share, share);
}

/// The work that went into dead elements leaves with them.
void Erosion::book_elements(State& state, const std::vector<int>& newly_dead) const {
  const auto work = to_host(state.lives.work);
  const auto mass = to_host(state.element_mass);
  Books& books = state.books;
  std::vector<int> lanes(chunked_.mesh.elements.size(), -1);
  visit_failing(model_, [&](int e, int lane) { lanes[at(e)] = lane; });
  for (const int e : newly_dead) {
    const std::size_t lane = at(lanes[at(e)]);
    for (std::size_t k = 0; k < work_kinds; ++k) books.eroded_work[k].add(work(find_work_place(lane, k)));
    books.eroded_mass.add(mass(at(e)));
  }
  for (ExactSum& sum : books.eroded_work) sum.normalize();
  books.eroded_mass.normalize();
  auto count = static_cast<std::int64_t>(newly_dead.size());
  all_reduce(model_.ranks, Reduce::sum, count);
  books.eroded_elements += count;
}

void Erosion::redefine(State& state, Bookkeeper& books) {
  const std::vector<int> newly_dead = list_newly_dead(state);
  open_faces(newly_dead);
  book_elements(state, newly_dead);
  unload_faces(state, true);
  sort_nodes(state, &books);
  if (contact_.is_active()) contact_.redefine(state.x, state.v);
}

void Erosion::restore(State& state) {
  if (state.books.eroded_elements == 0) return;
  copy_into_dead_lanes(ExecSpace(), model_.chunks, state.failing_elements(model_.failing));
  open_faces(list_newly_dead(state));
  unload_faces(state, false);
  sort_nodes(state, nullptr);
  if (contact_.is_active()) contact_.restore_surface();
}

}  // namespace percuss
