// Keys of `contact` and `joints`: what acts between bodies.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "src/deck/keys/strength_keys.hpp"
#include "src/deck/rigid_bodies.hpp"
#include "src/deck/sections/deck_keys.hpp"
#include "src/deck/sections/sensor_keys.hpp"
#include "src/deck/text/nearest_name.hpp"

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

const Keys<TieDeck>& tie_failure_keys() {
  static const Keys<TieDeck> keys = strength_keys<TieDeck>();
  return keys;
}

bool check_tie_failure(const Reader& reader, const Node& node, TieDeck& tie) {
  if (tie.has_strength()) return check_strengths(reader, node, tie);
  reader.error(node.spot, fmt::format("{} names no strength (must have normal or shear)", reader.self()));
  return false;
}

const Keys<CohesiveDeck>& cohesive_keys() {
  using Mix = CohesiveDeck::Mix;
  using Onset = CohesiveDeck::Onset;
  using Softening = CohesiveDeck::Softening;
  static const Keys<CohesiveDeck> keys = {
      need("normal_stiffness", &CohesiveDeck::normal_stiffness, NumberValue{positive}),
      may("shear_stiffness", &CohesiveDeck::shear_stiffness, NumberValue{positive}),
      need("normal_strength", &CohesiveDeck::normal_strength, NumberValue{positive}),
      need("shear_strength", &CohesiveDeck::shear_strength, NumberValue{positive}),
      need("normal_energy", &CohesiveDeck::normal_energy, NumberValue{positive}),
      need("shear_energy", &CohesiveDeck::shear_energy, NumberValue{positive}),
      may("plateau", &CohesiveDeck::plateau, NumberValue{{"at least 0 and below 1", 0, 1, false, true}}),
      may("mix", &CohesiveDeck::mix,
          ChoiceValue<Mix>{{{"benzeggagh_kenane", Mix::benzeggagh_kenane}, {"power_law", Mix::power_law}}}),
      may("exponent", &CohesiveDeck::exponent, NumberValue{positive}),
      may("onset", &CohesiveDeck::onset,
          ChoiceValue<Onset>{{{"quadratic", Onset::quadratic}, {"maximum", Onset::maximum}}}),
      may("softening", &CohesiveDeck::softening,
          ChoiceValue<Softening>{{{"linear", Softening::linear}, {"exponential", Softening::exponential}}}),
  };
  return keys;
}

/// The energy that is left beside a plateau is more than what is stored as damage begins: otherwise tractions would
/// jump.
bool check_cohesive(const Reader& reader, const Node& node, CohesiveDeck& glue) {
  bool good = true;
  if (glue.plateau > 0 && glue.softening == CohesiveDeck::Softening::exponential) {
    reader.error(node.find("plateau")->spot,
                 fmt::format("{} stands beside softening: exponential (which has no constant "
                             "traction): remove one of them",
                             reader.name_of("plateau")));
    good = false;
  }
  const auto check = [&](const char* key, double energy, double strength, double stiffness) {
    const double stored = 0.5 * strength * strength / stiffness, least = stored / (1 - glue.plateau);
    if (energy > least) return;
    reader.error(
        node.find(key)->spot,
        fmt::format("{} is {:g} (must be above {:.4g}, which is stored when the strength is reached): give more "
                    "stiffness, less strength{} or more energy",
                    reader.name_of(key), energy, least, glue.plateau > 0 ? ", a smaller plateau" : ""));
    good = false;
  };
  check("normal_energy", glue.normal_energy, glue.normal_strength, glue.normal_stiffness);
  check("shear_energy", glue.shear_energy, glue.shear_strength, glue.shear_stiffness.value_or(glue.normal_stiffness));
  return good;
}

const Keys<TieDeck>& tie_keys() {
  using Sticks = TieDeck::Sticks;
  static const Keys<TieDeck> keys = with_switch<TieDeck>({
      need("a", &TieDeck::a, SelectorValue{Chosen::surface_nodes}),
      need("b", &TieDeck::b, SelectorValue{Chosen::faces}),
      may("distance", &TieDeck::distance, NumberValue{positive}),
      may("empty", &TieDeck::may_be_empty, ChoiceValue<bool>{{{"refuse", false}, {"ignore", true}}}),
      may("rotations", &TieDeck::rotations, BooleanValue{}),
      may("sticks", &TieDeck::sticks,
          ChoiceValue<Sticks>{{{"at_start", Sticks::at_start}, {"on_contact", Sticks::on_contact}}}),
      group<TieDeck>("failure", MapValue<TieDeck>{tie_failure_keys, check_tie_failure}),
      may("cohesive", &TieDeck::cohesive, MapValue<CohesiveDeck>{cohesive_keys, check_cohesive}),
  });
  return keys;
}

/// Glue begins with the run, holds no rotations and fails by its own law.
bool check_tie(const Reader& reader, const Node& node, TieDeck& tie) {
  tie.place = node.spot.place;
  if (!tie.cohesive) return true;
  bool good = true;
  const auto refuse = [&](const char* key, bool is_used) {
    if (!is_used) return;
    reader.error(node.find(key)->key,
                 fmt::format("{} is of no use with cohesive{} (glue holds places of nodes, from the "
                             "start until its law lets go): leave it out",
                             reader.name_of(key), reader.in()));
    good = false;
  };
  refuse("failure", tie.has_strength());
  refuse("rotations", tie.rotations);
  refuse("sticks", tie.sticks == TieDeck::Sticks::on_contact);
  refuse("from", !tie.when.from.empty());
  refuse("until", !tie.when.until.empty());
  return good;
}

bool is_same(const Selector& a, const Selector& b) { return a.name == b.name && a.inside == b.inside; }

bool is_same(const std::optional<Selector>& a, const std::optional<Selector>& b) {
  return a && b ? is_same(*a, *b) : !a && !b;
}

/// Of two pairs of the same surfaces each may have its time.
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
      may("ties", &ContactDeck::ties, ListValue<MapValue<TieDeck>>{{tie_keys, check_tie}}),
      may("overlap", &ContactDeck::overlap,
          ChoiceValue<Overlap>{
              {{"accept", Overlap::accept}, {"push_out", Overlap::push_out}, {"refuse", Overlap::refuse}}}),
      may("enforcement", &ContactDeck::enforcement,
          ChoiceValue<Enforcement>{{{"kinematic", Enforcement::kinematic},
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

// --- joints

const Keys<JointDeck>& joint_keys() {
  ChoiceValue<JointDeck::Kind> kinds;
  for (const JointTraits& traits : joint_traits) kinds.choices.emplace_back(traits.word, traits.kind);
  static const Keys<JointDeck> keys = {
      need("kind", &JointDeck::kind, kinds),
      need("bodies", &JointDeck::bodies, ListValue<NameValue>{}),
      need("at", &JointDeck::at, vector3()),
      may("axis", &JointDeck::axis, DirectionValue{}),
      may("second_axis", &JointDeck::second_axis, DirectionValue{}),
      may("lead", &JointDeck::lead, NumberValue{any_number}),
  };
  return keys;
}

/// Whether a joint has the axis if its kind has one, and none if not.
bool check_axis(const Reader& reader, const Node& node, const JointDeck& joint, const char* key, bool is_given,
                bool is_needed) {
  if (is_given == is_needed) return true;
  const JointTraits& traits = find_traits(joint.kind);
  const std::string why = fmt::format("(a {} joint {})", traits.word, traits.motion);
  if (is_needed)
    reader.error(node.spot, fmt::format("{} has no {} {}", reader.self(), key, why));
  else
    reader.error(node.find(key)->key, fmt::format("{} has a key {} {}: leave it out", reader.self(), key, why));
  return false;
}

/// The axes of a universal joint are those of its cross.
bool check_cross(const Reader& reader, const Node& node, const JointDeck& joint) {
  constexpr double round_off = 1e-6;
  if (!joint.second_axis) return true;
  const Vec3 &a = *joint.axis, &b = *joint.second_axis;
  const double cosine = a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
  if (std::abs(cosine) <= round_off) return true;
  reader.error(node.find("second_axis")->key,
               fmt::format("{} has axes whose angle is {:.4g} degrees (those of a cross are perpendicular)",
                           reader.self(), std::acos(cosine) * 180 / std::numbers::pi));
  return false;
}

bool check_lead(const Reader& reader, const Node& node, const JointDeck& joint) {
  if (!joint.lead || *joint.lead != 0) return true;
  reader.error(node.find("lead")->spot, fmt::format("{} is 0 (such a screw does not slide): use revolute, or give the "
                                                    "way of a turn; a left-handed thread has a negative one",
                                                    reader.name_of("lead")));
  return false;
}

bool check_joint(const Reader& reader, const Node& node, JointDeck& joint) {
  const Node& bodies = *node.find("bodies");
  if (joint.bodies.empty() || joint.bodies.size() > 2) {
    reader.error(bodies.spot,
                 fmt::format("{} has {} names{} (must have two, or one of a body that is joined to the ground)",
                             reader.name_of("bodies"), joint.bodies.size(), reader.in()));
    return false;
  }
  if (joint.bodies.size() == 2 && joint.bodies[0] == joint.bodies[1]) {
    reader.error(bodies.items[1].spot,
                 fmt::format("{} joins '{}' to itself (which moves as one anyway)", reader.self(), joint.bodies[0]));
    return false;
  }
  const JointTraits& traits = find_traits(joint.kind);
  return check_axis(reader, node, joint, "axis", joint.axis.has_value(), traits.has_axis()) &&
         check_axis(reader, node, joint, "second_axis", joint.second_axis.has_value(), traits.has_second_axis()) &&
         check_axis(reader, node, joint, "lead", joint.lead.has_value(), traits.has_lead()) &&
         check_lead(reader, node, joint) && check_cross(reader, node, joint);
}

/// The same bodies at the same place.
bool repeats(const JointDeck& a, const JointDeck& b) {
  return a.at == b.at && a.bodies.size() == b.bodies.size() &&
         std::is_permutation(a.bodies.begin(), a.bodies.end(), b.bodies.begin());
}

}  // namespace

bool ContactValue::read(const Reader& reader, const std::string& name, const Node& node, ContactDeck& out) const {
  out.surfaces = ContactDeck::Surfaces::all;
  return MapValue<ContactDeck>{contact_keys, check_contact}.read(reader, name, node, out);
}

Form ContactValue::form() const { return form_of(contact_keys()); }

void check_joints(const Deck& deck, const Node& root, Reading& reading) {
  const RigidNames names = name_rigid_bodies(deck);
  const auto is_part = [&](const std::string& name) {
    return std::any_of(deck.parts.begin(), deck.parts.end(), [&](const PartDeck& part) { return part.name == name; });
  };
  for (auto joint = deck.joints.begin(); joint != deck.joints.end(); ++joint) {
    const Node* node = root.find("joints")->find(joint->name);
    for (std::size_t i = 0; i < joint->bodies.size(); ++i) {
      const std::string& name = joint->bodies[i];
      if (names.find(name) >= 0 || node->find("bodies")->items.size() != joint->bodies.size()) continue;
      reading.errors.add(
          node->find("bodies")->items[i].spot,
          is_part(name) ? fmt::format("joint '{}' is to hold part '{}', which deforms (joints hold rigid bodies): make "
                                      "it rigid, or join nodes of it that are a rigid set",
                                      joint->name, name)
                        : fmt::format("joint '{}' is to hold '{}', which is no rigid body{}", joint->name, name,
                                      name_hint(name, names.bodies)));
    }
    const auto first = std::find_if(deck.joints.begin(), joint, [&](const JointDeck& j) { return repeats(j, *joint); });
    if (first != joint)
      reading.errors.add(node->key, fmt::format("joint '{}' joins the same bodies at the same point as '{}' (once is "
                                                "enough): leave one of them out",
                                                joint->name, first->name));
  }
}

void check_body_names(const Deck& deck, Reading& reading) {
  const RigidNames names = name_rigid_bodies(deck);
  const auto check = [&](const Selector& where) {
    const std::string body = find_body(where);
    if (body.empty() || names.find(body) >= 0) return;
    reading.errors.add({where.place, -1}, fmt::format("there is no rigid body '{}' (a rigid part, its rigid.body, or a "
                                                      "rigid set){}",
                                                      body, name_hint(body, names.bodies)));
  };
  for (const InitialDeck& initial : deck.initial) check(initial.where);
  for (const ConditionDeck& condition : deck.conditions) check(condition.where);
  for (const NodalLoadDeck& load : deck.nodal_loads) check(load.where);
}

NamedMapValue<JointDeck, MapValue<JointDeck>> joints_value() { return {"joint", {joint_keys, check_joint}}; }

}  // namespace percuss
