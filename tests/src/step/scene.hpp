#pragma once
// A scene as run_scene holds it, open for tests: deck, mesh, model, state and stepper.

#include <algorithm>
#include <array>
#include <string>
#include <utility>

#include "kernels/core/host_copy.hpp"
#include "src/deck/reading/read_deck.hpp"
#include "src/mesh/decomposition/decompose.hpp"
#include "src/step/step.hpp"

namespace percuss::test {

/// Built once from a deck; not copied, because the stepper refers to the other members.
struct Scene {
  explicit Scene(Deck from, const Communicator& ranks = Communicator::world())
      : deck(std::move(from)),
        chunked(load_mesh(deck, ranks)),
        model(build_model(deck, chunked)),
        contact(chunked, deck, ranks),
        state(make_initial_state(model)),
        stepper(deck, chunked, model, contact) {}
  explicit Scene(const std::string& text, const Communicator& ranks = Communicator::world())
      : Scene(parse_deck(text, "deck.yaml"), ranks) {}
  Scene(const Scene&) = delete;
  Scene& operator=(const Scene&) = delete;

  /// Starts the stepper and advances it.
  void run(int steps) {
    stepper.start(state);
    for (int i = 0; i < steps; ++i) stepper.advance(state);
  }

  Deck deck;
  ChunkedMesh chunked;
  Model model;
  ContactStage contact;
  State state;
  Stepper stepper;
};

/// Column sums of rows of three.
inline Vec3 sum_rows(const Rows3<double>& rows) {
  const auto host = to_host(rows);
  Vec3 sum{};
  for (std::size_t i = 0; i < host.extent(0); ++i) {
    for (std::size_t k = 0; k < 3; ++k) sum[k] += host(i, k);
  }
  return sum;
}

/// Largest absolute value of rows of three.
inline double find_largest(const Rows3<double>& rows) {
  const auto host = to_host(rows);
  double largest = 0;
  for (std::size_t i = 0; i < host.extent(0); ++i) {
    for (std::size_t k = 0; k < 3; ++k) largest = std::max(largest, std::abs(host(i, k)));
  }
  return largest;
}

/// Materials that most tests use: c = 5048 m/s for bars of steel.
inline const std::string steel_text = R"(
materials:
  steel: {model: elastic, density: 7850, youngs_modulus: 200e9, poissons_ratio: 0.3}
)";

}  // namespace percuss::test
