#include "src/mesh/decomposition/decompose.hpp"

#include <algorithm>
#include <cstddef>
#include <limits>
#include <utility>

#include "comm/all_reduce.hpp"
#include "src/fail_together.hpp"
#include "src/mesh/decomposition/chunk_graph.hpp"
#include "src/mesh/decomposition/migrate.hpp"
#include "src/mesh/imperfections.hpp"
#include "src/mesh/pieces/check_pieces.hpp"
#include "src/mesh/pieces/join_pieces.hpp"
#include "src/mesh/thicknesses.hpp"

namespace percuss {
namespace {

/// Box of the nodes of all ranks.
void find_box(const Communicator& ranks, Mesh& mesh) {
  constexpr double far = std::numeric_limits<double>::infinity();
  Vec3 low{far, far, far}, minus_high = low;
  for (const Vec3& x : mesh.nodes) {
    for (std::size_t d = 0; d < 3; ++d) {
      low[d] = std::min(low[d], x[d]);
      minus_high[d] = std::min(minus_high[d], -x[d]);
    }
  }
  for (Vec3* bounds : {&low, &minus_high}) {
    all_reduce(ranks, Reduce::least, *bounds);
  }
  for (std::size_t d = 0; d < 3; ++d) {
    mesh.low[d] = low[d] + 0.0;  // never -0, which compares equal to 0: which of them wins depends on the ranks
    mesh.high[d] = 0.0 - minus_high[d];
  }
}

/// And what was done to the parts.
void report_warnings(const SceneParts& scene, Mesh& mesh) {
  for (const ScenePart& part : scene.parts) {
    for (Warning warning : part.warnings) {
      warning.place = "part '" + part.name + "'" + (warning.place.empty() ? "" : ", " + warning.place);
      mesh.warnings.push_back(std::move(warning));
    }
    for (const std::string& note : part.notes) mesh.notes.push_back("part '" + part.name + "': " + note);
  }
  mesh.notes.insert(mesh.notes.end(), scene.notes.begin(), scene.notes.end());
  mesh.warnings.insert(mesh.warnings.end(), scene.warnings.begin(), scene.warnings.end());
}

}  // namespace

ChunkedMesh load_mesh(const Deck& deck, const Communicator& ranks) {
  SceneParts scene = describe_parts(deck, ranks);
  ChunkPieces pieces;
  fail_together(ranks, [&] { pieces = make_pieces(scene, ranks.rank(), ranks.size()); });
  join_pieces(ranks, scene, pieces);
  check_pieces(deck, ranks, pieces, scene);
  for (ScenePart& part : scene.parts) part.file.reset();
  NumberedChunks numbered = number_chunks(deck, ranks, scene, pieces);
  numbered.numbering.ranks = partition_for_ranks(ranks, numbered.graph).parts;
  ChunkedMesh share = migrate_chunks(ranks, scene, std::move(numbered.numbering), pieces, numbered.numbers);
  share.mesh.ranks = ranks;
  set_thicknesses(deck, ranks, share.mesh);
  apply_imperfections(deck, ranks, share.mesh);
  find_box(ranks, share.mesh);
  report_warnings(scene, share.mesh);
  share.mesh.joints = scene.joints;
  return share;
}

Mesh build_mesh(const Deck& deck) { return load_mesh(deck, Communicator(MPI_COMM_SELF)).mesh; }

}  // namespace percuss
