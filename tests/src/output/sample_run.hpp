#pragma once
// A small run with known numbers: two cubes of hexahedra that shear and turn, as FieldsFile gets them from a time loop.

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "comm/communicator.hpp"
#include "src/mesh/ordering.hpp"
#include "src/output/vtkhdf/fields_file.hpp"
#include "tests/src/mesh/hand_made.hpp"

namespace percuss::sample {

/// cells^3 elements a cube; ids that are neither 0-based nor in order; a part name that XML must escape.
inline Mesh make_mesh(int cells = 2) {
  Mesh mesh;
  mesh.parts = {{"left"}, {"right <&\"> one"}};
  const int n = cells + 1;
  for (int part = 0; part < 2; ++part) {
    const int first = static_cast<int>(mesh.nodes.size());
    for (int i = 0; i < n * n * n; ++i) {
      mesh.nodes.push_back({i % n + 10.0 * part, i / n % n + 0.0, i / (n * n) + 0.0});
      mesh.node_ids.push_back(1000 - static_cast<std::int64_t>(mesh.node_ids.size()));
    }
    for (int i = 0; part == 0 && i < n * n; ++i) mesh.node_sets["left/floor"].push_back(first + i);
    for (int e = 0; e < cells * cells * cells; ++e) {
      if (part == 0 && e < cells * cells) mesh.side_sets["left/floor"].push_back({e, 4});
      const int c = first + e % cells + n * (e / cells % cells) + n * n * (e / (cells * cells));
      const int up = n * n;
      testing_mesh::add_element(mesh.elements, TopologyKind::hex8,
                                {c, c + 1, c + n + 1, c + n, c + up, c + up + 1, c + up + n + 1, c + up + n}, part);
      mesh.element_ids.push_back(500 + 3 * static_cast<std::int64_t>(mesh.element_ids.size()));
    }
  }
  return mesh;
}

/// The mesh cut into chunks, which are the layers of the cubes. Its nodes lie as chunks number them.
inline ChunkedMesh cut_layers(Mesh mesh) {
  ChunkedMesh chunked;
  const auto cells = static_cast<int>(std::lround(std::cbrt(static_cast<double>(mesh.elements.size()) / 2)));
  const int layer = cells * cells, plane = (cells + 1) * (cells + 1);
  chunked.numbering.first_element = chunked.numbering.first_node = {0};
  for (int c = 0; c < 2 * cells; ++c) {
    chunked.chunks.push_back({c * layer, layer, c / cells, c});
    chunked.numbering.ranks.push_back(0);
    chunked.numbering.first_element.push_back((c + 1) * layer);
    chunked.numbering.first_node.push_back(chunked.numbering.first_node.back() + (c % cells == 0 ? 2 : 1) * plane);
  }
  for (std::size_t n = 0; n < mesh.nodes.size(); ++n) mesh.node_numbers.push_back(static_cast<std::int64_t>(n));
  chunked.mesh = std::move(mesh);
  return chunked;
}

/// What a rank holds of it: every chunk goes to a rank, neighbouring ones to different ranks, to some ranks none at
/// all.
inline ChunkedMesh take_share(const ChunkedMesh& whole, const Communicator& ranks) {
  ChunkedMesh share;
  Mesh& own = share.mesh;
  share.numbering = whole.numbering;
  own.parts = whole.mesh.parts;
  own.node_sets["left/floor"] = {};
  own.side_sets["left/floor"] = {};
  own.elements.blocks = whole.mesh.elements.blocks;
  std::vector<int> local(whole.mesh.nodes.size(), -1);
  for (const Chunk& chunk : whole.chunks) {
    int& owner = share.numbering.ranks[static_cast<std::size_t>(chunk.number)];
    owner = (5 * chunk.number + 2) % ranks.size();
    if (owner != ranks.rank()) continue;
    share.chunks.push_back({static_cast<int>(own.elements.size()), chunk.element_count, chunk.part, chunk.number});
    for (int i = chunk.first_element; i < chunk.first_element + chunk.element_count; ++i) {
      const auto e = static_cast<std::size_t>(i);
      for (const ElementFace& face : whole.mesh.side_sets.at("left/floor")) {
        if (face.element == i)
          own.side_sets["left/floor"].push_back({static_cast<int>(own.elements.size()), face.face});
      }
      own.elements.add(whole.mesh.elements.block_index(e), whole.mesh.corners(e));
      own.element_ids.push_back(whole.mesh.element_ids[e]);
      for (const int node : whole.mesh.corners(e)) local[static_cast<std::size_t>(node)] = 0;
    }
  }
  for (std::size_t n = 0; n < local.size(); ++n) {
    if (local[n] < 0) continue;
    local[n] = static_cast<int>(own.nodes.size());
    own.nodes.push_back(whole.mesh.nodes[n]);
    own.node_ids.push_back(whole.mesh.node_ids[n]);
    own.node_numbers.push_back(static_cast<std::int64_t>(n));
  }
  for (const int node : whole.mesh.node_sets.at("left/floor")) {
    if (local[static_cast<std::size_t>(node)] >= 0)
      own.node_sets["left/floor"].push_back(local[static_cast<std::size_t>(node)]);
  }
  for (std::size_t e = 0; e < own.elements.size(); ++e) {
    for (int& node : own.elements.corners(e)) node = local[static_cast<std::size_t>(node)];
  }
  return share;
}

inline double time_of(int frame) { return 0.1 * frame; }  // not a round number in binary
inline long step_of(int frame) { return 10L * frame; }

/// What one frame holds. The numbers differ in every item, component and frame; those of an element follow from its id,
/// so that a rank can tell them from its share.
struct Frame {
  std::vector<double> positions, velocity, stress, von_mises, flag;

  Frame(const Mesh& mesh, int frame) {
    const double t = time_of(frame);
    for (const auto& node : mesh.nodes) {
      positions.insert(positions.end(), {node[0] + t * node[1], node[1] + t / 3, node[2] - t * t});
      velocity.insert(velocity.end(), {node[1] + frame, 1.0 / 3, -2 * t});
    }
    for (const std::int64_t id : mesh.element_ids) {
      const auto e = static_cast<double>((id - 500) / 3);
      for (int c = 0; c < 6; ++c) stress.push_back(100 * frame + e + 0.1 * c);
      von_mises.push_back(1e6 * frame + e / 7);
      flag.push_back(static_cast<double>((id + frame) % 2));
    }
  }

  std::vector<FieldData> fields() const {
    return {{"velocity", FieldPlace::node, 3, velocity},
            {"stress", FieldPlace::element, 6, stress},
            {"von_mises", FieldPlace::element, 1, von_mises},
            {"flag", FieldPlace::element, 1, flag, FieldNumber::byte}};
  }
};

template <class File>
void write_frame(File& file, const Mesh& mesh, int frame) {
  const Frame data(mesh, frame);
  const auto fields = data.fields();
  file.write_frame(time_of(frame), step_of(frame), data.positions, fields);
}

inline FieldsOptions options() {
  FieldsOptions options{"A sample & its <title>", "m, kg, s", FieldPrecision::float64, {{{0, 0, -1}, {0, 0, 1}}}};
  options.node_sets = options.side_sets = {"left/floor"};
  return options;
}

/// A fields file that one rank writes.
inline FieldsFile create_file(const std::string& folder, const Mesh& mesh, const FieldsOptions& how = options()) {
  return {folder, cut_layers(mesh), how, Communicator(MPI_COMM_SELF)};
}

/// A folder of its own for a test, removed at the end.
class TemporaryFolder {
 public:
  TemporaryFolder() {
    std::string pattern = (std::filesystem::temp_directory_path() / "percuss-test-XXXXXX").string();
    if (::mkdtemp(pattern.data()) == nullptr) std::abort();
    path_ = pattern;
  }
  ~TemporaryFolder() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  }
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;
  const std::string& path() const { return path_; }
  std::string file(const std::string& name) const { return path_ + "/" + name; }

 private:
  std::string path_;
};

}  // namespace percuss::sample
