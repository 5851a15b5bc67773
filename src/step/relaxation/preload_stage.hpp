#pragma once
// Preloads: the layer of elements that a plane cuts gets shorter at rest along the normal, as a bolt does by the turn
// of its nut, until the section has the force that the deck gives it. Of beams without a plane each gets shorter along
// its axis, until it has the force.
//
// In each step the layer loses a share of the length that the force lacks: a strain e without stress along the normal
// n, so that the stress grows by C : (e n n). From time 0 on the layer is like any other.

#include <functional>
#include <optional>
#include <vector>

#include "kernels/material/elastic.hpp"
#include "src/step/forces/force_sources.hpp"
#include "src/step/model/state.hpp"

namespace percuss {

class PreloadStage {
 public:
  /// Collective. Throws InputError with the deck's place, the same on all ranks: a plane that cuts no element of the
  /// part, a part without beams. deck outlives this.
  PreloadStage(const Deck& deck, const ChunkedMesh& chunked, const Model& model);

  bool any() const { return !layers_.empty(); }

  /// Finds how much force a shortening of each layer gives. evaluate: computes the forces of the state, at rest.
  /// Collective.
  void measure_stiffness(State& state, const std::function<void()>& evaluate);

  /// Brings the sections nearer to this share of their preloads. Call with the forces of the state. Collective.
  void tighten(State& state, double share);

  /// Mean length of the elements of each layer along the normal, or along its beams. Collective.
  std::vector<double> find_lengths(const State& state) const;

  /// Largest lack of a section in the last call, relative to its preload.
  double largest_lack() const { return largest_lack_; }
  /// The preload of the deck that lacks that.
  std::size_t largest_lacking() const { return largest_lacking_; }

  /// Normal forces in the last call, in the order of the deck; of beams that which lacks most.
  const std::vector<double>& forces() const { return forces_; }

 private:
  /// Part of a node's place in the length of an element.
  struct Corner {
    int node = 0;
    Vec3 share;
  };

  /// The elements of a rank that get shorter, by chunk.
  struct Layer {
    const PreloadDeck& deck;
    std::optional<SectionForce> section;  // none: each beam has the force
    LameConstants moduli;
    bool is_kirchhoff = false;    // whether the law has the rate of J sigma
    double stiffness = 0;         // of the section, force over strain
    Array<int> chunks;            // that have some
    Array<int> first;             // [chunks + 1] of the next three
    Array<int> elements;          // counted from the first of the chunk
    Array<double> volume;         // of solids at time 0
    Array<double> axes;           // [elements][2] the normal in the frame of a shell, or along a beam
    std::vector<Corner> corners;  // of all elements
  };

  static Layer make_layer(const Deck& deck, const PreloadDeck& preload);
  void find_elements(const ChunkedMesh& chunked, Layer& layer) const;
  [[noreturn]] void refuse_no_elements(const Mesh& mesh, const PreloadDeck& preload) const;
  void shorten(const Layer& layer, double strain, State& state) const;
  double shorten_beams(const Layer& layer, double force, State& state) const;
  std::vector<double> find_forces(const State& state);

  const Deck& deck_;
  const Model& model_;
  const double gain_;
  std::vector<Layer> layers_;
  std::vector<double> forces_;
  double largest_lack_ = 0;
  std::size_t largest_lacking_ = 0;
};

}  // namespace percuss
