#include "src/step/audit/part_energies.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <iterator>
#include <optional>

#include "comm/exact_reduction.hpp"
#include "kernels/core/host_copy.hpp"
#include "src/deck/asked_for.hpp"
#include "src/deck/rigid_bodies.hpp"
#include "src/step/model/moving_nodes.hpp"

namespace percuss {

namespace {

/// What is summed of each part; some have columns only where it can fail, or resists folding.
struct PartSum {
  enum : int {
    kinetic,
    internal,
    momentum = internal + work_kinds,
    mass = momentum + 3,
    eroded_mass,
    eroded_energy,
    count
  };
};
using P = PartSum;

/// What is summed over the nodes of a chunk.
struct ChunkSum {
  enum : int { kinetic, momentum, mass = momentum + 3, rotation, count };
};
using ChunkSums = Kokkos::View<double**, Kokkos::LayoutRight, MemSpace>;

/// A quantity of a part, in the order of its sums.
struct PartQuantity {
  const char* name;
  Dimension dimension;
  const char* meaning;
  bool (*has)(const BookedPart&);
};

bool always(const BookedPart&) { return true; }
bool resists_folding(const BookedPart& part) { return part.resists_folding; }
bool fails(const BookedPart& part) { return part.can_fail; }

constexpr PartQuantity part_quantities[] = {
    {"kinetic", dimensions::energy, "kinetic energy", always},
    {"internal", dimensions::energy, "internal energy", always},
    {"hourglass", dimensions::energy, "hourglass energy", always},
    {"viscous", dimensions::energy, "viscous energy", always},
    {"folding", dimensions::energy, "folding energy", resists_folding},
    {"momentum_x", dimensions::momentum, "linear momentum in x", always},
    {"momentum_y", dimensions::momentum, "linear momentum in y", always},
    {"momentum_z", dimensions::momentum, "linear momentum in z", always},
    {"mass", dimensions::mass, "mass", always},
    {"eroded_mass", dimensions::mass, "eroded mass", fails},
    {"eroded_energy", dimensions::energy, "eroded energy", fails},
};

/// Sums over the nodes of the listed chunks, in ascending order. A chunk is the same everywhere. has_own_mass: bodies
/// whose nodes are left out; may be empty.
void sum_chunks(const Model& model, const State& state, const Array<int>& listed, const Array<int>& has_own_mass,
                const ChunkSums& sums) {
  const MovingNodes moving = find_translations(model, state);
  const MovingNodes turning = model.has_rotations ? find_rotations(model, state) : MovingNodes{};
  const bool turns = model.has_rotations;
  const NodeRuns owned = model.owned_nodes;
  const bool leaves_out = has_own_mass.extent(0) > 0;
  const Array<const int> left_out = has_own_mass, body_of_node = model.rigid.body_of_node;
  Kokkos::parallel_for(
      "percuss::sum_parts", Range(ExecSpace(), 0, static_cast<int>(listed.extent(0))), KOKKOS_LAMBDA(const int i) {
        double sum[ChunkSum::count] = {}, f[3];
        for (int n = owned.first(listed(i)); n < owned.end(listed(i)); ++n) {
          if (leaves_out && body_of_node(n) >= 0 && left_out(body_of_node(n)) != 0) continue;
          moving.find_force(n, f);
          for (int k = 0; k < 3; ++k) {
            sum[ChunkSum::kinetic] += moving.find_energy(n, k, f[k]);
            sum[ChunkSum::momentum + k] += moving.inertia(n) * moving.velocity(n, k);
          }
          sum[ChunkSum::mass] += moving.inertia(n);
          if (!turns) continue;
          turning.find_force(n, f);
          for (int k = 0; k < 3; ++k) sum[ChunkSum::rotation] += turning.find_energy(n, k, f[k]);
        }
        for (int k = 0; k < ChunkSum::count; ++k) sums(i, k) = sum[k];
      });
}

/// Takes the work that went into dead elements of a chunk out of its part's, as the books of the scene do.
class DeadElements {
 public:
  DeadElements(const ChunkedMesh& chunked, const Model& model, const State& state)
      : dead_(chunked.mesh.eroded.dead),
        first_element_(to_host(model.chunks.first_element)),
        first_pack_(to_host(model.failing.first_pack)),
        work_(to_host(state.lives.work)),
        mass_(to_host(model.element_mass)) {}

  void take_out(int chunk, ExactSum* sums) const {
    if (first_pack_.extent(0) == 0 || first_pack_(chunk) < 0) return;  // none of this rank can fail; it cannot
    const int first = first_element_(chunk);
    for (int e = first; e < first_element_(chunk + 1); ++e) {
      if (dead_[static_cast<std::size_t>(e)] == 0) continue;
      const int lane = first_pack_(chunk) * width + e - first;
      for (int k = 0; k < work_kinds; ++k) {
        const double work = work_(static_cast<std::size_t>((lane / width * work_kinds + k) * width + lane % width));
        sums[P::internal + k].add(-work);
        sums[P::eroded_energy].add(work);
      }
      sums[P::eroded_mass].add(mass_(e));
    }
  }

 private:
  static constexpr int width = pack_size<Real>;
  const std::vector<std::uint8_t>& dead_;
  decltype(to_host(Array<int>())) first_element_, first_pack_;
  decltype(to_host(Array<double>())) work_, mass_;
};

/// Adds the work of a chunk to the sums of its part.
void add_chunk_work(const decltype(to_host(WorkRows()))& work, const std::optional<DeadElements>& dead, int chunk,
                    ExactSum* part) {
  for (int k = 0; k < work_kinds; ++k)
    part[P::internal + k].add(work(static_cast<std::size_t>(chunk), static_cast<std::size_t>(k)));
  if (dead) dead->take_out(chunk, part);
}

}  // namespace

std::vector<PartEnergy> sum_part_energies(const ChunkedMesh& chunked, const Model& model, const State& state) {
  const auto work = to_host(state.results.work);
  std::optional<DeadElements> dead;
  if (chunked.mesh.eroded.any) dead.emplace(chunked, model, state);
  std::vector<ExactSum> sums(P::count * chunked.mesh.parts.size());
  for (std::size_t c = 0; c < chunked.chunks.size(); ++c)
    add_chunk_work(work, dead, static_cast<int>(c), &sums[P::count * static_cast<std::size_t>(chunked.chunks[c].part)]);
  sum_over_ranks(model.ranks, sums);
  std::vector<PartEnergy> parts;
  for (std::size_t p = 0; p < chunked.mesh.parts.size(); ++p)
    parts.push_back({sums[P::count * p + P::internal].round(), sums[P::count * p + P::internal + 1].round()});
  return parts;
}

std::vector<BookedPart> find_booked_parts(const Deck& deck) {
  std::vector<BookedPart> parts;
  for (const HistoryPoint& point : deck.output.points) {
    for (std::size_t p = 0; names_parts(point) && p < deck.parts.size(); ++p) {
      if (!point.part.empty() && point.part != deck.parts[p].name) continue;
      parts.push_back(
          {deck.parts[p].name, static_cast<int>(p), can_fail(deck, deck.parts[p]), deck.elements.resist_folding});
    }
  }
  return parts;
}

std::vector<HistoryColumn> list_part_columns(const std::vector<BookedPart>& parts) {
  std::vector<HistoryColumn> columns;
  for (const BookedPart& part : parts) {
    for (const PartQuantity& quantity : part_quantities) {
      if (!quantity.has(part)) continue;
      columns.push_back({fmt::format("{}:{}", quantity.name, part.name), quantity.dimension,
                         fmt::format("{} of part '{}'", quantity.meaning, part.name)});
    }
  }
  return columns;
}

PartEnergies::PartEnergies(const Deck& deck, const ChunkedMesh& chunked)
    : chunked_(chunked), parts_(find_booked_parts(deck)) {
  if (parts_.empty()) return;
  std::vector<int> place(chunked.mesh.parts.size(), -1);
  for (std::size_t p = 0; p < parts_.size(); ++p)
    place[static_cast<std::size_t>(parts_[p].index)] = static_cast<int>(p);
  for (std::size_t c = 0; c < chunked.chunks.size(); ++c) {
    const int part = place[static_cast<std::size_t>(chunked.chunks[c].part)];
    if (part < 0) continue;
    chunks_.push_back(static_cast<int>(c));
    part_of_chunk_.push_back(part);
  }
  listed_ = to_view("percuss::chunks_of_booked_parts", chunks_);
  node_sums_ = ChunkSums("percuss::part_sums", chunks_.size(), ChunkSum::count);
  find_given_bodies(deck, place);
}

/// place: of a part of the deck among those with columns, -1: it has none.
void PartEnergies::find_given_bodies(const Deck& deck, const std::vector<int>& place) {
  const RigidNames names = name_rigid_bodies(deck);
  std::vector<int> has_own(names.bodies.size(), 0), first_part(names.bodies.size(), -1);
  bool any = false;
  for (std::size_t p = deck.parts.size(); p-- > 0;) {
    if (!deck.parts[p].rigid) continue;
    const RigidDeck& rigid = *deck.parts[p].rigid;
    const auto body = static_cast<std::size_t>(names.body_of_part[p]);
    first_part[body] = place[p];
    if (!rigid.mass && !rigid.center && !rigid.inertia) continue;
    has_own[body] = 1;
    any = true;
  }
  if (!any) return;
  for (std::size_t b = 0; b < has_own.size(); ++b) part_of_body_.push_back(has_own[b] != 0 ? first_part[b] : -1);
  has_own_mass_ = to_view("percuss::bodies_with_own_mass", has_own);
}

/// On the first rank, as all know the bodies.
void PartEnergies::add_given_bodies(const Model& model, const State& state, std::vector<ExactSum>& sums) {
  if (part_of_body_.empty()) return;
  if (!find_forces_) find_forces_.emplace(model);
  const std::vector<BodyForces> forces = (*find_forces_)(state);
  for (std::size_t b = 0; b < forces.size() && model.ranks.rank() == 0; ++b) {
    if (part_of_body_[b] < 0) continue;
    const RigidSums body = sum_rigid_body(model, state, b, forces[b]);
    ExactSum* const part = &sums[P::count * static_cast<std::size_t>(part_of_body_[b])];
    part[P::kinetic].add(body.kinetic);
    for (int k = 0; k < 3; ++k) part[P::momentum + k].add(get(body.momentum, k));
    part[P::mass].add(model.rigid.bodies[b].mass);
  }
}

/// The sums of this rank, part after part.
std::vector<ExactSum> PartEnergies::sum_parts(const Model& model, const State& state) {
  sum_chunks(model, state, listed_, has_own_mass_, node_sums_);
  const auto of_nodes = to_host(node_sums_);
  const auto work = to_host(state.results.work);
  std::optional<DeadElements> dead;
  if (chunked_.mesh.eroded.any) dead.emplace(chunked_, model, state);
  std::vector<ExactSum> sums(P::count * parts_.size());
  for (std::size_t i = 0; i < chunks_.size(); ++i) {
    ExactSum* const part = &sums[P::count * static_cast<std::size_t>(part_of_chunk_[i])];
    part[P::kinetic].add(of_nodes(i, ChunkSum::kinetic));
    part[P::kinetic].add(of_nodes(i, ChunkSum::rotation));
    for (int k = 0; k < 3; ++k) part[P::momentum + k].add(of_nodes(i, ChunkSum::momentum + k));
    part[P::mass].add(of_nodes(i, ChunkSum::mass));
    add_chunk_work(work, dead, chunks_[i], part);
  }
  add_given_bodies(model, state, sums);
  return sums;
}

void PartEnergies::append(const Model& model, const State& state, std::vector<double>& row) {
  if (parts_.empty()) return;
  std::vector<ExactSum> sums = sum_parts(model, state);
  sum_over_ranks(model.ranks, sums);
  for (std::size_t p = 0; p < parts_.size(); ++p) {
    for (std::size_t k = 0; k < std::size(part_quantities); ++k) {
      if (!part_quantities[k].has(parts_[p])) continue;
      row.push_back(sums[P::count * p + k].round());
    }
  }
}

}  // namespace percuss
