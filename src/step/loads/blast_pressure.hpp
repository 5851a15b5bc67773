#pragma once
// The pressure of a blast on the faces of a load.

#include <string>
#include <vector>

#include "kernels/node/pulse.hpp"
#include "src/deck/deck.hpp"
#include "src/deck/units.hpp"
#include "src/mesh/ordering.hpp"

namespace percuss {

/// The pressure on a face over time, by its middle and its normal at time 0: the share of the reflected wave that the
/// angle of incidence leaves, and the incident wave (Randers-Pehrson and Bannister, Airblast loading model for DYNA2D
/// and DYNA3D, ARL-TR-1310, 1997): p_r cos^2 + p_i (1 + cos^2 - 2 cos); on faces that look away p_i alone.
/// middle, normal (outward, of length 1): in the units of the deck.
Pulse find_blast_pulse(const BlastDeck& blast, const Units& units, const Vec3& middle, const Vec3& normal);

/// Faces that are too near or too far for the curves. Collective: throws InputError with the deck's place, on all
/// ranks, if there is one. faces: of the load, on this rank.
void require_blast_range(const Deck& deck, const PressureDeck& load, const ChunkedMesh& chunked,
                         const std::vector<ElementFace>& faces);

/// The pressures on the faces, one after the other.
std::vector<Pulse> list_blast_pulses(const Deck& deck, const PressureDeck& load, const Mesh& mesh,
                                     const std::vector<ElementFace>& faces);

}  // namespace percuss
