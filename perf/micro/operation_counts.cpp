#include "perf/micro/operation_counts.hpp"

#include <stdexcept>

#include "kernels/element/hex8/hex8_full.hpp"
#include "kernels/material/laws/materials.hpp"

namespace percuss {

namespace {

using Modes = VectorModes<Counted>;

/// A unit cube, pulled and bent, and its velocities.
void find_modes(Modes& a, Modes& v) {
  Counted corner[2][3][8];
  for (int i = 0; i < 8; ++i) {
    const double xi = ((i + 1) / 2) % 2, eta = (i / 2) % 2, zeta = i / 4;
    const double x[3] = {xi + 0.1 * eta * zeta, eta + 0.05 * xi * zeta, zeta};
    for (int k = 0; k < 3; ++k) {
      corner[0][k][i] = Counted(x[k]);
      corner[1][k][i] = Counted(0.1 * x[(k + 1) % 3]);
    }
  }
  for (auto& field : corner) {
    for (auto& u : field) to_modes(u);
  }
  for (int m = 1; m < 8; ++m) {
    a[m] = {corner[0][0][m], corner[0][1][m], corner[0][2][m]};
    v[m] = {corner[1][0][m], corner[1][1][m], corner[1][2][m]};
  }
}

template <class Material, HexKind Kind>
OperationCounts count(const Material& material) {
  SolidParameters<Material> parameters;
  parameters.material = material;
  parameters.lambda = parameters.mu = 1;
  HexState<Counted, Material, Kind> state{};
  state.mass = Counted(1);
  state.polar.rotation = identity_matrix<Counted>();
  state.polar.stretch = {Counted(1), Counted(1), Counted(1), Counted(0), Counted(0), Counted(0)};
  Counted fx[8], fy[8], fz[8];
  Modes a, v;
  Counted::counts = {};
  find_modes(a, v);
  advance_hex8(parameters, a, v, Counted(1e-3), state, {fx, fy, fz});
  return Counted::counts;
}

template <class Material>
OperationCounts count_kind(const Material& material, const std::string& element) {
  if (element == "assumed_strain") return count<Material, HexKind::assumed_strain>(material);
  if (element == "stiffness") return count<Material, HexKind::stiffness>(material);
  if (element == "viscous") return count<Material, HexKind::viscous>(material);
  if (element == "full") return count<Material, HexKind::full>(material);
  throw std::invalid_argument("no element '" + element + "'");
}

}  // namespace

OperationCounts count_operations(const std::string& material, const std::string& element) {
  if (material == "elastic") return count_kind(Elastic{1, 1}, element);
  if (material == "j2_plasticity") return count_kind(J2Plasticity{1, 1, 1e-2, 0.1}, element);
  throw std::invalid_argument("no material '" + material + "'");
}

}  // namespace percuss
