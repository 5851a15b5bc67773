#include "src/step/stable_step/mesh_eigenvalue.hpp"

#include <cmath>

#include "comm/exact_reduction.hpp"
#include "kernels/core/same_bits.hpp"
#include "kernels/core/small_space.hpp"
#include "kernels/core/view_copy.hpp"
#include "kernels/element/elastic_operator.hpp"
#include "src/step/model/element_blocks.hpp"
#include "src/step/stable_step/lanczos.hpp"

namespace percuss {
namespace {

/// Share of the eigenvalue that the iteration may fall short of it; half of it is lost of the step.
constexpr double margin = 0.04;
/// Chunks with bounds above this many times the trial step count with that value: (1 / 2.5)^2 is far from the
/// eigenvalue.
constexpr double coarse_ratio = 2.5;

/// Nearly normal: the sum of four uniform numbers from one of 64 random bits, less its mean.
KOKKOS_INLINE_FUNCTION double find_random(std::uint64_t key) {
  const std::uint64_t bits = mix_bits(key);
  double sum = 0;
  for (int i = 0; i < 4; ++i) sum += static_cast<double>(bits >> (16 * i) & 0xffff);
  return sum / 65535.0 - 2;
}

}  // namespace

MeshEigenvalue::MeshEigenvalue(const ChunkedMesh& chunked, const Model& model)
    : model_(model),
      unknowns_(3 * chunked.numbering.node_count()),
      iterations_(count_lanczos_steps(unknowns_, margin)),
      halo_(model.ranks, model.halo),
      slots_("percuss::lanczos_slots", static_cast<std::size_t>(model.slot_count)),
      before_("percuss::lanczos_before", static_cast<std::size_t>(model.node_count)),
      vector_("percuss::lanczos_vector", static_cast<std::size_t>(model.node_count)),
      next_("percuss::lanczos_next", static_cast<std::size_t>(model.node_count)) {}

double MeshEigenvalue::find(const State& state, double step) {
  Tridiagonal matrix;
  start_vector();
  double beta = 0, largest = 0;
  int done = 0;
  while (done < iterations_) {
    apply(state, step);
    subtract_previous(beta);
    matrix.diagonal.push_back(take_out());
    largest = find_largest_eigenvalue(matrix);
    ++done;
    beta = normalise();
    if (!(beta > 1e-10 * largest)) return largest;  // the whole space that the start reaches has been seen
    matrix.beside.push_back(beta);
  }
  return largest / (1 - find_lanczos_margin(unknowns_, done));
}

/// A direction that is the same on any ranks: random numbers from those of the nodes, equal in all directions of
/// sqrt(M) u.
void MeshEigenvalue::start_vector() {
  const auto numbers = model_.node_numbers;
  const auto inverse_mass = model_.inverse_mass;
  const auto next = next_;
  parallel_for(
      "percuss::start_lanczos", RangeOf(ExecSpace(), 0, model_.node_count), KOKKOS_LAMBDA(const int n) {
        for (int k = 0; k < 3; ++k) {
          next(n, k) = sqrt(inverse_mass(n, k)) * find_random(static_cast<std::uint64_t>(3 * numbers(n) + k));
        }
      });
  normalise();
  set_values(before_, 0.0);
}

/// Slots of -A(h) u.
void MeshEigenvalue::apply(const State& state, double step) {
  const ElasticProbe probe{state.x, vector_, step, coarse_ratio * step};
  const ChunkFields fields{state.elements, slots_, state.results};
  const ExecSpace space;
  apply_elastic_operator(space, model_.chunks, model_.sending->hexahedra, probe, fields);
  halo_.begin(space, slots_);
  apply_elastic_operator(space, model_.chunks, model_.others->hexahedra, probe, fields);
  halo_.end();
}

/// next = M^-1 A u - beta before.
void MeshEigenvalue::subtract_previous(double beta) {
  const auto next = next_, before = before_;
  const auto inverse_mass = model_.inverse_mass;
  assemble_slots(ExecSpace(), model_.nodes_to_slots, slots_, next_);
  parallel_for(
      "percuss::subtract_previous", RangeOf(ExecSpace(), 0, model_.node_count), KOKKOS_LAMBDA(const int n) {
        for (int k = 0; k < 3; ++k) next(n, k) = -inverse_mass(n, k) * next(n, k) - beta * before(n, k);
      });
}

/// Takes the current vector's share out of the next one; returns it.
double MeshEigenvalue::take_out() {
  const auto next = next_, vector = vector_;
  const auto mass = model_.mass;
  auto sums = sum_(
      ExecSpace(), model_.owned_nodes, KOKKOS_LAMBDA(const int n, OwnedNodeSums<1>::Values& sum) {
        for (int k = 0; k < 3; ++k) sum[0] += mass(n) * next(n, k) * vector(n, k);
      });
  sum_over_ranks(model_.ranks, sums);
  const double alpha = sums[0].round();
  parallel_for(
      "percuss::take_out", RangeOf(ExecSpace(), 0, model_.node_count), KOKKOS_LAMBDA(const int n) {
        for (int k = 0; k < 3; ++k) next(n, k) -= alpha * vector(n, k);
      });
  return alpha;
}

/// Makes the next vector, of length 1 in the masses, the current one; returns its length before.
double MeshEigenvalue::normalise() {
  const auto next = next_;
  const auto mass = model_.mass;
  auto sums = sum_(
      ExecSpace(), model_.owned_nodes, KOKKOS_LAMBDA(const int n, OwnedNodeSums<1>::Values& sum) {
        for (int k = 0; k < 3; ++k) sum[0] += mass(n) * next(n, k) * next(n, k);
      });
  sum_over_ranks(model_.ranks, sums);
  const double length = std::sqrt(sums[0].round());
  const double scale = length > 0 ? 1 / length : 0;
  parallel_for(
      "percuss::normalise", RangeOf(ExecSpace(), 0, model_.node_count), KOKKOS_LAMBDA(const int n) {
        for (int k = 0; k < 3; ++k) next(n, k) *= scale;
      });
  std::swap(before_, vector_);
  std::swap(vector_, next_);
  return length;
}

}  // namespace percuss
