#include "src/checks/who_touches.hpp"

#include <algorithm>

#include "src/checks/checked_scene.hpp"

namespace percuss {
namespace {

/// Whether an end of a spring may be at a part; a point without a name at any.
bool is_at(const Deck& deck, const SpringEndDeck& end, std::size_t part) {
  const std::string& point = end.point ? end.point->part : end.where.name;
  if (point.empty()) return true;
  Selector where;
  where.name = point;
  const std::vector<std::size_t> parts = find_named_parts(deck, where);
  return std::find(parts.begin(), parts.end(), part) != parts.end();
}

}  // namespace

void mark(const Deck& deck, const Selector& where, Marks& marks) {
  for (const std::size_t p : find_named_parts(deck, where)) marks[p] = true;
}

Marks mark_touching(const Deck& deck, double time) {
  if (deck.contact.surfaces == ContactDeck::Surfaces::all && deck.parts.size() > 1)
    return Marks(deck.parts.size(), true);
  return mark_named_surfaces(deck, time);
}

Marks mark_named_surfaces(const Deck& deck, double time) {
  const ContactDeck& contact = deck.contact;
  Marks marks(deck.parts.size(), false);
  const auto mark_both = [&](const auto& pair) {
    mark(deck, pair.a, marks);
    mark(deck, pair.b, marks);
  };
  for (const SurfacePairDeck& pair : contact.pairs)
    if (may_act_after(deck, pair.when, time)) mark_both(pair);
  std::for_each(contact.ties.begin(), contact.ties.end(), mark_both);
  return marks;
}

void mark_jointed(const Deck& deck, Marks& marks) {
  Selector body;
  for (const JointDeck& joint : deck.joints) {
    for (const std::string& name : joint.bodies) {
      body.name = body_prefix + name;
      mark(deck, body, marks);
    }
  }
}

Marks mark_connected(const Deck& deck) {
  Marks marks(deck.parts.size(), false);
  const auto mark_end = [&](const SpringEndDeck& end) {
    for (std::size_t p = 0; p < marks.size(); ++p) marks[p] = marks[p] || is_at(deck, end, p);
  };
  for (const TieDeck& tie : deck.contact.ties) {
    mark(deck, tie.a, marks);
    mark(deck, tie.b, marks);
  }
  for (const WeldDeck& weld : deck.welds) std::for_each(weld.between.begin(), weld.between.end(), mark_end);
  for (const SpringDeck& spring : deck.springs) std::for_each(spring.between.begin(), spring.between.end(), mark_end);
  for (const ConstraintDeck& constraint : deck.constraints) {
    if (constraint.between) std::for_each(constraint.between->begin(), constraint.between->end(), mark_end);
    if (constraint.nodes) mark(deck, *constraint.nodes, marks);
    for (const EquationTermDeck& term : constraint.equation) mark_end(term.of);
  }
  for (const EmbeddedDeck& embedded : deck.embedded) mark(deck, embedded.nodes, marks);
  for (const RigidSetDeck& set : deck.rigid_sets) mark(deck, set.where, marks);
  mark_jointed(deck, marks);
  return marks;
}

Marks mark_stopped(const Deck& deck, const WallDeck& wall) {
  Marks marks(deck.parts.size(), wall.nodes.empty());
  for (const Selector& where : wall.nodes) mark(deck, where, marks);
  return marks;
}

bool are_sprung(const Deck& deck, std::size_t part, std::size_t other) {
  return std::any_of(deck.springs.begin(), deck.springs.end(), [&](const SpringDeck& spring) {
    const auto& [a, b] = spring.between;
    return (is_at(deck, a, part) && is_at(deck, b, other)) || (is_at(deck, b, part) && is_at(deck, a, other));
  });
}

}  // namespace percuss
