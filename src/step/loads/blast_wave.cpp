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

/// 10^(c0 + c1 U + c2 U^2 + ...) with U = shift + slope log10 Z, up to a scaled distance Z.
struct LogFit {
  double end, shift, slope;
  std::array<double, 10> c;
};

// Kingery and Bulmash (1984), a sphere in free air, metric: kPa, ms and kPa ms of 1 kg, as above.
constexpr LogFit air_arrival_fits[] = {{40,
                                        -0.253273111999,
                                        1.37407043777,
                                        {0.0720707787637, 1.36456871214, -0.0570035692784, -0.182832224796,
                                         0.0118851436014, 0.0432648687627, -0.0007997367834, -0.00436073555033}}};
constexpr LogFit air_incident_fits[] = {
    {40,
     -0.214362789151,
     1.35034249993,
     {2.611368669, -1.69012801396, 0.00804973591951, 0.336743114941, -0.00516226351334, -0.0809228619888,
      -0.00478507266747, 0.00793030472242, 0.0007684469735}}};
constexpr LogFit air_reflected_fits[] = {
    {40,
     -0.214362789151,
     1.35034249993,
     {3.22958031387, -2.21400538997, 0.035119031446, 0.657599992109, 0.0141818951887, -0.243076636231, -0.0158699803158,
      0.0492741184234, 0.00227639644004, -0.00397126276058}}};
constexpr LogFit air_duration_fits[] = {
    {0.888,
     2.26367268496,
     5.11588554305,
     {-0.686608550419, 0.164953518069, 0.127788499497, 0.00291430135946, 0.00187957449227, 0.0173413962543,
      0.00269739758043, -0.00361976502798, -0.00100926577934}},
    {2.28,
     -1.33361206714,
     9.2996288611,
     {0.23031841078, -0.0297944268969, 0.0306329542941, 0.0183405574074, -0.0173964666286, -0.00106321963576,
      0.0056206003128, 0.0001618217499, -0.0006860188944}},
    {40,
     -3.13005805346,
     3.1524725364,
     {0.621036276475, 0.0967031995552, -0.00801302059667, 0.00482705779732, 0.00187587272287, -0.00246738509321,
      -0.000841116668, 0.0006193291052}}};
constexpr LogFit air_incident_impulse_fits[] = {
    {0.792,
     2.34723921354,
     3.24299066475,
     {2.38830516757, -0.443749377691, 0.168825414684, 0.0348138030308, -0.010435192824}},
    {40,
     -1.75305660315,
     2.30629231803,
     {1.55197227115, -0.40463292088, -0.0142721946082, 0.00912366316617, -0.0006750681404, -0.00800863718901,
      0.00314819515931, 0.00152044783382, -0.0007470265899}}};
constexpr LogFit air_reflected_impulse_fits[] = {
    {40, -0.204004553231, 1.37882996018, {2.55875660396, -0.903118886091, 0.101771877942, -0.0242139751146}}};

/// c0 + c1 x + c2 x^2 + ...
double evaluate_polynomial(std::span<const double> c, double x) {
  double sum = 0;
  for (auto term = c.rbegin(); term != c.rend(); ++term) sum = sum * x + *term;
  return sum;
}

/// The fit that holds at a scaled distance, of fits by ascending ends.
template <class AnyFit>
const AnyFit& find_fit(std::span<const AnyFit> fits, double scaled_distance) {
  const AnyFit* fit = &fits.front();
  while (fit != &fits.back() && scaled_distance > fit->end) ++fit;
  return *fit;
}

double evaluate(std::span<const LogFit> fits, double scaled_distance) {
  const LogFit& fit = find_fit(fits, scaled_distance);
  return std::pow(10.0, evaluate_polynomial(fit.c, fit.shift + fit.slope * std::log10(scaled_distance)));
}

double evaluate(std::span<const Fit> fits, double scaled_distance) {
  return std::exp(evaluate_polynomial(find_fit(fits, scaled_distance).a, std::log(scaled_distance)));
}

/// i / (p T) of a decay: falls from 1/2 at 0 towards 0.
double find_impulse_share(double decay) {
  if (std::abs(decay) < 1e-3) return 0.5 - decay / 6 + decay * decay / 24;  // the next term is below 1e-11
  return 1 / decay + std::expm1(-decay) / (decay * decay);
}

/// Blast wave of 1 kg at a scaled distance.
BlastWave find_wave_on_ground(double z) {
  return {evaluate(arrival_fits, z),          evaluate(duration_fits, z),  evaluate(incident_fits, z),
          evaluate(incident_impulse_fits, z), evaluate(reflected_fits, z), evaluate(reflected_impulse_fits, z)};
}

BlastWave find_wave_in_air(double z) {
  return {evaluate(air_arrival_fits, z),   evaluate(air_duration_fits, z),
          evaluate(air_incident_fits, z),  evaluate(air_incident_impulse_fits, z),
          evaluate(air_reflected_fits, z), evaluate(air_reflected_impulse_fits, z)};
}

}  // namespace

BlastRange find_blast_range(BlastDeck::Burst burst) {
  return {burst == BlastDeck::Burst::air ? 0.147 : 0.2};  // from where there are durations
}

BlastWave find_blast_wave(double charge, double distance, BlastDeck::Burst burst) {
  const double root = std::cbrt(charge), z = distance / root;
  BlastWave wave = burst == BlastDeck::Burst::air ? find_wave_in_air(z) : find_wave_on_ground(z);
  for (double* const scaled : {&wave.arrival, &wave.duration, &wave.incident_impulse, &wave.reflected_impulse})
    *scaled *= root;
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
