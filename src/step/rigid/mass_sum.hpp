#pragma once
// Mass, centre and second moments of what makes up a rigid body: of elements by exact integrals, of nodes as points.

#include "kernels/core/tensor.hpp"
#include "src/deck/deck.hpp"
#include "src/mesh/mesh.hpp"
#include "src/step/model/model.hpp"

namespace percuss {

/// Mass, centre and second moments of mass about the centre.
struct MassSum {
  double mass = 0;
  Vector3<double> center{};
  Symmetric3<double> second{};
};

/// r r^T
inline Symmetric3<double> find_dyad(const Vector3<double>& r) {
  return {r.x * r.x, r.y * r.y, r.z * r.z, r.x * r.y, r.y * r.z, r.z * r.x};
}

/// Both together; second moments without mass count as they are.
MassSum combine(const MassSum& a, const MassSum& b);

/// All pieces of all ranks together, the same bits on any number of them. Collective.
MassSum sum_pieces(const Communicator& ranks, const std::vector<MassSum>& pieces);

/// An element at time 0, of uniform density, by the exact integrals of its shape: of solids with bilinear or flat faces
/// over their surface (divergence theorem), of shells over their middle surface and thickness, of beams over their
/// length and cross section. mass: of the element, with what mass scaling gave it. model: the axes of beams are there.
MassSum find_element_masses(const Deck& deck, const Mesh& mesh, const Model& model, std::size_t element, double mass);

}  // namespace percuss
