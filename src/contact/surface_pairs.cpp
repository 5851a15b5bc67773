#include "src/contact/surface_pairs.hpp"

#include <algorithm>
#include <map>

namespace percuss {
namespace {

/// Numbers of the named surfaces, ascending.
using SurfaceSet = std::vector<int>;

void add_surface(SurfaceSet& set, int surface) {
  const auto place = std::lower_bound(set.begin(), set.end(), surface);
  if (place == set.end() || *place != surface) set.insert(place, surface);
}

bool has_surface(const SurfaceSet& set, int surface) { return std::binary_search(set.begin(), set.end(), surface); }

/// Gives each combination that occurs a number.
class ClassNumbers {
 public:
  int number(const SurfaceSet& set) {
    const auto [place, fresh] = numbers_.try_emplace(set, static_cast<int>(sets_.size()));
    if (fresh) sets_.push_back(set);
    return place->second;
  }
  const std::vector<SurfaceSet>& sets() const { return sets_; }

 private:
  std::map<SurfaceSet, int> numbers_;
  std::vector<SurfaceSet> sets_;
};

/// Surfaces of each face: 2 p and 2 p + 1 are the sides a and b of pair p.
std::vector<SurfaceSet> find_face_surfaces(const Mesh& mesh, const Deck& deck, const std::vector<ElementFace>& faces) {
  std::vector<SurfaceSet> sets(faces.size());
  for (std::size_t p = 0; p < deck.contact.pairs.size(); ++p) {
    const Selector* sides[2] = {&deck.contact.pairs[p].a, &deck.contact.pairs[p].b};
    for (int side = 0; side < 2; ++side)
      for (const ElementFace& selected : select_faces(mesh, deck, *sides[side])) {
        const auto place = std::lower_bound(faces.begin(), faces.end(), selected);
        if (place == faces.end() || *place != selected) continue;  // an interior face cannot touch anything
        add_surface(sets[static_cast<std::size_t>(place - faces.begin())], 2 * static_cast<int>(p) + side);
      }
  }
  return sets;
}

/// Friction between a node on surfaces `node` and a face on surfaces `face`: that of the first pair that fits.
double find_pair_friction(const ContactDeck& contact, const SurfaceSet& node, const SurfaceSet& face) {
  for (std::size_t p = 0; p < contact.pairs.size(); ++p) {
    const int a = 2 * static_cast<int>(p), b = a + 1;
    const bool fits = (has_surface(node, a) && has_surface(face, b)) || (has_surface(node, b) && has_surface(face, a));
    if (fits) return contact.pairs[p].friction.value_or(contact.friction);
  }
  return -1;
}

}  // namespace

SurfacePairs find_surface_pairs(const Mesh& mesh, const Deck& deck, const std::vector<ElementFace>& faces,
                                const std::vector<std::array<int, 4>>& corners, std::size_t num_nodes) {
  SurfacePairs pairs;
  if (deck.contact.surfaces != ContactDeck::Surfaces::pairs) {
    pairs.node_class.assign(num_nodes, 0);
    pairs.face_class.assign(faces.size(), 0);
    pairs.friction = {deck.contact.surfaces == ContactDeck::Surfaces::all ? deck.contact.friction : -1};
    return pairs;
  }
  const std::vector<SurfaceSet> face_sets = find_face_surfaces(mesh, deck, faces);
  std::vector<SurfaceSet> node_sets(num_nodes);
  for (std::size_t f = 0; f < faces.size(); ++f)
    for (const int node : corners[f])
      for (const int surface : face_sets[f]) add_surface(node_sets[static_cast<std::size_t>(node)], surface);
  ClassNumbers classes;
  for (const SurfaceSet& set : face_sets) pairs.face_class.push_back(classes.number(set));
  for (const SurfaceSet& set : node_sets) pairs.node_class.push_back(classes.number(set));
  pairs.num_classes = static_cast<int>(classes.sets().size());
  for (const SurfaceSet& node : classes.sets())
    for (const SurfaceSet& face : classes.sets())
      pairs.friction.push_back(find_pair_friction(deck.contact, node, face));
  return pairs;
}

}  // namespace percuss
