#pragma once
// Mass scaling on request: elements whose step bound is below a wanted step are given mass until it is that step.
//
// At rest every term of the bound goes with the square root of the element's mass (section 3.5 of docs/theory.md), so
// that (step / bound)^2 times the mass gives the bound exactly. Tetrahedra that share the mass of their nodes are given
// mass in several passes. The volume of a material follows from the element's own mass (CalledMaterial). The mass is
// added once, at time 0, and is mass in all that follows: inertia, weight, momentum and energy. Mass that the deck adds
// to nodes, without elements, is here too.

#include <string>
#include <vector>

#include "src/mesh/ordering.hpp"
#include "src/step/model/model.hpp"

namespace percuss {

/// Adds to the masses of elements of the parts that the deck asks to scale, and to model.added_masses what they got.
/// element_mass: [elements of this rank], in and out; model: chunks, blocks and start are there. Collective. Throws
/// InputError, the same on all ranks, where a part would get more than its limit.
void scale_masses(const Deck& deck, const ChunkedMesh& chunked, std::vector<double>& element_mass, Model& model);

/// A line for each part that was given mass, and one for all together.
std::vector<std::string> describe_added_masses(const Model& model);

/// Adds the masses of Deck::added_masses to those of the nodes, and to Model::extra_mass; a line for each to
/// Model::mass_notes. A share of a node follows from its own mass and sums that are exact: copies have the same bits.
/// mass: [nodes], of the elements, in and out. Collective. Throws InputError: unknown sets.
void add_deck_masses(const Deck& deck, const ChunkedMesh& chunked, std::vector<double>& mass, Model& model);

}  // namespace percuss
