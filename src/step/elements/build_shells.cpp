#include "src/step/elements/build_shells.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <type_traits>
#include <utility>

#include "kernels/core/host_copy.hpp"
#include "kernels/shell/layer_of_law.hpp"
#include "src/deck/law_traits.hpp"
#include "src/deck/make_material.hpp"
#include "src/error.hpp"
#include "src/mesh/hex_geometry.hpp"

namespace percuss {

namespace {

/// Calls use(law, layer) with the layer of a material. Returns false if shells do not know it.
template <class Use>
bool visit_layer(const MaterialDeck& material, const Use& use) {
  if (material.equation_of_state) return false;
  bool known = false;
  visit_law(material, [&](const auto& law) {
    if constexpr (LayerLaw<std::decay_t<decltype(law)>>) {
      use(law, make_layer(law, material.density));
      known = true;
    }
  });
  return known;
}

/// On all ranks alike: they know all blocks.
void check_materials(const Deck& deck, const Mesh& mesh) {
  for (const ElementBlock& block : mesh.elements.blocks) {
    if (!find_topology(block.topology).is_surface()) continue;
    const auto p = static_cast<std::size_t>(block.part);
    const MaterialDeck& material = deck.materials[static_cast<std::size_t>(block.material)];
    if (visit_layer(material, [](const auto&, const auto&) {})) continue;
    throw InputError(fmt::format(
        "{}: error: part '{}' has shells of material '{}' (shells support {}, without an equation of "
        "state): give it one of these, or solids",
        deck.where(deck.parts[p].place), mesh.parts[p].name, material.name, name_laws(&LawTraits::is_of_shells)));
  }
}

bool holds_triangle(const ChunkedMesh& chunked, const Chunk& chunk) {
  for (int e = chunk.first_element; e < chunk.first_element + chunk.element_count; ++e)
    if (chunked.mesh.topology_of(static_cast<std::size_t>(e)).corner_count == 3) return true;
  return false;
}

/// What the launchers and readers need to know of the records of chunk c.
template <class Law, class Layer>
void describe_records(const Law&, const Layer& layer, int points, std::size_t c, const ChunkRecords& records) {
  const int history = ShellRecord::layers + ShellRecord::stress_count;
  records.record_size[c] = find_shell_record_size(points, layer.count_history());
  records.points[c] = points;
  records.history[c] = layer.count_history() > 0 ? history : -1;
  int place = history;
  const std::size_t first = c * history_scalars;
  for (std::size_t k = 0; k < history_scalars; ++k) records.scalars[first + k] = -1;
  if constexpr (requires { Law::history_names; }) {
    for (const HistoryScalar name : Law::history_names)
      records.scalars[first + static_cast<std::size_t>(name)] = place++;
  }
}

/// The history of the layers of a chunk at the start, the same of all.
template <class Layer>
void add_start_history(const Layer& layer, int elements, std::size_t c, const ChunkRecords& records) {
  if constexpr (requires(double* history) { layer.start(history); }) {
    std::vector<double> row(static_cast<std::size_t>(layer.count_history()));
    layer.start(row.data());
    if (std::all_of(row.begin(), row.end(), [](double value) { return value == 0; })) return;
    records.first_start[c] = records.start_values.size();
    records.start_count[c] = layer.count_history();
    for (int e = 0; e < elements; ++e) {
      records.start_values.insert(records.start_values.end(), row.begin(), row.end());
    }
  }
}

template <class Layer>
void build_block(const Deck& deck, const ChunkedMesh& chunked, const ChunkRecords& records, ShellBlock<Layer>& block) {
  std::vector<int> chunks;
  std::vector<ShellParameters<Layer>> rows;
  std::map<int, int> row_of_part;
  for (std::size_t c = 0; c < chunked.chunks.size(); ++c) {
    if (!is_shell_chunk(chunked, chunked.chunks[c])) continue;
    const int part_index = chunked.chunks[c].part;
    const ElementBlock& of_chunk = find_block(chunked, chunked.chunks[c]);
    visit_layer(deck.materials[static_cast<std::size_t>(of_chunk.material)], [&](const auto& law, const auto& layer) {
      if constexpr (std::is_same_v<std::decay_t<decltype(layer)>, Layer>) {
        constexpr int usual = Layer::can_yield ? points_of_plastic_shells : points_of_elastic_shells;
        const int points = of_chunk.section.points > 0 ? of_chunk.section.points : usual;
        const auto [row, is_new] = row_of_part.emplace(part_index, static_cast<int>(rows.size()));
        const auto part = static_cast<std::size_t>(part_index);
        if (is_new) {
          rows.push_back({layer, find_thickness_points(points), deck.parts[part].offset,
                          deck.find_elements(part).shell_hourglass});
        }
        block.has_triangles = block.has_triangles || holds_triangle(chunked, chunked.chunks[c]);
        if (!is_rigid_chunk(deck, chunked.chunks[c])) chunks.push_back(static_cast<int>(c));
        records.parameters[c] = row->second;
        describe_records(law, layer, points, c, records);
        add_start_history(layer, chunked.chunks[c].element_count, c, records);
      }
    });
  }
  block.chunks = to_view("percuss::chunks_of_shell_block", chunks);
  block.parameters = to_view("percuss::shell_parameters", rows);
}

/// The rules of all numbers of points, by number.
std::vector<ThicknessPoints> list_thickness_rules() {
  std::vector<ThicknessPoints> rules(1);
  for (int count = 1; count <= most_thickness_points; ++count) rules.push_back(find_thickness_points(count));
  return rules;
}

}  // namespace

bool is_shell_chunk(const ChunkedMesh& chunked, const Chunk& chunk) {
  return find_topology(find_block(chunked, chunk).topology).family == ElementFamily::shells;
}

void build_shell_blocks(const Deck& deck, const ChunkedMesh& chunked, const ChunkRecords& records, Model& model) {
  if (!model.has_rotations) return;
  check_materials(deck, chunked.mesh);
  std::apply([&](auto&... block) { (build_block(deck, chunked, records, block), ...); }, model.others.shells);
  std::vector<double> thickness;
  for (std::size_t e = 0; e < chunked.mesh.elements.size(); ++e) thickness.push_back(chunked.mesh.thickness_of(e));
  model.start_thickness = to_view("percuss::start_thickness", thickness);
  model.thickness_rules = to_view("percuss::thickness_rules", list_thickness_rules());
}

std::vector<double> find_gyration_squares(const Deck& deck, const Mesh& mesh) {
  std::vector<double> squares(mesh.elements.size(), 0);
  for (std::size_t e = 0; e < mesh.elements.size(); ++e) {
    if (!mesh.topology_of(e).is_surface()) continue;
    const ElementBlock& block = mesh.block_of(e);
    const double t = mesh.thickness_of(e), offset = deck.parts[static_cast<std::size_t>(block.part)].offset;
    squares[e] = t * t / 12 + find_shell_area_size(gather_corners(mesh.elements, e, mesh.nodes)) / 8 + offset * offset;
  }
  return squares;
}

std::vector<double> find_shell_bounds(const Deck& deck, const Mesh& mesh, const std::vector<double>& element_mass) {
  const std::vector<double> gyration_square = find_gyration_squares(deck, mesh);
  std::vector<double> bounds(mesh.elements.size(), 0);
  for (std::size_t e = 0; e < mesh.elements.size(); ++e) {
    if (!mesh.topology_of(e).is_surface()) continue;
    const HexCorners x = gather_corners(mesh.elements, e, mesh.nodes);
    Vector3<double> corners[4];
    for (std::size_t i = 0; i < 4; ++i) corners[i] = {x[i][0], x[i][1], x[i][2]};
    const MixedShapes<bool> shapes{mesh.topology_of(e).corner_count == 3};
    const ElementBlock& block = mesh.block_of(e);
    const ShellSection<double> section{mesh.thickness_of(e), element_mass[e], gyration_square[e],
                                       deck.parts[static_cast<std::size_t>(block.part)].offset};
    visit_layer(deck.materials[static_cast<std::size_t>(block.material)], [&](const auto&, const auto& layer) {
      const auto geometry = find_shell_geometry(find_differences(corners), shapes);
      bounds[e] = find_shell_step(geometry, section, layer.elasticity, shapes);
    });
  }
  return bounds;
}

}  // namespace percuss
