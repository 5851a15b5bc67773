#pragma once
// Contact data in a checkpoint for a restart to the same bits.

#include "kernels/contact/rows/row_system.hpp"
#include "src/contact/surface/surface_share.hpp"
#include "src/output/checkpoint/checkpoint_archive.hpp"

namespace percuss {

/// The records of contact nodes, and of pairs of a wall and a node. Collective. Throws as CheckpointArchive does.
void archive_history(CheckpointArchive& archive, const ChunkedMesh& chunked, const SurfaceShare& share,
                     const WallPairs& walls, const ContactDeck& contact, const ContactHistory& history);

/// The records of edge pairs; nothing in a scene without edges. Likewise.
void archive_edges(CheckpointArchive& archive, const ChunkedMesh& chunked, const SurfaceShare& share,
                   EdgeHistory& history);

/// The impulses of ties, of places and of rotations. keys: of their rows; has_rotations: on any rank. Likewise.
void archive_ties(CheckpointArchive& archive, const ChunkedMesh& chunked, const std::vector<std::int64_t>& keys,
                  bool has_rotations, const ContactHistory& history);

/// Rows of all mesh nodes of this rank from those of its contact nodes, copies included; zero for other nodes.
/// values: [contact nodes that this rank owns][3]. Collective. Throws MpiError.
Rows3<double> spread_to_mesh(const Communicator& ranks, const ChunkedMesh& chunked, const SurfaceShare& share,
                             const Rows3<double>& values);

}  // namespace percuss
