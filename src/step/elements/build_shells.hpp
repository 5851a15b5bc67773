#pragma once
// The parts of the model that shells need. Internal to build_model.

#include <vector>

#include "src/deck/deck.hpp"
#include "src/deck/laws/law_traits.hpp"
#include "src/mesh/ordering.hpp"
#include "src/step/model/model.hpp"

namespace percuss {

/// Whether the elements of a chunk are shells.
bool is_shell_chunk(const ChunkedMesh& chunked, const Chunk& chunk);

/// Whether the elements of a chunk are not computed.
inline bool is_uncomputed_chunk(const Deck& deck, const Chunk& chunk) {
  return is_uncomputed(deck, static_cast<std::size_t>(chunk.part));
}

/// Layout of the records of each chunk, for the launchers; filled by who builds its block.
struct ChunkRecords {
  std::vector<int>&record_size, &history, &points, &rule, &parameters, &scalars;
  std::vector<std::size_t>& first_start;  // as in StartHistory
  std::vector<int>& start_count;
  std::vector<double>& start_values;
};

/// Fills the blocks of shells and the records of their chunks; model.has_rotations is set. Throws InputError with the
/// deck's place, the same on all ranks, where a part of shells has a material that they do not know.
void build_shell_blocks(const Deck& deck, const ChunkedMesh& chunked, const ChunkRecords& records, Model& model);

/// Rotary inertia over mass of each element [length^2]: t^2 / 12 + A / 8 and the square of the offset, more than a
/// shell has, so that rotations never hold the step down (docs/theory_shells.md); 0 of other elements.
std::vector<double> find_gyration_squares(const Deck& deck, const Mesh& mesh);

/// Step bound of each shell at rest in its first shape, with these masses of all elements; of others 0.
std::vector<double> find_shell_bounds(const Deck& deck, const Mesh& mesh, const std::vector<double>& element_mass);

}  // namespace percuss
