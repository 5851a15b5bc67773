#include "src/step/relaxation/preload_stage.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "comm/all_reduce.hpp"
#include "comm/exact_reduction.hpp"
#include "kernels/core/host_copy.hpp"
#include "kernels/core/small_space.hpp"
#include "src/deck/laws/material_properties.hpp"
#include "src/error.hpp"
#include "src/index.hpp"
#include "src/mesh/hex_geometry.hpp"
#include "src/step/model/element_blocks.hpp"
#include "src/step/relaxation/preload_records.hpp"

namespace percuss {
namespace {

/// No material yields at it.
constexpr double test_strain = 1e-6;

/// Share of what a force lacks that a step adds. With all of it, elements whose bound the step is near would gain
/// energy: with the share s, a mode of stiffness k and mass m is damped where dt^2 k / m < 4 - 2 s.
double find_gain(const Deck& deck) {
  const double scale = deck.time.step_scale;
  return std::clamp(1 - scale * scale, 0.01, 0.5);
}

ForceDeck make_section(const PreloadDeck& preload) {
  ForceDeck force;
  force.name = preload.name;
  force.kind = ForceDeck::Kind::section;
  force.part = preload.part;
  force.point = *preload.point;
  force.normal = *preload.normal;
  force.place = preload.place;
  return force;
}

const MaterialDeck& find_material(const Deck& deck, const std::string& part) {
  const auto of = std::find_if(deck.parts.begin(), deck.parts.end(), [&](const auto& p) { return p.name == part; });
  return *std::find_if(deck.materials.begin(), deck.materials.end(),
                       [&](const auto& material) { return material.name == of->material; });
}

/// Whether some corners of an element lie behind the plane and some do not.
bool is_cut(const Mesh& mesh, std::size_t element, const PreloadDeck& preload) {
  int behind = 0, count = 0;
  for (const int n : mesh.corners(element)) {
    behind += dot(subtract(mesh.nodes[at(n)], *preload.point), *preload.normal) < 0 ? 1 : 0;
    ++count;
  }
  return behind > 0 && behind < count;
}

bool is_of_layer(const Mesh& mesh, std::size_t element, const PreloadDeck& preload) {
  return preload.point ? is_cut(mesh, element, preload) : mesh.topology_of(element).is_line();
}

/// Axes of an element at time 0: the normal in the frame of a shell, or its component along a beam.
std::array<double, 2> find_axes(const Mesh& mesh, std::size_t element, const PreloadDeck& preload) {
  const int dimension = mesh.topology_of(element).dimension;
  if (dimension == 3 || !preload.normal) return {1, 0};
  const Vec3& n = *preload.normal;
  const auto nodes = mesh.elements.kernel_nodes(element);
  const auto place = [&](std::size_t corner) {
    const Vec3& x = mesh.nodes[at(nodes[corner])];
    return Vector3<double>{x[0], x[1], x[2]};
  };
  if (dimension == 1) {
    const Vector3<double> line = place(1) - place(0);
    return {dot(line, Vector3<double>{n[0], n[1], n[2]}) / norm(line), 0};
  }
  const Vector3<double> corners[4] = {place(0), place(1), place(2), place(3)};
  const MixedShapes<bool> shapes{mesh.corners(element).size() == 3};
  const ShellGeometry<double> g = find_shell_geometry(find_differences(corners), shapes);
  const Vector3<double> turned = g.frame * Vector3<double>{n[0], n[1], n[2]};
  return {turned.x, turned.y};
}

/// Nodes whose places times their shares sum up to the length of an element: the mean place of its corners ahead of the
/// plane less that of those behind it, along the normal; of a beam without a plane, along its axis at time 0.
std::vector<std::pair<int, Vec3>> find_end_shares(const Mesh& mesh, std::size_t element, const PreloadDeck& preload) {
  const auto corners = mesh.corners(element);
  const Vec3 along = preload.point ? *preload.normal : subtract(mesh.nodes[at(corners[1])], mesh.nodes[at(corners[0])]);
  const double norm = std::sqrt(dot(along, along));
  const auto is_behind = [&](std::size_t i) {
    return preload.point ? dot(subtract(mesh.nodes[at(corners[i])], *preload.point), along) < 0 : i == 0;
  };
  double behind = 0, ahead = 0;
  for (std::size_t i = 0; i < corners.size(); ++i) (is_behind(i) ? behind : ahead) += 1;
  std::vector<std::pair<int, Vec3>> shares;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const double share = is_behind(i) ? -1 / (behind * norm) : 1 / (ahead * norm);
    shares.push_back({corners[i], {share * along[0], share * along[1], share * along[2]}});
  }
  return shares;
}

Shortening make_shortening(const LameConstants& moduli, bool is_kirchhoff, const Vec3& n) {
  Shortening by{};
  const double lambda = moduli.lambda, mu = moduli.mu;
  by.is_kirchhoff = is_kirchhoff;
  by.modulus = lambda + 2 * mu;
  by.plane_lambda = 2 * lambda * mu / by.modulus;
  by.shear_twice = 2 * mu;
  by.dyad = {{n[0] * n[0], n[1] * n[1], n[2] * n[2], n[0] * n[1], n[1] * n[2], n[2] * n[0]}};
  for (int k = 0; k < 6; ++k) by.stress[k] = 2 * mu * by.dyad[k] + (k < 3 ? lambda : 0);
  return by;
}

/// Places of the corners of elements, at n.
struct CornerPositions {
  ElementChunks chunks;
  Rows3<const double> x;

  KOKKOS_INLINE_FUNCTION Vector3<double> find(int c, int e, int corner) const {
    const int n = chunks.slots_to_nodes(number_corner_slot(chunks, c, e, corner));
    return {x(n, 0), x(n, 1), x(n, 2)};
  }
  KOKKOS_INLINE_FUNCTION double find_length(int c, int e) const { return norm(find(c, e, 1) - find(c, e, 0)); }
  KOKKOS_INLINE_FUNCTION double find_area(int c, int e) const {
    return 0.5 * norm(cross(find(c, e, 2) - find(c, e, 0), find(c, e, 3) - find(c, e, 1)));
  }
};

/// Lanes of the records of an element: those past the last element of a chunk repeat it.
struct RecordLanes {
  ElementChunks chunks;
  Array<Real> records;

  KOKKOS_INLINE_FUNCTION int find_end(int c, int e) const { return find_lane_end(chunks, c, e); }
  KOKKOS_INLINE_FUNCTION LaneRecord<Real> find(int c, int lane) const { return find_record(chunks, records, c, lane); }
};

/// Shortens the elements of a layer, by one strain along the normal.
struct ShortenLayer {
  RecordLanes lanes;
  CornerPositions places;
  Kokkos::View<BeamParameters*, MemSpace> beams;
  Kokkos::View<ThicknessPoints*, MemSpace> rules;
  Array<const int> chunks, first, elements;
  Array<const double> volume, axes;
  Shortening by;
  ChunkResults results;

  KOKKOS_FUNCTION void operator()(int i) const {
    const int c = chunks(i);
    double work = 0;
    for (int j = first(i); j < first(i + 1); ++j) {
      const int e = elements(j), end = lanes.find_end(c, e);
      for (int lane = e; lane < end; ++lane) {
        const double energy = shorten_lane(c, j, lanes.find(c, lane));
        if (lane == e) work += energy;
      }
    }
    results.work(c, WorkKind::internal) += work;
    results.is_settled(c) = 0;
  }

  KOKKOS_FUNCTION double shorten_lane(int c, int j, const LaneRecord<Real>& record) const {
    const ElementChunks& all = lanes.chunks;
    if (is_beam(all, c))
      return places.find_length(c, elements(j)) *
             shorten_beam(record, beams(all.parameters(c)), by.strain * axes(2 * j) * axes(2 * j));
    if (!is_shell(all, c)) return volume(j) * shorten_solid(record, all.points(c), by);
    const double n[2] = {axes(2 * j), axes(2 * j + 1)};
    return places.find_area(c, elements(j)) * record.get(ShellRecord::thickness) *
           shorten_shell(record, rules(all.rule(c)), find_layer_size(all, c), n, by);
  }
};

/// The beams of a layer, by chunk.
struct BeamLists {
  Array<const int> chunks, first, elements;
};

struct BeamForce {
  double force;  // that each beam shall have
  double gain;   // share of what it lacks that it gets now
};

/// Forces that the beams of a rank lack; 0 where none lacks any.
struct LackingForces {
  double largest = 0, smallest = 0;
};

/// Gives each beam what its own force lacks.
LackingForces shorten_lacking(const Model& model, const BeamLists& lists, const BeamForce& wanted, const State& state) {
  const RecordLanes lanes{model.chunks, state.elements};
  const CornerPositions places{model.chunks, state.x};
  const auto beams = model.others->beams.parameters;
  const auto chunks = lists.chunks, first = lists.first, elements = lists.elements;
  const ChunkResults results = state.results;
  const double force = wanted.force, gain = wanted.gain;
  LackingForces found;
  parallel_reduce(
      "percuss::preload_beams", RangeOf(ExecSpace(), 0, static_cast<int>(chunks.extent(0))),
      KOKKOS_LAMBDA(const int i, double& largest, double& smallest) {
        const int c = chunks(i);
        const BeamParameters& parameters = beams(lanes.chunks.parameters(c));
        double work = 0;
        for (int j = first(i); j < first(i + 1); ++j) {
          const int e = elements(j), end = lanes.find_end(c, e);
          const double lack = force - lanes.find(c, e).get(BeamRecord::forces);
          largest = lack > largest ? lack : largest;
          smallest = lack < smallest ? lack : smallest;
          for (int lane = e; lane < end; ++lane) {
            const double energy =
                shorten_beam(lanes.find(c, lane), parameters, gain * lack / parameters.stiffness.axial);
            if (lane == e) work += places.find_length(c, e) * energy;
          }
        }
        results.work(c, WorkKind::internal) += work;
        results.is_settled(c) = 0;
      },
      Kokkos::Max<double>(found.largest), Kokkos::Min<double>(found.smallest));
  return found;
}

}  // namespace

PreloadStage::PreloadStage(const Deck& deck, const ChunkedMesh& chunked, const Model& model)
    : deck_(deck), model_(model), gain_(find_gain(deck)), forces_(deck.start.preloads.size(), 0) {
  for (const PreloadDeck& preload : deck.start.preloads) {
    Layer layer = make_layer(deck, preload);
    find_elements(chunked, layer);
    if (preload.point) layer.section.emplace(deck, make_section(preload), chunked, model);
    layers_.push_back(layer);
  }
}

PreloadStage::Layer PreloadStage::make_layer(const Deck& deck, const PreloadDeck& preload) {
  const MaterialDeck& material = find_material(deck, preload.part);
  return {preload, {}, find_moduli(material), material.law.model == Elastic::name, 0, {}, {}, {}, {}, {}, {}};
}

/// Throws, on all ranks. A plane is reported with the heights of the part above it.
void PreloadStage::refuse_no_elements(const Mesh& mesh, const PreloadDeck& preload) const {
  const std::string begin = fmt::format("{}: error: preload '{}'", deck_.where(preload.place), preload.name);
  if (!preload.point)
    throw InputError(
        fmt::format("{} is of part '{}', which has no beams: give it point and normal", begin, preload.part));
  double low = std::numeric_limits<double>::infinity(), high = -low;
  for (const int n : mesh.node_sets.at(preload.part)) {
    const double height = dot(subtract(mesh.nodes[at(n)], *preload.point), *preload.normal);
    low = std::min(low, height);
    high = std::max(high, height);
  }
  all_reduce(model_.ranks, Reduce::least, low);
  all_reduce(model_.ranks, Reduce::largest, high);
  const bool is_inside = low < 0 && high > 0;
  throw InputError(fmt::format(
      "{} cuts no element (its plane lies {} part '{}', which begins {:.6g} and ends {:.6g} from it along the normal): "
      "move its point into {}",
      begin, is_inside ? "between elements of" : "beside", preload.part, low, high,
      is_inside ? "an element" : "the part"));
}

void PreloadStage::find_elements(const ChunkedMesh& chunked, Layer& layer) const {
  std::vector<int> chunks, first{0}, elements;
  std::vector<double> volume, axes;
  for (std::size_t c = 0; c < chunked.chunks.size(); ++c) {
    const Chunk& chunk = chunked.chunks[c];
    if (deck_.parts[at(chunk.part)].name != layer.deck.part) continue;
    for (int e = chunk.first_element; e < chunk.first_element + chunk.element_count; ++e) {
      if (!is_of_layer(chunked.mesh, at(e), layer.deck)) continue;
      elements.push_back(e - chunk.first_element);
      volume.push_back(chunked.mesh.topology_of(at(e)).dimension == 3 ? find_element_volume(chunked.mesh, at(e)) : 0);
      for (const double axis : find_axes(chunked.mesh, at(e), layer.deck)) axes.push_back(axis);
      for (const auto& [node, share] : find_end_shares(chunked.mesh, at(e), layer.deck))
        layer.corners.push_back({node, share});
    }
    if (static_cast<int>(elements.size()) == first.back()) continue;
    chunks.push_back(static_cast<int>(c));
    first.push_back(static_cast<int>(elements.size()));
  }
  int some = elements.empty() ? 0 : 1;
  all_reduce(model_.ranks, Reduce::largest, some);
  if (some == 0) refuse_no_elements(chunked.mesh, layer.deck);
  layer.chunks = to_view("percuss::preloaded_chunks", chunks);
  layer.first = to_view("percuss::first_preloaded", first);
  layer.elements = to_view("percuss::preloaded_elements", elements);
  layer.volume = to_view("percuss::preloaded_volume", volume);
  layer.axes = to_view("percuss::preloaded_axes", axes);
}

void PreloadStage::shorten(const Layer& layer, double strain, State& state) const {
  Shortening by = make_shortening(layer.moduli, layer.is_kirchhoff, *layer.deck.normal);
  by.strain = strain;
  parallel_for("percuss::add_preload", RangeOf(ExecSpace(), 0, static_cast<int>(layer.chunks.extent(0))),
               ShortenLayer{{model_.chunks, state.elements},
                            {model_.chunks, state.x},
                            model_.others->beams.parameters,
                            model_.thickness_rules,
                            layer.chunks,
                            layer.first,
                            layer.elements,
                            layer.volume,
                            layer.axes,
                            by,
                            state.results});
}

/// Gives each beam what its own force lacks. Returns the largest of that, with its sign; the same on all ranks.
double PreloadStage::shorten_beams(const Layer& layer, double force, State& state) const {
  const LackingForces found =
      shorten_lacking(model_, {layer.chunks, layer.first, layer.elements}, {force, gain_}, state);
  double most = found.largest, least = found.smallest;
  all_reduce(model_.ranks, Reduce::largest, most);
  all_reduce(model_.ranks, Reduce::least, least);
  return most > -least ? most : least;
}

/// Forces of sections; 0 for others.
std::vector<double> PreloadStage::find_forces(const State& state) {
  std::vector<ExactSum> sums;
  for (Layer& layer : layers_) {
    const ImpulseSums of_layer = layer.section ? layer.section->find_impulse(state, 1) : ImpulseSums{};
    sums.insert(sums.end(), of_layer.begin(), of_layer.begin() + 3);
  }
  sum_over_ranks(model_.ranks, sums);
  std::vector<double> forces;
  for (std::size_t i = 0; i < layers_.size(); ++i) {
    const Vec3 force{sums[3 * i].round(), sums[3 * i + 1].round(), sums[3 * i + 2].round()};
    forces.push_back(dot(force, layers_[i].deck.normal.value_or(Vec3{})));
  }
  return forces;
}

std::vector<double> PreloadStage::find_lengths(const State& state) const {
  const auto x = to_host(state.x);
  std::vector<ExactSum> sums(2 * layers_.size());
  for (std::size_t i = 0; i < layers_.size(); ++i) {
    for (const Corner& corner : layers_[i].corners)
      for (std::size_t k = 0; k < 3; ++k) sums[2 * i].add(corner.share[k] * x(at(corner.node), k));
    sums[2 * i + 1].add(static_cast<double>(layers_[i].elements.extent(0)));
    sums[2 * i].normalize();
  }
  sum_over_ranks(model_.ranks, sums);
  std::vector<double> lengths;
  for (std::size_t i = 0; i < layers_.size(); ++i) lengths.push_back(sums[2 * i].round() / sums[2 * i + 1].round());
  return lengths;
}

void PreloadStage::measure_stiffness(State& state, const std::function<void()>& evaluate) {
  const std::vector<double> before = find_forces(state);
  for (std::size_t i = 0; i < layers_.size(); ++i) {
    Layer& layer = layers_[i];
    if (!layer.section) continue;
    shorten(layer, test_strain, state);
    evaluate();
    layer.stiffness = (find_forces(state)[i] - before[i]) / test_strain;
    shorten(layer, -test_strain, state);
    evaluate();
    if (layer.stiffness > 0) continue;
    throw InputError(
        fmt::format("{}: error: preload '{}' is of a section without area (the plane does not part the elements that "
                    "it cuts along its normal): move its point",
                    deck_.where(layer.deck.place), layer.deck.name));
  }
}

void PreloadStage::tighten(State& state, double share) {
  forces_ = find_forces(state);
  largest_lack_ = 0;
  for (std::size_t i = 0; i < layers_.size(); ++i) {
    const Layer& layer = layers_[i];
    const double wanted = share * layer.deck.force;
    const double lack = layer.section ? wanted - forces_[i] : shorten_beams(layer, wanted, state);
    const double share_lacking = std::abs(lack / layer.deck.force);
    if (!(share_lacking <= largest_lack_)) largest_lacking_ = i;
    largest_lack_ = std::max(largest_lack_, share_lacking);
    forces_[i] = layer.section ? forces_[i] : wanted - lack;
    if (layer.section) shorten(layer, gain_ * lack / layer.stiffness, state);
  }
}

}  // namespace percuss
