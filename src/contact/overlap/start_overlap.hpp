#pragma once
// Overlap between surfaces: what a scene starts with, and what an audit finds.

#include "src/contact/history/carried_history.hpp"
#include "src/contact/overlap/flush_ties.hpp"
#include "src/contact/overlap/start_crossings.hpp"
#include "src/contact/search/contact_finder.hpp"
#include "src/contact/search/reuse_bound.hpp"

namespace percuss {

/// Overlap between two parts, or of a part with a wall.
struct PartOverlap {
  int part = 0;            // of the nodes
  int other = 0;           // of the faces; -1 - w: wall w
  std::int64_t nodes = 0;  // contact nodes of `part` inside `other`
  double deepest = 0;      // [length]
};

/// Overlap at the start: what was found, on all ranks, and taken into the history.
struct StartOverlap {
  std::int64_t nodes = 0;          // contact nodes inside another body or behind a wall
  std::int64_t too_deep = 0;       // of these, deeper than contact can hold
  double deepest = 0;              // [length]
  std::int64_t deepest_node = -1;  // number of the node, lowest of equals
  std::vector<PartOverlap> parts;  // by (part, other)
  std::vector<PartOverlap> lost;   // likewise, of nodes in a cylinder that ends, too deep for it to stop them
  std::int64_t edge_pairs = 0;     // pairs of edges inside one another
  double deepest_edges = 0;        // [length]
  std::vector<PartGap> gaps;       // of parts within reach of each other; negative: how far they are inside
  std::vector<PartCrossing> crossings;
  std::vector<std::int64_t> inside;  // numbers of the nodes, of this rank alone, one for each that holds it
};

/// Context of a search for overlap. At the start and after erosion the finder is that of the run, whose pairs are used
/// or searched again; audits bring one of their own.
struct OverlapSearch {
  const Communicator& ranks;
  const SurfaceShare& share;
  const WallPairs& walls;
  const ReuseBound& bound;
  ContactFinder& finder;
  const FlushTies& tied;  // what overlaps at a tie is accepted, and is not counted

  /// Margin of boxes that find nodes half a face deep, with the reach of the check. Collective.
  double find_margin(const SurfaceMotion& motion) const;
  /// Searches at these positions with such boxes.
  void search_everywhere(const SurfaceMotion& motion) const { finder.search(motion, find_margin(motion)); }
};

/// Faces, nodes and walls that may be touched from now on, and are not yet in the history.
struct BornContact {
  std::vector<std::int64_t> faces;  // numbers of faces of the pairs of surfaces, of all ranks, ascending
  std::vector<std::int64_t> nodes;  // numbers of their corners, likewise
  std::vector<char> walls;          // [walls of the deck]
};

/// Takes overlap at the positions of `motion`, whose dt is 0, into a history in use, as seed_history() does: only that
/// of these faces, of the edges between these nodes, and of these walls. Looks at the candidate pairs that the finder
/// has. Collective.
StartOverlap seed_born(const OverlapSearch& search, const SurfaceMotion& motion, const BornContact& born,
                       ContactHistory& history);

/// Finds overlap at the positions of `motion`, whose dt is 0, and writes it to the history: as accepted reference,
/// which is to be pushed out where the history says so. Collective.
StartOverlap seed_history(const OverlapSearch& search, const SurfaceMotion& motion, ContactHistory& history);

/// The surface before and after it was redefined by erosion or released ties.
struct SurfaceChange {
  const HistoryOwners& before;
  const HistoryOwners& now;
  const std::vector<std::int64_t>& released_nodes;  // numbers of nodes that were tied, of all ranks, ascending
  const std::vector<std::int64_t>& released_faces;  // numbers of this rank's faces that were
};

/// The edges before and after ties were released, or others have folded.
struct EdgeChange {
  const std::vector<EdgeTopology>& before;
  const std::vector<EdgeTopology>& now;
  const std::vector<std::int64_t>& released_nodes;  // as of SurfaceChange
};

/// Joins to the gaps those of tied parts, and of parts that overlap or cross.
void complete_gaps(const std::vector<PartGap>& tied, StartOverlap& found);

/// Describes the overlap and what becomes of it; empty if there is none. Warnings of it are those of src/checks.
/// deepest_id: the user's of deepest_node. when: "at the start".
std::string describe_overlap(const StartOverlap& found, ContactDeck::Overlap overlap, const Mesh& mesh,
                             std::int64_t deepest_id, const std::string& when);

/// How much of it is left at the end.
std::string describe_overlap_left(const StartOverlap& left);

/// Bound of the sum of the squares of the depths that contact is to push out [length^2]; 0 where overlap is accepted.
double find_pushed_square(const StartOverlap& found, ContactDeck::Overlap overlap);

/// Takes overlap at the positions of `motion`, whose dt is 0, into the history, as seed_history() does: only that of
/// new nodes and faces, and of those that were tied. Records of the surfaces before stay. Looks at the candidate pairs
/// that the finder has. Collective.
void seed_opened(const OverlapSearch& search, const SurfaceMotion& motion, const SurfaceChange& change,
                 ContactHistory& history);

/// Numbers of this rank's edges whose overlap has cost nothing: new ones, blunt ones that have folded, and those with
/// an end that was tied.
std::vector<std::int64_t> list_fresh_edges(const EdgeChange& change);

/// As seed_opened(), for pairs of edges of which one has folded, or has an end that was tied. No work was done against
/// their overlap, and it is accepted. Records that are there stay.
void seed_edges(const OverlapSearch& search, const SurfaceMotion& motion, const EdgeChange& change,
                EdgeHistory& history);

/// Deepest penetration / shortest edge, faces and walls, on any rank. Collective.
double find_deepest_penetration(const OverlapSearch& search, const SurfaceMotion& motion);

}  // namespace percuss
