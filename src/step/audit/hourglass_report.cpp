#include "src/step/audit/hourglass_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "comm/agreement.hpp"
#include "comm/exact_reduction.hpp"
#include "kernels/core/host_copy.hpp"
#include "src/deck/laws/law_traits.hpp"
#include "src/step/audit/hourglass_pattern.hpp"
#include "src/step/audit/part_energies.hpp"
#include "src/step/model/whole_mesh.hpp"

namespace percuss {
namespace {

/// Positions of the corners of an element at the start and now.
struct CornerPlaces {
  std::array<Vec3, most_corners> start{}, now{};
  std::size_t count = 0;
};

template <class Places>
CornerPlaces find_corners(const ChunkedMesh& chunked, const Places& x, int element) {
  CornerPlaces corners;
  for (const int node : chunked.mesh.corners(static_cast<std::size_t>(element))) {
    const auto n = static_cast<std::size_t>(node);
    corners.start[corners.count] = chunked.mesh.nodes[n];
    corners.now[corners.count++] = {x(n, 0), x(n, 1), x(n, 2)};
  }
  return corners;
}

/// Whether the hourglass control of a chunk is the stiffness of the material itself, so that its energy is also that of
/// bending.
bool bends_by_control(const Deck& deck, const ChunkedMesh& chunked, const Chunk& chunk) {
  const ElementFamily family = chunked.mesh.topology_of(static_cast<std::size_t>(chunk.first_element)).family;
  if (family == ElementFamily::shells) return true;
  return family == ElementFamily::hexahedra &&
         deck.find_elements(static_cast<std::size_t>(chunk.part)).hourglass == ElementDeck::Hourglass::assumed_strain;
}

/// Hourglass pattern of a chunk.
struct ChunkPattern {
  double share = 0;       // of its hourglass energy that alternates
  int worst_element = 0;  // with the largest hourglass displacement, as far as it counts
};

template <class Places>
ChunkPattern find_pattern(const ChunkedMesh& chunked, const Places& x, const Chunk& chunk) {
  std::vector<HourglassDisplacement> motions(static_cast<std::size_t>(chunk.element_count));
  for (std::size_t i = 0; i < motions.size(); ++i) {
    const auto e = static_cast<std::size_t>(chunk.first_element) + i;
    if (e < chunked.mesh.eroded.dead.size() && chunked.mesh.eroded.dead[e] != 0) continue;
    const CornerPlaces corners = find_corners(chunked, x, static_cast<int>(e));
    motions[i] = find_hourglass_displacement(chunked.mesh.topology_of(e), {corners.start.data(), corners.count},
                                             {corners.now.data(), corners.count});
  }
  const std::vector<double> shares = find_alternating_shares(chunked.mesh, chunk.first_element, motions);
  ChunkPattern pattern{0, chunk.first_element};
  double all = 0, alternating = 0, largest = -1;
  for (std::size_t i = 0; i < motions.size(); ++i) {
    const double own = shares[i] * motions[i].square;
    all += motions[i].square;
    alternating += own;
    if (own > largest) pattern.worst_element = chunk.first_element + static_cast<int>(i);
    largest = std::max(largest, own);
  }
  if (all > 0) pattern.share = alternating / all;
  return pattern;
}

/// The chunk with most hourglass energy that counts.
struct WorstChunk {
  double energy = -1;
  int number = 0;  // in the whole mesh
};

/// The hourglass energy that counts, of the parts for which it is to be found.
class CountedEnergy {
 public:
  /// is_wanted: [parts]. Collective.
  CountedEnergy(const Deck& deck, const ChunkedMesh& chunked, const Model& model, const State& state,
                const std::vector<char>& is_wanted)
      : chunked_(chunked), ranks_(model.ranks), worst_(is_wanted.size()), own_elements_(is_wanted.size(), 0) {
    const auto work = to_host(state.results.work);
    x_ = to_host(state.x);
    std::vector<ExactSum> sums(2 * is_wanted.size());  // of each part: what alternates, and what counts as a whole
    for (std::size_t c = 0; c < chunked.chunks.size(); ++c) {
      const Chunk& chunk = chunked.chunks[c];
      const auto part = static_cast<std::size_t>(chunk.part);
      if (is_wanted[part] == 0 || chunk.element_count == 0) continue;
      const ChunkPattern pattern = find_pattern(chunked, x_, chunk);
      const bool is_whole = !bends_by_control(deck, chunked, chunk);
      const double energy = (is_whole ? 1 : pattern.share) * work(c, WorkKind::hourglass);
      sums[2 * part].add(pattern.share * work(c, WorkKind::hourglass));
      sums[2 * part + 1].add(is_whole ? work(c, WorkKind::hourglass) : 0);
      if (energy <= worst_[part].energy) continue;
      worst_[part] = {energy, chunk.number};
      own_elements_[part] = pattern.worst_element;
    }
    sum_over_ranks(ranks_, sums);
    for (std::size_t p = 0; p < is_wanted.size(); ++p)
      energies_.push_back({sums[2 * p].round(), sums[2 * p + 1].round()});
    wait_mpi(
        [&] {
          return MPI_Allreduce(MPI_IN_PLACE, worst_.data(), static_cast<int>(worst_.size()), MPI_DOUBLE_INT, MPI_MAXLOC,
                               ranks_.handle());
        },
        "MPI_Allreduce");
  }

  double alternating(std::size_t part) const { return energies_[part][0]; }
  double whole(std::size_t part) const { return energies_[part][1]; }

  /// "element 7 of part 'bar' at (1, 2, 3)", in the words of the rank that has it. Collective.
  std::string describe_worst(std::size_t part) const {
    const int chunk = worst_[part].number;
    const auto is_own = [&](const Chunk& c) { return c.number == chunk; };
    std::string text;
    if (std::any_of(chunked_.chunks.begin(), chunked_.chunks.end(), is_own)) {
      const CornerPlaces corners = find_corners(chunked_, x_, own_elements_[part]);
      Vec3 at{};
      for (std::size_t i = 0; i < corners.count; ++i)
        for (std::size_t k = 0; k < 3; ++k) at[k] += corners.now[i][k] / static_cast<double>(corners.count);
      text = fmt::format("{} at ({:.6g}, {:.6g}, {:.6g})", name_element(chunked_.mesh, own_elements_[part]), at[0],
                         at[1], at[2]);
    }
    return broadcast_text(ranks_, text, chunked_.numbering.ranks[static_cast<std::size_t>(chunk)]);
  }

 private:
  const ChunkedMesh& chunked_;
  Communicator ranks_;
  decltype(to_host(Rows3<double>())) x_;
  std::vector<std::array<double, 2>> energies_;
  std::vector<WorstChunk> worst_;
  std::vector<int> own_elements_;  // [parts] of this rank's worst chunk
};

bool is_of_fluid(const Deck& deck, std::size_t part) {
  const auto material = std::find_if(deck.materials.begin(), deck.materials.end(),
                                     [&](const MaterialDeck& m) { return m.name == deck.parts[part].material; });
  return material != deck.materials.end() && find_traits(*material).needs_equation_of_state;
}

}  // namespace

std::vector<PartHourglass> find_hourglassed_parts(const Deck& deck, const ChunkedMesh& chunked, const Model& model,
                                                  const State& state, const HourglassLimits& limits) {
  const std::vector<PartEnergy> energies = sum_part_energies(chunked, model, state);
  // What is stored besides: stress, and bending where the control resists it as the material does.
  const auto find_stored = [&](std::size_t p, double counted) {
    return energies[p].internal + energies[p].hourglass - counted;
  };
  const auto is_much = [&](double counted, double stored, double share) {
    return stored > 0 && counted > share * stored && counted > limits.least;
  };
  std::vector<char> is_wanted;
  for (const PartEnergy& energy : energies)
    is_wanted.push_back(static_cast<char>(is_much(energy.hourglass, energy.internal, limits.share)));
  std::vector<PartHourglass> found;
  if (std::none_of(is_wanted.begin(), is_wanted.end(), [](char wanted) { return wanted != 0; })) return found;
  const CountedEnergy counted(deck, chunked, model, state, is_wanted);
  for (std::size_t p = 0; p < energies.size(); ++p) {
    if (is_wanted[p] == 0) continue;
    const double whole = counted.whole(p), alternating = counted.alternating(p);
    const bool is_whole = is_much(whole, find_stored(p, whole), limits.whole_share);
    if (!is_whole && !is_much(alternating, find_stored(p, alternating), limits.share)) continue;
    const double energy = is_whole ? std::max(whole, alternating) : alternating;
    found.push_back(
        {chunked.mesh.parts[p].name, find_stored(p, energy), energy, counted.describe_worst(p), is_of_fluid(deck, p)});
  }
  double hourglass = 0;
  for (const PartHourglass& part : found) hourglass += part.hourglass;
  return hourglass > limits.least_of_all ? found : std::vector<PartHourglass>{};
}

}  // namespace percuss
