#pragma once
// What a checkpoint holds of model and state, and whether it belongs to the scene at hand.

#include <string>
#include <vector>

#include "src/output/checkpoint/checkpoint_file.hpp"
#include "src/step/model/state.hpp"

namespace percuss {

/// Everything of the state that a step reads. Loaded, copies of nodes and the slots of other ranks are not filled in:
/// complete_state() and Stepper::resume() do that. Collective.
void archive_state(CheckpointArchive& archive, const ChunkedMesh& chunked, const Model& model, State& state);

/// Gives the copies of nodes what their owners have read. Collective.
void complete_state(const ChunkedMesh& chunked, const Model& model, const State& state);

/// The header of a checkpoint of this state. pieces: of the mesh (mesh_pieces.hpp).
CheckpointHeader make_checkpoint_header(const Deck& deck, const std::vector<std::string>& pieces,
                                        const ChunkedMesh& chunked, const State& state);

/// Throws InputError if the checkpoint is of another version, precision, mesh or deck, and says what differs. `now`:
/// the header of the scene at hand.
void check_checkpoint_header(const std::string& path, const CheckpointHeader& checkpoint, const CheckpointHeader& now,
                             const Deck& deck);

/// Values of the deck that differ from those of the checkpoint, a text each; all of them may.
std::vector<std::string> list_changed_values(const CheckpointHeader& checkpoint, const Deck& deck);

/// Throws InputError if a field output of the checkpoint's run shows another region now: its file would hold both.
void refuse_changed_regions(const CheckpointHeader& checkpoint, const Deck& deck,
                            const std::vector<std::string>& changes);

}  // namespace percuss
