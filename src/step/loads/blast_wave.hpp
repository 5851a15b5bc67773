#pragma once
// The blast wave of a charge of TNT: a hemisphere on the ground, or a sphere in free air.
//
// Kingery and Bulmash, Airblast parameters from TNT spherical air burst and hemispherical surface burst, ARBRL-TR-02555
// (1984). That on the ground in the simplified form of Swisdak, Simplified Kingery airblast calculations, Naval Surface
// Warfare Center (1994), metric tables; that in free air by the polynomials of 1984.

#include "src/deck/deck.hpp"

namespace percuss {

/// A blast wave at one distance, in kPa and ms. Impulses are those of the positive phase.
struct BlastWave {
  double arrival = 0, duration = 0;
  double incident = 0, incident_impulse = 0;    // of the wave that passes
  double reflected = 0, reflected_impulse = 0;  // of the wave that meets a wall head-on
};

/// Scaled distances, in m / kg^(1/3), for which there are curves of all quantities.
struct BlastRange {
  double least = 0, largest = 40;
};
BlastRange find_blast_range(BlastDeck::Burst burst);

/// Blast wave of a charge in kg at a distance in m, within these scaled distances.
BlastWave find_blast_wave(double charge, double distance, BlastDeck::Burst burst = BlastDeck::Burst::ground);

/// The decay b of a pulse p (1 - t/T) exp(-b t/T), 0 < t < T, (Friedlander) with the impulse:
/// i / (p T) = 1/b - (1 - exp(-b)) / b^2.
double find_decay(double peak, double duration, double impulse);

}  // namespace percuss
