#pragma once
// What lies inside another body and is not held by contact: it came there where no check saw it.

#include <algorithm>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "src/contact/overlap/pierced_faces.hpp"
#include "src/contact/overlap/start_overlap.hpp"

namespace percuss {

/// How something lies in what no contact keeps it out of.
enum class MissedWay { inside, across_edge, through };

/// The deepest node or edge, as a share of the size of what it is inside of.
struct MissedContact {
  double ratio = 0, depth = 0;  // share of an element, [length]
  std::int64_t node = -1;       // number; of an edge its lower end
  bool is_edge = false;
  int part = -1, other = -1;  // index into Mesh::parts; -1: of edges that cross edges
  MissedWay way = MissedWay::inside;
  double x[3] = {0, 0, 0};  // [length]
};

/// Contact that is not missed. What lies beside the rim of a shell, within its thickness, is not inside it.
struct KnownContact {
  std::vector<std::int64_t> inside;  // numbers of this rank's nodes that began inside another body, ascending
  std::vector<char> of_shells;       // [parts of the mesh]
  bool holds_deep = false;           // contact may hold what is deep: springs give way, or overlap has been accepted

  bool is_of_shells(int part) const { return of_shells[static_cast<std::size_t>(part)] != 0; }
  bool has_shells() const { return std::find(of_shells.begin(), of_shells.end(), 1) != of_shells.end(); }
};

/// Part of the surface that find_missed_contact() has to check: no nodes, on all ranks, if no node may be in the box of
/// a face that counts. Collective.
LookedAt find_watched(const OverlapSearch& search, const SurfaceMotion& motion, const ContactHistory& history,
                      const KnownContact& known);

/// Searches at the positions of `motion`, whose dt is 0, for what is inside another body by more than a tenth of an
/// element without a record in the history: nodes of solids in solids, and, where the scene has no shells, edges that
/// have crossed others. at: of find_watched(). Empty: nothing. The same on all ranks. Collective.
std::optional<MissedContact> find_missed_contact(const OverlapSearch& search, const SurfaceMotion& motion,
                                                 const ContactHistory& history, const LookedAt& at,
                                                 const KnownContact& known);

/// Result of find_missed_edge(), and the tests of points and boxes that it took.
struct MissedEdge {
  std::optional<MissedContact> missed;
  std::int64_t tests = 0;
};

/// Looks for sharp edges of solids and shells inside bodies of solids by more than a tenth of an element, which entered
/// between nodes. Where contact holds the edge or an end, and may hold deep overlap, by more than it can hold. Searches
/// nothing. Collective.
MissedEdge find_missed_edge(const OverlapSearch& search, const Rows3<const double>& x, const ContactHistory& history,
                            const KnownContact& known);

/// Looks for edges that go through sheets by more than a tenth of an element, or through their own body by more than
/// half of one; where contact holds an end, as find_missed_edge(). found: of all ranks. Collective.
std::optional<MissedContact> find_missed_piercing(const OverlapSearch& search, const ContactHistory& history,
                                                  const KnownContact& known, const std::vector<PiercingEdge>& found);

/// "node 17 of part 'ball' lies 0.01 (0.8 of an element) inside part 'sheet' at (...) and no contact holds it".
std::string describe_missed_contact(const MissedContact& missed, const Mesh& mesh, std::int64_t id);

}  // namespace percuss
