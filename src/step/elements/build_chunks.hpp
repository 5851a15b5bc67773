#pragma once
// Chunks as kernels hold them: slots of nodes, the variant of the element that computes each, records, thresholds.

#include "src/mesh/mesh.hpp"
#include "src/step/model/model.hpp"

namespace percuss {

/// Fills model.chunks, the blocks of each kind of element and the history at the start.
void build_chunks(const Deck& deck, const ChunkedMesh& chunked, Model& model);

/// Chunks of rigid parts and of skins, which are not computed.
void mark_uncomputed_chunks(const Deck& deck, const ChunkedMesh& chunked, Model& model);

}  // namespace percuss
