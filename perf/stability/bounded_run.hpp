#pragma once
// Runs of a scene at any share of its step bound, with a verdict: did the motion stay bounded?

#include <string>
#include <vector>

#include "src/deck/deck.hpp"

namespace percuss {

struct BoundedRun {
  double scale = 0;  // of the step bound
  bool is_bounded = false;
  std::string outcome;  // "bounded", or what ended it
  long steps = 0;
  double energy_error = 0;  // magnitude at the last audit
  double growth = 0;        // largest kinetic energy over what the scene was given, sum m v(n-1/2)^2 / 2
};

/// Runs the deck with step_scale = scale, which may exceed 1. noise: largest component of a velocity, the same for the
/// same mesh, that each free node is given on top of the deck's. Stops at the first sign of instability: an element
/// fails, the balance of energy leaves the deck's audit, kinetic energy exceeds `most_growth` of what the scene was
/// given.
BoundedRun run_bounded(const Deck& deck, double scale, double noise);

/// Bisects for the largest scale that stays bounded between low, which is taken to, and high, until they are within
/// `tolerance` of each other. Every trial in its order: first high, then low if that is not bounded, then the rest.
std::vector<BoundedRun> search_largest_scale(const Deck& deck, double low, double high, double tolerance, double noise);

}  // namespace percuss
