#pragma once
// The blast wave of a hemispherical charge of TNT on the ground.
//
// Kingery and Bulmash, Airblast parameters from TNT spherical air burst and hemispherical surface burst, ARBRL-TR-02555
// (1984), in the simplified form of Swisdak, Simplified Kingery airblast calculations, Naval Surface Warfare Center
// (1994), metric tables.

namespace percuss {

/// At one distance, in kPa and ms. Impulses are those of the positive phase.
struct BlastWave {
  double arrival = 0, duration = 0;
  double incident = 0, incident_impulse = 0;    // of the wave that passes
  double reflected = 0, reflected_impulse = 0;  // of the wave that meets a wall head-on
};

/// Scaled distances, in m / kg^(1/3), for which there are curves of all quantities.
inline constexpr double least_scaled_distance = 0.2, largest_scaled_distance = 40;

/// Of a charge in kg at a distance in m, within these scaled distances.
BlastWave find_blast_wave(double charge, double distance);

/// The decay b of a pulse p (1 - t/T) exp(-b t/T), 0 < t < T, (Friedlander) with the impulse:
/// i / (p T) = 1/b - (1 - exp(-b)) / b^2.
double find_decay(double peak, double duration, double impulse);

}  // namespace percuss
