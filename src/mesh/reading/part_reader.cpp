#include "src/mesh/reading/part_reader.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <numeric>
#include <span>

#include "src/deck/mesh_size.hpp"
#include "src/error.hpp"
#include "src/mesh/formats/exodus/trial_process.hpp"
#include "src/mesh/quality/check_mesh.hpp"
#include "src/mesh/reading/choose_blocks.hpp"
#include "src/mesh/reading/collapsed_elements.hpp"
#include "src/mesh/reading/cut_elements.hpp"
#include "src/mesh/reading/mesh_reader.hpp"

namespace percuss {
namespace {

constexpr int not_chosen = -1;

/// Ids beyond this are hashes, not numbers that a person reads; they would overflow when parts are joined.
constexpr std::int64_t highest_id = 1'000'000'000'000'000;

/// Turns a quadrilateral of which two corners in a row are one node so that these come last. The normal stays as it is.
/// Returns whether they do: it is a triangle.
bool turn_triangle(std::span<int> nodes) {
  for (std::size_t turn = 0; turn < 4 && nodes[2] != nodes[3]; ++turn)
    std::rotate(nodes.begin(), nodes.begin() + 1, nodes.end());
  return nodes[2] == nodes[3];
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
  mesh.warnings.push_back(
      {"file_ids",
       fmt::format("the file's {} ids are not positive and unique (percuss numbers them by their position in the file)",
                   what),
       "", 0, 1});
  std::iota(ids.begin(), ids.end(), std::int64_t{1});
  return ids;
}

/// Makes a part from a file: reads block after block, then keeps the nodes and set entries that the blocks use.
class PartReader {
 public:
  PartReader(const MeshFile& file, Choice choice) : file_(file), choice_(std::move(choice)) {}

  PartMesh read() {
    file_node_ids_ = accept_ids(file_.read_node_ids(), "node", mesh_);
    file_element_ids_ = accept_ids(file_.read_element_ids(), "element", mesh_);
    if (std::any_of(choice_.blocks.begin(), choice_.blocks.end(), is_cut)) prepare_cuts();
    read_elements();
    forget_missing_thicknesses();
    throw_problems();  // what follows relies on indexes in range
    drop_unused_nodes();
    check_connectivity(mesh_, problems_);
    throw_problems();
    read_node_sets();
    read_side_sets();
    read_element_sets();
    name_sides_of_shells();
    throw_problems();
    if (cut_.size() > 0) mesh_.notes.push_back(describe_cuts());
    for (const std::string& note : file_.notes()) mesh_.warnings.push_back({"unread_content", note, "", 0, 1});
    return std::move(mesh_);
  }

 private:
  void throw_problems() const {
    if (!problems_.empty()) throw InputError(problems_.join(""));
  }

  /// Places, which choose how elements are cut, and ids of pieces.
  void prepare_cuts() {
    places_ = file_.read_coordinates();
    std::optional<std::int64_t> stride = find_piece_stride(file_element_ids_, highest_id);
    if (!stride) {
      mesh_.warnings.push_back({"file_ids",
                                "the file's element ids leave no room for those of the pieces of tetrahedra of ten "
                                "nodes (percuss numbers elements by their position in the file)",
                                "", 0, 1});
      std::iota(file_element_ids_.begin(), file_element_ids_.end(), std::int64_t{1});
      stride = find_piece_stride(file_element_ids_, highest_id);
    }
    piece_stride_ = *stride;
  }

  std::string describe_cuts() const {
    return fmt::format(
        "tetrahedra of ten nodes, cut into eight of four: {} into {} (pieces of element N: N, N + {}, N + {}, ..., N + "
        "{})",
        cut_.size(), tet10_pieces * cut_.size(), piece_stride_, 2 * piece_stride_,
        static_cast<std::int64_t>(tet10_pieces - 1) * piece_stride_);
  }

  void read_elements() {
    file_to_part_element_.assign(static_cast<std::size_t>(file_.element_count()), not_chosen);
    for (const FileBlock& block : choice_.blocks) {
      const std::vector<std::int64_t> corners = file_.read_connectivity(block);
      const std::vector<double> thicknesses = file_.read_thicknesses(block);
      for (std::size_t e = 0; e < static_cast<std::size_t>(block.elements); ++e) {
        const std::size_t in_file = static_cast<std::size_t>(block.first_element - 1) + e;
        if (!choice_.elements.empty() && choice_.elements[in_file] == 0) continue;
        check_count();
        file_to_part_element_[in_file] = static_cast<int>(mesh_.elements.size());
        ++taken_elements_;
        mesh_.element_ids.push_back(file_element_ids_[in_file]);
        std::vector<int> nodes = read_corners(corners, e, block);
        is_cut(block) ? add_pieces(nodes, block) : add_element(std::move(nodes), block);
        mesh_.elements.own_thickness.resize(mesh_.elements.size(), thicknesses.empty() ? 0 : thicknesses[e]);
      }
    }
  }

  /// Whether one more element of the file, cut or not, can be counted.
  void check_count() const {
    if (double(mesh_.elements.size() + tet10_pieces) <= largest_mesh) return;
    throw InputError(
        fmt::format("its tetrahedra of ten nodes, each cut into {}, make more elements than percuss counts ({:.0f}): "
                    "choose fewer with blocks",
                    tet10_pieces, largest_mesh));
  }

  void forget_missing_thicknesses() {
    std::vector<double>& thicknesses = mesh_.elements.own_thickness;
    if (std::all_of(thicknesses.begin(), thicknesses.end(), [](double t) { return t == 0; })) thicknesses.clear();
  }

  std::vector<int> read_corners(const std::vector<std::int64_t>& corners, std::size_t element, const FileBlock& block) {
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

  /// The first piece has the id of the element. A file without nodes is refused later, for the corners of its elements.
  void add_pieces(const std::vector<int>& nodes, const FileBlock& block) {
    cut_.add(static_cast<int>(mesh_.elements.size()));
    const std::int64_t id = mesh_.element_ids.back();
    const auto pieces = cut_tet10(places_.empty() ? 0 : find_shortest_diagonal(nodes, places_, file_node_ids_));
    for (std::size_t p = 0; p < pieces.size(); ++p) {
      if (p > 0) mesh_.element_ids.push_back(id + static_cast<std::int64_t>(p) * piece_stride_);
      std::vector<int> corners;
      for (const int place : pieces[p]) corners.push_back(nodes[static_cast<std::size_t>(place)]);
      mesh_.elements.add(find_block(block.name, TopologyKind::tet4), corners);
    }
  }

  void add_element(std::vector<int> nodes, const FileBlock& block) {
    TopologyKind kind = *block.topology;
    if (kind == TopologyKind::quad4 && turn_triangle(nodes)) {
      kind = TopologyKind::tri3;
      nodes.pop_back();
    }
    if (kind == TopologyKind::hex8) kind = collapsed_.collapse(static_cast<int>(mesh_.elements.size()), nodes);
    mesh_.elements.add(find_block(block.name, kind), nodes);
  }

  /// The block of the part for a block of the file; triangles among quadrilaterals form one of their own.
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
    const std::vector<Vec3> nodes = places_.empty() ? file_.read_coordinates() : std::exchange(places_, {});
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
      mesh_.file_nodes.push_back(static_cast<int>(n));
    }
    for (std::size_t e = 0; e < mesh_.elements.size(); ++e) {
      for (int& node : mesh_.elements.corners(e)) node = file_to_part_node_[static_cast<std::size_t>(node)];
    }
    warn_of_unused_nodes();
  }

  void warn_of_unused_nodes() {
    const std::size_t unused = file_to_part_node_.size() - mesh_.nodes.size();
    // With only some blocks chosen, the others are what uses the rest.
    if (unused == 0 || taken_elements_ != file_.element_count()) return;
    const auto first = std::find(file_to_part_node_.begin(), file_to_part_node_.end(), not_chosen);
    mesh_.warnings.push_back({"unused_nodes",
                              fmt::format("{} nodes belong to no element and are dropped, the first is node {}", unused,
                                          file_node_ids_[static_cast<std::size_t>(first - file_to_part_node_.begin())]),
                              "", 0, 1});
  }

  void read_node_sets() {
    for (const FileSet& set : file_.node_sets()) {
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
    for (const FileSet& set : file_.side_sets()) {
      std::vector<ElementFace>& faces = mesh_.side_sets[set.name];
      for (const auto& [element, side] : file_.read_side_set(set)) {
        if (element < 1 || element > file_.element_count()) {
          problems_.add(fmt::format("side set '{}' names element number {} (the file has the elements 1 to {})",
                                    set.name, element, file_.element_count()));
          continue;
        }
        const int in_part = file_to_part_element_[static_cast<std::size_t>(element - 1)];
        if (in_part == not_chosen) continue;
        if (cut_.has(in_part)) {
          add_faces_of_pieces(set, in_part, side, faces);
          continue;
        }
        const Topology& topology =
            collapsed_.has(in_part) ? hex8_topology : mesh_.elements.topology_of(static_cast<std::size_t>(in_part));
        int face = file_.find_face(topology, side);
        if (face >= 0 && collapsed_.has(in_part)) {
          face = collapsed_.find_face(mesh_.elements, in_part, face, file_to_part_node_);
          if (face < 0) continue;  // a side without area
        }
        if (face < 0 || face >= topology.face_count) {
          problems_.add(fmt::format(
              "side set '{}' names side {} of element {} ({})", set.name, side,
              mesh_.element_ids[static_cast<std::size_t>(in_part)],
              topology.is_surface() ? "of a shell the sides 1 and 2, its surfaces, can be named; nodes on its "
                                      "edges belong into a node set"
              : topology.is_line()  ? "a beam has no sides"
                                    : fmt::format("a {} has the sides 1 to {}", topology.noun, topology.face_count)));
          continue;
        }
        faces.push_back({in_part, face});
      }
      std::sort(faces.begin(), faces.end());
      faces.erase(std::unique(faces.begin(), faces.end()), faces.end());
    }
  }

  void add_faces_of_pieces(const FileSet& set, int first_piece, std::int64_t side, std::vector<ElementFace>& faces) {
    const std::vector<ElementFace> found =
        CutElements::find_faces(mesh_.elements, first_piece, file_.find_face(tet4_topology, side));
    if (found.empty())
      problems_.add(fmt::format("side set '{}' names side {} of element {} (a tetrahedron has the sides 1 to 4)",
                                set.name, side, mesh_.element_ids[static_cast<std::size_t>(first_piece)]));
    faces.insert(faces.end(), found.begin(), found.end());
  }

  /// An element set is a set of all faces of its elements; selections of faces keep the exterior ones.
  void read_element_sets() {
    for (const FileSet& set : file_.element_sets()) {
      if (mesh_.side_sets.contains(set.name)) {
        mesh_.warnings.push_back({"file_ids",
                                  fmt::format("the file has a side set and an element set '{}' (the name means the "
                                              "side set)",
                                              set.name),
                                  "", 0, 1});
        continue;
      }
      std::vector<ElementFace>& faces = mesh_.side_sets[set.name];
      for (const std::int64_t element : file_.read_element_set(set)) {
        if (element < 1 || element > file_.element_count()) {
          problems_.add(fmt::format("element set '{}' names element number {} (the file has the elements 1 to {})",
                                    set.name, element, file_.element_count()));
          continue;
        }
        const int in_part = file_to_part_element_[static_cast<std::size_t>(element - 1)];
        if (in_part == not_chosen) continue;
        const int count = mesh_.elements.topology_of(static_cast<std::size_t>(in_part)).face_count;
        for (int piece = in_part; piece < in_part + cut_.count_pieces(in_part); ++piece)
          for (int face = 0; face < count; ++face) faces.push_back({piece, face});
      }
      std::sort(faces.begin(), faces.end());
      faces.erase(std::unique(faces.begin(), faces.end()), faces.end());
    }
  }

  /// Names the sides that generated shells have too, unless the file has sets of these names.
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

  const MeshFile& file_;
  Choice choice_;
  std::vector<std::int64_t> file_node_ids_, file_element_ids_;
  std::vector<int> file_to_part_node_, file_to_part_element_;
  CollapsedElements collapsed_;
  CutElements cut_;
  std::vector<Vec3> places_;  // of the file's nodes, while elements are cut
  std::int64_t piece_stride_ = 0, taken_elements_ = 0;
  PartMesh mesh_;
  Problems problems_;
};

PartMesh read_part(const MeshFile& file, const FileMesh& source) {
  if (double(file.node_count()) > largest_mesh || double(file.element_count()) > largest_mesh) {
    throw InputError(fmt::format("the file has {} elements and {} nodes (percuss counts up to {:.0f})",
                                 file.element_count(), file.node_count(), largest_mesh));
  }
  if (file.element_count() == 0) throw InputError("the file has no elements");
  if (file.dimensions() != 3) {
    throw InputError(fmt::format("the mesh has {} dimensions (only meshes of 3 can be run)", file.dimensions()));
  }
  Choice choice = choose_blocks(file, source.blocks);
  if (choice.blocks.empty()) throw InputError("the chosen blocks have no elements");
  check_kinds(file, choice.blocks);
  return PartReader(file, std::move(choice)).read();
}

}  // namespace

MeshContents read_mesh_contents(const std::string& path) {
  const MeshReader& reader = find_mesh_reader(path);
  const auto read = [&] {
    const std::unique_ptr<MeshFile> file = reader.open(path);
    return MeshContents{reader.name,          file->dimensions(), file->element_count(),
                        file->blocks(),       file->node_sets(),  file->side_sets(),
                        file->element_sets(), file->list_kinds(), file->read_coordinates()};
  };
  if (reader.uses_libraries) run_trial_process([&] { read(); }, reader.find_patience(path));
  return read();
}

PartMesh MeshFiles::read(const FileMesh& source) {
  const MeshReader& reader = source.is_exodus ? exodus_reader() : find_mesh_reader(source.file);
  if (reader.uses_libraries) {
    run_trial_process([&] { read_part(*reader.open(source.file), source); }, reader.find_patience(source.file));
  }
  std::unique_ptr<MeshFile>& file = files_[source.file];
  const bool is_new = !file;
  if (is_new) file = reader.open(source.file);
  PartMesh mesh = read_part(*file, source);
  if (!is_new) std::erase_if(mesh.warnings, [](const Warning& w) { return w.rule == "unread_content"; });
  if (source.is_exodus) files_.erase(source.file);
  for (Vec3& x : mesh.nodes) {
    for (double& coordinate : x) coordinate *= source.scale;
  }
  for (double& thickness : mesh.elements.own_thickness) thickness *= source.scale;
  return mesh;
}

PartMesh read_part_mesh(const FileMesh& source) { return MeshFiles().read(source); }

}  // namespace percuss
