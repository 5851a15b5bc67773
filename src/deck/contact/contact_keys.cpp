#include "src/deck/contact/contact_keys.hpp"

#include <algorithm>

#include "src/deck/contact/tie_keys.hpp"
#include "src/deck/keys/switch_keys.hpp"

namespace percuss {
namespace {

const Keys<SurfacePairDeck>& pair_keys() {
  static const Keys<SurfacePairDeck> keys = with_switch<SurfacePairDeck>({
      need("a", &SurfacePairDeck::a, SelectorValue{Chosen::touching}),
      need("b", &SurfacePairDeck::b, SelectorValue{Chosen::touching}),
      may("friction", &SurfacePairDeck::friction, NumberValue{not_negative}),
  });
  return keys;
}

/// [a, b] or {a: ..., b: ..., friction: ...}.
struct PairValue {
  bool read(const Reader& reader, const std::string& name, const Node& node, SurfacePairDeck& out) const {
    if (node.kind == Node::Kind::map) return MapValue<SurfacePairDeck>{pair_keys}.read(reader, name, node, out);
    std::array<Selector, 2> surfaces;
    if (node.kind != Node::Kind::list || node.items.size() != 2) {
      reader.refuse(node, name, takes());
      return false;
    }
    if (!TupleValue<SelectorValue, 2>{{Chosen::touching}}.read(reader, name, node, surfaces)) return false;
    out.a = surfaces[0];
    out.b = surfaces[1];
    return true;
  }
  std::string takes() const { return "a pair [a, b] or {a: ..., b: ..., friction: ...}"; }
  Form form() const { return any_form({TupleValue<SelectorValue, 2>{}.form(), form_of(pair_keys())}); }
};

bool is_same(const Selector& a, const Selector& b) { return a.name == b.name && a.inside == b.inside; }

bool is_same(const std::optional<Selector>& a, const std::optional<Selector>& b) {
  return a && b ? is_same(*a, *b) : !a && !b;
}

/// Whether a pair acts at some times only: two pairs of the same surfaces may follow each other.
bool is_switched(const SurfacePairDeck& pair) { return pair.when.any(); }
bool is_switched(const PairFrictionDeck&) { return false; }

/// Refuses a pair that an earlier one names, either way round: its friction would never act.
template <class Pair>
bool are_different(const Reader& reader, const std::string& name, const Node& node, const std::vector<Pair>& pairs) {
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    const std::optional<Selector> a = pairs[i].a, b = pairs[i].b;
    const bool is_repeated =
        std::any_of(pairs.begin(), pairs.begin() + static_cast<std::ptrdiff_t>(i), [&](const Pair& other) {
          if (is_switched(other)) return false;
          const std::optional<Selector> c = other.a, d = other.b;
          return (is_same(a, c) && is_same(b, d)) || (is_same(a, d) && is_same(b, c));
        });
    if (!is_repeated) continue;
    const std::string names = b ? fmt::format("'{}' and '{}'", a->name, b->name) : fmt::format("'{}'", a->name);
    reader.error(
        node.items[i].spot,
        fmt::format("{}.{} names {} again (the first such pair gives the friction): leave out one", name, i, names));
    return false;
  }
  return true;
}

const Keys<PairFrictionDeck>& pair_friction_keys() {
  static const Keys<PairFrictionDeck> keys = {
      need("a", &PairFrictionDeck::a, SelectorValue{Chosen::touching}),
      may("b", &PairFrictionDeck::b, SelectorValue{Chosen::touching}),
      need("friction", &PairFrictionDeck::friction, NumberValue{not_negative}),
  };
  return keys;
}

struct PairFrictionsValue {
  ListValue<MapValue<PairFrictionDeck>> list{{pair_friction_keys}};

  bool read(const Reader& reader, const std::string& name, const Node& node, std::vector<PairFrictionDeck>& out) const {
    return list.read(reader, name, node, out) && are_different(reader, name, node, out);
  }
  std::string takes() const { return list.takes(); }
  Form form() const { return list.form(); }
};

const Keys<ContactDeck>& friction_keys() {
  static const Keys<ContactDeck> keys = {
      may("default", &ContactDeck::friction, NumberValue{not_negative}),
      may("pairs", &ContactDeck::frictions, PairFrictionsValue{}),
  };
  return keys;
}

/// One coefficient, or a map: that of all, and those of pairs.
struct FrictionValue {
  MapValue<ContactDeck> map{friction_keys};

  bool read(const Reader& reader, const std::string& name, const Node& node, ContactDeck& out) const {
    if (node.kind == Node::Kind::map) return map.read(reader, name, node, out);
    return NumberValue{not_negative}.read(reader, name, node, out.friction);
  }
  std::string takes() const { return NumberValue{not_negative}.takes() + ", or a map"; }
  Form form() const { return any_form({NumberValue{not_negative}.form(), map.form()}); }
};

/// all, none or a list of pairs.
struct SurfacesValue {
  bool read(const Reader& reader, const std::string& name, const Node& node, ContactDeck& out) const {
    using Surfaces = ContactDeck::Surfaces;
    if (node.kind == Node::Kind::list) {
      out.surfaces = Surfaces::pairs;
      if (node.items.empty()) {
        reader.refuse(node, name, "all, none or at least one pair [a, b]");
        return false;
      }
      return ListValue<PairValue>{}.read(reader, name, node, out.pairs) && are_different(reader, name, node, out.pairs);
    }
    const ChoiceValue<Surfaces> word{{{"all", Surfaces::all}, {"none", Surfaces::none}}};
    if (node.kind == Node::Kind::scalar) return word.read(reader, name, node, out.surfaces);
    reader.refuse(node, name, takes());
    return false;
  }
  std::string takes() const { return "all | none or a list of pairs"; }
  Form form() const { return any_form({word_form({"all", "none"}), list_form(PairValue{}.form(), 1)}); }
};

const Keys<ContactDeck>& contact_keys() {
  using Overlap = ContactDeck::Overlap;
  using Rebalance = ContactDeck::Rebalance;
  using Enforcement = ContactDeck::Enforcement;
  using Search = ContactDeck::Search;
  static const Keys<ContactDeck> keys = {
      group<ContactDeck>("surfaces", SurfacesValue{}),
      group<ContactDeck>("friction", FrictionValue{}),
      may("ties", &ContactDeck::ties, ListValue<MapValue<TieDeck>>{tie_value()}),
      may("overlap", &ContactDeck::overlap,
          ChoiceValue<Overlap>{
              {{"accept", Overlap::accept}, {"push_out", Overlap::push_out}, {"refuse", Overlap::refuse}}}),
      may("enforcement", &ContactDeck::enforcement,
          ChoiceValue<Enforcement>{{{"automatic", Enforcement::automatic},
                                    {"kinematic", Enforcement::kinematic},
                                    {"lagrange", Enforcement::lagrange},
                                    {"penalty", Enforcement::penalty}}}),
      may("penalty_scale", &ContactDeck::penalty_scale, NumberValue{positive}),
      may("restitution", &ContactDeck::restitution, NumberValue{{"from 0 to 1", 0, 1}}),
      may("tolerance", &ContactDeck::tolerance, NumberValue{positive}),
      may("edges", &ContactDeck::edges, BooleanValue{}),
      may("beams", &ContactDeck::beams, BooleanValue{}),
      may("search", &ContactDeck::search,
          ChoiceValue<Search>{{{"blocks", Search::blocks}, {"points_in_box", Search::points_in_box}}}),
      may("reuse_search", &ContactDeck::reuse_search, BooleanValue{}),
      may("rebalance", &ContactDeck::rebalance,
          ChoiceValue<Rebalance>{
              {{"auto", Rebalance::automatic}, {"always", Rebalance::always}, {"never", Rebalance::never}}}),
  };
  return keys;
}

/// Springs that hold ties as they hold contact would let tied bodies part; ties by impulses beside springs are neither.
bool check_contact(const Reader& reader, const Node& node, ContactDeck& contact) {
  const bool are_glue = std::all_of(contact.ties.begin(), contact.ties.end(),
                                    [](const TieDeck& tie) { return tie.cohesive.has_value(); });
  if (are_glue || contact.enforcement != ContactDeck::Enforcement::penalty) return true;
  reader.error(node.find("ties")->spot,
               "ties cannot be held by contact.enforcement: penalty (springs would let them part): use kinematic or "
               "lagrange, or ties that are cohesive");
  return false;
}

}  // namespace

bool ContactValue::read(const Reader& reader, const std::string& name, const Node& node, ContactDeck& out) const {
  out.surfaces = ContactDeck::Surfaces::all;
  return MapValue<ContactDeck>{contact_keys, check_contact}.read(reader, name, node, out);
}

Form ContactValue::form() const { return form_of(contact_keys()); }

}  // namespace percuss
