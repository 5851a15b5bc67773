#pragma once
// Rows of a step as one complementarity problem: A = H M^-1 G^T assembled and solved (contact.enforcement: lagrange).
//
// G holds the coefficients of the impulses of all rows in their directions, H those of the gaps and slides that the
// rows watch; they differ only where the push direction of a curved surface is not the normal of the triangle.

#include <vector>

#include "kernels/contact/rows/row_system.hpp"

namespace percuss {

/// A row with its nodes, as it can be solved anywhere.
struct CoupledRow {
  ContactRow row;
  std::int64_t node[row_nodes] = {-1, -1, -1, -1, -1};  // numbers
  Point3 inverse_mass[row_nodes]{};                     // 0: held; of a rigid body that of all of it
  int body[row_nodes] = {-1, -1, -1, -1, -1};           // rigid one that has the node
  Point3 arm[row_nodes]{};                              // of the node about its centre
  Symmetric3<double> inverse_inertia[row_nodes]{};      // of it
  Point3 own{};                                         // TurningRow::compliance
};

struct CoupledReport {
  std::int64_t rows = 0;
  int sweeps = 0;
  bool converged = true;
  double complementarity = 0;  // largest deviation from the conditions / largest closing velocity
};

/// The impulses of all rows, which are in the order of their keys. A's product is that of Kokkos Kernels. impulses:
/// out, [rows]. dt: step.
CoupledReport solve_coupled_rows(const std::vector<CoupledRow>& rows, double dt, std::vector<RowImpulse>& impulses);

/// As solve_coupled_rows(), for rows in any order.
CoupledReport solve_in_key_order(const std::vector<CoupledRow>& rows, double dt, std::vector<RowImpulse>& impulses);

/// The rows of a rank with their nodes. node_numbers: [mesh nodes].
std::vector<CoupledRow> list_coupled_rows(const RowSystem& system, const Array<const std::int64_t>& node_numbers);

/// Gives the rows of a rank their impulses.
void set_impulses(const WorkSpace& space, const std::vector<RowImpulse>& impulses, const RowSystem& system);

}  // namespace percuss
