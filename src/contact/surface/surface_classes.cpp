#include "src/contact/surface/surface_classes.hpp"

#include <algorithm>

#include "comm/gather_items.hpp"
#include "src/deck/rigid_bodies.hpp"
#include "src/deck/switches.hpp"

namespace percuss {
namespace {

/// Numbers of rigid bodies among those of surfaces: after all of these.
constexpr int first_body_surface = 1 << 24;

/// Whether both belong to one rigid body, whose surfaces never move to each other.
bool share_body(const SurfaceSet& node, const SurfaceSet& face) {
  return std::any_of(face.begin(), face.end(), [&](int surface) {
    return surface >= first_body_surface && std::binary_search(node.begin(), node.end(), surface);
  });
}

/// Where rows of contact.friction stand among the pairs of surfaces.
std::size_t first_friction(const ContactDeck& contact) { return contact.pairs.size() + contact.ties.size(); }

bool has_surface(const SurfaceSet& set, int surface) { return std::binary_search(set.begin(), set.end(), surface); }

/// Whether one is on one side of a pair or tie and the other on the other.
bool are_opposite(const SurfaceSet& node, const SurfaceSet& face, std::size_t pair) {
  const int a = 2 * static_cast<int>(pair), b = a + 1;
  return (has_surface(node, a) && has_surface(face, b)) || (has_surface(node, b) && has_surface(face, a));
}

/// Rows of contact.friction that have a surface of a set on a side.
void list_friction_rows(const ContactDeck& contact, const SurfaceSet& set, std::vector<std::size_t>& rows) {
  const auto first = static_cast<int>(first_friction(contact)),
             last = first + static_cast<int>(contact.frictions.size());
  for (auto s = std::lower_bound(set.begin(), set.end(), 2 * first); s != set.end() && *s < 2 * last; ++s)
    rows.push_back(static_cast<std::size_t>(*s / 2 - first));
}

/// Coulomb's coefficient where a pair of the deck gives none: of the first row of its table that fits.
double find_friction(const ContactDeck& contact, const SurfaceSet& node, const SurfaceSet& face) {
  std::vector<std::size_t> rows;
  list_friction_rows(contact, node, rows);
  list_friction_rows(contact, face, rows);
  std::sort(rows.begin(), rows.end());
  for (const std::size_t f : rows) {
    const std::size_t pair = first_friction(contact) + f;
    const int a = 2 * static_cast<int>(pair);
    const bool fits =
        contact.frictions[f].b ? are_opposite(node, face, pair) : has_surface(node, a) || has_surface(face, a);
    if (fits) return contact.frictions[f].friction;
  }
  return contact.friction;
}

/// Rule for a node on surfaces `node` and a face on surfaces `face`.
PairRule find_rule(const ContactDeck& contact, const ActiveContact& active, const SurfaceSet& node,
                   const SurfaceSet& face) {
  if (share_body(node, face)) return {};
  for (std::size_t t = 0; t < contact.ties.size(); ++t)
    if (are_opposite(node, face, contact.pairs.size() + t)) return {};
  if (contact.surfaces == ContactDeck::Surfaces::all) return {0, find_friction(contact, node, face)};
  for (std::size_t p = 0; p < contact.pairs.size(); ++p)
    if (active.has_pair(p) && are_opposite(node, face, p)) {
      const std::optional<double> own = contact.pairs[p].friction;
      return {static_cast<int>(p), own ? *own : find_friction(contact, node, face)};
    }
  return {};
}

/// The sets of all ranks, each as its length and its surfaces.
std::vector<int> gather_sets(const Communicator& ranks, const std::vector<SurfaceSet>& sets) {
  std::vector<int> own;
  for (const SurfaceSet& set : sets) {
    own.push_back(static_cast<int>(set.size()));
    own.insert(own.end(), set.begin(), set.end());
  }
  return gather_items(ranks, own);
}

}  // namespace

int SurfaceClasses::find(const SurfaceSet& set) const {
  return static_cast<int>(std::lower_bound(sets.begin(), sets.end(), set) - sets.begin());
}

ActiveContact find_active_contact(const Deck& deck, const std::vector<char>& happened) {
  const auto list = [&](const auto& entries) {
    std::vector<char> active;
    active.reserve(entries.size());
    for (const auto& entry : entries) active.push_back(find_switch(deck.sensors, entry.when).is_on(happened) ? 1 : 0);
    return active;
  };
  return {list(deck.contact.pairs), list(deck.walls), list(deck.contact.ties)};
}

bool has_switched_pairs(const ContactDeck& contact) {
  return std::any_of(contact.pairs.begin(), contact.pairs.end(),
                     [](const SurfacePairDeck& pair) { return pair.when.any(); });
}

std::vector<PairRule> SurfaceClasses::find_rules(const ContactDeck& contact, const ActiveContact& active) const {
  std::vector<PairRule> rules;
  for (const SurfaceSet& node : sets) {
    for (const SurfaceSet& face : sets) rules.push_back(find_rule(contact, active, node, face));
  }
  return rules;
}

std::vector<SurfaceSet> find_face_surfaces(const Mesh& mesh, const Deck& deck, const TiedSurfaces& ties,
                                           const std::vector<ElementFace>& faces) {
  std::vector<SurfaceSet> sets(faces.size());
  if (deck.contact.surfaces == ContactDeck::Surfaces::none) return sets;
  const auto add = [&](const std::vector<ElementFace>& selected, std::size_t pair, int side) {
    for (const ElementFace& face : selected) {
      const auto place = std::lower_bound(faces.begin(), faces.end(), face);
      sets[static_cast<std::size_t>(place - faces.begin())].push_back(2 * static_cast<int>(pair) + side);
    }
  };
  const bool selects = !deck.contact.pairs.empty() || !deck.contact.frictions.empty();
  const std::vector<ElementFace> exterior = selects ? find_exterior_faces(mesh) : std::vector<ElementFace>{};
  const auto select = [&](const Selector& side) { return select_touching_faces(mesh, deck, side, exterior); };
  for (std::size_t p = 0; p < deck.contact.pairs.size(); ++p) {
    add(select(deck.contact.pairs[p].a), p, 0);
    add(select(deck.contact.pairs[p].b), p, 1);
  }
  for (std::size_t t = 0; t < ties.faces.size(); ++t)
    for (std::size_t side = 0; side < 2; ++side)
      add(ties.faces[t][side], deck.contact.pairs.size() + t, static_cast<int>(side));
  for (std::size_t f = 0; f < deck.contact.frictions.size(); ++f) {
    const PairFrictionDeck& row = deck.contact.frictions[f];
    add(select(row.a), first_friction(deck.contact) + f, 0);
    if (row.b) add(select(*row.b), first_friction(deck.contact) + f, 1);
  }
  if (!has_rigid_parts(deck)) return sets;
  const std::vector<int> bodies = name_rigid_bodies(deck).body_of_part;
  for (std::size_t f = 0; f < faces.size(); ++f) {
    const int body = bodies[static_cast<std::size_t>(mesh.part_of(static_cast<std::size_t>(faces[f].element)))];
    if (body >= 0) sets[f].push_back(first_body_surface + body);
  }
  return sets;
}

std::vector<SurfaceSet> find_part_surfaces(const Mesh& mesh, const Deck& deck) {
  std::vector<SurfaceSet> sets(mesh.parts.size());
  const auto add = [&](const Selector& side, int surface) {
    for (std::size_t part = 0; part < sets.size(); ++part) {
      if (!side.inside && (side.name.empty() || side.name == mesh.parts[part].name)) sets[part].push_back(surface);
    }
  };
  for (std::size_t p = 0; p < deck.contact.pairs.size(); ++p) {
    add(deck.contact.pairs[p].a, 2 * static_cast<int>(p));
    add(deck.contact.pairs[p].b, 2 * static_cast<int>(p) + 1);
  }
  for (std::size_t f = 0; f < deck.contact.frictions.size(); ++f) {
    const PairFrictionDeck& row = deck.contact.frictions[f];
    const int a = 2 * static_cast<int>(first_friction(deck.contact) + f);
    add(row.a, a);
    if (row.b) add(*row.b, a + 1);
  }
  if (!has_rigid_parts(deck)) return sets;
  const std::vector<int> bodies = name_rigid_bodies(deck).body_of_part;
  for (std::size_t part = 0; part < sets.size(); ++part)
    if (bodies[part] >= 0) sets[part].push_back(first_body_surface + bodies[part]);
  return sets;
}

void sort_unique(std::vector<SurfaceSet>& sets) {
  sets.erase(std::unique(sets.begin(), sets.end()), sets.end());  // neighbours are mostly alike: little is left to sort
  std::sort(sets.begin(), sets.end());
  sets.erase(std::unique(sets.begin(), sets.end()), sets.end());
}

SurfaceClasses agree_on_classes(const Mesh& mesh, std::vector<SurfaceSet> sets) {
  sort_unique(sets);
  if (mesh.ranks && mesh.ranks->size() > 1) {
    const std::vector<int> all = gather_sets(*mesh.ranks, sets);
    sets.clear();
    for (auto next = all.begin(); next != all.end();) {
      const auto first = next + 1;
      next = first + *next;
      sets.emplace_back(first, next);
    }
    sort_unique(sets);
  }
  if (sets.empty()) sets.push_back({});
  return {std::move(sets)};
}

}  // namespace percuss
