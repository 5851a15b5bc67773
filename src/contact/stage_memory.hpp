#pragma once
// Everything that one contact stage holds between steps, and what it does with it. Internal to src/contact.

#include <cstdint>
#include <string>
#include <vector>

#include "kernels/contact/capture_boxes.hpp"
#include "kernels/contact/enforcement.hpp"
#include "kernels/contact/penetration.hpp"
#include "src/contact/build_surface.hpp"
#include "src/contact/contact_stage.hpp"

namespace percuss {

/// Memory of one search and of the checks of its pairs. The stage has one for the run and one for audits.
struct SearchMemory {
  explicit SearchMemory(const ContactSurface& surface);
  Boxes boxes;
  SearchScratch scratch;
  CandidateList candidates;
  FaceState faces;
};

/// Finds candidate pairs for boxes widened by `margin`; throws RunError if there are absurdly many.
void search_pairs(const ContactSurface& surface, const SurfaceMotion& motion, double margin,
                  const Array<const int>& history_face, SearchMemory& memory);

/// Whether candidate pairs may be used again: a bound on the motion since the search that found them.
class ReuseBound {
 public:
  ReuseBound(const ContactSurface& surface, bool enabled);

  /// Whether the pairs of the last search still hold all that the check could accept in this step.
  bool covers(const ContactSurface& surface, const SurfaceMotion& motion) const;

  /// Starts anew at this step's places; returns the margin by which capture boxes must be widened.
  double restart(const ContactSurface& surface, const SurfaceMotion& motion);

 private:
  bool enabled_;
  bool valid_ = false;
  double margin_ = 0;
  Rows3<double> origin_;
};

/// An empty history.
ContactHistory make_history(const ContactSurface& surface, const WallPairs& walls);

/// Overlap at the start: what was found and taken into the history.
struct StartOverlap {
  int nodes = 0;     // contact nodes inside another body or behind a wall
  int too_deep = 0;  // of these, deeper than contact can hold
  double deepest = 0;
  int deepest_node = -1;  // contact node
};

/// Finds overlap at the places of `motion` and writes it to the history: as accepted reference, or to be pushed out.
StartOverlap seed_history(const ContactSurface& surface, const WallPairs& walls, const SurfaceMotion& motion,
                          ContactDeck::Overlap overlap, const ContactHistory& history);

/// Deepest penetration / shortest edge, faces and walls.
double find_deepest_penetration(const ContactSurface& surface, const WallPairs& walls, const Rows3<const double>& x);

}  // namespace percuss
