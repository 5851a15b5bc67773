#pragma once
// The compiled variant of the element that computes a chunk, its constants, and what its records hold: the place
// where the materials of a deck become those of the kernels.

#include <algorithm>
#include <array>
#include <map>
#include <tuple>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

#include "kernels/core/host_copy.hpp"
#include "kernels/element/hex8/hex_record.hpp"
#include "kernels/element/internal_force.hpp"
#include "kernels/material/laws/call_material.hpp"
#include "kernels/one_point/one_point_chunks.hpp"
#include "kernels/shell/thickness_points.hpp"
#include "kernels/tet/tet_chunks.hpp"
#include "src/deck/deck.hpp"
#include "src/mesh/hex_geometry.hpp"
#include "src/step/elements/build_shells.hpp"
#include "src/step/elements/element_mass.hpp"
#include "src/step/model/model.hpp"

namespace percuss {

/// of_material: points across a thick shell unless the deck says.
inline HexKind find_kind(const ElementDeck& deck, int of_material) {
  if (deck.integration == ElementDeck::Integration::full) return HexKind::full;
  if (deck.integration == ElementDeck::Integration::thick_shell) {
    const int points = deck.thick_points > 0 ? deck.thick_points : of_material;
    return points == layers_of<HexKind::thick3> ? HexKind::thick3 : HexKind::thick5;
  }
  switch (deck.hourglass) {
    case ElementDeck::Hourglass::stiffness:
      return HexKind::stiffness;
    case ElementDeck::Hourglass::viscous:
      return HexKind::viscous;
    case ElementDeck::Hourglass::assumed_strain:
      break;
  }
  return HexKind::assumed_strain;
}

template <class List>
struct VariantOf;
template <class... Material>
struct VariantOf<TypeList<Material...>> {
  using type = std::variant<Material...>;
};

/// A material of the deck as elements compute it: the law itself, or one that calls it.
struct KernelMaterial {
  VariantOf<CompiledMaterials>::type material;
  std::array<int, history_scalars> named_history;  // places of named scalars, from the first; -1: it has none
};
KernelMaterial make_kernel_material(const MaterialDeck& material);

/// Data of an element for code of a user. Throws InputError as find_user_lengths() does.
UserElement describe_to_user(const Deck& deck, const Mesh& mesh, std::size_t element);

/// Adds the chunks of one material to the variant that computes it, and says how long its records are.
struct BlockBuilder {
  const Deck& deck;
  const ChunkedMesh& chunked;
  std::vector<KernelMaterial> materials;  // of the deck
  std::vector<int> record_size, history, points, rule, parameters, scalars;
  std::vector<std::size_t> first_start;  // by chunk, into start_values
  std::vector<int> start_count;
  std::vector<double> start_values;

  template <class Material, HexKind Kind>
  void build(HexBlock<Material, Kind>& block) {
    const auto is_ours = [&](const Chunk& chunk) {
      return find_family(chunk) == ElementFamily::hexahedra && find_kind(chunk) == Kind;
    };
    add_chunks<Material>(is_ours, block, [&](std::size_t c, const auto& material, const auto& named) {
      describe_records(c, material, named, (HexRecord::history<Kind, Material>), hex_points<Kind>);
    });
  }

  template <class Material>
  void build(TetBlock<Material>& block) {
    const auto is_ours = [&](const Chunk& chunk) { return find_family(chunk) == ElementFamily::tetrahedra; };
    add_chunks<Material>(is_ours, block, [&](std::size_t c, const auto& material, const auto& named) {
      describe_records(c, material, named, TetRecord::history, 1);
    });
  }

  template <class Material, class Shape>
  void build(OnePointBlock<Material, Shape>& block) {
    constexpr ElementFamily family = std::is_same_v<Shape, Wedge6> ? ElementFamily::wedges : ElementFamily::pyramids;
    const auto is_ours = [&](const Chunk& chunk) { return find_family(chunk) == family; };
    add_chunks<Material>(is_ours, block, [&](std::size_t c, const auto& material, const auto& named) {
      describe_records(c, material, named, OnePointRecord<Shape>::history, 1);
    });
  }

  ElementFamily find_family(const Chunk& chunk) const {
    return find_topology(find_block(chunked, chunk).topology).family;
  }

  /// Kind of a chunk of hexahedra. What is not elastic yields, as for shells.
  HexKind find_kind(const Chunk& chunk) const {
    const auto& material = materials[static_cast<std::size_t>(find_block(chunked, chunk).material)].material;
    return percuss::find_kind(find_elements(chunk), std::holds_alternative<Elastic>(material)
                                                        ? points_of_elastic_shells
                                                        : points_of_plastic_shells);
  }

  /// The settings of the part of a chunk, which has no other.
  ElementDeck find_elements(const Chunk& chunk) const {
    return deck.find_elements(static_cast<std::size_t>(chunk.part));
  }

  /// is_ours(chunk): whether the block computes it if its material is Material; describe(c, material, named history) is
  /// called for each that it computes. A row of parameters for each material with its settings.
  template <class Material, class IsOurs, class Block, class Describe>
  void add_chunks(const IsOurs& is_ours, Block& block, const Describe& describe) {
    std::vector<int> chunks;
    std::vector<SolidParameters<Material>> rows;
    std::map<std::tuple<int, bool, std::array<double, 3>>, int> row_of_settings;
    for (std::size_t c = 0; c < chunked.chunks.size(); ++c) {
      if (!is_ours(chunked.chunks[c])) continue;
      const int index = find_block(chunked, chunked.chunks[c]).material;
      const ElementDeck settings = find_elements(chunked.chunks[c]);
      const KernelMaterial& of_chunk = materials[static_cast<std::size_t>(index)];
      if (!std::holds_alternative<Material>(of_chunk.material)) continue;
      const bool is_scaled = deck.find_mass_scaling(static_cast<std::size_t>(chunked.chunks[c].part)) != nullptr;
      const std::tuple key{
          index, is_scaled,
          std::array{settings.hourglass_coefficient, settings.linear_viscosity, settings.quadratic_viscosity}};
      const auto [row, is_new] = row_of_settings.emplace(key, static_cast<int>(rows.size()));
      if (is_new) {
        Material material = std::get<Material>(of_chunk.material);
        if constexpr (is_called<Material>) material.is_scaled = is_scaled;
        rows.push_back(make_parameters(material, settings));
      }
      const Material& material = rows[static_cast<std::size_t>(row->second)].material;
      if (!is_uncomputed_chunk(deck, chunked.chunks[c])) chunks.push_back(static_cast<int>(c));
      parameters[c] = row->second;
      describe(c, material, of_chunk.named_history);
      if constexpr (is_called<Material>) add_start_history(c, material);
    }
    block.chunks = to_view("percuss::chunks_of_block", chunks);
    block.parameters = to_view("percuss::parameters", rows);
  }

  /// first: place of the history in a record; point_count: points of an element.
  template <class Material>
  void describe_records(std::size_t c, const Material& material, const std::array<int, history_scalars>& named,
                        int first, int point_count) {
    int count = Material::history_count;
    if constexpr (is_called<Material>) count = material.count_history();
    record_size[c] = first + point_count * (1 + HexRecord::rest) * count;
    points[c] = point_count;
    history[c] = count > 0 ? first : -1;
    for (std::size_t k = 0; k < named.size(); ++k)
      scalars[c * history_scalars + k] = named[k] < 0 ? -1 : first + point_count * named[k];
  }

  /// The history of the elements of a chunk at the start.
  void add_start_history(std::size_t c, const CalledMaterial& material) {
    const Chunk& chunk = chunked.chunks[c];
    const auto count = static_cast<std::size_t>(material.count_history());
    first_start[c] = start_values.size();
    start_count[c] = material.count_history();
    for (int e = chunk.first_element; e < chunk.first_element + chunk.element_count; ++e) {
      const Vec3 x =
          find_center(gather_corners(chunked.mesh.elements, static_cast<std::size_t>(e), chunked.mesh.nodes));
      start_values.resize(start_values.size() + count);
      double* const values = &start_values[start_values.size() - count];
      start_history(material, values, {x[0], x[1], x[2]});
      if (needs_elements(material))
        start_element(material, describe_to_user(deck, chunked.mesh, static_cast<std::size_t>(e)), values);
      if (material.is_scaled)
        values[material.find_mass_place()] = find_element_mass(deck, chunked.mesh, static_cast<std::size_t>(e));
    }
  }

  template <class Material>
  static SolidParameters<Material> make_parameters(const Material& material, const ElementDeck& settings) {
    SolidParameters<Material> p;
    p.material = material;
    const LameConstants c = material.moduli();
    p.lambda = std::max(c.lambda, 0.0);
    p.mu = c.mu;
    p.hourglass = settings.hourglass_coefficient;
    p.viscosity = {settings.linear_viscosity, settings.quadratic_viscosity};
    return p;
  }
};

}  // namespace percuss
