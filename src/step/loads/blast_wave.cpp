#include "src/step/loads/blast_wave.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

namespace percuss {
namespace {

/// exp(a0 + a1 ln Z + a2 (ln Z)^2 + ...) up to a scaled distance Z.
struct Fit {
  double end;
  std::array<double, 7> a;
};

// Swisdak (1994), metric: kPa, ms and kPa ms of 1 kg. Other charges: times and impulses times the cube root of theirs.
constexpr Fit arrival_fits[] = {{1.5, {-0.7604, 1.8058, 0.1257, -0.0437, -0.0310, -0.00669}},
                                {40, {-0.7137, 1.5732, 0.5561, -0.4213, 0.1054, -0.00929}}};
constexpr Fit incident_fits[] = {{2.9, {7.2106, -2.1069, -0.3229, 0.1117, 0.0685}},
                                 {23.8, {7.5938, -3.0523, 0.40977, 0.0261, -0.01267}},
                                 {198.5, {6.0536, -1.4066}}};
constexpr Fit reflected_fits[] = {{2, {9.006, -2.6893, -0.6295, 0.1011, 0.29255, 0.13505, 0.019736}},
                                  {40, {8.8396, -1.733, -2.64, 2.293, -0.8232, 0.14247, -0.0099}}};
constexpr Fit duration_fits[] = {{1.02, {0.5426, 3.2299, -1.5931, -5.9667, -4.0815, -0.9149}},
                                 {2.8, {0.5440, 2.7082, -9.7354, 14.3425, -9.7791, 2.8535}},
                                 {40, {-2.4608, 7.1639, -5.6215, 2.2711, -0.44994, 0.03486}}};
constexpr Fit incident_impulse_fits[] = {{0.96, {5.522, 1.117, 0.6, -0.292, -0.087}},
                                         {2.38, {5.465, -0.308, -1.464, 1.362, -0.432}},
                                         {33.7, {5.2749, -0.4677, -0.2499, 0.0588, -0.00554}},
                                         {158.7, {5.9825, -1.062}}};
constexpr Fit reflected_impulse_fits[] = {{40, {6.7853, -1.3466, 0.101, -0.01123}}};

double evaluate(std::span<const Fit> fits, double scaled_distance) {
  const Fit* fit = &fits.front();
  while (fit != &fits.back() && scaled_distance > fit->end) ++fit;
  const double log_z = std::log(scaled_distance);
  double sum = 0;
  for (auto a = fit->a.rbegin(); a != fit->a.rend(); ++a) sum = sum * log_z + *a;
  return std::exp(sum);
}

/// i / (p T) of a decay: falls from 1/2 at 0 towards 0.
double find_impulse_share(double decay) {
  if (std::abs(decay) < 1e-3) return 0.5 - decay / 6 + decay * decay / 24;  // the next term is below 1e-11
  return 1 / decay + std::expm1(-decay) / (decay * decay);
}

}  // namespace

BlastWave find_blast_wave(double charge, double distance) {
  const double root = std::cbrt(charge), z = distance / root;
  BlastWave wave;
  wave.arrival = root * evaluate(arrival_fits, z);
  wave.duration = root * evaluate(duration_fits, z);
  wave.incident = evaluate(incident_fits, z);
  wave.incident_impulse = root * evaluate(incident_impulse_fits, z);
  wave.reflected = evaluate(reflected_fits, z);
  wave.reflected_impulse = root * evaluate(reflected_impulse_fits, z);
  return wave;
}

double find_decay(double peak, double duration, double impulse) {
  const double share = impulse / (peak * duration);
  double low = -20, high = 1e4;  // shares of 1e6 and 1e-4: far beyond the curves
  for (int i = 0; i < 100; ++i) {
    const double middle = 0.5 * (low + high);
    (find_impulse_share(middle) > share ? low : high) = middle;
  }
  return 0.5 * (low + high);
}

}  // namespace percuss
