#pragma once
// Who may touch whom: the deck's named surfaces as classes of nodes and faces and a table of pairs.

#include <vector>

#include "src/contact/surface/tied_surfaces.hpp"
#include "src/deck/deck.hpp"
#include "src/mesh/mesh.hpp"

namespace percuss {

/// Numbers of named surfaces, ascending: 2 p and 2 p + 1 are the sides a and b of the deck's pair p;
/// then those of its ties, side a as far as it is tied; then those of its table of friction; then the rigid bodies.
using SurfaceSet = std::vector<int>;

/// How a node may touch a face.
struct PairRule {
  int pair = -1;         // of the deck, -1: not at all; 0 where all may touch all
  double friction = -1;  // Coulomb's coefficient; negative: may not touch
};

/// The deck's pairs of surfaces, walls and ties that act now, by their place in the deck. Empty: all do.
struct ActiveContact {
  std::vector<char> pairs, walls, ties;

  bool has_pair(std::size_t pair) const { return pairs.empty() || pairs[pair] != 0; }
  bool has_wall(std::size_t wall) const { return walls.empty() || walls[wall] != 0; }
  bool has_tie(std::size_t tie) const { return ties.empty() || ties[tie] != 0; }
  bool operator==(const ActiveContact&) const = default;
};

/// happened: State::happened.
ActiveContact find_active_contact(const Deck& deck, const std::vector<char>& happened);

/// Whether any pair of surfaces may act at another time.
bool has_switched_pairs(const ContactDeck& contact);

/// The combinations of named surfaces on which nodes or faces lie together, the same on every rank.
struct SurfaceClasses {
  std::vector<SurfaceSet> sets;  // [classes] ascending

  int count() const { return static_cast<int>(sets.size()); }
  int find(const SurfaceSet& set) const;

  /// Rules by [class of the node * count() + class of the face]: that of the first pair that fits.
  /// What is tied to a surface may not touch it.
  std::vector<PairRule> find_rules(const ContactDeck& contact, const ActiveContact& active) const;
};

/// Surfaces of each face of the share. Throws InputError for unknown surfaces. Collective over Mesh::ranks.
std::vector<SurfaceSet> find_face_surfaces(const Mesh& mesh, const Deck& deck, const TiedSurfaces& ties,
                                           const std::vector<ElementFace>& faces);

/// [parts] surfaces that a part belongs to as a whole: what its particles and beams touch as.
std::vector<SurfaceSet> find_part_surfaces(const Mesh& mesh, const Deck& deck);

/// Each set once, ascending.
void sort_unique(std::vector<SurfaceSet>& sets);

/// All sets that occur on any rank. Collective over Mesh::ranks.
SurfaceClasses agree_on_classes(const Mesh& mesh, std::vector<SurfaceSet> sets);

}  // namespace percuss
