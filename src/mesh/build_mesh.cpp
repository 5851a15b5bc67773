// Makes the meshes of all parts, checks them and puts them together.

#include <fmt/format.h>

#include <algorithm>
#include <numeric>
#include <utility>

#include "src/deck/mesh_size.hpp"
#include "src/error.hpp"
#include "src/mesh/check_mesh.hpp"
#include "src/mesh/exodus_mesh.hpp"
#include "src/mesh/id_allotment.hpp"
#include "src/mesh/part_mesh.hpp"

namespace percuss {
namespace {

struct MakeShape {
  PartMesh operator()(const BoxShape& shape) const { return make_box(shape); }
  PartMesh operator()(const CylinderShape& shape) const { return make_cylinder(shape); }
  PartMesh operator()(const TubeShape& shape) const { return make_tube(shape); }
  PartMesh operator()(const SphereShape& shape) const { return make_sphere(shape); }
  PartMesh operator()(const ExodusMesh& shape) const { return read_exodus_mesh(shape); }
};

/// Nodes and elements are counted in int; a step beyond is refused before memory is asked for.
void check_size(const Mesh& so_far, double nodes, double elements) {
  nodes += double(so_far.nodes.size());
  elements += double(so_far.elements.size());
  if (nodes <= largest_mesh && elements <= largest_mesh) return;
  throw InputError(
      fmt::format("the mesh would have {:.3g} elements and {:.3g} nodes (percuss counts up to {:.0f}); use fewer cells",
                  elements, nodes, largest_mesh));
}

double count_copies(const PartDeck& part) {
  return part.array ? double(part.array->count[0]) * part.array->count[1] * part.array->count[2] : 1.0;
}

std::string describe_source(const PartDeck& part) {
  const auto* exodus = std::get_if<ExodusMesh>(&part.shape);
  return exodus ? fmt::format("part '{}': {}: ", part.name, exodus->file) : fmt::format("part '{}': ", part.name);
}

/// The part in the coordinates of the scene, checked. Throws InputError with the problem alone, without its place.
PartMesh make_part(const PartDeck& part, const Mesh& so_far) {
  const MeshSize generated = count_cells(part);
  check_size(so_far, generated.nodes, generated.elements);
  PartMesh mesh = std::visit(MakeShape{}, part.shape);
  const double copies = count_copies(part);
  check_size(so_far, copies * double(mesh.nodes.size()), copies * double(mesh.elements.size()));
  place_part(mesh, part);
  Problems problems;
  check_geometry(mesh, problems);
  if (!problems.empty()) throw InputError(problems.join(""));
  return mesh;
}

/// Each line of the text after the prefix and before an end of line.
std::string prefix_lines(const std::string& text, const std::string& prefix) {
  std::string lines;
  for (std::size_t first = 0; first <= text.size();) {
    const std::size_t last = std::min(text.find('\n', first), text.size());
    lines += prefix + text.substr(first, last - first) + "\n";
    first = last + 1;
  }
  return lines;
}

void warn_of_raised_ids(Mesh& mesh, const IdAllotment& nodes, const IdAllotment& elements) {
  for (std::size_t p = 0; p < mesh.parts.size(); ++p) {
    if (!nodes.raised(p) && !elements.raised(p)) continue;
    mesh.warnings.push_back(
        fmt::format("part '{}': the file's {} ids are used by an earlier part (they are raised above the others)",
                    mesh.parts[p].name,
                    !nodes.raised(p)      ? "element"
                    : !elements.raised(p) ? "node"
                                          : "node and element"));
  }
}

int find_material(const Deck& deck, const std::string& name) {
  const auto found =
      std::find_if(deck.materials.begin(), deck.materials.end(), [&](const auto& m) { return m.name == name; });
  if (found == deck.materials.end()) throw InputError(fmt::format("material '{}' is not in the deck", name));
  return static_cast<int>(found - deck.materials.begin());
}

/// The nodes of faces, ascending.
std::vector<int> list_face_nodes(const std::vector<std::array<int, 8>>& elements,
                                 const std::vector<ElementFace>& faces) {
  std::vector<int> nodes;
  nodes.reserve(4 * faces.size());
  for (const ElementFace& f : faces) {
    for (const int corner : hex_faces[f.face]) {
      nodes.push_back(elements[static_cast<std::size_t>(f.element)][static_cast<std::size_t>(corner)]);
    }
  }
  std::sort(nodes.begin(), nodes.end());
  nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
  return nodes;
}

/// Appends the sets of a part whose first node and element got the given indexes. A side set without a node set of the
/// same name gives one.
void append_sets(Mesh& mesh, PartMesh& part, const std::string& name, int first_node, int first_element) {
  for (auto& [set, faces] : part.side_sets) {
    if (!part.node_sets.contains(set)) part.node_sets[set] = list_face_nodes(part.elements, faces);
    for (ElementFace& f : faces) f.element += first_element;
    mesh.side_sets[name + "/" + set] = std::move(faces);
  }
  for (auto& [set, nodes] : part.node_sets) {
    for (int& n : nodes) n += first_node;
    mesh.node_sets[name + "/" + set] = std::move(nodes);
  }
  std::vector<int>& all = mesh.node_sets[name];
  all.resize(part.nodes.size());
  std::iota(all.begin(), all.end(), first_node);
}

/// Appends everything but the ids.
void append_part(Mesh& mesh, PartMesh part, const MeshPart& description) {
  const int first_node = static_cast<int>(mesh.nodes.size()), first_element = static_cast<int>(mesh.elements.size());
  append_sets(mesh, part, description.name, first_node, first_element);
  for (auto& element : part.elements) {
    for (int& node : element) node += first_node;
  }
  mesh.nodes.insert(mesh.nodes.end(), part.nodes.begin(), part.nodes.end());
  mesh.elements.insert(mesh.elements.end(), part.elements.begin(), part.elements.end());
  mesh.element_part.resize(mesh.elements.size(), static_cast<int>(mesh.parts.size()));
  mesh.parts.push_back(description);
  for (const std::string& warning : part.warnings) {
    mesh.warnings.push_back(fmt::format("part '{}': {}", description.name, warning));
  }
}

}  // namespace

Mesh build_mesh(const Deck& deck) {
  Mesh mesh;
  IdAllotment node_ids, element_ids;
  std::string errors;
  for (const PartDeck& part : deck.parts) {
    try {
      const int material = find_material(deck, part.material);
      PartMesh made = make_part(part, mesh);
      node_ids.add(std::move(made.node_ids), made.nodes.size());
      element_ids.add(std::move(made.element_ids), made.elements.size());
      append_part(mesh, std::move(made), {part.name, material});
    } catch (const InputError& error) {
      errors += prefix_lines(error.what(), fmt::format("{}: error: {}", deck.where(part.place), describe_source(part)));
    } catch (const SystemError& error) {
      throw SystemError(fmt::format("{}: error: {}{}", deck.where(part.place), describe_source(part), error.what()));
    }
  }
  if (!errors.empty()) throw InputError(errors.substr(0, errors.size() - 1));
  mesh.node_ids = node_ids.assign();
  mesh.element_ids = element_ids.assign();
  warn_of_raised_ids(mesh, node_ids, element_ids);
  mark_exterior_faces(mesh);
  if (!mesh.nodes.empty()) mesh.low = mesh.high = mesh.nodes.front();
  for (const Vec3& x : mesh.nodes) {
    for (std::size_t d = 0; d < 3; ++d) {
      mesh.low[d] = std::min(mesh.low[d], x[d]);
      mesh.high[d] = std::max(mesh.high[d], x[d]);
    }
  }
  return mesh;
}

}  // namespace percuss
