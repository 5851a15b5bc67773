#include "src/step/build_conditions.hpp"

#include <fmt/format.h>

#include <array>
#include <map>
#include <utility>

#include "kernels/core/host_copy.hpp"
#include "src/error.hpp"

namespace percuss {

namespace {

/// Held directions by (node, direction), so that the first condition of the deck that holds one is known.
struct HeldDirection {
  int motion = 0;
  const ConditionDeck* condition = nullptr;
};
using HeldMap = std::map<std::pair<int, int>, HeldDirection>;

bool is_rest(const ConditionDeck& condition) {
  return condition.kind == ConditionDeck::Kind::fixed || condition.kind == ConditionDeck::Kind::symmetry;
}

HeldMap find_held_directions(const Deck& deck, const Mesh& mesh, Model& model) {
  HeldMap held;
  model.motions.push_back({});  // row 0: at rest
  for (const ConditionDeck& condition : deck.conditions) {
    const std::vector<int> nodes = select_nodes(mesh, deck, condition.where);
    for (int k = 0; k < 3; ++k) {
      if (!condition.active[static_cast<std::size_t>(k)]) continue;
      int row = 0;
      if (!is_rest(condition)) {
        row = static_cast<int>(model.motions.size());
        model.motions.push_back(
            {condition.value[static_cast<std::size_t>(k)], condition.kind == ConditionDeck::Kind::displacement});
        model.is_driven = true;
      }
      for (const int node : nodes) {
        const auto [entry, is_new] = held.emplace(std::pair{node, k}, HeldDirection{row, &condition});
        if (!is_new && !(entry->second.motion == 0 && row == 0)) {
          throw InputError(fmt::format(
              "{}: error: node {} is held in direction {} by two conditions that move it (the other is at {}); leave "
              "it out of one of them",
              deck.where(condition.where.place), mesh.node_ids[static_cast<std::size_t>(node)], "xyz"[k],
              deck.where(entry->second.condition->where.place)));
        }
      }
    }
  }
  return held;
}

Vec3 cross(const Vec3& a, const Vec3& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

}  // namespace

std::vector<int> build_pressure_faces(const Deck& deck, const Mesh& mesh, Model& model) {
  const auto chunk_slots = to_host(model.chunks.slots_to_nodes);
  std::vector<int> slot_nodes(chunk_slots.data(), chunk_slots.data() + chunk_slots.extent(0));
  std::vector<std::array<int, 4>> corners;
  std::vector<int> loads;
  for (const PressureDeck& pressure : deck.pressures) {
    for (const ElementFace& face : select_faces(mesh, deck, pressure.where)) {
      std::array<int, 4> nodes{};
      for (std::size_t i = 0; i < 4; ++i) {
        const int corner = hex_faces[face.face][i];
        nodes[i] = mesh.elements[static_cast<std::size_t>(face.element)][static_cast<std::size_t>(corner)];
        slot_nodes.push_back(nodes[i]);
      }
      corners.push_back(nodes);
      loads.push_back(static_cast<int>(model.pressures.size()));
    }
    model.pressures.push_back(pressure.value);
  }
  PressureFaces& faces = model.pressure_faces;
  faces.first_slot = model.slot_count;
  faces.count = static_cast<int>(corners.size());
  faces.load = to_view("percuss::pressure_load", loads);
  faces.nodes = to_rows("percuss::pressure_nodes", corners);
  model.slot_count = static_cast<int>(slot_nodes.size());
  return slot_nodes;
}

void build_held_directions(const Deck& deck, const Mesh& mesh, const std::vector<double>& mass, Model& model) {
  const HeldMap held = find_held_directions(deck, mesh, model);
  std::vector<std::array<double, 3>> inverse_mass(mesh.nodes.size());
  for (std::size_t n = 0; n < mass.size(); ++n) inverse_mass[n] = {1 / mass[n], 1 / mass[n], 1 / mass[n]};
  std::vector<int> node, direction, motion;
  std::vector<double> start;
  for (const auto& [key, value] : held) {
    const auto n = static_cast<std::size_t>(key.first);
    const auto k = static_cast<std::size_t>(key.second);
    inverse_mass[n][k] = 0;
    node.push_back(key.first);
    direction.push_back(key.second);
    motion.push_back(value.motion);
    start.push_back(mesh.nodes[n][k]);
  }
  model.inverse_mass = to_rows("percuss::inverse_mass", inverse_mass);
  model.held = {to_view("percuss::held_node", node), to_view("percuss::held_direction", direction),
                to_view("percuss::held_motion", motion), to_view("percuss::held_start", start),
                static_cast<int>(node.size())};
}

void build_initial_velocities(const Deck& deck, const Mesh& mesh, const std::vector<double>& mass, Model& model) {
  std::vector<Vec3> velocity(mesh.nodes.size(), Vec3{});
  for (const InitialDeck& initial : deck.initial) {
    const std::vector<int> nodes = select_nodes(mesh, deck, initial.where);
    Vec3 center = initial.center.value_or(Vec3{});
    if (!initial.center) {
      double sum = 0;
      for (const int n : nodes) {
        const double m = mass[static_cast<std::size_t>(n)];
        sum += m;
        for (std::size_t k = 0; k < 3; ++k) center[k] += m * mesh.nodes[static_cast<std::size_t>(n)][k];
      }
      for (double& c : center) c /= sum;
    }
    for (const int n : nodes) {
      const Vec3& p = mesh.nodes[static_cast<std::size_t>(n)];
      const Vec3 turn = cross(initial.angular_velocity, {p[0] - center[0], p[1] - center[1], p[2] - center[2]});
      for (std::size_t k = 0; k < 3; ++k) velocity[static_cast<std::size_t>(n)][k] = initial.velocity[k] + turn[k];
    }
  }
  model.start_velocity = to_rows("percuss::start_velocity", velocity);
}

}  // namespace percuss
