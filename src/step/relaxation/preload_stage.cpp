#include "src/step/relaxation/preload_stage.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "comm/all_reduce.hpp"
#include "comm/exact_reduction.hpp"
#include "kernels/core/host_copy.hpp"
#include "src/deck/make_material.hpp"
#include "src/error.hpp"
#include "src/index.hpp"
#include "src/mesh/hex_geometry.hpp"
#include "src/step/model/pack_width.hpp"

namespace percuss {
namespace {

/// No material yields at it.
constexpr double test_strain = 1e-6;

ForceDeck make_section(const PreloadDeck& preload) {
  ForceDeck force;
  force.name = preload.name;
  force.kind = ForceDeck::Kind::section;
  force.part = preload.part;
  force.point = preload.point;
  force.normal = preload.normal;
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
    behind += dot(subtract(mesh.nodes[at(n)], preload.point), preload.normal) < 0 ? 1 : 0;
    ++count;
  }
  return behind > 0 && behind < count;
}

/// What the records of a layer are shortened with.
struct Shortening {
  // xx, yy, zz, xy, yz, zx of n n, and of the stress of a strain of 1 along n
  Kokkos::Array<double, 6> dyad, stress;
  double modulus;     // lambda + 2 mu
  bool is_kirchhoff;  // the law has the rate of J sigma
  double strain;
};

/// J = det V of a record.
KOKKOS_INLINE_FUNCTION double find_volume_ratio(const Real* record) {
  const Real* const v = record + HexRecord::stretch * pack_width;
  double c[6];
  for (int k = 0; k < 6; ++k) c[k] = static_cast<double>(v[k * pack_width]);
  return c[0] * (c[1] * c[2] - c[4] * c[4]) - c[3] * (c[3] * c[2] - c[4] * c[5]) + c[5] * (c[3] * c[4] - c[1] * c[5]);
}

/// Shortens one lane of a record by a strain along the normal, at the same places of its nodes. Returns the energy that
/// this takes, per volume at time 0.
KOKKOS_INLINE_FUNCTION double shorten_record(Real* record, int points, const Shortening& by) {
  const double j = find_volume_ratio(record), share = by.is_kirchhoff ? 1 / j : 1;
  double energy = 0;
  for (int p = 0; p < points; ++p) {
    Real* const s = record + (HexRecord::stress + 6 * p) * pack_width;
    double along = 0;  // n . s n
    for (int k = 0; k < 6; ++k) along += (k < 3 ? 1 : 2) * by.dyad[k] * static_cast<double>(s[k * pack_width]);
    energy += by.strain * (along + 0.5 * share * by.strain * by.modulus);
    for (int k = 0; k < 6; ++k) s[k * pack_width] += static_cast<Real>(share * by.strain * by.stress[k]);
  }
  return j * energy / points;
}

}  // namespace

PreloadStage::PreloadStage(const Deck& deck, const ChunkedMesh& chunked, const Model& model)
    : deck_(deck), model_(model), forces_(deck.start.preloads.size(), 0) {
  for (const PreloadDeck& preload : deck.start.preloads) {
    Layer layer{preload, SectionForce(deck, make_section(preload), chunked, model), 0, false, 0, {}, {}, {}, {}, {},
                {}};
    const MaterialDeck& material = find_material(deck, preload.part);
    const LameConstants moduli = find_moduli(material);
    layer.is_kirchhoff = material.law.model == Elastic::name;
    layer.modulus = moduli.lambda + 2 * moduli.mu;
    const Vec3& n = preload.normal;
    layer.dyad = {{n[0] * n[0], n[1] * n[1], n[2] * n[2], n[0] * n[1], n[1] * n[2], n[2] * n[0]}};
    for (int k = 0; k < 6; ++k) layer.stress[k] = 2 * moduli.mu * layer.dyad[k] + (k < 3 ? moduli.lambda : 0);
    find_elements(chunked, layer);
    layers_.push_back(layer);
  }
}

void PreloadStage::find_elements(const ChunkedMesh& chunked, Layer& layer) const {
  std::vector<int> chunks, first{0}, elements;
  std::vector<double> volume;
  int others = 0;
  for (std::size_t c = 0; c < chunked.chunks.size(); ++c) {
    const Chunk& chunk = chunked.chunks[c];
    if (deck_.parts[at(chunk.part)].name != layer.deck.part) continue;
    for (int e = chunk.first_element; e < chunk.first_element + chunk.element_count; ++e) {
      if (!is_cut(chunked.mesh, at(e), layer.deck)) continue;
      if (chunked.mesh.topology_of(at(e)).dimension != 3) others = 1;
      elements.push_back(e - chunk.first_element);
      volume.push_back(find_element_volume(chunked.mesh, at(e)));
    }
    if (static_cast<int>(elements.size()) == first.back()) continue;
    chunks.push_back(static_cast<int>(c));
    first.push_back(static_cast<int>(elements.size()));
  }
  all_reduce(model_.ranks, Reduce::largest, others);
  if (others != 0)
    throw InputError(
        fmt::format("{}: error: preload '{}' cuts shells or beams (only solids have one): move its plane, "
                    "or give the fastener solid elements",
                    deck_.where(layer.deck.place), layer.deck.name));
  layer.chunks = to_view("percuss::preloaded_chunks", chunks);
  layer.first = to_view("percuss::first_preloaded", first);
  layer.elements = to_view("percuss::preloaded_elements", elements);
  layer.volume = to_view("percuss::preloaded_volume", volume);
}

/// Lanes past the last element of a chunk repeat it.
void PreloadStage::shorten(const Layer& layer, double strain, State& state) const {
  const HexChunks chunks = model_.chunks;
  const Array<Real> records = state.elements;
  const ChunkResults results = state.results;
  const Array<int> list = layer.chunks, first = layer.first, elements = layer.elements;
  const Array<double> volume = layer.volume;
  const Shortening by{layer.dyad, layer.stress, layer.modulus, layer.is_kirchhoff, strain};
  Kokkos::parallel_for(
      "percuss::add_preload", Range(ExecSpace(), 0, static_cast<int>(list.extent(0))), KOKKOS_LAMBDA(const int i) {
        const int c = list(i), size = chunks.record_size(c), points = chunks.points(c);
        const int count = chunks.first_element(c + 1) - chunks.first_element(c),
                  lanes = (chunks.first_pack(c + 1) - chunks.first_pack(c)) * pack_width;
        double work = 0;
        for (int j = first(i); j < first(i + 1); ++j) {
          const int e = elements(j), end = e + 1 < count ? e + 1 : lanes;
          for (int lane = e; lane < end; ++lane) {
            Real* const record =
                &records(chunks.first_state(c)) + lane / pack_width * size * pack_width + lane % pack_width;
            const double energy = volume(j) * shorten_record(record, points, by);
            if (lane == e) work += energy;
          }
        }
        results.work(c, 0) += work;
        results.is_settled(c) = 0;
      });
}

std::vector<double> PreloadStage::find_forces(const State& state) {
  std::vector<ExactSum> sums;
  for (Layer& layer : layers_) {
    const ImpulseSums of_layer = layer.section.find_impulse(state, 1);
    sums.insert(sums.end(), of_layer.begin(), of_layer.begin() + 3);
  }
  sum_over_ranks(model_.ranks, sums);
  std::vector<double> forces;
  for (std::size_t i = 0; i < layers_.size(); ++i) {
    const Vec3 force{sums[3 * i].round(), sums[3 * i + 1].round(), sums[3 * i + 2].round()};
    forces.push_back(dot(force, layers_[i].deck.normal));
  }
  return forces;
}

void PreloadStage::measure_stiffness(State& state, const std::function<void()>& evaluate) {
  const std::vector<double> before = find_forces(state);
  for (std::size_t i = 0; i < layers_.size(); ++i) {
    Layer& layer = layers_[i];
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
    const double lack = share * layers_[i].deck.force - forces_[i];
    largest_lack_ = std::max(largest_lack_, std::abs(lack / layers_[i].deck.force));
    shorten(layers_[i], lack / layers_[i].stiffness, state);
  }
}

}  // namespace percuss
