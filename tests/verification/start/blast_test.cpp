// The pressure of a blast: the curves against those of Kingery and Bulmash, the impulse on bodies against the curves.

#include "src/step/loads/blast_wave.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "src/deck/units.hpp"
#include "src/error.hpp"
#include "src/step/loads/blast_pressure.hpp"
#include "tests/verification/support/run_deck.hpp"

namespace percuss::test::blast_test {
namespace {

using testing::HasSubstr;
using Burst = BlastDeck::Burst;

/// A charge of 8 kg and a cube of steel, 0.1 m wide, 10 m from it along x. more: keys of the time, or of the deck.
std::string make_scene(const std::string& faces, const std::string& center = "[-10, 0.05, 0.05]",
                       const std::string& burst = "ground") {
  return fmt::format(R"yaml(
units: m, kg, s
time: {{end: 0.03, max_step: 5e-6}}
parts: {{cube: {{box: {{size: [0.1, 0.1, 0.1], cells: [2, 2, 2]}}, material: steel}}}}
materials: {{steel: {{model: elastic, density: 7850, youngs_modulus: 2e9, poissons_ratio: 0}}}}
loads: {{pressure: [{{faces: {}, blast: {{charge: 8, center: {}, burst: {}}}}}]}}
output: {{history: {{every: 1e-4}}}}
)yaml",
                     faces, center, burst);
}

/// The integral of the pulse p (1 - s) exp(-b s) over 0 < s < 1, by Simpson's rule.
double integrate(const Pulse& curve, double start, double duration) {
  constexpr int steps = 20000;
  double sum = 0;
  for (int i = 0; i <= steps; ++i)
    sum += (i == 0 || i == steps ? 1 : i % 2 == 1 ? 4 : 2) * curve(start + duration * i / steps);
  return sum * duration / steps / 3;
}

}  // namespace

// Kingery and Bulmash (1984) for a hemispherical burst, by their polynomials of the common logarithm, of a charge of 1
// kg: distance, arrival, incident and reflected pressure, reflected impulse, duration, incident impulse. Swisdak gives
// his fits 1 % of them, 1.5 % of the incident impulse.
TEST(Blast, TheFitsAreThoseOfKingeryAndBulmash) {
  constexpr double table[][7] = {{1, 0.4675, 1357, 8145, 884.8, 1.737, 236.4},
                                 {3, 3.544, 115.7, 330.7, 224.3, 2.830, 92.75},
                                 {10, 21.64, 14.81, 31.54, 59.33, 4.788, 31.01},
                                 {30, 78.90, 3.559, 7.237, 18.76, 6.607, 10.63}};
  for (const auto& row : table) {
    const BlastWave wave = find_blast_wave(1, row[0]);
    EXPECT_NEAR(wave.arrival, row[1], 0.01 * row[1]) << row[0];
    EXPECT_NEAR(wave.incident, row[2], 0.01 * row[2]) << row[0];
    EXPECT_NEAR(wave.reflected, row[3], 0.01 * row[3]) << row[0];
    EXPECT_NEAR(wave.reflected_impulse, row[4], 0.01 * row[4]) << row[0];
    EXPECT_NEAR(wave.duration, row[5], 0.015 * row[5]) << row[0];
    EXPECT_NEAR(wave.incident_impulse, row[6], 0.015 * row[6]) << row[0];
  }
}

// Kingery and Bulmash (1984) for a spherical burst in free air, as above, by their polynomials evaluated apart.
TEST(Blast, TheWavesInAirAreThoseOfKingeryAndBulmash) {
  constexpr double table[][7] = {{0.2, 0.0384594, 15298, 157618, 6176.34, 0.189514, 225.788},
                                 {0.5, 0.154076, 3884.8, 30359.6, 1454.13, 0.319647, 141.287},
                                 {0.85, 0.393493, 1335.68, 7940.16, 693.092, 1.56612, 192.443},
                                 {1, 0.531839, 934.861, 5005.58, 559.034, 1.79487, 174.543},
                                 {2, 1.94397, 194.67, 645.829, 235.747, 1.8459, 92.1216},
                                 {3, 3.98744, 81.5889, 215.496, 147.083, 2.68455, 64.3306},
                                 {10, 22.7224, 11.0911, 23.313, 39.7149, 4.19952, 21.131},
                                 {30, 80.6197, 2.5335, 5.11874, 12.4851, 5.7307, 7.16196}};
  for (const auto& row : table) {
    const BlastWave wave = find_blast_wave(1, row[0], Burst::air);
    EXPECT_NEAR(wave.arrival, row[1], 1e-4 * row[1]) << row[0];
    EXPECT_NEAR(wave.incident, row[2], 1e-4 * row[2]) << row[0];
    EXPECT_NEAR(wave.reflected, row[3], 1e-4 * row[3]) << row[0];
    EXPECT_NEAR(wave.reflected_impulse, row[4], 1e-4 * row[4]) << row[0];
    EXPECT_NEAR(wave.duration, row[5], 1e-4 * row[5]) << row[0];
    EXPECT_NEAR(wave.incident_impulse, row[6], 1e-4 * row[6]) << row[0];
  }
}

// What the curves do not know of each other. In air of 101.325 kPa with an exponent of 7/5 a shock of overpressure p is
// reflected with 2 p (7 p0 + 4 p) / (7 p0 + p) and moves at 340.3 m/s sqrt(1 + 6 p / (7 p0)) (Rankine and Hugoniot).
// Beyond 1 m of 1 kg the polynomials keep the former to 1.5 %, the latter to 3 %; hotter air nearby is no ideal gas.
// Kinney and Graham, Explosive shocks in air (1985), give the incident pressure from other experiments: to 12 %.
TEST(Blast, TheWavesInAirAreShocks) {
  constexpr double air = 101.325;
  for (const double z : {1.0, 2.0, 3.0, 5.0, 10.0, 20.0}) {
    const BlastWave wave = find_blast_wave(1, z, Burst::air);
    const double p = wave.incident, reflected = 2 * p * (7 * air + 4 * p) / (7 * air + p);
    EXPECT_NEAR(wave.reflected, reflected, 0.015 * reflected) << z;
    const double speed = 0.3403 * std::sqrt(1 + 6 * p / (7 * air)), near = 1e-3 * z;
    const double delay =
        find_blast_wave(1, z + near, Burst::air).arrival - find_blast_wave(1, z - near, Burst::air).arrival;
    EXPECT_NEAR(delay, 2 * near / speed, 0.03 * delay) << z;
    const auto root = [&](double length) { return std::sqrt(1 + z * z / (length * length)); };
    const double kinney = air * 808 * (1 + z * z / (4.5 * 4.5)) / (root(0.048) * root(0.32) * root(1.35));
    EXPECT_NEAR(p, kinney, 0.12 * kinney) << z;
  }
}

// The ground reflects what a hemisphere sends down: it acts like a sphere of up to twice its mass, 1.8 of it as its
// crater takes the rest (UFC 3-340-02, 2008).
TEST(Blast, TheGroundStrengthensTheWave) {
  for (const double z : {1.0, 3.0, 10.0, 30.0}) {
    const double on_ground = find_blast_wave(1, z).incident;
    EXPECT_GT(on_ground, find_blast_wave(1, z, Burst::air).incident) << z;
    EXPECT_NEAR(on_ground, find_blast_wave(1.8, z, Burst::air).incident, 0.1 * on_ground) << z;
  }
}

TEST(Blast, LengthsAndTimesScaleWithTheCubeRootOfTheCharge) {
  const BlastWave one = find_blast_wave(1, 3), many = find_blast_wave(27, 9);
  EXPECT_NEAR(many.incident, one.incident, 1e-12 * one.incident);
  EXPECT_NEAR(many.arrival, 3 * one.arrival, 1e-12 * many.arrival);
  EXPECT_NEAR(many.reflected_impulse, 3 * one.reflected_impulse, 1e-12 * many.reflected_impulse);
}

TEST(Blast, ThePulseHasItsImpulse) {
  for (const double distance : {0.21, 0.5, 1.0, 2.5, 7.0, 25.0, 39.0}) {
    const BlastWave wave = find_blast_wave(1, distance);
    const double decay = find_decay(wave.reflected, wave.duration, wave.reflected_impulse),
                 slow = find_decay(wave.incident, wave.duration, wave.incident_impulse);
    const Pulse reflected{2, wave.duration, {wave.reflected, 0}, {decay, 0}};
    EXPECT_NEAR(integrate(reflected, 2, wave.duration), wave.reflected_impulse, 1e-6 * wave.reflected_impulse);
    const Pulse incident{2, wave.duration, {wave.incident, 0}, {slow, 0}};
    EXPECT_NEAR(integrate(incident, 2, wave.duration), wave.incident_impulse, 1e-6 * wave.incident_impulse);
    EXPECT_EQ(reflected(1.999), 0);
    EXPECT_NEAR(reflected(2), wave.reflected, 1e-12 * wave.reflected);
    EXPECT_EQ(reflected(2 + 1.001 * wave.duration), 0);
    const BlastWave in_air = find_blast_wave(1, distance, Burst::air);
    const double in_air_decay = find_decay(in_air.reflected, in_air.duration, in_air.reflected_impulse);
    const Pulse pulse{2, in_air.duration, {in_air.reflected, 0}, {in_air_decay, 0}};
    EXPECT_NEAR(integrate(pulse, 2, in_air.duration), in_air.reflected_impulse, 1e-6 * in_air.reflected_impulse);
  }
}

// The integral of p (1 - s) exp(-b s) over all s is 1/b - 1/b^2.
TEST(Blast, TheNegativePhaseTakesImpulse) {
  const double decay = 2.5, duration = 3, all = duration * (1 / decay - 1 / (decay * decay));
  const Pulse pulse{1, duration, {7, 0}, {decay, 0}, true};
  EXPECT_NEAR(integrate(pulse, 1, 15 * duration), 7 * all, 1e-5 * 7 * all);
  EXPECT_LT(pulse(1 + 1.5 * duration), 0);
}

TEST(Blast, TheAngleOfIncidenceDividesItIntoBothWaves) {
  const Units si = *find_units("m, kg, s");
  for (const Burst burst : {Burst::ground, Burst::air}) {
    const BlastDeck blast{8, {0, 0, 0}, 0, false, burst};
    const BlastWave wave = find_blast_wave(8, 10, burst);
    const double arrival = 1e-3 * wave.arrival * (1 + 1e-12);
    const auto peak = [&](double degrees) {
      const double angle = degrees * std::acos(-1.0) / 180;
      return find_blast_pulse(blast, si, {10, 0, 0}, {-std::cos(angle), std::sin(angle), 0})(arrival);
    };
    EXPECT_NEAR(peak(0), 1e3 * wave.reflected, 1e-6 * 1e3 * wave.reflected);
    EXPECT_NEAR(peak(90), 1e3 * wave.incident, 1e-6 * 1e3 * wave.incident);
    EXPECT_NEAR(peak(180), 1e3 * wave.incident, 1e-6 * 1e3 * wave.incident);
    const double oblique = 0.25 * wave.reflected + 0.25 * wave.incident;  // at 60 degrees: 1 + 1/4 - 1
    EXPECT_NEAR(peak(60), 1e3 * oblique, 1e-6 * 1e3 * oblique);
  }
}

TEST(Blast, ABodyGetsTheReflectedImpulse) {
  const Outcome run = run_deck(make_scene("cube/x_min"));
  // Pa s on 0.01 m^2; half a step of the front is 0.1 %; the middles of the faces are off the axis by 0.025 sqrt(2) m
  // in 10 m, whose square counts.
  const double impulse = find_blast_wave(8, 10).reflected_impulse * 0.01;
  fmt::print("impulse {:.6g}, of the curve {:.6g}\n", run.history.last("momentum_x"), impulse);
  EXPECT_NEAR(run.history.last("momentum_x"), impulse, 2e-3 * impulse);
  EXPECT_LT(run.summary.momentum.linear_error, 1e-12);
  EXPECT_LT(std::abs(run.summary.energy.error), 1e-5);
  // It begins with the arrival.
  const double arrival = 1e-3 * find_blast_wave(8, 10).arrival;
  EXPECT_EQ(run.history.at(0.98 * arrival, "momentum_x"), 0);
  EXPECT_GT(run.history.at(1.02 * arrival, "momentum_x"), 0);
}

TEST(Blast, ABodyGetsTheReflectedImpulseOfABurstInAir) {
  const Outcome run = run_deck(make_scene("cube/x_min", "[-10, 0.05, 0.05]", "air"));
  const double impulse = find_blast_wave(8, 10, Burst::air).reflected_impulse * 0.01;
  fmt::print("impulse {:.6g}, of the curve {:.6g}\n", run.history.last("momentum_x"), impulse);
  EXPECT_NEAR(run.history.last("momentum_x"), impulse, 2e-3 * impulse);
  EXPECT_LT(std::abs(run.summary.energy.error), 1e-5);
}

TEST(Blast, OtherUnitsGiveTheSame) {
  const Outcome si = run_deck(make_scene("cube"));
  const Outcome other = run_deck(R"yaml(
units: mm, t, s
time: {end: 0.03, max_step: 5e-6}
parts: {cube: {box: {size: [100, 100, 100], cells: [2, 2, 2]}, material: steel}}
materials: {steel: {model: elastic, density: 7850e-12, youngs_modulus: 2e3, poissons_ratio: 0}}
loads: {pressure: [{faces: cube, blast: {charge: 8e-3, center: [-10e3, 50, 50]}}]}
output: {history: {every: 1e-4}}
)yaml");
  const double momentum = si.history.last("momentum_x");
  EXPECT_GT(momentum, 0);
  EXPECT_NEAR(other.history.last("momentum_x"), momentum, 1e-9 * momentum);  // t mm / s is kg m / s
}

TEST(Blast, FacesBeyondTheCurvesAreRefused) {
  const auto refuse = [](const std::string& center, const std::string& text, const std::string& burst = "ground",
                         const std::string& range = "the curves reach from 0.2 to 40") {
    try {
      run_deck(make_scene("cube/x_min", center, burst));
      FAIL();
    } catch (const InputError& error) {
      EXPECT_THAT(error.what(), HasSubstr(text));
      EXPECT_THAT(error.what(), HasSubstr(range));
    }
  };
  refuse("[-0.1, 0.05, 0.05]", "element 1 of part 'cube' is at a scaled distance of 0.053");
  refuse("[-100, 0.05, 0.05]", "is at a scaled distance of 50 m/kg^(1/3) from the charge");
  refuse("[-0.2, 0.05, 0.05]", "is at a scaled distance of 0.1", "air", "the curves reach from 0.147 to 40");
}

}  // namespace percuss::test::blast_test
