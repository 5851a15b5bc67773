#include "src/step/elements/build_shells.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <limits>
#include <map>
#include <optional>
#include <type_traits>
#include <utility>

#include "kernels/core/host_copy.hpp"
#include "kernels/shell/layer_of_law.hpp"
#include "kernels/shell/membrane.hpp"
#include "src/deck/laws/laminates.hpp"
#include "src/deck/laws/law_traits.hpp"
#include "src/deck/laws/make_material.hpp"
#include "src/deck/laws/material_properties.hpp"
#include "src/error.hpp"
#include "src/fail_together.hpp"
#include "src/mesh/hex_geometry.hpp"
#include "src/step/elements/build_laminates.hpp"
#include "src/step/model/element_blocks.hpp"

namespace percuss {

namespace {

/// The layers of the shells of a material.
template <class Layer>
struct BuiltSection {
  Layer layer;
  ThicknessPoints rule;
  std::array<int, history_scalars> scalars;  // place of each in the history of a layer, -1: none
};

template <class Law>
std::array<int, history_scalars> list_history() {
  std::array<int, history_scalars> places;
  places.fill(-1);
  int place = 0;
  if constexpr (requires { Law::history_names; }) {
    for (const HistoryScalar name : Law::history_names) places[static_cast<std::size_t>(name)] = place++;
  }
  return places;
}

std::array<int, history_scalars> list_history(const Laminate& laminate) {
  std::array<int, history_scalars> places;
  places.fill(-1);
  if (laminate.can_yield) places[static_cast<std::size_t>(HistoryScalar::equivalent_plastic_strain)] = 0;
  if (laminate.can_fail) {
    places[static_cast<std::size_t>(HistoryScalar::fibre_damage)] = PlyHistory::fibre_damage;
    places[static_cast<std::size_t>(HistoryScalar::matrix_damage)] = PlyHistory::matrix_damage;
  }
  return places;
}

/// Calls use(section) with the layers of a block, which check_materials() has let through.
template <class Use>
void visit_section(const MaterialDeck& material, const ElementBlock& block, const Use& use) {
  if (is_laminate(material)) {
    const Laminate laminate = make_laminate(material, block.section.points);
    use(BuiltSection<LaminateLayer>{laminate.layer, laminate.rule, list_history(laminate)});
    return;
  }
  visit_law(material, [&]<class Law>(const Law& law) {
    if constexpr (requires { make_layer(law, 1.0); }) {
      const auto layer = make_layer(law, material.density);
      using Layer = std::decay_t<decltype(layer)>;
      constexpr int usual = Layer::can_yield ? points_of_plastic_shells : points_of_elastic_shells;
      const int points = block.section.points > 0 ? block.section.points : usual;
      use(BuiltSection<Layer>{layer, find_thickness_points(points), list_history<Law>()});
    }
  });
}

/// Why shells cannot be a skin as the deck has it; empty: they can.
std::string find_skin_fault(const Deck& deck, const MaterialDeck& material, const ElementBlock& block) {
  if (material.failure) return "a skin, which never fails: leave failure out, or make it of another material";
  if (!deck.parts[static_cast<std::size_t>(block.part)].plies.empty()) return "a skin, which has no plies";
  const auto& contact = deck.contact;
  const bool has_springs =
      contact.enforcement == ContactDeck::Enforcement::penalty && contact.surfaces != ContactDeck::Surfaces::none;
  return has_springs && !(find_moduli(material).lambda > 0)
             ? "a skin, which needs contact_modulus beside enforcement: penalty"
             : "";
}

/// Why shells cannot have a material; empty: they can.
std::string find_fault(const Deck& deck, const MaterialDeck& material, const ElementBlock& block) {
  if (find_traits(material).is_skin) return find_skin_fault(deck, material, block);
  if (find_traits(material).is_of_membranes_alone && !material.equation_of_state)
    return block.section.is_membrane ? "" : "which does not bend: it needs integration: membrane";
  const std::string known = name_laws(&LawTraits::is_of_shells);
  if (material.equation_of_state || !find_traits(material).is_of_shells)
    return fmt::format("shells support {}, without an equation of state", known);
  if (const auto found = material.law.numbers.find("thermal_expansion");
      found != material.law.numbers.end() && found->second > 0)
    return "which has a thermal_expansion, and shells do not expand";
  return is_laminate(material) ? find_laminate_fault(material) : "";
}

/// Places of the corners of a shell.
void find_shell_corners(const Mesh& mesh, std::size_t element, Vector3<double> (&corners)[4]) {
  const ElementCorners x = gather_corners(mesh.elements, element, mesh.nodes);
  for (std::size_t i = 0; i < 4; ++i) corners[i] = {x[i][0], x[i][1], x[i][2]};
}

/// Skins alone have nothing that bounds the step.
void refuse_skins_alone(const Deck& deck) {
  for (std::size_t p = 0; p < deck.parts.size(); ++p)
    if (!is_uncomputed(deck, p) || deck.parts[p].rigid) return;
  if (!deck.rigid_sets.empty()) return;
  throw InputError(
      fmt::format("{}: error: all parts are skins (a skin has no stress, so nothing bounds the time step): "
                  "add what they cover, or give one a material with strength",
                  deck.where(deck.parts.front().place)));
}

/// Throws on all ranks alike: they know all blocks.
void check_materials(const Deck& deck, const Mesh& mesh) {
  refuse_skins_alone(deck);
  for (const ElementBlock& block : mesh.elements.blocks) {
    if (!find_topology(block.topology).is_surface()) continue;
    const auto p = static_cast<std::size_t>(block.part);
    const MaterialDeck& material = deck.materials[static_cast<std::size_t>(block.material)];
    const std::string fault = find_fault(deck, material, block);
    if (fault.empty() || (deck.parts[p].rigid && find_traits(material).is_of_membranes_alone)) continue;
    throw InputError(fmt::format("{}: error: part '{}' has shells of material '{}' ({}): give it another, or solids",
                                 deck.where(deck.parts[p].place), mesh.parts[p].name, material.name, fault));
  }
}

bool holds_triangle(const ChunkedMesh& chunked, const Chunk& chunk) {
  for (int e = chunk.first_element; e < chunk.first_element + chunk.element_count; ++e)
    if (chunked.mesh.topology_of(static_cast<std::size_t>(e)).corner_count == 3) return true;
  return false;
}

/// Layout of the records of chunk c, for launchers and readers.
template <class Layer>
void describe_records(const BuiltSection<Layer>& section, std::size_t c, const ChunkRecords& records) {
  const int history = ShellRecord::layers + ShellRecord::stress_count, points = section.rule.count;
  records.record_size[c] = find_shell_record_size(points, section.layer.count_history());
  records.points[c] = points;
  records.history[c] = section.layer.count_history() > 0 ? history : -1;
  const std::size_t first = c * history_scalars;
  for (std::size_t k = 0; k < history_scalars; ++k)
    records.scalars[first + k] = section.scalars[k] < 0 ? -1 : history + section.scalars[k];
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

/// Adds to records of laminates where their reference axis points.
void add_reference_axes(const Deck& deck, const ChunkedMesh& chunked, std::size_t c, const ChunkRecords& records) {
  const Chunk& chunk = chunked.chunks[c];
  const Mesh& mesh = chunked.mesh;
  const MaterialDeck& material = deck.materials[static_cast<std::size_t>(find_block(chunked, chunk).material)];
  const std::optional<Vector3<double>> given = find_given_axis(material);
  records.first_start[c] = records.start_values.size();
  records.start_count[c] = PlyHistory::count;
  for (int i = 0; i < chunk.element_count; ++i) {
    const auto e = static_cast<std::size_t>(chunk.first_element) + static_cast<std::size_t>(i);
    Vector3<double> corners[4];
    find_shell_corners(mesh, e, corners);
    const PlaneDirection<double> axis =
        find_reference_axis(given, corners, find_shell_geometry(find_differences(corners)).frame);
    if (axis.cosine == 0 && axis.sine == 0)
      throw InputError(fmt::format(
          "{}: error: part '{}' has a shell whose normal is first_axis of its material '{}' (which then has no "
          "direction in it): choose another first_axis, or axes: elements",
          deck.where(deck.parts[static_cast<std::size_t>(chunk.part)].place),
          deck.parts[static_cast<std::size_t>(chunk.part)].name, material.name));
    std::array<double, PlyHistory::count> row{};
    row[PlyHistory::cosine] = axis.cosine;
    row[PlyHistory::sine] = axis.sine;
    records.start_values.insert(records.start_values.end(), row.begin(), row.end());
  }
}

/// Adds to records of fabric where the threads of each membrane lie, by its diagonals.
void add_threads(const Deck& deck, const ChunkedMesh& chunked, std::size_t c, const ChunkRecords& records) {
  const Chunk& chunk = chunked.chunks[c];
  const MaterialDeck& material = deck.materials[static_cast<std::size_t>(find_block(chunked, chunk).material)];
  const FabricConstants constants = make_law<Fabric>(material.law).constants;
  std::optional<Vector3<double>> given;
  if (!constants.by_elements) given = make_direction(constants.first_axis);
  records.first_start[c] = records.start_values.size();
  records.start_count[c] = FabricHistory::count;
  for (int i = 0; i < chunk.element_count; ++i) {
    const auto e = static_cast<std::size_t>(chunk.first_element) + static_cast<std::size_t>(i);
    Vector3<double> corners[4];
    find_shell_corners(chunked.mesh, e, corners);
    const MixedShapes<bool> shapes{chunked.mesh.topology_of(e).corner_count == 3};
    const ShellGeometry<double> g = find_shell_geometry(find_differences(corners), shapes);
    const PlaneDirection<double> warp = find_reference_axis(given, corners, g.frame);
    if (warp.cosine == 0 && warp.sine == 0)
      throw InputError(
          fmt::format("{}: error: part '{}' has a membrane whose normal is first_axis of its material "
                      "'{}' (which then has no direction in it): choose another first_axis, or axes: "
                      "elements",
                      deck.where(deck.parts[static_cast<std::size_t>(chunk.part)].place),
                      deck.parts[static_cast<std::size_t>(chunk.part)].name, material.name));
    const std::array<double, FabricHistory::count> row = lay_threads(g, warp);
    records.start_values.insert(records.start_values.end(), row.begin(), row.end());
  }
}

/// The rows of a block while they are listed. rules: of the model, in and out.
template <class Layer>
struct ListedShells {
  std::vector<int> chunks;
  std::vector<ShellParameters<Layer>> rows;
  std::vector<int> rule_of_row;
  std::map<int, int> row_of_part;
};

template <class Layer>
void list_chunk(const Deck& deck, const ChunkedMesh& chunked, const BuiltSection<Layer>& section, std::size_t c,
                ListedShells<Layer>& listed, std::vector<ThicknessPoints>& rules) {
  const int part_index = chunked.chunks[c].part;
  const auto part = static_cast<std::size_t>(part_index);
  const auto [row, is_new] = listed.row_of_part.emplace(part_index, static_cast<int>(listed.rows.size()));
  if (!is_new) return;
  listed.rows.push_back({section.layer, section.rule, deck.parts[part].offset, deck.find_elements(part).shell_hourglass,
                         deck.parts[part].is_membrane()});
  listed.rule_of_row.push_back(section.rule.count);
  if constexpr (has_plies<Layer>) {
    listed.rule_of_row.back() = static_cast<int>(rules.size());
    rules.push_back(section.rule);
  }
}

template <class Layer>
void build_block(const Deck& deck, const ChunkedMesh& chunked, const ChunkRecords& records,
                 std::vector<ThicknessPoints>& rules, ShellBlock<Layer>& block) {
  ListedShells<Layer> listed;
  for (std::size_t c = 0; c < chunked.chunks.size(); ++c) {
    const Chunk& chunk = chunked.chunks[c];
    if (!is_shell_chunk(chunked, chunk)) continue;
    const ElementBlock& of_chunk = find_block(chunked, chunk);
    if (is_laminate(deck.materials[static_cast<std::size_t>(of_chunk.material)]) != has_plies<Layer>) continue;
    visit_section(deck.materials[static_cast<std::size_t>(of_chunk.material)], of_chunk, [&](const auto& section) {
      if constexpr (std::is_same_v<std::decay_t<decltype(section.layer)>, Layer>) {
        list_chunk(deck, chunked, section, c, listed, rules);
        block.has_triangles = block.has_triangles || holds_triangle(chunked, chunk);
        if (!is_uncomputed_chunk(deck, chunk)) listed.chunks.push_back(static_cast<int>(c));
        records.parameters[c] = listed.row_of_part.at(chunk.part);
        records.rule[c] = listed.rule_of_row[static_cast<std::size_t>(records.parameters[c])];
        describe_records(section, c, records);
        if constexpr (has_plies<Layer>)
          add_reference_axes(deck, chunked, c, records);
        else if constexpr (is_fabric<Layer>)
          add_threads(deck, chunked, c, records);
        else
          add_start_history(section.layer, chunk.element_count, c, records);
      }
    });
  }
  block.chunks = to_view("percuss::chunks_of_shell_block", listed.chunks);
  block.parameters = to_view("percuss::shell_parameters", listed.rows);
}

/// The rules of all numbers of points, by number; those of laminates follow.
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
  std::vector<ThicknessPoints> rules = list_thickness_rules();
  fail_together(model.ranks, [&] {
    std::apply([&](auto&... block) { (build_block(deck, chunked, records, rules, block), ...); }, model.others->shells);
  });
  std::vector<double> thickness;
  for (std::size_t e = 0; e < chunked.mesh.elements.size(); ++e) thickness.push_back(chunked.mesh.thickness_of(e));
  model.start_thickness = to_view("percuss::start_thickness", thickness);
  model.thickness_rules = to_view("percuss::thickness_rules", rules);
}

std::vector<double> find_gyration_squares(const Deck& deck, const Mesh& mesh) {
  std::vector<double> squares(mesh.elements.size(), 0);
  for (std::size_t e = 0; e < mesh.elements.size(); ++e) {
    if (!mesh.topology_of(e).is_surface()) continue;
    const ElementBlock& block = mesh.block_of(e);
    if (block.section.is_membrane) continue;  // nodes that only membranes hold do not turn
    const double t = mesh.thickness_of(e), offset = deck.parts[static_cast<std::size_t>(block.part)].offset;
    squares[e] = t * t / 12 + find_shell_area_size(gather_corners(mesh.elements, e, mesh.nodes)) / 8 + offset * offset;
  }
  return squares;
}

std::vector<double> find_shell_bounds(const Deck& deck, const Mesh& mesh, const std::vector<double>& element_mass) {
  const std::vector<double> gyration_square = find_gyration_squares(deck, mesh);
  std::vector<PlaneElasticity> of_blocks(mesh.elements.blocks.size());
  for (std::size_t b = 0; b < of_blocks.size(); ++b) {
    const ElementBlock& block = mesh.elements.blocks[b];
    if (!find_topology(block.topology).is_surface()) continue;
    visit_section(deck.materials[static_cast<std::size_t>(block.material)], block,
                  [&](const auto& section) { of_blocks[b] = find_bound(section.layer); });
  }
  std::vector<double> bounds(mesh.elements.size(), 0);
  for (std::size_t e = 0; e < mesh.elements.size(); ++e) {
    if (!mesh.topology_of(e).is_surface()) continue;
    const ElementBlock& block = mesh.block_of(e);
    if (find_traits(deck.materials[static_cast<std::size_t>(block.material)]).is_skin) {
      bounds[e] = std::numeric_limits<double>::infinity();
      continue;
    }
    Vector3<double> corners[4];
    find_shell_corners(mesh, e, corners);
    const MixedShapes<bool> shapes{mesh.topology_of(e).corner_count == 3};
    const ShellSection<double> section{mesh.thickness_of(e), element_mass[e], gyration_square[e],
                                       deck.parts[static_cast<std::size_t>(block.part)].offset};
    const auto b = static_cast<std::size_t>(mesh.elements.block_index(e));
    const ShellGeometry<double> geometry = find_shell_geometry(find_differences(corners), shapes);
    bounds[e] = block.section.is_membrane ? find_membrane_step(geometry, section, of_blocks[b], shapes)
                                          : find_shell_step(geometry, section, of_blocks[b], shapes);
  }
  return bounds;
}

}  // namespace percuss
