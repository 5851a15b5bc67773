#include "src/step/damping/build_stiffness_damping.hpp"

#include <fmt/format.h>

#include "kernels/core/host_copy.hpp"
#include "src/deck/laws/law_traits.hpp"
#include "src/deck/laws/material_properties.hpp"
#include "src/error.hpp"
#include "src/index.hpp"
#include "src/step/model/element_blocks.hpp"

namespace percuss {
namespace {

/// Damping factor of a part; rigid ones have none.
double find_factor(const Deck& deck, int part) {
  return deck.parts[at(part)].rigid ? 0 : deck.find_elements(at(part)).stiffness_damping;
}

ElementFamily find_block_family(const ElementBlock& block) { return find_topology(block.topology).family; }

const char* find_refusal(const Deck& deck, const ElementBlock& block) {
  const ElementFamily family = find_block_family(block);
  const bool is_damped =
      family == ElementFamily::hexahedra || family == ElementFamily::shells || find_topology(block.topology).is_line();
  if (!is_damped) return "(stiffness_damping acts on hexahedra, shells and beams): set it by part";
  if (!grows_in_increments(deck.materials[at(block.material)]))
    return "(stiffness_damping needs elastic constants that do not change: of elastic and of plastic materials without "
           "an equation of state): set it by part";
  return nullptr;
}

/// Throws on all ranks alike: they know all blocks.
void refuse_others(const Deck& deck, const Mesh& mesh) {
  for (const ElementBlock& block : mesh.elements.blocks) {
    if (find_factor(deck, block.part) == 0) continue;
    const PartDeck& part = deck.parts[at(block.part)];
    if (deck.time.step_estimate == TimeDeck::StepEstimate::global)
      throw InputError(
          fmt::format("{}: error: part '{}' has stiffness_damping (time.step_estimate: global does not "
                      "know it): use time.step_estimate: element",
                      deck.where(part.place), part.name));
    const char* const refusal = find_refusal(deck, block);
    if (refusal == nullptr) continue;
    throw InputError(fmt::format("{}: error: part '{}' with its {} of material '{}' cannot be damped {}",
                                 deck.where(part.place), part.name, find_topology(block.topology).name,
                                 deck.materials[at(block.material)].name, refusal));
  }
}

PlaneElasticity make_plane_elasticity(const LameConstants& moduli) {
  const double sum = moduli.lambda + moduli.mu;
  return find_plane_elasticity(moduli.mu * (3 * moduli.lambda + 2 * moduli.mu) / sum, 0.5 * moduli.lambda / sum);
}

/// Mean square of the places of the points in half the thickness.
double find_bending_square(int points) {
  const ThicknessPoints rule = find_thickness_points(points);
  double sum = 0;
  for (int p = 0; p < points; ++p) sum += rule.weight[p] * rule.place[p] * rule.place[p];
  return sum;
}

bool has_triangle(const ChunkedMesh& chunked, const Chunk& chunk) {
  for (int e = chunk.first_element; e < chunk.first_element + chunk.element_count; ++e)
    if (chunked.mesh.topology_of(at(e)).corner_count == 3) return true;
  return false;
}

/// The chunks of this rank, while they are listed.
struct DampedLists {
  std::vector<int> solids, shells, beams;
  std::vector<DampedKind> kind;
  std::vector<double> factor, lambda, mu;
  std::vector<DampedSection> sections;
  bool has_triangles = false;

  explicit DampedLists(std::size_t count)
      : kind(count, DampedKind::mean), factor(count, 0), lambda(count, 0), mu(count, 0), sections(count) {}
};

void list_chunk(const Deck& deck, const ChunkedMesh& chunked, int points, std::size_t c, DampedLists& lists) {
  const Chunk& chunk = chunked.chunks[c];
  const double beta = lists.factor[c] = is_uncomputed(deck, at(chunk.part)) ? 0 : find_factor(deck, chunk.part);
  if (beta == 0) return;
  const ElementBlock& block = find_block(chunked, chunk);
  const LameConstants moduli = find_moduli(deck.materials[at(block.material)]);
  if (find_block_family(block) == ElementFamily::shells) {
    lists.shells.push_back(static_cast<int>(c));
    lists.sections[c] = {make_plane_elasticity(moduli), beta, find_bending_square(points),
                         deck.parts[at(chunk.part)].offset, block.section.is_membrane};
    lists.has_triangles = lists.has_triangles || has_triangle(chunked, chunk);
    return;
  }
  if (find_topology(block.topology).is_line()) {
    lists.beams.push_back(static_cast<int>(c));
    return;
  }
  lists.solids.push_back(static_cast<int>(c));
  using Integration = ElementDeck::Integration;
  const Integration integration = deck.find_elements(at(chunk.part)).integration;
  lists.kind[c] = integration == Integration::full          ? DampedKind::full
                  : integration == Integration::thick_shell ? DampedKind::thick
                                                            : DampedKind::mean;
  lists.lambda[c] = beta * moduli.lambda;
  lists.mu[c] = beta * moduli.mu;
}

}  // namespace

void build_stiffness_damping(const Deck& deck, const ChunkedMesh& chunked, Model& model) {
  refuse_others(deck, chunked.mesh);
  bool is_asked_for = false;
  for (std::size_t p = 0; p < deck.parts.size(); ++p)
    is_asked_for = is_asked_for || find_factor(deck, static_cast<int>(p)) > 0;
  model.damps_stiffness = is_asked_for;
  if (!is_asked_for) return;
  DampedLists lists(chunked.chunks.size());
  const auto points = to_host(model.chunks.points);
  for (std::size_t c = 0; c < chunked.chunks.size(); ++c) list_chunk(deck, chunked, points(c), c, lists);
  model.stiffness_damping = to_view("percuss::stiffness_damping", lists.factor);
  model.others->damped_solids = {to_view("percuss::damped_solids", lists.solids),
                                 to_view("percuss::damping_lambda", lists.lambda),
                                 to_view("percuss::damping_mu", lists.mu), to_view("percuss::damped_kind", lists.kind)};
  model.others->damped_shells = {to_view("percuss::damped_shells", lists.shells),
                                 to_view("percuss::damped_sections", lists.sections), lists.has_triangles};
  model.others->damped_beams = {to_view("percuss::damped_beams", lists.beams), model.stiffness_damping,
                                model.others->beams.parameters};
}

}  // namespace percuss
