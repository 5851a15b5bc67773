#include "src/step/audit/hourglass_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "comm/agreement.hpp"
#include "kernels/core/host_copy.hpp"
#include "src/step/audit/part_energies.hpp"
#include "src/step/model/whole_mesh.hpp"

namespace percuss {
namespace {

/// The chunk with most hourglass energy.
struct WorstChunk {
  double energy;
  int number;  // in the whole mesh
};

/// [parts] of all ranks; of equals the lowest number. Collective.
std::vector<WorstChunk> find_worst_chunks(const ChunkedMesh& chunked, const Model& model, const State& state) {
  std::vector<WorstChunk> worst(chunked.mesh.parts.size(), {-1, 0});
  const auto work = to_host(state.results.work);
  for (std::size_t c = 0; c < chunked.chunks.size(); ++c) {
    WorstChunk& part = worst[static_cast<std::size_t>(chunked.chunks[c].part)];
    if (work(c, 1) > part.energy) part = {work(c, 1), chunked.chunks[c].number};
  }
  wait_mpi(
      [&] {
        return MPI_Allreduce(MPI_IN_PLACE, worst.data(), static_cast<int>(worst.size()), MPI_DOUBLE_INT, MPI_MAXLOC,
                             model.ranks.handle());
      },
      "MPI_Allreduce");
  return worst;
}

/// Displacements of the corners of an element as kernels see it, and where they are.
struct MovedCorners {
  std::array<Vec3, 8> by;
  Vec3 center{};
};

template <class Places>
MovedCorners find_corners(const ChunkedMesh& chunked, const Places& x, int element) {
  MovedCorners corners;
  const auto nodes = chunked.mesh.elements.kernel_nodes(static_cast<std::size_t>(element));
  for (std::size_t i = 0; i < 8; ++i) {
    const auto n = static_cast<std::size_t>(nodes[i]);
    for (std::size_t k = 0; k < 3; ++k) {
      corners.by[i][k] = x(n, k) - chunked.mesh.nodes[n][k];
      corners.center[k] += x(n, k) / 8;
    }
  }
  return corners;
}

/// Square of the displacement in the modes that a mean gradient does not see; of a shell, whose corners are named
/// twice, that of its one mode counts in all.
double find_hourglass_square(const std::array<Vec3, 8>& by) {
  static constexpr int modes[4][8] = {{1, -1, 1, -1, 1, -1, 1, -1},  // xi eta
                                      {1, 1, -1, -1, -1, -1, 1, 1},  // eta zeta
                                      {1, -1, -1, 1, -1, 1, 1, -1},  // zeta xi
                                      {-1, 1, -1, 1, 1, -1, 1, -1}};
  double square = 0;
  for (const auto& mode : modes) {
    for (std::size_t k = 0; k < 3; ++k) {
      double sum = 0;
      for (std::size_t i = 0; i < 8; ++i) sum += mode[i] * by[i][k];
      square += sum * sum;
    }
  }
  return square;
}

/// In the words of the rank that has the chunk. Collective.
std::string describe_worst_element(const ChunkedMesh& chunked, const Model& model, const State& state, int chunk) {
  const auto own =
      std::find_if(chunked.chunks.begin(), chunked.chunks.end(), [&](const Chunk& c) { return c.number == chunk; });
  std::string text;
  if (own != chunked.chunks.end()) {
    const auto x = to_host(state.x);
    double largest = -1;
    int worst = own->first_element;
    for (int e = own->first_element; e < own->first_element + own->element_count; ++e) {
      const auto i = static_cast<std::size_t>(e);
      if (i < chunked.mesh.eroded.dead.size() && chunked.mesh.eroded.dead[i] != 0) continue;
      const double square = find_hourglass_square(find_corners(chunked, x, e).by);
      if (square > largest) worst = e;
      largest = std::max(largest, square);
    }
    const Vec3 at = find_corners(chunked, x, worst).center;
    text = fmt::format("{} at ({:.6g}, {:.6g}, {:.6g})", name_element(chunked.mesh, worst), at[0], at[1], at[2]);
  }
  return broadcast_text(model.ranks, text, chunked.numbering.ranks[static_cast<std::size_t>(chunk)]);
}

}  // namespace

std::vector<PartHourglass> find_hourglassed_parts(const ChunkedMesh& chunked, const Model& model, const State& state,
                                                  double share, double least) {
  const std::vector<PartEnergy> energies = sum_part_energies(chunked, model, state);
  const std::vector<WorstChunk> worst = find_worst_chunks(chunked, model, state);
  std::vector<PartHourglass> found;
  for (std::size_t p = 0; p < energies.size(); ++p) {
    const auto& [internal, hourglass] = energies[p];
    if (!(internal > 0 && hourglass > share * internal && hourglass > least)) continue;
    found.push_back({chunked.mesh.parts[p].name, internal, hourglass,
                     describe_worst_element(chunked, model, state, worst[p].number)});
  }
  return found;
}

}  // namespace percuss
