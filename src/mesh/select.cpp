// Exterior faces; nodes and faces that a selector of the deck means.

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <optional>
#include <variant>

#include "comm/all_reduce.hpp"
#include "src/deck/rigid_bodies.hpp"
#include "src/deck/text/nearest_name.hpp"
#include "src/error.hpp"
#include "src/mesh/surface_nodes.hpp"

namespace percuss {
namespace {

/// Share of the mesh's diagonal by which `inside` is widened, so that nodes on its faces count in spite of round-off.
constexpr double inside_margin = 1e-9;

std::string fault(const Deck& deck, const Selector& selector, const std::string& text) {
  return fmt::format("{}: error: {}", deck.where(selector.place), text);
}

class InsideBox {
 public:
  InsideBox(const Mesh& mesh, const Selector& selector) : mesh_(mesh) {
    if (!selector.inside) return;
    active_ = true;
    low_ = (*selector.inside)[0];
    high_ = (*selector.inside)[1];
    const double margin = inside_margin * find_diagonal();
    for (std::size_t d = 0; d < 3; ++d) {
      low_[d] -= margin;
      high_[d] += margin;
    }
  }

  bool holds(int node) const {
    if (!active_) return true;
    const Vec3& x = mesh_.nodes[static_cast<std::size_t>(node)];
    for (std::size_t d = 0; d < 3; ++d) {
      if (x[d] < low_[d] || x[d] > high_[d]) return false;
    }
    return true;
  }

  bool holds(const ElementFace& face) const {
    const std::array<int, 4> nodes = mesh_.elements.face_nodes(face);
    return std::all_of(nodes.begin(), nodes.end(), [&](int node) { return holds(node); });
  }

 private:
  double find_diagonal() const {
    return std::hypot(mesh_.high[0] - mesh_.low[0], mesh_.high[1] - mesh_.low[1], mesh_.high[2] - mesh_.low[2]);
  }

  const Mesh& mesh_;
  bool active_ = false;
  Vec3 low_{}, high_{};
};

/// The mesh file whose sets go across its parts that has the part of a set "part/set"; empty: the set is of the part.
std::string find_common_file(const Deck& deck, const std::string& set) {
  const std::string name = set.substr(0, set.find('/'));
  const auto part = std::find_if(deck.parts.begin(), deck.parts.end(), [&](const auto& p) { return p.name == name; });
  const auto* mesh = part == deck.parts.end() ? nullptr : std::get_if<FileMesh>(&part->shape);
  return mesh == nullptr || mesh->is_exodus ? "" : mesh->file;
}

/// The set of that name, or, for a name without its part ("nodes_7"), the only one of any part, or all of it if several
/// parts are of the file that has it. None if there is none.
template <class Sets>
std::optional<typename Sets::mapped_type> find_set(const Sets& sets, const Deck& deck, const Selector& selector) {
  if (const auto exact = sets.find(selector.name); exact != sets.end()) return exact->second;
  const std::string ending = "/" + selector.name;
  const typename Sets::value_type* first = nullptr;
  std::optional<typename Sets::mapped_type> found;
  for (const auto& entry : sets) {
    if (!entry.first.ends_with(ending) || entry.first.find('/') + ending.size() != entry.first.size()) continue;
    if (!found) {
      first = &entry;
      found = entry.second;
      continue;
    }
    const std::string file = find_common_file(deck, first->first);
    if (file.empty() || file != find_common_file(deck, entry.first)) {
      throw InputError(
          fault(deck, selector,
                fmt::format("'{}' may mean '{}' or '{}' (several parts have such a set): write the part's name as well",
                            selector.name, first->first, entry.first)));
    }
    found->insert(found->end(), entry.second.begin(), entry.second.end());
  }
  if (found) {
    std::sort(found->begin(), found->end());
    found->erase(std::unique(found->begin(), found->end()), found->end());
  }
  return found;
}

[[noreturn]] void refuse_unknown(const Deck& deck, const Selector& selector, const char* what,
                                 std::vector<std::string> known) {
  std::sort(known.begin(), known.end());
  known.erase(std::unique(known.begin(), known.end()), known.end());
  throw InputError(fault(deck, selector,
                         fmt::format("no {} is called '{}'{}", what, selector.name, name_hint(selector.name, known))));
}

/// Whether any rank has some. Collective.
template <class T>
bool has_any(const Mesh& mesh, const std::vector<T>& selected) {
  int some = selected.empty() ? 0 : 1;
  if (mesh.ranks) {
    all_reduce(*mesh.ranks, Reduce::largest, some);
  }
  return some != 0;
}

/// Throws, on all ranks, if none of them has anything selected.
template <class T>
void require_some(const Mesh& mesh, const std::vector<T>& selected, const Deck& deck, const Selector& selector,
                  const char* what) {
  if (has_any(mesh, selected) || mesh.eroded.any) return;
  const std::string name = selector.name.empty() ? "the mesh" : fmt::format("'{}'", selector.name);
  throw InputError(fault(deck, selector,
                         selector.inside
                             ? fmt::format("{} has no {} inside the box: check its corners and units", name, what)
                             : fmt::format("{} has no {}", name, what)));
}

std::vector<ElementFace> list_candidate_faces(const Mesh& mesh, const Deck& deck, const Selector& selector,
                                              const std::vector<ElementFace>& exterior) {
  if (selector.name.empty()) return exterior;
  const auto part =
      std::find_if(mesh.parts.begin(), mesh.parts.end(), [&](const auto& p) { return p.name == selector.name; });
  std::vector<ElementFace> faces;
  if (part != mesh.parts.end()) {
    const int index = static_cast<int>(part - mesh.parts.begin());
    std::copy_if(exterior.begin(), exterior.end(), std::back_inserter(faces), [&](const ElementFace& face) {
      return mesh.part_of(static_cast<std::size_t>(face.element)) == index;
    });
    return faces;
  }
  if (const auto set = find_set(mesh.side_sets, deck, selector)) {
    std::set_intersection(set->begin(), set->end(), exterior.begin(), exterior.end(), std::back_inserter(faces));
    return faces;
  }
  std::vector<std::string> known = list_names(mesh.side_sets);
  for (const MeshPart& p : mesh.parts) known.push_back(p.name);
  const char* what = find_set(mesh.node_sets, deck, selector) ? "part or side set (it is a node set, faces are needed)"
                                                              : "part or side set";
  refuse_unknown(deck, selector, what, std::move(known));
}

/// Whether a selector names a set of nodes that is neither a part nor a side with faces: the edge of a shell is a side
/// without. Collective.
bool names_nodes_alone(const Mesh& mesh, const Deck& deck, const Selector& selector) {
  const auto is_part = [&](const MeshPart& part) { return part.name == selector.name; };
  if (selector.name.empty() || std::any_of(mesh.parts.begin(), mesh.parts.end(), is_part)) return false;
  const auto faces = find_set(mesh.side_sets, deck, selector);
  return (!faces || !has_any(mesh, *faces)) && find_set(mesh.node_sets, deck, selector).has_value();
}

}  // namespace

std::vector<ElementFace> find_exterior_faces(const Mesh& mesh) {
  std::vector<ElementFace> faces;
  for (int e = 0; e < static_cast<int>(mesh.elements.size()); ++e) {
    const unsigned mask = mesh.exterior[static_cast<std::size_t>(e)];
    for (int f = 0; mask >> f != 0; ++f) {
      if ((mask >> f & 1) != 0) faces.push_back({e, f});
    }
  }
  return faces;
}

namespace {

/// Nodes of the parts and of the sets of a rigid body.
std::vector<int> select_body(const Mesh& mesh, const Deck& deck, const std::string& body) {
  const RigidNames names = name_rigid_bodies(deck);
  const int index = names.find(body);
  std::vector<int> nodes;
  for (std::size_t e = 0; e < mesh.elements.size(); ++e) {
    if (names.body_of_part[static_cast<std::size_t>(mesh.part_of(e))] != index) continue;
    for (const int n : mesh.corners(e)) nodes.push_back(n);
  }
  for (std::size_t s = 0; s < deck.rigid_sets.size(); ++s) {
    if (names.body_of_set[s] != index) continue;
    const std::vector<int> of_set = select_nodes(mesh, deck, deck.rigid_sets[s].where);
    nodes.insert(nodes.end(), of_set.begin(), of_set.end());
  }
  std::sort(nodes.begin(), nodes.end());
  nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
  return nodes;
}

}  // namespace

std::vector<int> select_nodes(const Mesh& mesh, const Deck& deck, const Selector& selector) {
  if (const std::string body = find_body(selector); !body.empty()) return select_body(mesh, deck, body);
  const InsideBox box(mesh, selector);
  std::vector<int> nodes;
  if (selector.name.empty()) {
    for (int n = 0; n < static_cast<int>(mesh.nodes.size()); ++n) {
      if (box.holds(n)) nodes.push_back(n);
    }
  } else {
    const std::optional<std::vector<int>> set = find_set(mesh.node_sets, deck, selector);
    if (!set) refuse_unknown(deck, selector, "part, side or node set", list_names(mesh.node_sets));
    std::copy_if(set->begin(), set->end(), std::back_inserter(nodes), [&](int n) { return box.holds(n); });
  }
  require_some(mesh, nodes, deck, selector, "nodes");
  return nodes;
}

std::vector<ElementFace> select_faces(const Mesh& mesh, const Deck& deck, const Selector& selector) {
  return select_faces(mesh, deck, selector, find_exterior_faces(mesh));
}

std::vector<ElementFace> select_faces(const Mesh& mesh, const Deck& deck, const Selector& selector,
                                      const std::vector<ElementFace>& exterior) {
  const InsideBox box(mesh, selector);
  std::vector<ElementFace> faces;
  for (const ElementFace& face : list_candidate_faces(mesh, deck, selector, exterior)) {
    if (box.holds(face)) faces.push_back(face);
  }
  require_some(mesh, faces, deck, selector, "exterior faces");
  return faces;
}

bool names_beams_alone(const Mesh& mesh, const Selector& selector) {
  if (selector.name.empty() || selector.inside) return false;
  bool has_beams = false, has_others = false;
  for (const ElementBlock& block : mesh.elements.blocks) {
    if (mesh.parts[static_cast<std::size_t>(block.part)].name != selector.name) continue;
    (find_topology(block.topology).is_line() ? has_beams : has_others) = true;
  }
  return has_beams && !has_others;
}

std::vector<ElementFace> select_touching_faces(const Mesh& mesh, const Deck& deck, const Selector& selector,
                                               const std::vector<ElementFace>& exterior) {
  if (names_beams_alone(mesh, selector)) return {};
  return select_faces(mesh, deck, selector, exterior);
}

std::vector<int> list_whole_elements(const Elements& elements, const std::vector<ElementFace>& faces) {
  std::vector<int> whole;
  for (std::size_t first = 0, last = 0; first < faces.size(); first = last) {
    const int element = faces[first].element;
    while (last < faces.size() && faces[last].element == element) ++last;
    const int count = elements.topology_of(static_cast<std::size_t>(element)).face_count;
    if (static_cast<int>(last - first) == count) whole.push_back(element);
  }
  return whole;
}

namespace {

/// Elements of each block that has a name, "part/block".
std::map<std::string, std::vector<int>> list_block_elements(const Mesh& mesh) {
  std::map<std::string, std::vector<int>> blocks;
  std::vector<std::vector<int>*> of_block;
  for (const ElementBlock& block : mesh.elements.blocks) {
    const std::string& part = mesh.parts[static_cast<std::size_t>(block.part)].name;
    of_block.push_back(block.name.empty() ? nullptr : &blocks[fmt::format("{}/{}", part, block.name)]);
  }
  for (std::size_t e = 0; e < mesh.elements.size(); ++e)
    if (auto* const members = of_block[static_cast<std::size_t>(mesh.elements.block_index(e))])
      members->push_back(static_cast<int>(e));
  return blocks;
}

/// Elements of an element set, else of a block.
std::vector<int> list_elements_of_set(const Mesh& mesh, const Deck& deck, const Selector& selector) {
  if (const auto set = find_set(mesh.side_sets, deck, selector)) return list_whole_elements(mesh.elements, *set);
  const auto blocks = list_block_elements(mesh);
  if (auto block = find_set(blocks, deck, selector)) return *block;
  std::vector<std::string> known = list_names(mesh.side_sets);
  for (const std::string& name : list_names(blocks)) known.push_back(name);
  refuse_unknown(deck, selector, "part, element block or element set", std::move(known));
}

}  // namespace

std::vector<char> mark_elements(const Mesh& mesh, const Deck& deck, const std::vector<Selector>& selectors) {
  std::vector<char> marks(mesh.elements.size(), 0);
  for (const Selector& selector : selectors) {
    std::vector<int> elements;
    const auto is_it = [&](const MeshPart& part) { return part.name == selector.name; };
    const auto part = std::find_if(mesh.parts.begin(), mesh.parts.end(), is_it);
    if (part != mesh.parts.end()) {
      for (std::size_t e = 0; e < marks.size(); ++e)
        if (mesh.part_of(e) == part - mesh.parts.begin()) elements.push_back(static_cast<int>(e));
    } else {
      elements = list_elements_of_set(mesh, deck, selector);
    }
    require_some(mesh, elements, deck, selector,
                 "elements (a part, or an element block or element set of a mesh file is needed)");
    for (const int e : elements) marks[static_cast<std::size_t>(e)] = 1;
  }
  return marks;
}

SurfaceNodes select_surface_nodes(const Mesh& mesh, const Deck& deck, const Selector& selector) {
  SurfaceNodes selected;
  selected.is_node_set = names_nodes_alone(mesh, deck, selector);
  if (selected.is_node_set) {
    selected.nodes = select_nodes(mesh, deck, selector);
    const auto is_selected = [&](int n) { return std::binary_search(selected.nodes.begin(), selected.nodes.end(), n); };
    for (const ElementFace& face : find_exterior_faces(mesh)) {
      const std::array<int, 4> corners = mesh.elements.face_nodes(face);
      if (std::any_of(corners.begin(), corners.end(), is_selected)) selected.faces.push_back(face);
    }
    return selected;
  }
  selected.faces = select_faces(mesh, deck, selector);
  for (const ElementFace& face : selected.faces) {
    const std::array<int, 4> corners = mesh.elements.face_nodes(face);
    selected.nodes.insert(selected.nodes.end(), corners.begin(), corners.end());
  }
  std::sort(selected.nodes.begin(), selected.nodes.end());
  selected.nodes.erase(std::unique(selected.nodes.begin(), selected.nodes.end()), selected.nodes.end());
  return selected;
}

}  // namespace percuss
