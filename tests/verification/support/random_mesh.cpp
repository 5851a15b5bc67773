#include "tests/verification/support/random_mesh.hpp"

#include "tests/kernels/element/random_element.hpp"

namespace percuss::test {

RandomMesh make_random_mesh(int n, double distortion, unsigned long seed) {
  Random random(seed);
  RandomMesh mesh;
  const double h = 1.0 / n;
  const auto node = [n](int i, int j, int k) { return std::int64_t{1} + i + (n + 1) * (j + (n + 1) * k); };
  for (int k = 0; k <= n; ++k) {
    for (int j = 0; j <= n; ++j) {
      for (int i = 0; i <= n; ++i) {
        const int at[3] = {i, j, k};
        Vec3 x{};
        bool is_interior = true;
        for (std::size_t d = 0; d < 3; ++d) {
          const bool is_on_side = at[d] == 0 || at[d] == n;
          const double move = distortion * random();
          x[d] = h * (at[d] + (is_on_side ? 0 : move)) - 0.5;
          is_interior = is_interior && !is_on_side;
        }
        mesh.written.nodes.push_back(x);
        mesh.is_interior.push_back(is_interior);
      }
    }
  }
  testing_mesh::WrittenBlock block;
  block.name = "body";
  for (int k = 0; k < n; ++k) {
    for (int j = 0; j < n; ++j) {
      for (int i = 0; i < n; ++i) {
        for (const std::int64_t corner :
             {node(i, j, k), node(i + 1, j, k), node(i + 1, j + 1, k), node(i, j + 1, k), node(i, j, k + 1),
              node(i + 1, j, k + 1), node(i + 1, j + 1, k + 1), node(i, j + 1, k + 1)}) {
          block.corners.push_back(corner);
        }
      }
    }
  }
  mesh.written.blocks.push_back(block);
  return mesh;
}

}  // namespace percuss::test
