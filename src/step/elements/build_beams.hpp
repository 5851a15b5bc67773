#pragma once
// The parts of the model that beams need. Internal to build_model.

#include <vector>

#include "src/deck/deck.hpp"
#include "src/mesh/ordering.hpp"
#include "src/step/model/model.hpp"

namespace percuss {

/// Whether some beams of the mesh bend, so that their nodes have rotations; the same on all ranks.
bool has_bending_beams(const Deck& deck, const Mesh& mesh);

/// Records of each chunk, as the launchers need them.
struct BeamRecords {
  std::vector<int>&record_size, &history, &points, &parameters, &scalars;
};

/// Fills the block of beams, the records of its chunks and the axes of their sections at the start. Collective. Throws
/// InputError with the deck's place, the same on all ranks: a material that beams do not know, a section that cannot
/// yield, a direction along a beam.
void build_beam_block(const Deck& deck, const ChunkedMesh& chunked, const BeamRecords& records, Model& model);

/// Sets rotary inertia over mass of each beam [length^2], more than a short one has, so that rotations never hold the
/// step down (docs/theory_line_elements.md).
void set_beam_gyrations(const Deck& deck, const Mesh& mesh, std::vector<double>& squares);

/// Rotary inertia of each beam about its axis beyond that across it: the tensor xx, yy, zz, xy, yz, zx of both nodes
/// [mass x length^2]. Of elements that do not bend, and of others: 0.
std::vector<std::array<double, 6>> find_beam_tensors(const Deck& deck, const Mesh& mesh,
                                                     const std::vector<double>& element_mass);

/// Sets the step bound of each beam at rest, with these masses of all elements.
void set_beam_bounds(const Deck& deck, const Mesh& mesh, const std::vector<double>& element_mass,
                     std::vector<double>& bounds);

}  // namespace percuss
