#pragma once
// Operations of one element in one step, counted by running its own code on a scalar that counts.

#include "perf/micro/counted.hpp"
#include "src/deck/deck.hpp"

namespace percuss {

/// material: "elastic" or "j2_plasticity"; element: as elements.hourglass of the deck, or "full". From the corners'
/// positions and velocities to the corners' forces, without gathering and adding up. What the compiler finds twice and
/// computes once is counted twice (a few reciprocals).
OperationCounts count_operations(const std::string& material, const std::string& element);

}  // namespace percuss
