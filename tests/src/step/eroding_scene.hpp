#pragma once
// A scene that erodes, open for tests: any element can be killed at any time.

#include <vector>

#include "src/mesh/hex_geometry.hpp"
#include "src/step/audit/audit.hpp"
#include "src/step/erosion.hpp"
#include "src/step/model/whole_mesh.hpp"
#include "tests/src/step/scene.hpp"

namespace percuss::test {

struct ErodingScene {
  explicit ErodingScene(const std::string& text, const Communicator& ranks = Communicator::world())
      : ErodingScene(parse_deck(text, "deck.yaml"), ranks) {}
  explicit ErodingScene(Deck from, const Communicator& ranks = Communicator::world())
      : scene(std::move(from), ranks),
        erosion(scene.deck, scene.chunked, scene.model, scene.contact),
        audit(scene.model) {
    if (scene.contact.is_active()) scene.contact.prepare(scene.state.x, scene.state.v);
    scene.stepper.start(scene.state);
    audit(scene.state);
  }

  void advance() {
    scene.stepper.advance(scene.state);
    if (!scene.state.bound.died) return;
    ++events;
    erosion.redefine(scene.state, scene.stepper.bookkeeper());
    scene.stepper.drop_vanished(scene.state);
  }
  void run(int steps) {
    for (int i = 0; i < steps; ++i) advance();
  }

  /// Lets the elements with these centres at time 0 fail now: they are dead after the next step.
  void kill(const std::vector<Vec3>& centers) {
    const auto steps_left = to_host(scene.state.lives.steps_left);
    const auto force_share = to_host(scene.state.lives.force_share), work_share = to_host(scene.state.lives.work_share);
    const auto first_pack = to_host(scene.model.failing.first_pack);
    constexpr int width = pack_size<double>;
    for (std::size_t c = 0; c < scene.chunked.chunks.size(); ++c) {
      const Chunk& chunk = scene.chunked.chunks[c];
      for (int i = 0; i < chunk.element_count; ++i) {
        const Vec3 center = find_center(chunk.first_element + i);
        for (const Vec3& wanted : centers) {
          if (std::hypot(center[0] - wanted[0], center[1] - wanted[1], center[2] - wanted[2]) > 1e-6) continue;
          const auto lane = static_cast<std::size_t>(first_pack(c) * width + i);
          const LifeShares shares = find_life_shares(1, 1);
          steps_left(lane) = 1;
          force_share(lane) = shares.force;
          work_share(lane) = shares.work;
        }
      }
    }
    Kokkos::deep_copy(scene.state.lives.steps_left, steps_left);
    Kokkos::deep_copy(scene.state.lives.force_share, force_share);
    Kokkos::deep_copy(scene.state.lives.work_share, work_share);
    Kokkos::deep_copy(scene.state.results.is_settled, 0);
  }

  Vec3 find_center(int element) const {
    const Mesh& mesh = scene.chunked.mesh;
    return percuss::find_center(gather_corners(mesh.elements, static_cast<std::size_t>(element), mesh.nodes));
  }

  /// Least and largest value of component k of a row array over this rank's nodes of a part, and over all ranks.
  double find_least(const Rows3<double>& rows, const std::string& part, std::size_t k) const {
    const auto host = to_host(rows);
    double least = 1e300;
    for (const int n : scene.chunked.mesh.node_sets.at(part))
      least = std::min(least, host(static_cast<std::size_t>(n), k));
    MPI_Allreduce(MPI_IN_PLACE, &least, 1, MPI_DOUBLE, MPI_MIN, scene.model.ranks.handle());
    return least;
  }
  double find_largest_of(const Rows3<double>& rows, const std::string& part, std::size_t k) const {
    const auto host = to_host(rows);
    double largest = -1e300;
    for (const int n : scene.chunked.mesh.node_sets.at(part))
      largest = std::max(largest, host(static_cast<std::size_t>(n), k));
    MPI_Allreduce(MPI_IN_PLACE, &largest, 1, MPI_DOUBLE, MPI_MAX, scene.model.ranks.handle());
    return largest;
  }

  Scene scene;
  Erosion erosion;
  Audit audit;
  int events = 0;
};

}  // namespace percuss::test
