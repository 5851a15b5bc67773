#include "src/step/glue/build_glue.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "comm/all_reduce.hpp"
#include "comm/gather_items.hpp"
#include "kernels/core/host_copy.hpp"
#include "src/contact/ties/tie_areas.hpp"
#include "src/contact/ties/ties.hpp"
#include "src/error.hpp"
#include "src/index.hpp"
#include "src/step/springs/connected_nodes.hpp"

namespace percuss {
namespace {

/// Every rank computes all glue.
constexpr std::size_t most_points = 100000;

CohesiveLaw make_cohesive_law(const CohesiveDeck& deck) {
  CohesiveLaw law;
  law.normal_stiffness = deck.normal_stiffness;
  law.shear_stiffness = deck.shear_stiffness.value_or(deck.normal_stiffness);
  law.normal_strength = deck.normal_strength;
  law.shear_strength = deck.shear_strength;
  law.normal_energy = deck.normal_energy;
  law.shear_energy = deck.shear_energy;
  law.plateau = deck.plateau;
  law.mix =
      deck.mix == CohesiveDeck::Mix::power_law ? CohesiveLaw::Mix::power_law : CohesiveLaw::Mix::benzeggagh_kenane;
  law.exponent = deck.exponent;
  if (deck.onset == CohesiveDeck::Onset::maximum) law.onset = CohesiveLaw::Onset::maximum;
  if (deck.softening == CohesiveDeck::Softening::exponential) law.softening = CohesiveLaw::Softening::exponential;
  return law;
}

/// The glued nodes of all ranks with their areas, by number.
std::vector<TiedNode> list_glued(const Deck& deck, const ChunkedMesh& chunked, const Communicator& ranks) {
  const TiedSurfaces ties = find_ties(chunked, deck, ranks);
  std::vector<TiedNode> own;
  std::vector<std::int64_t> numbers;
  for (const TiedNode& tied : ties.nodes) {
    if (!deck.contact.ties[at(tied.tie)].cohesive) continue;
    own.push_back(tied);
    numbers.push_back(tied.node);
  }
  const std::vector<double> areas = sum_tie_areas({chunked, deck, ranks, chunked.mesh.nodes}, ties, numbers);
  for (std::size_t i = 0; i < own.size(); ++i) own[i].area = areas[i];
  std::vector<TiedNode> all = gather_items(ranks, own);
  std::sort(all.begin(), all.end(), [](const TiedNode& a, const TiedNode& b) { return a.node < b.node; });
  return all;
}

void check_glued(const Deck& deck, const std::vector<TiedNode>& glued) {
  if (glued.size() > most_points)
    throw InputError(
        fmt::format("{}: error: cohesive ties have {} nodes (at most {}, because every rank computes all of them): "
                    "glue smaller surfaces, or the coarser side as a",
                    deck.where(deck.contact.ties[at(glued.front().tie)].place), glued.size(), most_points));
  for (const TiedNode& tied : glued) {
    if (tied.side != 0) continue;
    const TieDeck& tie = deck.contact.ties[at(tied.tie)];
    throw InputError(
        fmt::format("{}: error: tie of '{}' and '{}' has nodes in the middle of a shell (glue needs two surfaces that "
                    "face each other): leave half the thickness between them",
                    deck.where(tie.place), tie.a.name, tie.b.name));
  }
}

void number_nodes(const std::vector<TiedNode>& glued, GlueModel& glue) {
  for (const TiedNode& tied : glued) {
    glue.nodes.push_back(tied.node);
    glue.nodes.insert(glue.nodes.end(), std::begin(tied.corners), std::end(tied.corners));
  }
  std::sort(glue.nodes.begin(), glue.nodes.end());
  glue.nodes.erase(std::unique(glue.nodes.begin(), glue.nodes.end()), glue.nodes.end());
}

/// Vector from a node to the glue: what its own shell has of the distance between both meshes, shells and gap.
Point3 find_arm(const TiedNode& tied) {
  const Point3 normal = find_face_normal(tied.geometry.face);
  return (-tied.own_share * dot(tied.geometry.offset, normal)) * normal;
}

std::vector<GluePoint> make_points(const std::vector<TiedNode>& glued, const std::vector<std::int64_t>& nodes) {
  const auto find_place = [&](std::int64_t number) {
    return static_cast<int>(std::lower_bound(nodes.begin(), nodes.end(), number) - nodes.begin());
  };
  std::vector<GluePoint> points;
  for (const TiedNode& tied : glued) {
    GluePoint point;
    point.number = tied.node;
    point.tie = tied.tie;
    point.geometry = tied.geometry;
    point.arm = find_arm(tied);
    point.side = tied.side;
    point.area = tied.area;
    point.node[0] = find_place(tied.node);
    for (std::size_t i = 0; i < 4; ++i) point.node[i + 1] = find_place(tied.corners[i]);
    points.push_back(point);
  }
  return points;
}

}  // namespace

void build_glue(const Deck& deck, const ChunkedMesh& chunked, LocalSlots& slots, Model& model) {
  if (!deck.contact.has_glue()) return;
  const std::vector<TiedNode> glued = list_glued(deck, chunked, model.ranks);
  check_glued(deck, glued);
  GlueModel& glue = model.glue;
  for (const TieDeck& tie : deck.contact.ties)
    glue.laws.push_back(tie.cohesive ? make_cohesive_law(*tie.cohesive) : CohesiveLaw{});
  number_nodes(glued, glue);
  glue.points = make_points(glued, glue.nodes);
  add_force_slots(chunked, model.ranks, glue, slots);
}

void move_glue_off_nodes(Model& model) {
  GlueModel& glue = model.glue;
  if (!glue.any()) return;
  std::vector<int> can_turn(glue.nodes.size(), 0);
  const auto nodes = to_host(glue.owned_node), places = to_host(glue.owned_place);
  const auto inertia = to_host(model.inertia);
  for (std::size_t i = 0; model.has_rotations && i < nodes.extent(0); ++i)
    can_turn[at(places(i))] = inertia(nodes(i)) > 0 ? 1 : 0;
  all_reduce(model.ranks, Reduce::largest, can_turn);
  const std::vector<int> is_rigid = mark_rigid_nodes(model, glue);
  for (GluePoint& point : glue.points) {
    if (can_turn[at(point.node[0])] == 0 || is_rigid[at(point.node[0])] != 0) point.arm = {};
    point.geometry.offset = point.geometry.offset + point.arm;
  }
}

}  // namespace percuss
