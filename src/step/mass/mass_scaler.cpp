#include "src/step/mass/mass_scaler.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "comm/exact_reduction.hpp"
#include "kernels/core/common_record.hpp"
#include "kernels/core/host_copy.hpp"
#include "kernels/core/small_space.hpp"
#include "kernels/core/view_copy.hpp"
#include "kernels/element/element_records.hpp"
#include "src/mesh/mesh.hpp"
#include "src/output/checkpoint/checkpoint_archive.hpp"
#include "src/step/audit/books.hpp"

namespace percuss {
namespace {

/// Mass that an element of a chunk lacks to have the requested step as its bound.
struct MissingMass {
  ElementBounds bounds;
  Array<double> mass;
  FailingChunks failing;
  ElementLives lives;

  KOKKOS_INLINE_FUNCTION double operator()(int c, int i, double target) const {
    const int pack = failing.find_pack(c);
    if (pack >= 0 && lives.steps_left(pack * pack_width + i) == 0) return 0;
    const double bound = bounds(c, i);
    if (!(bound > 0 && bound < target)) return 0;
    const double ratio = target / bound;
    return mass(bounds.chunks.first_element(c) + i) * (ratio * ratio - 1);
  }
};

}  // namespace

MassScaler::MassScaler(const Deck& deck, const ChunkedMesh& chunked, const Model& model)
    : chunked_(chunked),
      model_(model),
      target_("percuss::wanted_step", chunked.chunks.size()),
      missing_("percuss::missing_mass", static_cast<std::size_t>(model.element_count)),
      wanted_("percuss::missing_mass_of_chunks", chunked.chunks.size()),
      share_("percuss::share_of_missing_mass", chunked.chunks.size()),
      bounds_(model),
      summer_(model),
      shared_(chunked, model) {
  std::vector<int> places(deck.parts.size(), -1);
  for (const AddedMass& start : model.added_masses) {
    const auto part =
        std::find_if(deck.parts.begin(), deck.parts.end(), [&](const auto& p) { return p.name == start.part; });
    const auto p = static_cast<std::size_t>(part - deck.parts.begin());
    const MassScalingDeck& request = *deck.find_mass_scaling(p);
    if (!request.every) continue;
    places[p] = static_cast<int>(parts_.size());
    parts_.push_back({start.part, request, std::max(0.0, request.max_added * start.mass - start.added), 0});
  }
  for (const Chunk& chunk : chunked.chunks) part_of_chunk_.push_back(places[static_cast<std::size_t>(chunk.part)]);
}

bool MassScaler::wants_masses(const State& state, const HostMirror<Array<double>>& bounds) const {
  for (std::size_t c = 0; c < part_of_chunk_.size(); ++c) {
    if (part_of_chunk_[c] < 0) continue;
    const ScaledPart& part = parts_[static_cast<std::size_t>(part_of_chunk_[c])];
    if (bounds(c) < part.request.step && is_due(part, state.step)) return true;
  }
  return false;
}

/// Finds the mass that each element lacks for the step of its part.
void MassScaler::find_missing(const State& state) {
  const auto target = Kokkos::create_mirror_view(target_);
  for (std::size_t c = 0; c < part_of_chunk_.size(); ++c) {
    const int p = part_of_chunk_[c];
    const bool due = p >= 0 && is_due(parts_[static_cast<std::size_t>(p)], state.step);
    target(c) = due ? parts_[static_cast<std::size_t>(p)].request.step : 0;
  }
  copy_values(target_, target);
  const MissingMass find{bounds_, state.element_mass, model_.failing, state.lives};
  const auto missing = missing_, step = target_;
  const ElementChunks chunks = model_.chunks;
  parallel_for(
      "percuss::find_missing_mass", RangeOf(ExecSpace(), 0, chunks.count), KOKKOS_LAMBDA(const int c) {
        for (int i = 0; i < count_elements(chunks, c); ++i)
          missing(find_element(chunks, c, i)) = step(c) > 0 ? find(c, i, step(c)) : 0;
      });
  if (shared_.is_any()) shared_.spread(state.element_mass, summer_, missing_);
}

/// The share of what its elements lack that each part may have, the same on all ranks.
std::vector<double> MassScaler::find_shares() {
  const auto missing = missing_, wanted = wanted_;
  const ElementChunks chunks = model_.chunks;
  parallel_for(
      "percuss::sum_missing_mass", RangeOf(ExecSpace(), 0, chunks.count), KOKKOS_LAMBDA(const int c) {
        double sum = 0;
        for (int i = 0; i < count_elements(chunks, c); ++i) sum += missing(find_element(chunks, c, i));
        wanted(c) = sum;
      });
  std::vector<ExactSum> sums(parts_.size());
  const auto by_chunk = to_host(wanted_);
  for (std::size_t c = 0; c < part_of_chunk_.size(); ++c) {
    if (part_of_chunk_[c] >= 0) sums[static_cast<std::size_t>(part_of_chunk_[c])].add(by_chunk(c));
  }
  sum_over_ranks(model_.ranks, sums);
  std::vector<double> shares(parts_.size(), 0);
  for (std::size_t p = 0; p < parts_.size(); ++p) {
    const double lacks = sums[p].round(), left = parts_[p].most - parts_[p].added;
    if (lacks > 0) shares[p] = lacks > left ? left / lacks : 1;
    parts_[p].added += std::min(lacks, left);
  }
  return shares;
}

/// The mass into elements and their records; chunks at rest are evaluated again.
void MassScaler::give(const State& state, const std::vector<double>& shares) {
  const auto by_chunk = Kokkos::create_mirror_view(share_);
  for (std::size_t c = 0; c < part_of_chunk_.size(); ++c)
    by_chunk(c) = part_of_chunk_[c] >= 0 ? shares[static_cast<std::size_t>(part_of_chunk_[c])] : 0;
  copy_values(share_, by_chunk);
  const auto missing = missing_, wanted = wanted_, share = share_, mass = state.element_mass;
  const auto elements = state.elements;
  const auto settled = state.results.is_settled;
  const ElementChunks chunks = model_.chunks;
  parallel_for(
      "percuss::add_mass", RangeOf(ExecSpace(), 0, chunks.count), KOKKOS_LAMBDA(const int c) {
        if (!(wanted(c) > 0 && share(c) > 0)) return;
        for (int i = 0; i < count_elements(chunks, c); ++i)
          mass(find_element(chunks, c, i)) += share(c) * missing(find_element(chunks, c, i));
        for (int i = 0; i < count_lanes(chunks, c); ++i)
          find_record(chunks, elements, c, i)[CommonRecord::mass] = static_cast<Real>(mass(find_element(chunks, c, i)));
        settled(c) = 0;
      });
}

/// Sums the masses of all elements, and what the deck adds.
void MassScaler::sum_lumped(const State& state) {
  lumped_ = summer_.sum(state.element_mass);
  if (model_.extra_mass.extent(0) == 0) return;
  const auto lumped = lumped_;
  const auto extra = model_.extra_mass;
  parallel_for(
      "percuss::add_extra_mass", RangeOf(ExecSpace(), 0, model_.node_count),
      KOKKOS_LAMBDA(const int n) { lumped(n, 0) += extra(n); });
}

/// Scales the inertia tensors of nodes of beams: what they have beyond the number grows with it.
void MassScaler::scale_tensors(const State& state) const {
  const SpinInertia inertia = state.spin_inertia();
  const auto lumped = lumped_;
  parallel_for(
      "percuss::scale_tensors", RangeOf(ExecSpace(), 0, static_cast<int>(inertia.tensors.node.extent(0))),
      KOKKOS_LAMBDA(const int i) {
        const int n = inertia.tensors.node(i);
        if (!(inertia.number(n) > 0)) return;
        const double growth = lumped(n, 1) / inertia.number(n);
        for (int k = 0; k < 6; ++k) inertia.tensors.excess(i, k) *= growth;
      });
}

/// Nodes that have vanished stay without mass, held directions without motion.
void MassScaler::set_nodes(State& state) const {
  const auto lumped = lumped_;
  const auto whole = state.lumped_mass, mass = state.mass, inertia = state.inertia;
  const auto inverse_mass = state.inverse_mass, inverse_inertia = state.inverse_inertia;
  const bool has_spins = model_.has_rotations;
  parallel_for(
      "percuss::set_node_masses", RangeOf(ExecSpace(), 0, model_.node_count), KOKKOS_LAMBDA(const int n) {
        whole(n) = lumped(n, 0);
        if (mass(n) == 0) return;
        mass(n) = lumped(n, 0);
        if (has_spins) inertia(n) = lumped(n, 1);
        for (int k = 0; k < 3; ++k) {
          if (inverse_mass(n, k) > 0) inverse_mass(n, k) = 1 / mass(n);
          if (has_spins && inverse_inertia(n, k) > 0) inverse_inertia(n, k) = 1 / inertia(n);
        }
      });
}

void MassScaler::change_masses(State& state, Bookkeeper& books) {
  std::vector<bool> were_full;
  for (const ScaledPart& part : parts_) were_full.push_back(part.is_full());
  find_missing(state);
  const std::vector<double> shares = find_shares();
  give(state, shares);
  sum_lumped(state);
  books.book_added(lumped_, state);
  scale_tensors(state);
  set_nodes(state);
  for (std::size_t p = 0; p < parts_.size(); ++p) {
    if (were_full[p] || !parts_[p].is_full()) continue;
    warnings_.push_back(
        {"mass_scaling_limit",
         fmt::format("mass scaling has added max_added = {:g} of its mass to the part (no more is added, and its "
                     "smallest element limits the time step again): lower mass_scaling.step, or raise max_added",
                     parts_[p].request.max_added),
         "part '" + parts_[p].name + "'", state.time, 1});
  }
}

/// Masses of the nodes from those of the elements, which a checkpoint holds.
void MassScaler::restore(State& state) {
  const bool is_untouched = std::all_of(parts_.begin(), parts_.end(), [](const auto& part) { return part.added == 0; });
  if (is_untouched) return;
  sum_lumped(state);
  set_nodes(state);
}

std::vector<Warning> MassScaler::take_warnings() {
  std::vector<Warning> taken;
  taken.swap(warnings_);
  return taken;
}

void MassScaler::archive(CheckpointArchive& archive, State& state) {
  for (std::size_t p = 0; p < parts_.size(); ++p)
    archive.number("mass_scaling/added/" + std::to_string(p), parts_[p].added);
  archive.rows("elements/mass", find_element_rows(chunked_), 1, state.element_mass);
  archive.number("books/added_mass", state.books.added_mass);
  archive.number("books/added_energy", state.books.added_energy);
  if (!model_.can_erode) archive.number("books/total_mass", state.total_mass);
  if (archive.is_loading()) restore(state);
}

}  // namespace percuss
