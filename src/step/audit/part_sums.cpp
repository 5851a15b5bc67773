#include "src/step/audit/part_sums.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

#include "kernels/element/element_records.hpp"
#include "src/deck/rigid_bodies.hpp"

namespace percuss {
namespace {

/// A quantity of a part or block, in the order of its sums.
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
static_assert(std::size(part_quantities) == PartSum::count);

}  // namespace

std::vector<HistoryColumn> list_sum_columns(const std::vector<BookedPart>& owners, const char* kind) {
  std::vector<HistoryColumn> columns;
  for (const BookedPart& owner : owners) {
    for (const PartQuantity& quantity : part_quantities) {
      if (!quantity.has(owner)) continue;
      columns.push_back({fmt::format("{}:{}", quantity.name, owner.name), quantity.dimension,
                         fmt::format("{} of {} '{}'", quantity.meaning, kind, owner.name)});
    }
  }
  return columns;
}

void append_sums(const std::vector<BookedPart>& owners, const std::vector<ExactSum>& sums, std::vector<double>& row) {
  for (std::size_t p = 0; p < owners.size(); ++p) {
    for (std::size_t k = 0; k < std::size(part_quantities); ++k) {
      if (part_quantities[k].has(owners[p])) row.push_back(sums[PartSum::count * p + k].round());
    }
  }
}

std::vector<int> mark_bodies_of_parts(const Deck& deck) {
  if (!has_rigid_parts(deck)) return {};
  const RigidNames names = name_rigid_bodies(deck);
  std::vector<int> marks(names.bodies.size(), 0);
  for (const int body : names.body_of_part)
    if (body >= 0) marks[static_cast<std::size_t>(body)] = 1;
  return marks;
}

ChunkWork::DeadElements::DeadElements(const ChunkedMesh& chunked, const Model& model, const State& state)
    : dead_(chunked.mesh.eroded.dead),
      first_element_(to_host(model.chunks.first_element)),
      first_pack_(to_host(model.failing.first_pack)),
      work_(to_host(state.lives.work)),
      mass_(to_host(model.element_mass)) {}

void ChunkWork::DeadElements::take_out(int chunk, ExactSum* sums) const {
  if (first_pack_.extent(0) == 0 || first_pack_(chunk) < 0) return;  // none of this rank can fail; it cannot
  const int first = first_element_(chunk);
  for (int e = first; e < first_element_(chunk + 1); ++e) {
    if (dead_[static_cast<std::size_t>(e)] == 0) continue;
    const int lane = first_pack_(chunk) * pack_width + e - first;
    for (int k = 0; k < work_kinds; ++k) {
      const double work = work_(find_work_place(static_cast<std::size_t>(lane), static_cast<std::size_t>(k)));
      sums[PartSum::internal + k].add(-work);
      sums[PartSum::eroded_energy].add(work);
    }
    sums[PartSum::eroded_mass].add(mass_(e));
  }
}

ChunkWork::ChunkWork(const ChunkedMesh& chunked, const Model& model, const State& state)
    : work_(to_host(state.results.work)) {
  if (chunked.mesh.eroded.any) dead_.emplace(chunked, model, state);
}

void ChunkWork::add(int chunk, ExactSum* owner) const {
  for (int k = 0; k < work_kinds; ++k)
    owner[PartSum::internal + k].add(work_(static_cast<std::size_t>(chunk), static_cast<std::size_t>(k)));
  if (dead_) dead_->take_out(chunk, owner);
}

}  // namespace percuss
