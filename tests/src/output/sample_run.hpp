#pragma once
// A small run with known numbers: two cubes of hexahedra that shear and turn, as FieldsFile gets them from a time loop.

#include <cstdlib>
#include <filesystem>
#include <string>
#include <vector>

#include "src/mesh/mesh.hpp"
#include "src/output/fields_file.hpp"

namespace percuss::sample {

/// cells^3 elements a cube; ids that are neither 0-based nor in order; a part name that XML must escape.
inline Mesh make_mesh(int cells = 2) {
  Mesh mesh;
  mesh.parts = {{"left", 0}, {"right <&\"> one", 1}};
  const int n = cells + 1;
  for (int part = 0; part < 2; ++part) {
    const int first = static_cast<int>(mesh.nodes.size());
    for (int i = 0; i < n * n * n; ++i) {
      mesh.nodes.push_back({i % n + 10.0 * part, i / n % n + 0.0, i / (n * n) + 0.0});
      mesh.node_ids.push_back(1000 - static_cast<std::int64_t>(mesh.node_ids.size()));
    }
    for (int e = 0; e < cells * cells * cells; ++e) {
      const int c = first + e % cells + n * (e / cells % cells) + n * n * (e / (cells * cells));
      const int up = n * n;
      mesh.elements.push_back({c, c + 1, c + n + 1, c + n, c + up, c + up + 1, c + up + n + 1, c + up + n});
      mesh.element_ids.push_back(500 + 3 * static_cast<std::int64_t>(mesh.element_ids.size()));
      mesh.element_part.push_back(part);
    }
  }
  return mesh;
}

inline double time_of(int frame) { return 0.1 * frame; }  // not a round number in binary
inline long step_of(int frame) { return 10L * frame; }

/// What one frame holds. The numbers differ in every item, component and frame.
struct Frame {
  std::vector<double> positions, velocity, stress, von_mises;

  Frame(const Mesh& mesh, int frame) {
    const double t = time_of(frame);
    for (const auto& node : mesh.nodes) {
      positions.insert(positions.end(), {node[0] + t * node[1], node[1] + t / 3, node[2] - t * t});
      velocity.insert(velocity.end(), {node[1] + frame, 1.0 / 3, -2 * t});
    }
    for (std::size_t e = 0; e < mesh.elements.size(); ++e) {
      for (int c = 0; c < 6; ++c) stress.push_back(100 * frame + static_cast<double>(e) + 0.1 * c);
      von_mises.push_back(1e6 * frame + static_cast<double>(e) / 7);
    }
  }

  std::vector<FieldData> fields() const {
    return {{"velocity", FieldPlace::node, 3, velocity},
            {"stress", FieldPlace::element, 6, stress},
            {"von_mises", FieldPlace::element, 1, von_mises}};
  }
};

inline void write_frame(FieldsFile& file, const Mesh& mesh, int frame) {
  const Frame data(mesh, frame);
  const auto fields = data.fields();
  file.write_frame(time_of(frame), step_of(frame), data.positions, fields);
}

inline FieldsOptions options() { return {"A sample & its <title>", "m, kg, s", FieldPrecision::float64}; }

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
