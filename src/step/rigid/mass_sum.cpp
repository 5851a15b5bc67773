#include "src/step/rigid/mass_sum.hpp"

#include <array>
#include <cmath>

#include "comm/exact_reduction.hpp"
#include "src/index.hpp"
#include "src/mesh/hex_geometry.hpp"

namespace percuss {
namespace {

/// Gauss points on an interval from 0 to 1: exact to the fifth degree.
constexpr double gauss_places[3] = {0.1127016653792583, 0.5, 0.8872983346207417},
                 gauss_weights[3] = {5.0 / 18, 8.0 / 18, 5.0 / 18};

/// Integrals of 1, x and x x^T.
struct ShapeMoments {
  double volume = 0;
  Vector3<double> first{};
  Symmetric3<double> second{};

  void add(double weight, const Vector3<double>& x) {
    volume += weight;
    first = first + weight * x;
    second = second + weight * find_dyad(x);
  }

  /// The sum scaled to this mass. from: the point that its places are relative to.
  MassSum scale_to(double mass, const Vector3<double>& from) const {
    const double density = mass / volume;
    const Vector3<double> center = (1 / volume) * first;
    return {mass, from + center, density * second + (-mass) * find_dyad(center)};
  }
};

using BilinearFace = std::array<Vector3<double>, 4>;

/// Calls visit(place, area vector times weight) at the points of a bilinear face.
template <class Visit>
void visit_face(const BilinearFace& x, const Visit& visit) {
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) {
      const double a = gauss_places[i], b = gauss_places[j];
      const Vector3<double> along = (1 - b) * (x[1] - x[0]) + b * (x[2] - x[3]),
                            across = (1 - a) * (x[3] - x[0]) + a * (x[2] - x[1]);
      const Vector3<double> place = (1 - b) * ((1 - a) * x[0] + a * x[1]) + b * ((1 - a) * x[3] + a * x[2]);
      visit(place, (gauss_weights[i] * gauss_weights[j]) * cross(along, across));
    }
  }
}

/// A function of degree d has the integral over the surface of f x . n / (3 + d).
ShapeMoments integrate_solid(const Topology& topology, const std::array<Vector3<double>, kernel_corner_count>& x) {
  ShapeMoments m;
  for (const FaceCorners& face : topology.faces()) {
    const auto corner = [&](std::size_t i) { return x[at(face.four[i])]; };
    visit_face({corner(0), corner(1), corner(2), corner(3)}, [&](const Vector3<double>& at, const Vector3<double>& da) {
      const double flux = dot(at, da);
      m.volume += flux / 3;
      m.first = m.first + (flux / 4) * at;
      m.second = m.second + (flux / 5) * find_dyad(at);
    });
  }
  return m;
}

/// The middle lies `offset` along the normal from the nodes.
ShapeMoments integrate_shell(const BilinearFace& x, double thickness, double offset) {
  ShapeMoments m;
  visit_face(x, [&](const Vector3<double>& at, const Vector3<double>& da) {
    const double area = norm(da);
    if (!(area > 0)) return;
    const Vector3<double> normal = (1 / area) * da;
    m.add(area, at + offset * normal);
    m.second = m.second + (area * thickness * thickness / 12) * find_dyad(normal);
  });
  return m;
}

/// The cross section turns the mass about its axes y and z, along e2 and e3.
ShapeMoments integrate_beam(const BeamSection& section, const Vector3<double>& line, const Vector3<double>& e2) {
  ShapeMoments m;
  for (int i = 0; i < 3; ++i) m.add(gauss_weights[i], gauss_places[i] * line);
  const Vector3<double> e3 = (1 / norm(line)) * cross(line, e2);
  const double over_area = 1 / section.area;
  m.second =
      m.second + (over_area * section.inertia_z) * find_dyad(e2) + (over_area * section.inertia_y) * find_dyad(e3);
  return m;
}

}  // namespace

MassSum combine(const MassSum& a, const MassSum& b) {
  if (!(b.mass > 0)) return {a.mass, a.center, a.second + b.second};
  MassSum sum{a.mass + b.mass, {}, a.second + b.second};
  sum.center = (1 / sum.mass) * (a.mass * a.center + b.mass * b.center);
  for (const MassSum* of : {&a, &b}) sum.second = sum.second + of->mass * find_dyad(of->center - sum.center);
  return sum;
}

MassSum sum_pieces(const Communicator& ranks, const std::vector<MassSum>& pieces) {
  std::array<ExactSum, 4> first{};
  for (const MassSum& piece : pieces) {
    first[3].add(piece.mass);
    for (std::size_t k = 0; k < 3; ++k) first[k].add(piece.mass * get(piece.center, static_cast<int>(k)));
  }
  sum_over_ranks(ranks, first);
  MassSum sum;
  sum.mass = first[3].round();
  if (sum.mass > 0) sum.center = (1 / sum.mass) * Vector3<double>{first[0].round(), first[1].round(), first[2].round()};
  std::array<ExactSum, 6> second{};
  for (const MassSum& piece : pieces) {
    const Symmetric3<double> j = piece.second + piece.mass * find_dyad(piece.center - sum.center);
    const double values[6] = {j.xx, j.yy, j.zz, j.xy, j.yz, j.zx};
    for (std::size_t k = 0; k < 6; ++k) second[k].add(values[k]);
  }
  sum_over_ranks(ranks, second);
  double s[6];
  for (std::size_t k = 0; k < 6; ++k) s[k] = second[k].round();
  sum.second = {s[0], s[1], s[2], s[3], s[4], s[5]};
  return sum;
}

MassSum find_element_masses(const Deck& deck, const Mesh& mesh, const Model& model, std::size_t element, double mass) {
  const ElementCorners corners = gather_corners(mesh.elements, element, mesh.nodes);
  const Vector3<double> from = to_vector(corners[0]);
  std::array<Vector3<double>, kernel_corner_count> x;
  for (std::size_t i = 0; i < x.size(); ++i) x[i] = to_vector(corners[i]) - from;
  const Topology& topology = mesh.topology_of(element);
  const PartDeck& part = deck.parts[at(mesh.part_of(element))];
  if (topology.is_surface())
    return integrate_shell({x[0], x[1], x[2], x[3]}, mesh.thickness_of(element), part.offset).scale_to(mass, from);
  if (!topology.is_line()) return integrate_solid(topology, x).scale_to(mass, from);
  const auto axes = Kokkos::subview(model.start_beam_axes, element, Kokkos::ALL);
  const Vector3<double> e2{axes(0), axes(1), axes(2)};
  return integrate_beam(make_beam_section(*part.section), x[1], e2).scale_to(mass, from);
}

}  // namespace percuss
