#pragma once
// What a scene is, for programs: the answer of `percuss check --json` (docs/results.md).

#include <string>

#include "kernels/element/element_chunks.hpp"
#include "src/app/reports/scene_report.hpp"
#include "src/contact/overlap/start_overlap.hpp"

namespace percuss {

/// JSON of all that format_scene() says, and for each part its step, for each entry of the deck that selects nodes or
/// faces the numbers of these nodes (evenly thinned above 4000), and the nodes that overlap at the start. Nodes are
/// numbered from 0 as in fields.vtkhdf. results: of the elements at time 0. Of a mesh that is not divided over ranks.
std::string format_scene_json(const SceneReport& scene, const ChunkedMesh& chunked, const StartOverlap& overlap,
                              const ChunkResults& results);

}  // namespace percuss
