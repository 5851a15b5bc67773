#include "src/step/mass/shared_mass.hpp"

#include <cmath>
#include <vector>

#include "kernels/core/host_copy.hpp"
#include "kernels/core/small_space.hpp"
#include "kernels/element/element_records.hpp"
#include "src/mesh/mesh.hpp"

namespace percuss {
namespace {

/// The 16th root of a sum of 16th powers is at least the largest term, and hardly more.
KOKKOS_INLINE_FUNCTION double raise_to_16(double a) {
  const double fourth = (a * a) * (a * a);
  return (fourth * fourth) * (fourth * fourth);
}
KOKKOS_INLINE_FUNCTION double find_16th_root(double a) { return std::sqrt(std::sqrt(std::sqrt(std::sqrt(a)))); }

/// No corner has less of the mass of its element.
constexpr double least_share = 0.125;

/// Factor by which elements give a node more than they lack themselves, so that its neediest element has enough.
KOKKOS_INLINE_FUNCTION double find_demand(const Rows3<const double>& nodes, int n) {
  const double lacking = nodes(n, SharedMass::lacking);
  const double most = find_16th_root(nodes(n, SharedMass::need) / least_share);
  return lacking > 0 ? nodes(n, SharedMass::mass) * most / lacking : 0;
}

}  // namespace

SharedMass::SharedMass(const ChunkedMesh& chunked, const Model& model) : model_(model) {
  if (!model.mixes_solids) return;
  std::vector<int> shares;
  for (const Chunk& chunk : chunked.chunks) {
    const Topology& topology = find_topology(find_block(chunked, chunk).topology);
    shares.push_back(topology.is_solid() && topology.family != ElementFamily::hexahedra ? 1 : 0);
  }
  shares_ = to_view("percuss::chunks_that_share_mass", shares);
  values_ = Array<double>("percuss::values_of_elements", static_cast<std::size_t>(model.element_count));
  nodes_ = Rows3<double>("percuss::shared_mass", static_cast<std::size_t>(model.node_count));
}

/// value(element) of the elements that share, lumped as masses are.
template <class Value>
void SharedMass::sum(Column column, LumpedMasses& summer, const Value& value) {
  const auto values = values_;
  const auto shares = shares_;
  const ElementChunks chunks = model_.chunks;
  parallel_for(
      "percuss::set_shared_values", RangeOf(ExecSpace(), 0, chunks.count), KOKKOS_LAMBDA(const int c) {
        for (int e = chunks.first_element(c); e < chunks.first_element(c + 1); ++e)
          values(e) = shares(c) != 0 ? value(e) : 0;
      });
  const Rows3<double> lumped = summer.sum(values_), nodes = nodes_;
  const int k = column;
  parallel_for(
      "percuss::take_shared_sums", RangeOf(ExecSpace(), 0, model_.node_count),
      KOKKOS_LAMBDA(const int n) { nodes(n, k) = lumped(n, 0); });
}

void SharedMass::spread(const Array<const double>& element_mass, LumpedMasses& summer, const Array<double>& missing) {
  const Array<const double> own = missing;
  sum(Column::mass, summer, [element_mass] KOKKOS_FUNCTION(int e) { return element_mass(e); });
  sum(Column::lacking, summer, [own] KOKKOS_FUNCTION(int e) { return own(e); });
  sum(Column::need, summer,
      [element_mass, own] KOKKOS_FUNCTION(int e) { return own(e) > 0 ? raise_to_16(own(e) / element_mass(e)) : 0; });
  const auto shares = shares_;
  const Rows3<const double> nodes = nodes_;
  const ElementChunks chunks = model_.chunks;
  parallel_for(
      "percuss::spread_missing_mass", RangeOf(ExecSpace(), 0, chunks.count), KOKKOS_LAMBDA(const int c) {
        if (shares(c) == 0) return;
        for (int i = 0; i < count_elements(chunks, c); ++i) {
          const int e = find_element(chunks, c, i);
          if (!(missing(e) > 0)) continue;
          double most = 1;
          for (int k = 0; k < 8; ++k) {
            const int slot = number_corner_slot(chunks, c, i, k);
            const double demand = find_demand(nodes, chunks.slots_to_nodes(slot));
            most = demand > most ? demand : most;
          }
          missing(e) *= most;
        }
      });
}

}  // namespace percuss
