#pragma once
// Edges of a smooth surface that become sharp in the run: where faces fold, edges touch edges from then on. So do the
// ridges across faces that warp.
//
// All edges are checked periodically, whatever else happens: which edges are folds depends only on the states at these
// steps.

#include <vector>

#include "src/contact/surface/edge_sides.hpp"
#include "src/deck/deck.hpp"
#include "src/output/checkpoint/checkpoint_archive.hpp"

namespace percuss {

/// Steps between two checks, and between those that make a new surface for any fold: one for a single edge costs as
/// much as one for many. Between these only edges that fold fast make one.
constexpr long fold_steps = 32, slow_fold_steps = 256;

/// Angles between the faces of an edge at which it is a fold [degrees].
struct FoldAngles {
  double least;  // less is never one: flush flat faces get no rows where their meshes cross
  double bend;   // more than at the start, or the angle of feature edges; smooth bodies that roll stay as they are
  double slack;  // less by this than what made it a fold, it is one no longer
  double fast;   // more by this than what makes it a fold, it folds fast
};
constexpr FoldAngles fold_angles{10, 5, 5, 10};
/// Fold angles of the diagonals of a face, which get rows only where its fan is crossed. At 10 degrees the fan is 0.03
/// of an element behind its ridge.
constexpr FoldAngles ridge_angles{5, 5, 3, 5};

/// When an edge changes.
struct FoldRule {
  int is_solid, is_fold;  // 1: of solids, by which only convex edges fold; has folded
  // Cosines between the normals of its faces: less makes it a fold, a fast one, more ends that.
  double sharp, fast, smooth;
};

/// Change of an edge.
enum class FoldChange { none, slow, fast };

/// A side of an edge by mesh nodes of this rank.
struct WatchedSide {
  int ends[2], wings[2];  // as of EdgeSide
  int turn;               // 1 if the face runs from end 0 to end 1, else -1
};

/// An edge where two faces meet that are both this rank's, or a diagonal of one.
struct WatchedEdge {
  WatchedSide side, other;
  FoldRule rule;
};

class FoldWatch {
 public:
  /// Mesh and deck outlive this.
  FoldWatch(const ChunkedMesh& chunked, const ContactDeck& contact, const Communicator& ranks)
      : chunked_(chunked), ranks_(ranks), is_active_(has_edge_contact(contact)) {}

  /// Whether the edges are looked at after this step.
  bool is_due(long step) const { return is_active_ && step % fold_steps == 0; }

  /// The share has other faces now.
  void redefine() { has_edges_ = false; }

  /// Looks at all edges at positions x after a step. Returns whether folds() are others now. Collective.
  bool look(const SurfaceShare& share, const Rows3<const double>& x, long step);

  /// Folds of all ranks, ascending.
  const std::vector<EdgeEnds>& folds() const { return folds_; }

  /// Returns whether folds were loaded. Collective.
  bool archive(CheckpointArchive& archive, const SurfaceShare& share);

  // Kernels of its own: nvcc takes none in a private function.
  std::int64_t look_at_own(const Rows3<const double>& x, FoldChange least, std::vector<EdgeEnds>& changed) const;
  std::int64_t look_at_shared(const Rows3<const double>& x, FoldChange least, std::vector<EdgeEnds>& changed) const;
  void note_own(const std::vector<EdgeEnds>& changed);

 private:
  /// An edge with a side of another rank, whose lower node is this rank's.
  struct SharedEdge {
    EdgeEnds ends;
    int side, other;  // places among the shapes of this rank's own sides; beyond these among the received
    FoldRule rule;
  };

  void list_edges(const SurfaceShare& share);
  void list_diagonals(const SurfaceShare& share, const std::vector<char>& touches);
  bool is_fold(const EdgeEnds& ends) const { return std::binary_search(folds_.begin(), folds_.end(), ends); }
  void note(std::vector<EdgeEnds> changed);

  const ChunkedMesh& chunked_;
  const Communicator ranks_;
  const bool is_active_;
  std::vector<EdgeEnds> folds_;
  bool has_edges_ = false;  // of the share as it is
  std::vector<WatchedEdge> own_;
  Array<WatchedEdge> own_edges_;  // these
  std::vector<SharedEdge> shared_;
  Array<const WatchedSide> sides_;  // of which other ranks must know, and those of shared edges
  std::vector<int> sent_to_;        // ranks, of the first of these
};

}  // namespace percuss
