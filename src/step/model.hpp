#pragma once
// What a run never changes after set-up: connectivity in chunks, masses, materials, conditions and loads.

#include <cstdint>
#include <string>
#include <vector>

#include "kernels/core/views.hpp"
#include "kernels/element/internal_force.hpp"
#include "kernels/node/conditions.hpp"
#include "kernels/node/motion.hpp"
#include "kernels/node/pressure.hpp"
#include "src/deck/deck.hpp"
#include "src/mesh/mesh.hpp"
#include "src/mesh/ordering.hpp"

namespace percuss {

/// A prescribed motion: one curve for one direction of one condition.
struct Motion {
  Curve curve;
  bool is_displacement = false;
};

struct Model {
  int node_count = 0;
  int element_count = 0;

  HexChunks chunks;
  HexBlocks blocks;
  std::size_t state_size = 0;  // scalars of all element records

  NodeSlots nodes_to_slots;
  int slot_count = 0;  // chunk slots, then four a pressure face

  Rows3<double> start;           // position at time 0
  Rows3<double> start_velocity;  // velocity at time 0
  Array<double> element_mass;    // at time 0; it does not change
  Array<double> mass;            // lumped: an eighth of each element's mass to its corners
  Rows3<double> inverse_mass;    // 0 in held directions
  double total_mass = 0;
  Vec3 mass_center{};  // at time 0; moments are taken about it

  Gravity gravity;
  PressureFaces pressure_faces;
  std::vector<Curve> pressures;  // by load
  HeldDirections held;
  std::vector<Motion> motions;  // by HeldDirections::motion; row 0 is "at rest"
  bool is_driven = false;       // whether a prescribed motion other than rest exists
};

/// Builds the model of a chunked mesh. Throws InputError with the deck's place: unknown sets, contradicting conditions.
Model build_model(const Deck& deck, const ChunkedMesh& chunked);

}  // namespace percuss
