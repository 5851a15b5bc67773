#include "src/checks/scene_measures.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <iterator>
#include <limits>
#include <numeric>
#include <unordered_map>

#include "comm/all_reduce.hpp"
#include "comm/exact_reduction.hpp"
#include "kernels/core/host_copy.hpp"
#include "src/index.hpp"
#include "src/mesh/element_height.hpp"
#include "src/mesh/hex_geometry.hpp"

namespace percuss {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// A part before anything was found.
PartMeasures make_empty() {
  PartMeasures empty;
  empty.low = empty.velocity_low = {infinity, infinity, infinity};
  empty.high = empty.velocity_high = {-infinity, -infinity, -infinity};
  empty.shortest_edge = empty.smallest_element = infinity;
  return empty;
}

void widen(const Vec3& value, Vec3& low, Vec3& high) {
  for (std::size_t k = 0; k < 3; ++k) {
    low[k] = std::min(low[k], value[k]);
    high[k] = std::max(high[k], value[k]);
  }
}

/// Takes the edges of an element into those of its part.
void measure_edges(const Mesh& mesh, std::size_t element, PartMeasures& part) {
  const std::span<const int> corners = mesh.corners(element);
  for (const auto& [a, b] : mesh.topology_of(element).edges()) {
    const double length = find_distance(mesh.nodes[at(corners[at(a)])], mesh.nodes[at(corners[at(b)])]);
    part.shortest_edge = std::min(part.shortest_edge, length);
    part.longest_edge = std::max(part.longest_edge, length);
  }
}

void measure_height(const Mesh& mesh, std::size_t element, PartMeasures& part) {
  if (mesh.topology_of(element).is_line()) return;
  const ElementCorners x = gather_corners(mesh.elements, element, mesh.nodes);
  double longest = 0;
  for (const auto& [a, b] : mesh.topology_of(element).edges())
    longest = std::max(longest, find_distance(x[at(a)], x[at(b)]));
  const double height = find_element_height(mesh.topology_of(element), x);
  part.thinnest = std::min(part.thinnest, height);
  part.sharpest = std::max(part.sharpest, longest / height);
  if (longest >= least_sharp * height) part.thinnest_sliver = std::min(part.thinnest_sliver, height);
}

/// Two faces of a hexahedron that lie opposite to each other, and the edge between them.
struct Direction {
  int low, high, corner;
};

/// The one direction in which both faces of a hexahedron are on the surface: that across a sheet. None of a bar, which
/// has two, or of a block.
const Direction* find_layer_direction(std::uint8_t exterior) {
  static constexpr Direction directions[3] = {{3, 1, 1}, {0, 2, 3}, {4, 5, 4}};
  const Direction* found = nullptr;
  for (const Direction& direction : directions) {
    if ((exterior >> direction.low & 1) == 0 || (exterior >> direction.high & 1) == 0) continue;
    if (found != nullptr) return nullptr;
    found = &direction;
  }
  return found;
}

void measure_layer(const Mesh& mesh, std::size_t element, PartMeasures& part) {
  const Direction* across = find_layer_direction(mesh.exterior[element]);
  if (across == nullptr) return;
  const std::span<const int> corners = mesh.corners(element);
  ++part.single_layer;
  part.layer_thickness = std::max(
      part.layer_thickness, find_distance(mesh.nodes[at(corners[0])], mesh.nodes[at(corners[at(across->corner)])]));
}

/// Counts the directions of a hexahedron that are not the one across a sheet: first, second and third by its nodes.
void measure_ways(const Mesh& mesh, std::size_t element, PartMeasures& part) {
  constexpr double much = 1.5 * 1.5;  // of squares
  static constexpr int edges[3][4][2] = {
      {{0, 1}, {3, 2}, {4, 5}, {7, 6}}, {{0, 3}, {1, 2}, {4, 7}, {5, 6}}, {{0, 4}, {1, 5}, {2, 6}, {3, 7}}};
  const std::span<const int> corners = mesh.corners(element);
  Vec3 squares{};
  for (std::size_t way = 0; way < 3; ++way) {
    Vec3 sum{};
    for (const auto& [a, b] : edges[way])
      sum = add(sum, subtract(mesh.nodes[at(corners[at(b)])], mesh.nodes[at(corners[at(a)])]));
    squares[way] = dot(sum, sum);
  }
  const double shortest = *std::min_element(squares.begin(), squares.end());
  for (std::size_t way = 0; way < 3; ++way) {
    if (squares[way] > much * shortest) ++part.long_ways[way];
  }
}

/// A wedge between the two faces of a sheet: both of its triangles lie on them, or one of its sides does, where the cut
/// of a cell runs from one face to the other.
void measure_wedge(const Mesh& mesh, std::size_t element, PartMeasures& part) {
  constexpr unsigned sides = 0b00111, triangles = 0b11000;  // of wedge6_topology
  const unsigned exterior = mesh.exterior[element];
  const std::span<const int> corners = mesh.corners(element);
  const auto find_edge = [&](std::size_t a, std::size_t b) {
    return find_distance(mesh.nodes[at(corners[a])], mesh.nodes[at(corners[b])]);
  };
  double thickness = find_edge(0, 3);
  if ((exterior & triangles) != triangles) {
    if (std::popcount(exterior & sides) != 1) return;
    const auto side = static_cast<std::size_t>(std::countr_zero(exterior & sides));  // along the edge from this corner
    thickness = std::min(find_edge((side + 1) % 3, (side + 2) % 3), find_edge((side + 2) % 3, side));
  }
  ++part.layered_wedges;
  part.layer_thickness = std::max(part.layer_thickness, thickness);
}

/// Area of the faces of a tetrahedron or a pyramid that lie on the surface, and how many there are.
double measure_open_faces(const Mesh& mesh, std::size_t element, PartMeasures& part) {
  double area = 0;
  const Topology& topology = mesh.topology_of(element);
  for (int f = 0; f < topology.face_count; ++f) {
    if ((mesh.exterior[element] >> f & 1) == 0) continue;
    const std::array<int, 4> nodes = mesh.elements.face_nodes({static_cast<int>(element), f});
    const auto place = [&](std::size_t i) { return mesh.nodes[at(nodes[i])]; };
    const Vec3 twice = cross(subtract(place(2), place(0)), subtract(place(3), place(1)));
    area += 0.5 * std::sqrt(dot(twice, twice));
    ++part.cut_faces;
  }
  return area;
}

void measure_elements(const Mesh& mesh, std::vector<PartMeasures>& parts) {
  for (std::size_t e = 0; e < mesh.elements.size(); ++e) {
    PartMeasures& part = parts[at(mesh.part_of(e))];
    const Topology& topology = mesh.topology_of(e);
    measure_edges(mesh, e, part);
    measure_height(mesh, e, part);
    ++(topology.is_solid() ? part.solids : topology.is_surface() ? part.shells : part.beams);
    if (topology.is_surface() && topology.corner_count == 3) ++part.triangles;
    if (topology.family == ElementFamily::hexahedra) {
      measure_layer(mesh, e, part);
      measure_ways(mesh, e, part);
    }
    if (topology.family == ElementFamily::wedges) measure_wedge(mesh, e, part);
    if (topology.is_solid() && topology.family != ElementFamily::hexahedra) ++part.small_solids;
  }
}

/// Masses and the sizes of tetrahedra and pyramids by exact sums, which have no order, and sizes of elements.
void measure_masses(const Deck& deck, const Mesh& mesh, std::vector<PartMeasures>& parts) {
  std::vector<ExactSum> sums(3 * parts.size());  // of each part: mass, volume and area of what is cut
  for (std::size_t e = 0; e < mesh.elements.size(); ++e) {
    const ElementBlock& block = mesh.block_of(e);
    const double volume = find_element_volume(mesh, e), size = find_element_size(mesh, e, volume);
    PartMeasures& part = parts[at(block.part)];
    const std::size_t first = 3 * at(block.part);
    part.smallest_element = std::min(part.smallest_element, size);
    part.largest_element = std::max(part.largest_element, size);
    sums[first].add(deck.materials[at(block.material)].density * volume);
    const ElementFamily family = mesh.topology_of(e).family;
    if (family != ElementFamily::tetrahedra && family != ElementFamily::pyramids) continue;
    ++part.cut_solids;
    sums[first + 1].add(volume);
    sums[first + 2].add(measure_open_faces(mesh, e, part));
  }
  if (mesh.ranks && mesh.ranks->size() > 1) sum_over_ranks(*mesh.ranks, sums);
  for (std::size_t p = 0; p < parts.size(); ++p) {
    parts[p].mass = sums[3 * p].round();
    parts[p].cut_volume = sums[3 * p + 1].round();
    parts[p].cut_area = sums[3 * p + 2].round();
  }
}

/// Velocities at time 0 on the host.
using Velocities = decltype(to_host(Rows3<double>()));

Vec3 find_velocity(const Velocities& velocities, int node) {
  return {velocities(node, 0), velocities(node, 1), velocities(node, 2)};
}

/// Counts nodes and the moments of their places, each on the rank that owns it.
void measure_places(const Mesh& mesh, const std::vector<bool>& owned, std::vector<PartMeasures>& parts) {
  constexpr double unit = 1 << 30;
  const Vec3 size = subtract(mesh.high, mesh.low);
  for (std::size_t p = 0; p < parts.size(); ++p) {
    for (const int node : mesh.node_sets.at(mesh.parts[p].name)) {
      if (!owned[at(node)]) continue;
      ++parts[p].nodes;
      for (std::size_t k = 0; k < 3; ++k) {
        const double share = size[k] > 0 ? (mesh.nodes[at(node)][k] - mesh.low[k]) / size[k] : 0;
        parts[p].moments[k] += std::llround(unit * share);
        parts[p].moments[3 + k] += std::llround(unit * share * share);
      }
    }
  }
}

void measure_nodes(const Mesh& mesh, const Velocities& velocities, std::vector<PartMeasures>& parts) {
  for (std::size_t p = 0; p < parts.size(); ++p) {
    PartMeasures& part = parts[p];
    for (const int node : mesh.node_sets.at(mesh.parts[p].name)) {
      const Vec3 velocity = find_velocity(velocities, node);
      widen(mesh.nodes[at(node)], part.low, part.high);
      widen(velocity, part.velocity_low, part.velocity_high);
      part.speed = std::max(part.speed, dot(velocity, velocity));
    }
    part.speed = std::sqrt(part.speed);
  }
}

/// [parts] lowest part of those that are joined.
std::vector<int> find_assemblies(const Mesh& mesh) {
  std::vector<int> assemblies(mesh.parts.size());
  std::iota(assemblies.begin(), assemblies.end(), 0);
  for (bool has_changed = !mesh.joints.empty(); has_changed;) {
    has_changed = false;
    for (const PartJoint& joint : mesh.joints) {
      int &a = assemblies[at(joint.part)], &b = assemblies[at(joint.other)];
      has_changed = has_changed || a != b;
      a = b = std::min(a, b);
    }
  }
  return assemblies;
}

/// Joints of each shared node of this rank.
std::unordered_map<int, std::vector<std::size_t>> find_joints_of_nodes(const Mesh& mesh) {
  std::unordered_map<int, std::vector<std::size_t>> joints;
  std::vector<int> shared;
  for (std::size_t j = 0; j < mesh.joints.size(); ++j) {
    const std::vector<int>&a = mesh.node_sets.at(mesh.parts[at(mesh.joints[j].part)].name),
          &b = mesh.node_sets.at(mesh.parts[at(mesh.joints[j].other)].name);
    shared.clear();
    std::set_intersection(a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(shared));
    for (const int node : shared) joints[node].push_back(j);
  }
  return joints;
}

/// Faces that joined parts share, those of this rank's elements; nothing where the deck joins none.
std::vector<JointMeasures> measure_joints(const Deck& deck, const Mesh& mesh) {
  std::vector<JointMeasures> measures;
  if (deck.joins.empty()) return measures;
  for (const PartJoint& joint : mesh.joints) measures.push_back({joint.part, joint.other, joint.nodes, 0});
  const auto joints = find_joints_of_nodes(mesh);
  for (std::size_t e = 0; e < mesh.elements.size() && !joints.empty(); ++e) {
    const int faces = mesh.topology_of(e).face_count;
    for (int f = 0; f < faces; ++f) {
      const std::array<int, 4> nodes = mesh.elements.face_nodes({static_cast<int>(e), f});
      const auto first = joints.find(nodes[0]);
      if (first == joints.end()) continue;
      for (const std::size_t j : first->second) {
        const auto has = [&](int node) {
          const auto of_node = joints.find(node);
          return of_node != joints.end() && std::binary_search(of_node->second.begin(), of_node->second.end(), j);
        };
        measures[j].faces += measures[j].part == mesh.part_of(e) && std::all_of(nodes.begin() + 1, nodes.end(), has);
      }
    }
  }
  return measures;
}

/// Marks the nodes of this rank's share that it counts in sums over all nodes.
std::vector<bool> find_owned(const ChunkedMesh& chunked) {
  const int rank = chunked.mesh.ranks ? chunked.mesh.ranks->rank() : 0;
  std::vector<bool> owned(chunked.mesh.nodes.size(), true);
  if (!chunked.mesh.ranks || chunked.mesh.ranks->size() == 1) return owned;
  NodeOwners owners(chunked.numbering);
  for (std::size_t n = 0; n < owned.size(); ++n) owned[n] = owners.find(chunked.mesh.node_numbers[n]) == rank;
  return owned;
}

/// Counts of the entries of `initial` on this rank's nodes.
class InitialCounts {
 public:
  InitialCounts(const Deck& deck, const Mesh& mesh, const Velocities& velocities, const std::vector<bool>& owned)
      : deck_(deck), mesh_(mesh), velocities_(velocities), owned_(owned) {}

  std::vector<InitialMeasures> operator()() {
    std::vector<InitialMeasures> entries(deck_.initial.size());
    if (entries.empty()) return entries;
    find_governing(entries);
    find_stopping();
    for (std::size_t n = 0; n < mesh_.nodes.size(); ++n) {
      if (!owned_[n] || governing_[n] < 0) continue;
      InitialMeasures& entry = entries[at(governing_[n])];
      ++entry.governed;
      if (find_velocity(velocities_, static_cast<int>(n)) == Vec3{}) continue;
      ++entry.moving;
      if (stopping_[n] == InitialMeasures::no_condition) continue;
      ++entry.stopped;
      entry.condition = std::min(entry.condition, stopping_[n]);
    }
    return entries;
  }

 private:
  void find_governing(std::vector<InitialMeasures>& entries) {
    governing_.assign(mesh_.nodes.size(), -1);
    for (std::size_t i = 0; i < entries.size(); ++i) {
      for (const int node : select_nodes(mesh_, deck_, deck_.initial[i].where)) {
        governing_[at(node)] = static_cast<int>(i);
        entries[i].selected += owned_[at(node)] ? 1 : 0;
      }
    }
  }

  /// The first condition, or else the rigid part, that keeps each node from its velocity at the start.
  void find_stopping() {
    stopping_.assign(mesh_.nodes.size(), InitialMeasures::no_condition);
    for (std::size_t c = 0; c < deck_.conditions.size(); ++c) {
      const ConditionDeck& condition = deck_.conditions[c];
      if (condition.kind == ConditionDeck::Kind::displacement || condition.turn || !condition.when.from.empty())
        continue;
      for (const int node : select_nodes(mesh_, deck_, condition.where)) {
        for (std::size_t k = 0; k < 3; ++k) {
          const double held = condition.kind == ConditionDeck::Kind::velocity ? condition.value[k](0) : 0;
          if (condition.active[k]) stop(node, k, held, static_cast<int>(c));
        }
      }
    }
    for (std::size_t p = 0; p < deck_.parts.size(); ++p) {
      const auto& rigid = deck_.parts[p].rigid;
      for (std::size_t k = 0; rigid && k < 3; ++k) {
        if (!rigid->fixed[k]) continue;
        for (const int node : mesh_.node_sets.at(deck_.parts[p].name))
          stop(node, k, 0, static_cast<int>(deck_.conditions.size() + p));
      }
    }
  }

  /// Notes what keeps a node at a velocity along an axis, if that takes more than a share of its speed, and nothing
  /// else did before.
  void stop(int node, std::size_t axis, double held, int by) {
    constexpr double share = 0.5;
    const Vec3 velocity = find_velocity(velocities_, node);
    const double least = share * std::sqrt(dot(velocity, velocity));
    if (stopping_[at(node)] == InitialMeasures::no_condition && least > 0 && std::abs(velocity[axis] - held) > least)
      stopping_[at(node)] = by;
  }

  const Deck& deck_;
  const Mesh& mesh_;
  const Velocities& velocities_;
  const std::vector<bool>& owned_;
  std::vector<int> governing_, stopping_;  // [nodes] entries of initial and conditions
};

/// The counts of all ranks, and the least and the largest of any.
void reduce(const Communicator& ranks, SceneMeasures& scene) {
  std::vector<std::int64_t> counts;
  std::vector<double> largest;
  const auto list = [&](const auto& count, const auto& value) {
    for (PartMeasures& part : scene.parts) {
      for (std::int64_t* c : {&part.solids, &part.small_solids, &part.shells, &part.triangles, &part.beams,
                              &part.single_layer, &part.layered_wedges, &part.cut_solids, &part.cut_faces, &part.nodes})
        count(*c);
      for (std::int64_t& way : part.long_ways) count(way);
      for (std::int64_t& moment : part.moments) count(moment);
      value(part.shortest_edge, -1);
      value(part.longest_edge, 1);
      value(part.thinnest, -1);
      value(part.thinnest_sliver, -1);
      value(part.sharpest, 1);
      value(part.smallest_element, -1);
      value(part.largest_element, 1);
      value(part.layer_thickness, 1);
      value(part.speed, 1);
      for (std::size_t k = 0; k < 3; ++k) {
        value(part.low[k], -1);
        value(part.high[k], 1);
        value(part.velocity_low[k], -1);
        value(part.velocity_high[k], 1);
      }
    }
    for (InitialMeasures& entry : scene.initial) {
      for (std::int64_t* c : {&entry.selected, &entry.governed, &entry.moving, &entry.stopped}) count(*c);
    }
    for (JointMeasures& joint : scene.joints) count(joint.faces);
  };
  list([&](std::int64_t c) { counts.push_back(c); }, [&](double x, double sign) { largest.push_back(sign * x); });
  all_reduce(ranks, Reduce::sum, counts);
  all_reduce(ranks, Reduce::largest, largest);
  auto c = counts.begin();
  auto x = largest.begin();
  list([&](std::int64_t& out) { out = *c++; }, [&](double& out, double sign) { out = sign * *x++; });
  std::vector<int> conditions;  // the first of all ranks
  for (const InitialMeasures& entry : scene.initial) conditions.push_back(entry.condition);
  all_reduce(ranks, Reduce::least, conditions);
  for (std::size_t i = 0; i < conditions.size(); ++i) scene.initial[i].condition = conditions[i];
}

}  // namespace

double PartMeasures::extent() const { return std::max({high[0] - low[0], high[1] - low[1], high[2] - low[2]}); }

std::vector<bool> SceneMeasures::mark_beams() const {
  std::vector<bool> has_surface(parts.size(), false), marks;  // has_surface: by assembly
  for (std::size_t p = 0; p < parts.size(); ++p)
    if (parts[p].solids + parts[p].shells > 0) has_surface[at(assemblies[p])] = true;
  for (std::size_t p = 0; p < parts.size(); ++p) marks.push_back(!has_surface[at(assemblies[p])]);
  return marks;
}

SceneMeasures measure_scene(const Deck& deck, const ChunkedMesh& chunked, const Rows3<double>& start_velocity) {
  const Mesh& mesh = chunked.mesh;
  const auto velocities = to_host(start_velocity);
  SceneMeasures scene{std::vector<PartMeasures>(mesh.parts.size(), make_empty()),
                      {},
                      mesh.low,
                      mesh.high,
                      find_assemblies(mesh),
                      measure_joints(deck, mesh)};
  measure_elements(mesh, scene.parts);
  for (const ElementBlock& block : mesh.elements.blocks) {  // the same on all ranks
    double& thickest = scene.parts[at(block.part)].shell_thickness;
    thickest = std::max(thickest, block.section.thickness);
  }
  measure_nodes(mesh, velocities, scene.parts);
  const std::vector<bool> owned = find_owned(chunked);
  measure_places(mesh, owned, scene.parts);
  measure_masses(deck, mesh, scene.parts);
  scene.selections = measure_selections(deck, chunked, owned);
  scene.initial = InitialCounts(deck, mesh, velocities, owned)();
  if (mesh.ranks && mesh.ranks->size() > 1) reduce(*mesh.ranks, scene);
  return scene;
}

void find_velocity_ranges(const Mesh& mesh, const Rows3<double>& velocity, std::vector<Vec3>& low,
                          std::vector<Vec3>& high) {
  const auto velocities = to_host(velocity);
  std::vector<double> bounds;  // -low, high of each part
  for (const MeshPart& part : mesh.parts) {
    Vec3 least{infinity, infinity, infinity}, most{-infinity, -infinity, -infinity};
    for (const int node : mesh.node_sets.at(part.name)) widen(find_velocity(velocities, node), least, most);
    for (std::size_t k = 0; k < 3; ++k) bounds.insert(bounds.end(), {-least[k], most[k]});
  }
  if (mesh.ranks && mesh.ranks->size() > 1) all_reduce(*mesh.ranks, Reduce::largest, bounds);
  low.resize(mesh.parts.size());
  high.resize(mesh.parts.size());
  for (std::size_t p = 0; p < low.size(); ++p) {
    for (std::size_t k = 0; k < 3; ++k) {
      low[p][k] = -bounds[6 * p + 2 * k];
      high[p][k] = bounds[6 * p + 2 * k + 1];
    }
  }
}

std::vector<double> find_part_steps(const ChunkedMesh& chunked, const ChunkResults& results) {
  const Mesh& mesh = chunked.mesh;
  std::vector<double> steps(mesh.parts.size(), infinity);
  const auto bounds = to_host(results.stable_step);
  for (std::size_t c = 0; c < chunked.chunks.size(); ++c) {
    double& step = steps[at(chunked.chunks[c].part)];
    step = std::min(step, bounds(c));
  }
  if (mesh.ranks && mesh.ranks->size() > 1) all_reduce(*mesh.ranks, Reduce::least, steps);
  return steps;
}

}  // namespace percuss
