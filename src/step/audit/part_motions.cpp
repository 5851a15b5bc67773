#include "src/step/audit/part_motions.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "comm/exact_reduction.hpp"
#include "kernels/core/host_copy.hpp"
#include "kernels/core/small_space.hpp"
#include "kernels/core/view_copy.hpp"

namespace percuss {
namespace {

/// Sums over the nodes of a chunk, and of a part.
struct MotionSum {
  enum : int { mass, displacement, velocity = displacement + 3, count = velocity + 3 };
};

/// Indexes into Deck::parts.
std::vector<std::size_t> list_moving_parts(const Deck& deck) {
  std::vector<std::size_t> parts;
  const std::vector<std::string>& names = deck.output.motions;
  for (std::size_t p = 0; p < deck.parts.size(); ++p) {
    const bool is_named = std::find(names.begin(), names.end(), deck.parts[p].name) != names.end();
    if (is_named || (!names.empty() && names.front() == "all")) parts.push_back(p);
  }
  return parts;
}

void sum_motions(const Model& model, const State& state, const Array<int>& listed, const Rows3<double>& start,
                 const ChunkSums& sums) {
  const NodeRuns owned = model.owned_nodes;
  const auto x = state.x, v = state.v;
  const auto mass = state.mass;
  parallel_for(
      "percuss::sum_part_motions", RangeOf(ExecSpace(), 0, static_cast<int>(listed.extent(0))),
      KOKKOS_LAMBDA(const int i) {
        double sum[MotionSum::count] = {};
        for (int n = owned.first(listed(i)); n < owned.end(listed(i)); ++n) {
          sum[MotionSum::mass] += mass(n);
          for (int k = 0; k < 3; ++k) {
            sum[MotionSum::displacement + k] += mass(n) * (x(n, k) - start(n, k));
            sum[MotionSum::velocity + k] += mass(n) * v(n, k);
          }
        }
        for (int k = 0; k < MotionSum::count; ++k) sums(i, k) = sum[k];
      });
}

}  // namespace

std::vector<HistoryColumn> list_motion_columns(const Deck& deck) {
  std::vector<HistoryColumn> columns;
  for (const std::size_t p : list_moving_parts(deck)) {
    const std::string& name = deck.parts[p].name;
    for (const char axis : {'x', 'y', 'z'})
      columns.push_back(
          {fmt::format("mean_displacement_{}:{}", axis, name), dimensions::length,
           fmt::format("mean displacement of part '{}' in {}, weighted with the masses of its nodes", name, axis)});
    for (const char axis : {'x', 'y', 'z'})
      columns.push_back(
          {fmt::format("mean_velocity_{}:{}", axis, name), dimensions::velocity,
           fmt::format("mean velocity of part '{}' in {}, weighted with the masses of its nodes", name, axis)});
  }
  return columns;
}

PartMotions::PartMotions(const Deck& deck, const ChunkedMesh& chunked) {
  const std::vector<std::size_t> parts = list_moving_parts(deck);
  parts_ = static_cast<int>(parts.size());
  if (parts.empty()) return;
  std::vector<int> chunks;
  for (std::size_t c = 0; c < chunked.chunks.size(); ++c) {
    const auto part = std::find(parts.begin(), parts.end(), static_cast<std::size_t>(chunked.chunks[c].part));
    if (part == parts.end()) continue;
    chunks.push_back(static_cast<int>(c));
    part_of_chunk_.push_back(static_cast<int>(part - parts.begin()));
  }
  listed_ = to_view("percuss::chunks_of_moving_parts", chunks);
  sums_ = ChunkSums("percuss::part_motions", chunks.size(), MotionSum::count);
  start_ = Rows3<double>("percuss::start_of_parts", chunked.mesh.nodes.size());
  const auto host = Kokkos::create_mirror_view(start_);
  for (std::size_t n = 0; n < chunked.mesh.nodes.size(); ++n)
    for (std::size_t k = 0; k < 3; ++k) host(n, k) = chunked.mesh.nodes[n][k];
  copy_values(start_, host);
}

void PartMotions::append(const Model& model, const State& state, std::vector<double>& row) {
  if (parts_ == 0) return;
  sum_motions(model, state, listed_, start_, sums_);
  const auto of_chunks = to_host(sums_);
  std::vector<ExactSum> sums(static_cast<std::size_t>(MotionSum::count * parts_));
  for (std::size_t i = 0; i < part_of_chunk_.size(); ++i) {
    for (int k = 0; k < MotionSum::count; ++k)
      sums[static_cast<std::size_t>(MotionSum::count * part_of_chunk_[i] + k)].add(of_chunks(i, k));
  }
  sum_over_ranks(model.ranks, sums);
  for (int p = 0; p < parts_; ++p) {
    ExactSum* const of = &sums[static_cast<std::size_t>(MotionSum::count * p)];
    const double mass = of[MotionSum::mass].round();  // 0: all of the part has vanished
    for (int k = MotionSum::displacement; k < MotionSum::count; ++k) row.push_back(mass > 0 ? of[k].round() / mass : 0);
  }
}

}  // namespace percuss
