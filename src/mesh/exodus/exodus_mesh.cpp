#include "src/mesh/exodus/exodus_mesh.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <numeric>
#include <optional>
#include <span>
#include <string_view>

#include "src/deck/mesh_size.hpp"
#include "src/deck/text/nearest_name.hpp"
#include "src/error.hpp"
#include "src/mesh/exodus/exodus_file.hpp"
#include "src/mesh/exodus/trial_process.hpp"
#include "src/mesh/quality/check_mesh.hpp"

namespace percuss {
namespace {

constexpr int not_chosen = -1;

/// Ids beyond this are hashes, not numbers that a person reads; they would overflow when parts are joined.
constexpr std::int64_t highest_id = 1'000'000'000'000'000;

/// Whether the name of a block's kind begins so, in capitals or not.
bool is_called_kind(const ExodusBlock& block, std::string_view kind) {
  return !kind.empty() && block.topology.size() >= kind.size() &&
         std::equal(kind.begin(), kind.end(), block.topology.begin(),
                    [](char a, char b) { return a == std::toupper(static_cast<unsigned char>(b)); });
}

/// None: elements of this kind cannot be run.
std::optional<TopologyKind> find_kind(const ExodusBlock& block) {
  for (std::size_t kind = 0; kind < topology_count; ++kind) {
    const Topology& topology = topologies[kind];
    const auto& names = topology.exodus_names;
    const bool is_called =
        std::any_of(names.begin(), names.end(), [&](std::string_view name) { return is_called_kind(block, name); });
    if (is_called && block.nodes_per_element == topology.corner_count) return static_cast<TopologyKind>(kind);
  }
  return {};
}

/// Turns a quadrilateral of which two corners in a row are one node so that these come last. The normal stays as it is.
/// Returns whether they do: it is a triangle.
bool turn_triangle(std::span<int> nodes) {
  for (std::size_t turn = 0; turn < 4 && nodes[2] != nodes[3]; ++turn)
    std::rotate(nodes.begin(), nodes.begin() + 1, nodes.end());
  return nodes[2] == nodes[3];
}

bool is_called(const ExodusBlock& block, const std::string& name) {
  return block.name == name || fmt::format("block_{}", block.id) == name;
}

std::vector<ExodusBlock> choose_blocks(const ExodusFile& file, const std::vector<std::string>& wanted) {
  std::vector<std::string> known;
  for (const ExodusBlock& block : file.blocks()) known.push_back(block.name);
  for (const std::string& name : wanted) {
    const auto called = [&](const ExodusBlock& block) { return is_called(block, name); };
    if (std::none_of(file.blocks().begin(), file.blocks().end(), called)) {
      throw InputError(fmt::format("the file has no block '{}'{}", name, name_hint(name, known)));
    }
  }
  std::vector<ExodusBlock> chosen;
  for (const ExodusBlock& block : file.blocks()) {
    const auto calls = [&](const std::string& name) { return is_called(block, name); };
    const bool is_wanted = wanted.empty() || std::any_of(wanted.begin(), wanted.end(), calls);
    if (is_wanted && block.elements > 0) chosen.push_back(block);
  }
  return chosen;
}

void check_kinds(const ExodusFile& file, const std::vector<ExodusBlock>& chosen) {
  std::string problems, others;
  for (const ExodusBlock& block : chosen) {
    if (can_run(block)) continue;
    problems += fmt::format("{}block '{}' has {} elements of kind {} with {} nodes (of all kinds only {} can be run)",
                            problems.empty() ? "" : "\n", block.name, block.elements, block.topology,
                            block.nodes_per_element, list_kinds());
  }
  if (problems.empty()) return;
  for (const ExodusBlock& block : file.blocks()) {
    if (can_run(block) && block.elements > 0) others += (others.empty() ? "" : ", ") + block.name;
  }
  if (!others.empty()) problems += fmt::format("; choose with blocks: [{}]", others);
  throw InputError(problems);
}

/// Whether ids can serve as they are: positive, not absurd, each only once.
bool are_usable(const std::vector<std::int64_t>& ids) {
  std::vector<std::int64_t> sorted = ids;
  if (!std::is_sorted(sorted.begin(), sorted.end())) std::sort(sorted.begin(), sorted.end());
  return sorted.empty() || (sorted.front() >= 1 && sorted.back() <= highest_id &&
                            std::adjacent_find(sorted.begin(), sorted.end()) == sorted.end());
}

std::vector<std::int64_t> accept_ids(std::vector<std::int64_t> ids, const char* what, PartMesh& mesh) {
  if (are_usable(ids)) return ids;
  mesh.warnings.push_back({"file_ids",
                           fmt::format("the file's {} ids are not positive and different (their places in the file "
                                       "serve instead)",
                                       what),
                           "", 0, 1});
  std::iota(ids.begin(), ids.end(), std::int64_t{1});
  return ids;
}

/// From a file to a part: reads block after block, then keeps the nodes and set entries that the blocks use.
class ExodusReader {
 public:
  ExodusReader(const ExodusFile& file, std::vector<ExodusBlock> blocks) : file_(file), blocks_(std::move(blocks)) {}

  PartMesh read() {
    file_node_ids_ = accept_ids(file_.read_node_ids(), "node", mesh_);
    file_element_ids_ = accept_ids(file_.read_element_ids(), "element", mesh_);
    read_elements();
    throw_problems();  // what follows relies on indexes in range
    drop_unused_nodes();
    check_connectivity(mesh_, problems_);
    throw_problems();
    read_node_sets();
    read_side_sets();
    name_sides_of_shells();
    throw_problems();
    return std::move(mesh_);
  }

 private:
  void throw_problems() const {
    if (!problems_.empty()) throw InputError(problems_.join(""));
  }

  void read_elements() {
    file_to_part_element_.assign(static_cast<std::size_t>(file_.element_count()), not_chosen);
    for (const ExodusBlock& block : blocks_) {
      const std::vector<std::int64_t> corners = file_.read_connectivity(block);
      for (std::size_t e = 0; e < static_cast<std::size_t>(block.elements); ++e) {
        const std::size_t in_file = static_cast<std::size_t>(block.first_element - 1) + e;
        file_to_part_element_[in_file] = static_cast<int>(mesh_.elements.size());
        mesh_.element_ids.push_back(file_element_ids_[in_file]);
        add_element(read_corners(corners, e, block), block);
      }
    }
  }

  std::vector<int> read_corners(const std::vector<std::int64_t>& corners, std::size_t element,
                                const ExodusBlock& block) {
    const auto count = static_cast<std::size_t>(block.nodes_per_element);
    std::vector<int> nodes(count, 0);
    for (std::size_t c = 0; c < count; ++c) {
      const std::int64_t node = corners[count * element + c];
      if (node >= 1 && node <= file_.node_count()) {
        nodes[c] = static_cast<int>(node - 1);
        continue;
      }
      problems_.add(
          fmt::format("element {} of block '{}' has node number {} as its corner {} (the file has the nodes 1 to {})",
                      mesh_.element_ids.back(), block.name, node, c + 1, file_.node_count()));
    }
    return nodes;
  }

  void add_element(std::vector<int> nodes, const ExodusBlock& block) {
    TopologyKind kind = *find_kind(block);
    if (kind == TopologyKind::quad4 && turn_triangle(nodes)) {
      kind = TopologyKind::tri3;
      nodes.pop_back();
    }
    mesh_.elements.add(find_block(block.name, kind), nodes);
  }

  /// That of a block of the file, of which triangles among quadrilaterals are one of their own.
  int find_block(const std::string& name, TopologyKind kind) {
    std::vector<ElementBlock>& blocks = mesh_.elements.blocks;
    const auto found = std::find_if(blocks.rbegin(), blocks.rend(), [&](const ElementBlock& block) {
      return block.topology == kind && block.name == name;
    });
    if (found != blocks.rend()) return static_cast<int>(blocks.rend() - found) - 1;
    ElementBlock& added = blocks.emplace_back();
    added.topology = kind;
    added.name = name;
    return static_cast<int>(blocks.size()) - 1;
  }

  void drop_unused_nodes() {
    const std::vector<Vec3> nodes = file_.read_coordinates();
    std::vector<char> used(nodes.size(), 0);
    for (std::size_t e = 0; e < mesh_.elements.size(); ++e) {
      for (const int node : mesh_.elements.corners(e)) used[static_cast<std::size_t>(node)] = 1;
    }
    file_to_part_node_.assign(nodes.size(), not_chosen);
    for (std::size_t n = 0; n < nodes.size(); ++n) {
      if (!used[n]) continue;
      file_to_part_node_[n] = static_cast<int>(mesh_.nodes.size());
      mesh_.nodes.push_back(nodes[n]);
      mesh_.node_ids.push_back(file_node_ids_[n]);
    }
    for (std::size_t e = 0; e < mesh_.elements.size(); ++e) {
      for (int& node : mesh_.elements.corners(e)) node = file_to_part_node_[static_cast<std::size_t>(node)];
    }
    warn_of_unused_nodes();
  }

  void warn_of_unused_nodes() {
    const std::size_t unused = file_to_part_node_.size() - mesh_.nodes.size();
    // With only some blocks chosen, the others are what uses the rest.
    if (unused == 0 || mesh_.elements.size() != static_cast<std::size_t>(file_.element_count())) return;
    const auto first = std::find(file_to_part_node_.begin(), file_to_part_node_.end(), not_chosen);
    mesh_.warnings.push_back({"unused_nodes",
                              fmt::format("{} nodes belong to no element and are dropped, the first is node {}", unused,
                                          file_node_ids_[static_cast<std::size_t>(first - file_to_part_node_.begin())]),
                              "", 0, 1});
  }

  void read_node_sets() {
    for (const ExodusSet& set : file_.node_sets()) {
      std::vector<int>& nodes = mesh_.node_sets[set.name];
      for (const std::int64_t node : file_.read_node_set(set)) {
        if (node < 1 || node > file_.node_count()) {
          problems_.add(fmt::format("node set '{}' names node number {} (the file has the nodes 1 to {})", set.name,
                                    node, file_.node_count()));
          continue;
        }
        const int in_part = file_to_part_node_[static_cast<std::size_t>(node - 1)];
        if (in_part != not_chosen) nodes.push_back(in_part);
      }
      std::sort(nodes.begin(), nodes.end());
      nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
    }
  }

  void read_side_sets() {
    for (const ExodusSet& set : file_.side_sets()) {
      std::vector<ElementFace>& faces = mesh_.side_sets[set.name];
      for (const auto& [element, side] : file_.read_side_set(set)) {
        if (element < 1 || element > file_.element_count()) {
          problems_.add(fmt::format("side set '{}' names element number {} (the file has the elements 1 to {})",
                                    set.name, element, file_.element_count()));
          continue;
        }
        const int in_part = file_to_part_element_[static_cast<std::size_t>(element - 1)];
        if (in_part == not_chosen) continue;
        const Topology& topology = mesh_.elements.topology_of(static_cast<std::size_t>(in_part));
        if (side < 1 || side > topology.face_count) {
          problems_.add(fmt::format(
              "side set '{}' names side {} of element {} ({})", set.name, side,
              mesh_.element_ids[static_cast<std::size_t>(in_part)],
              topology.is_surface() ? "of a shell the sides 1 and 2, its surfaces, can be named; nodes on its "
                                      "edges belong into a node set"
                                    : fmt::format("a {} has the sides 1 to {}", topology.noun, topology.face_count)));
          continue;
        }
        faces.push_back({in_part, topology.exodus_sides[static_cast<std::size_t>(side - 1)]});
      }
      std::sort(faces.begin(), faces.end());
      faces.erase(std::unique(faces.begin(), faces.end()), faces.end());
    }
  }

  /// Those that generated shells have too, unless the file has sets of these names.
  void name_sides_of_shells() {
    std::vector<ElementFace> tops, bottoms;
    for (int e = 0; e < static_cast<int>(mesh_.elements.size()); ++e) {
      if (!mesh_.elements.topology_of(static_cast<std::size_t>(e)).is_surface()) continue;
      tops.push_back({e, top_face});
      bottoms.push_back({e, bottom_face});
    }
    if (tops.empty()) return;
    mesh_.side_sets.try_emplace("top", std::move(tops));
    mesh_.side_sets.try_emplace("bottom", std::move(bottoms));
  }

  const ExodusFile& file_;
  std::vector<ExodusBlock> blocks_;
  std::vector<std::int64_t> file_node_ids_, file_element_ids_;
  std::vector<int> file_to_part_node_, file_to_part_element_;
  PartMesh mesh_;
  Problems problems_;
};

PartMesh read_file(const ExodusMesh& source) {
  const ExodusFile file(source.file);
  if (double(file.node_count()) > largest_mesh || double(file.element_count()) > largest_mesh) {
    throw InputError(fmt::format("the file has {} elements and {} nodes (percuss counts up to {:.0f})",
                                 file.element_count(), file.node_count(), largest_mesh));
  }
  if (file.element_count() == 0) throw InputError("the file has no elements");
  if (file.dimensions() != 3) {
    throw InputError(fmt::format("the mesh has {} dimensions (only meshes of 3 can be run)", file.dimensions()));
  }
  const std::vector<ExodusBlock> chosen = choose_blocks(file, source.blocks);
  if (chosen.empty()) throw InputError("the chosen blocks have no elements");
  check_kinds(file, chosen);
  return ExodusReader(file, chosen).read();
}

}  // namespace

std::string list_kinds() {
  std::string list;
  for (const Topology& topology : topologies) {
    for (const std::string_view name : topology.exodus_names)
      if (!name.empty()) list += fmt::format("{}{}{}", list.empty() ? "" : ", ", name, topology.corner_count);
  }
  return list;
}

bool can_run(const ExodusBlock& block) { return find_kind(block).has_value(); }

ExodusContents read_exodus_contents(const std::string& path) {
  const ExodusContainer container = inspect_exodus_container(path);
  const auto read = [&] {
    const ExodusFile file(path);
    return ExodusContents{file.dimensions(), file.element_count(), file.blocks(),
                          file.node_sets(),  file.side_sets(),     file.read_coordinates()};
  };
  run_trial_process([&] { read(); }, find_patience(container.bytes));
  return read();
}

PartMesh read_exodus_mesh(const ExodusMesh& source) {
  const ExodusContainer container = inspect_exodus_container(source.file);
  run_trial_process([&] { read_file(source); }, find_patience(container.bytes));
  PartMesh mesh = read_file(source);
  for (Vec3& x : mesh.nodes) {
    for (double& coordinate : x) coordinate *= source.scale;
  }
  return mesh;
}

}  // namespace percuss
