#include "src/mesh/parts/scene_parts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <cstdlib>
#include <map>
#include <utility>

#include "comm/agreement.hpp"
#include "src/deck/mesh_size.hpp"
#include "src/error.hpp"
#include "src/fail_together.hpp"
#include "src/mesh/ordering.hpp"
#include "src/mesh/parts/mirrored_order.hpp"
#include "src/mesh/parts/part_joints.hpp"
#include "src/mesh/parts/place_groups.hpp"
#include "src/mesh/parts/shared_meshes.hpp"
#include "src/mesh/quality/check_mesh.hpp"
#include "src/mesh/quality/mesh_doubts.hpp"
#include "src/mesh/reading/part_reader.hpp"
#include "src/mesh/surface_nodes.hpp"
#include "src/mesh/topology/connectivity.hpp"

namespace percuss {
namespace {

/// Nodes and elements of the parts so far.
struct Totals {
  double nodes = 0, elements = 0;
};

/// Nodes and elements are counted in int; a step beyond is refused before memory is allocated.
void check_size(const Totals& so_far, double nodes, double elements) {
  nodes += so_far.nodes;
  elements += so_far.elements;
  if (nodes <= largest_mesh && elements <= largest_mesh) return;
  throw InputError(
      fmt::format("the mesh would have {:.3g} elements and {:.3g} nodes (percuss counts up to {:.0f}): use fewer cells",
                  elements, nodes, largest_mesh));
}

double count_copies(const PartDeck& part) {
  return part.array ? double(part.array->count[0]) * part.array->count[1] * part.array->count[2] : 1.0;
}

int find_material(const Deck& deck, const std::string& name) {
  const auto found =
      std::find_if(deck.materials.begin(), deck.materials.end(), [&](const auto& m) { return m.name == name; });
  if (found == deck.materials.end()) throw InputError(fmt::format("material '{}' is not in the deck", name));
  return static_cast<int>(found - deck.materials.begin());
}

/// Element blocks and sets of sections by nodes (ForceDeck::elements) and of OutputDeck::blocks, without the part's
/// name: their elements share no chunk with others, because forces and work of elements are added up by chunk.
std::vector<std::string> list_summed_sets(const Deck& deck, const std::string& part) {
  std::vector<std::string> sets;
  const auto add = [&](const Selector& elements) {
    const bool has_part = elements.name.starts_with(part + "/");
    sets.push_back(has_part ? elements.name.substr(part.size() + 1) : elements.name);
  };
  for (const ForceDeck& force : deck.output.forces) std::for_each(force.elements.begin(), force.elements.end(), add);
  std::for_each(deck.output.blocks.begin(), deck.output.blocks.end(), add);
  return sets;
}

/// Elements of the set of this name, else of the block.
std::vector<int> list_members(const PartMesh& mesh, const std::string& name) {
  const auto set = mesh.side_sets.find(name);
  if (set != mesh.side_sets.end()) return list_whole_elements(mesh.elements, set->second);
  std::vector<int> members;
  for (std::size_t e = 0; e < mesh.elements.size(); ++e)
    if (mesh.elements.block_of(e).name == name) members.push_back(static_cast<int>(e));
  return members;
}

/// [elements] equal where they are of the same of these sets; empty: no element is of any.
std::vector<int> group_elements(const PartMesh& mesh, const std::vector<std::string>& sets) {
  std::vector<std::vector<int>> memberships(mesh.elements.size());
  bool is_any = false;
  for (std::size_t s = 0; s < sets.size(); ++s) {
    for (const int e : list_members(mesh, sets[s])) {
      memberships[static_cast<std::size_t>(e)].push_back(static_cast<int>(s));
      is_any = true;
    }
  }
  if (!is_any) return {};
  std::map<std::vector<int>, int> numbers;
  for (const std::vector<int>& of : memberships) numbers[of] = 0;
  int next = 0;
  for (auto& [of, number] : numbers) number = next++;
  std::vector<int> groups;
  for (const std::vector<int>& of : memberships) groups.push_back(numbers[of]);
  return groups;
}

/// Puts the elements of the part, their ids and its side sets in chunk order.
void order_elements(FilePart& file, const std::vector<std::string>& summed_sets) {
  PartMesh& mesh = file.mesh;
  const ElementOrder order = bisect_elements(mesh, group_elements(mesh, summed_sets));
  file.first_of_chunk = order.first_of_chunk;
  std::vector<int> new_place(order.elements.size());
  std::vector<std::int64_t> ids(order.elements.size());
  for (std::size_t i = 0; i < order.elements.size(); ++i) {
    const auto old = static_cast<std::size_t>(order.elements[i]);
    new_place[old] = static_cast<int>(i);
    ids[i] = mesh.element_ids[old];
  }
  mesh.elements = mesh.elements.select(order.elements);
  mesh.element_ids = std::move(ids);
  for (auto& [name, faces] : mesh.side_sets) {
    for (ElementFace& f : faces) f.element = new_place[static_cast<std::size_t>(f.element)];
  }
}

bool is_of_shells(const ElementBlock& block) { return find_topology(block.topology).is_surface(); }

bool is_of_beams(const ElementBlock& block) { return find_topology(block.topology).is_line(); }

/// Shells need a thickness, and only they.
void check_thickness(const PartDeck& deck, const PartMesh& mesh) {
  const bool has_shells = std::any_of(mesh.elements.blocks.begin(), mesh.elements.blocks.end(), is_of_shells);
  if (has_shells && !deck.has_thickness()) throw InputError("thickness is missing (the shells of the file need one)");
  if (!has_shells && (deck.has_thickness() || deck.points)) {
    throw InputError("it has a thickness or points (the file has no shells, which alone have them)");
  }
}

/// Thicknesses of the file that the part does not use, or that it wants and the file has not.
void check_own_thickness(const PartDeck& deck, PartMesh& mesh) {
  const std::vector<double>& own = mesh.elements.own_thickness;
  if (deck.thickness_of_file && own.empty())
    throw InputError("thickness.file is true (the file gives its shells no thickness): give a number");
  if (deck.thickness_of_file || own.empty()) return;
  const auto count = std::count_if(own.begin(), own.end(), [](double t) { return t != 0; });
  mesh.warnings.push_back({"unread_content",
                           fmt::format("the thicknesses that the file gives {} of its shells are not used: write "
                                       "thickness: {{file: true}} for them",
                                       count),
                           "", 0, 1});
  mesh.elements.own_thickness.clear();
}

/// Beams need a section, and only they.
void check_section(const PartDeck& deck, const PartMesh& mesh) {
  const bool has_beams = std::any_of(mesh.elements.blocks.begin(), mesh.elements.blocks.end(), is_of_beams);
  if (has_beams && !deck.section)
    throw InputError("section is missing (the beams of the file need one): give the part a section");
  if (!has_beams && deck.section) throw InputError("it has a section (the file has no beams, which alone have one)");
}

void read_file_part(const Deck& scene, const PartDeck& deck, const Totals& so_far, MeshFiles& files, ScenePart& part) {
  auto file = std::make_unique<FilePart>();
  PartMesh& mesh = file->mesh;
  mesh = files.read(std::get<FileMesh>(deck.shape));
  check_thickness(deck, mesh);
  check_own_thickness(deck, mesh);
  check_section(deck, mesh);
  const double copies = count_copies(deck);
  check_size(so_far, copies * double(mesh.nodes.size()), copies * double(mesh.elements.size()));
  const std::size_t own_elements = mesh.elements.size();
  place_part(mesh, deck);
  const GeometryFindings findings = check_geometry(mesh);
  if (!findings.problems().empty()) throw InputError(findings.problems().join(""));
  findings.warn(mesh.warnings);
  warn_of_doubts(mesh, own_elements, mesh.warnings);
  add_side_nodes(mesh);
  order_elements(*file, list_summed_sets(scene, deck.name));
  file->exterior = mark_exterior_faces(mesh.elements, mesh.nodes.size());
  file->bodies = find_bodies(mesh.elements, mesh.nodes.size());
  part.nodes = static_cast<std::int64_t>(mesh.nodes.size());
  part.elements = static_cast<std::int64_t>(mesh.elements.size());
  part.chunks = static_cast<int>(file->first_of_chunk.size()) - 1;
  part.blocks = mesh.elements.blocks;
  part.bodies = 1 + *std::max_element(file->bodies.begin(), file->bodies.end());
  part.node_sets = list_names(mesh.node_sets);
  part.side_sets = list_names(mesh.side_sets);
  part.warnings = mesh.warnings;
  part.notes = mesh.notes;
  part.file = std::move(file);
}

void describe_generated_part(const PartDeck& deck, ScenePart& part) {
  std::unique_ptr<ShapeSource> source = make_source(deck.shape);
  source = cut_cells(std::move(source), deck.elements);
  if (is_mirrored(deck)) source = mirror_corners(std::move(source));
  const PartPlacement place(deck);
  PartTiling tiling(*source, place.copies());
  part.nodes = std::int64_t{source->node_count()} * place.copies();
  part.elements = std::int64_t{source->element_count()} * place.copies();
  part.chunks = tiling.chunk_count();
  part.bodies = place.copies();
  part.blocks.resize(1);
  part.blocks[0].topology = source->topology();
  part.node_sets = part.side_sets = side_names(deck.shape);
  part.generated.emplace(GeneratedPart{std::move(source), place, std::move(tiling)});
}

/// All that the deck and the file say of a part; without files, on other ranks than 0, these are left for later.
ScenePart describe_part(const Deck& deck, const PartDeck& from, const Totals& so_far, MeshFiles* files) {
  ScenePart part;
  part.name = from.name;
  try {
    find_material(deck, from.material);
    const MeshSize size = count_cells(from);
    check_size(so_far, size.nodes, size.elements);
    if (!std::holds_alternative<FileMesh>(from.shape)) {
      describe_generated_part(from, part);
    } else if (files != nullptr) {
      read_file_part(deck, from, so_far, *files, part);
    }
  } catch (const InputError& error) {
    part.error = error.what();
  } catch (const SystemError& error) {
    throw SystemError(fmt::format("{}: error: {}{}", deck.where(from.place), describe_source(from), error.what()));
  }
  return part;
}

/// Numbers of a part that rank 0 alone knows.
struct PartNumbers {
  std::int64_t nodes, elements, first_node_id, first_element_id;
  int chunks, bodies, blocks;
  bool failed;
};

void share_numbers(const Communicator& ranks, SceneParts& scene) {
  std::vector<PartNumbers> numbers;
  for (const ScenePart& part : scene.parts) {
    numbers.push_back({part.nodes, part.elements, part.first_node_id, part.first_element_id, part.chunks, part.bodies,
                       static_cast<int>(part.blocks.size()), !part.error.empty()});
  }
  broadcast_values(ranks, numbers, 0);
  for (std::size_t p = 0; p < numbers.size(); ++p) {
    ScenePart& part = scene.parts[p];
    const PartNumbers& n = numbers[p];
    part.nodes = n.nodes;
    part.elements = n.elements;
    part.first_node_id = n.first_node_id;
    part.first_element_id = n.first_element_id;
    part.chunks = n.chunks;
    part.bodies = n.bodies;
    part.blocks.resize(static_cast<std::size_t>(n.blocks));
    if (n.failed) part.generated.reset();
  }
}

/// Names as one text; none of them holds a character 0.
void share_names(const Communicator& ranks, std::vector<std::string>& names) {
  std::string text;
  for (const std::string& name : names) text += name + '\0';
  text = broadcast_text(ranks, text, 0);
  names.clear();
  for (std::size_t first = 0; first < text.size();) {
    names.emplace_back(text.c_str() + first);
    first += names.back().size() + 1;
  }
}

/// Topologies and names of the blocks of a file.
void share_blocks(const Communicator& ranks, std::vector<ElementBlock>& blocks) {
  std::vector<TopologyKind> kinds;
  std::vector<std::string> names;
  for (const ElementBlock& block : blocks) {
    kinds.push_back(block.topology);
    names.push_back(block.name);
  }
  broadcast_values(ranks, kinds, 0);
  share_names(ranks, names);
  for (std::size_t b = 0; b < blocks.size(); ++b) {
    blocks[b].topology = kinds[b];
    blocks[b].name = names[b];
  }
}

/// A layer of a membrane has one point.
Section describe_shells(const PartDeck& part) {
  Section section;
  section.thickness = part.thickness.value_or(0);
  section.is_membrane = part.is_membrane();
  section.points = section.is_membrane ? 1 : part.points.value_or(0);
  return section;
}

/// Gives the blocks of each part its material, and its section to those of shells and of beams.
void describe_blocks(const Deck& deck, SceneParts& scene) {
  for (std::size_t p = 0; p < scene.parts.size(); ++p) {
    const PartDeck& from = deck.parts[p];
    for (ElementBlock& block : scene.parts[p].blocks) {
      block.part = static_cast<int>(p);
      block.material = find_material(deck, from.material);
      if (is_of_shells(block)) block.section = describe_shells(from);
      if (is_of_beams(block) && from.section) block.section.area = make_beam_section(*from.section).area;
    }
  }
}

/// Where keys, chunks, bodies, blocks and sets of each part begin.
void lay_out(SceneParts& scene) {
  int chunks = 0, bodies = 0, blocks = 0, node_sets = 0, side_sets = 0;
  for (ScenePart& part : scene.parts) {
    part.first_key = std::exchange(scene.keys, scene.keys + part.nodes);
    part.first_chunk = std::exchange(chunks, chunks + part.chunks);
    part.first_body = std::exchange(bodies, bodies + part.bodies);
    part.first_block = std::exchange(blocks, blocks + static_cast<int>(part.blocks.size()));
    part.first_node_set = std::exchange(node_sets, node_sets + static_cast<int>(part.node_sets.size()));
    part.first_side_set = std::exchange(side_sets, side_sets + static_cast<int>(part.side_sets.size()));
  }
}

void count_elements(const Communicator& ranks, SceneParts& scene) {
  scene.first_element.assign(1, 0);
  for (const ScenePart& part : scene.parts) {
    std::vector<int> counts;
    if (part.generated) {
      for (int c = 0; c < part.chunks; ++c) counts.push_back(part.generated->tiling.count_elements(c));
    } else {
      for (int c = 0; part.file && c < part.chunks; ++c) {
        const auto at = static_cast<std::size_t>(c);
        counts.push_back(part.file->first_of_chunk[at + 1] - part.file->first_of_chunk[at]);
      }
      broadcast_values(ranks, counts, 0);
    }
    for (const int count : counts) scene.first_element.push_back(scene.first_element.back() + count);
  }
}

}  // namespace

Vec3 find_node_place(const ScenePart& part, std::int64_t node) {
  if (part.file) return part.file->mesh.nodes[static_cast<std::size_t>(node)];
  const auto [copy, local] = std::div(static_cast<long>(node), static_cast<long>(part.generated->source->node_count()));
  return part.generated->place(part.generated->source->place(static_cast<int>(local)), static_cast<int>(copy));
}

std::string describe_source(const PartDeck& part) {
  const auto* exodus = std::get_if<FileMesh>(&part.shape);
  return exodus ? fmt::format("part '{}': {}: ", part.name, exodus->file) : fmt::format("part '{}': ", part.name);
}

SceneParts describe_parts(const Deck& deck, const Communicator& ranks) {
  SceneParts scene;
  fail_together(ranks, [&] {
    Totals so_far;
    MeshFiles files;
    for (const PartDeck& part : deck.parts) {
      scene.parts.push_back(describe_part(deck, part, so_far, ranks.rank() == 0 ? &files : nullptr));
      so_far.nodes += double(scene.parts.back().nodes);
      so_far.elements += double(scene.parts.back().elements);
    }
    if (ranks.rank() == 0) assign_ids(deck, scene);
  });
  share_numbers(ranks, scene);
  for (ScenePart& part : scene.parts) {
    if (part.generated) continue;
    share_names(ranks, part.node_sets);
    share_names(ranks, part.side_sets);
    share_blocks(ranks, part.blocks);
  }
  describe_blocks(deck, scene);
  lay_out(scene);
  place_groups(deck, ranks, scene);
  join_parts(deck, ranks, scene);
  count_elements(ranks, scene);
  return scene;
}

}  // namespace percuss
