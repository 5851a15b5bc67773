#pragma once
// What elements and layers of shells carry that can fail, in a checkpoint.

#include "src/output/checkpoint/checkpoint_archive.hpp"
#include "src/step/model/state.hpp"

namespace percuss {

/// Saves or loads State::lives, element after element: without the packs, whose width depends on the machine.
/// Collective.
void archive_lives(CheckpointArchive& archive, const Model& model, const State& state);

}  // namespace percuss
