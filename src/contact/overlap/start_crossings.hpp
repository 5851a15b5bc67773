#pragma once
// Parts that cross at the start: edges of one go through faces of the other, wherever their nodes are, whether they may
// touch each other or not.

#include <array>
#include <string>
#include <vector>

#include "comm/communicator.hpp"
#include "src/contact/surface/surface_share.hpp"
#include "src/contact/surface/tied_surfaces.hpp"
#include "src/deck/deck.hpp"

namespace percuss {

/// Two parts of which one goes through the other, or one that goes through itself.
struct PartCrossing {
  /// When they may touch each other where they cross: as the deck is, only while a sensor has it so, or now.
  enum class Contact { never, later, now };

  int part = 0, other = 0;  // part <= other
  Contact contact = Contact::never;
  bool is_of_solids = false;                  // both
  double depth = 0, size = 0;                 // largest; of the elements there, or thickness of shells [length]
  Vec3 deepest{};                             // place of the depth [length]
  std::vector<std::array<double, 3>> places;  // where edges go through faces [length]

  /// Deeper than chords of curved meshes that touch, or than round-off.
  bool is_deep() const;
  /// Diagonal of the box of its places [length].
  double find_extent() const;
  /// "(1, 2, 3)" of `deepest`.
  std::string name_place() const;
};

struct CrossingScene {
  const Communicator& ranks;
  const ChunkedMesh& chunked;
  const Deck& deck;
  const SurfaceShare& share;
  const TiedSurfaces& ties;
};

/// Crossings at the places x that are deeper than round-off, by (part, other), the same on all ranks. Left out: parts
/// of one rigid body or of one joint, and what ties, constraints and solids around embedded nodes hold. Collective.
std::vector<PartCrossing> find_crossings(const CrossingScene& scene, const Rows3<const double>& x);

/// Text with `before`, and "'a' and 'b' by 5 at (1, 2, 3), ..." of the deep ones of one kind, deepest first, a few of
/// them; empty if there are none.
std::string describe_crossings(const std::string& before, PartCrossing::Contact contact,
                               const std::vector<PartCrossing>& crossings, const Mesh& mesh);

/// Names the deep ones that may touch `now`, and that `overlap` refuses: all, or with push_out those of sheets, or too
/// deep to be pushed out. Empty: none.
std::string describe_refused_crossings(const std::vector<PartCrossing>& crossings, ContactDeck::Overlap overlap,
                                       const Mesh& mesh);

}  // namespace percuss
