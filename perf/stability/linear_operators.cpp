#include "perf/stability/linear_operators.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

#include "kernels/core/host_copy.hpp"
#include "src/mesh/decomposition/decompose.hpp"
#include "src/step/model/element_blocks.hpp"
#include "src/step/model/model.hpp"
#include "src/step/model/state.hpp"

namespace percuss {

namespace {

constexpr double difference = 6e-6;    // of the shortest edge: error of the difference and rounding are equal there
constexpr double endless_step = 1e12;  // in bounds: rates vanish

enum class Input { displacement, velocity };

/// The nodes of a part in the order of its lattice, and what scales its motion.
struct Lattice {
  std::vector<std::size_t> nodes;
  double shortest_edge = 0;
  Vec3 center{};
};

int find_cells(const PartDeck& part) { return std::get<BoxShape>(part.shape).cells[0]; }

Lattice find_lattice(const Mesh& mesh, const PartDeck& part) {
  const int cells = find_cells(part);
  const auto side = static_cast<std::size_t>(cells) + 1;
  Lattice lattice;
  lattice.nodes.resize(side * side * side);
  for (const int node : mesh.node_sets.at(part.name)) {
    std::size_t place = 0;
    for (const double x : mesh.nodes[static_cast<std::size_t>(node)]) {
      place = place * side + static_cast<std::size_t>(std::lround(x * cells));
    }
    lattice.nodes[place] = static_cast<std::size_t>(node);
  }
  return lattice;
}

double find_distance(const Vec3& a, const Vec3& b) { return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]); }

/// Moves the nodes of a part to their places.
void set_shape(const LinearShape& shape, Lattice& lattice, Mesh& mesh) {
  const auto side = static_cast<std::size_t>(std::lround(std::cbrt(static_cast<double>(lattice.nodes.size()))));
  lattice.shortest_edge = find_distance(shape.nodes[0], shape.nodes[1]);
  for (std::size_t i = 0; i < lattice.nodes.size(); ++i) {
    mesh.nodes[lattice.nodes[i]] = shape.nodes[i];
    for (std::size_t k = 0; k < 3; ++k) {
      lattice.center[k] += shape.nodes[i][k] / static_cast<double>(lattice.nodes.size());
    }
    for (const std::size_t stride : {std::size_t{1}, side, side * side}) {
      if (i / stride % side + 1 == side) continue;
      lattice.shortest_edge = std::min(lattice.shortest_edge, find_distance(shape.nodes[i], shape.nodes[i + stride]));
    }
  }
}

/// The elements of a scene, always evaluated from rest.
class RestingElements {
 public:
  explicit RestingElements(const Model& model)
      : model_(model), state_(make_initial_state(model)), rest_(state_.elements) {
    state_.elements = Array<double>("stability::elements", rest_.extent(0));
  }

  /// Internal forces (they resist), by node, after a step dt to x with velocity v.
  const std::vector<Vec3>& find_forces(const std::vector<Vec3>& x, const std::vector<Vec3>& v, double dt) {
    Kokkos::deep_copy(state_.elements, rest_);
    state_.x = to_rows("stability::x", x);
    state_.v = to_rows("stability::v", v);
    advance_elements(ExecSpace(), model_.chunks, model_.others->hexahedra, {state_.x, state_.v, dt},
                     state_.chunk_fields());
    advance_plain(ExecSpace(), model_.chunks, model_.others->one_point, {state_.x, state_.v, dt},
                  state_.chunk_fields());
    assemble_slots(ExecSpace(), model_.nodes_to_slots, state_.slot_force, state_.force);
    const auto force = to_host(state_.force);
    forces_.resize(x.size());
    for (std::size_t n = 0; n < x.size(); ++n) {
      for (std::size_t k = 0; k < 3; ++k) forces_[n][k] = -force(n, k);
    }
    return forces_;
  }

  /// Bounds of the last evaluation, by chunk.
  auto bounds() const { return to_host(state_.results.stable_step); }

 private:
  const Model& model_;
  State state_;
  Array<double> rest_;
  std::vector<Vec3> forces_;
};

/// Measures all parts at once: none touches another.
class PartMeasurement {
 public:
  PartMeasurement(const ChunkedMesh& chunked, const Model& model, const std::vector<Lattice>& lattices,
                  const std::vector<LinearShape>& shapes)
      : lattices_(lattices), shapes_(shapes), elements_(model), x_(chunked.mesh.nodes), parts_(shapes.size()) {
    base_.assign(x_.size(), {});
    for (std::size_t p = 0; p < parts_.size(); ++p) set_base(p, to_host(model.mass));
    elements_.find_forces(x_, base_, 0);
    const auto bounds = elements_.bounds();
    for (LinearPart& part : parts_) part.bound = std::numeric_limits<double>::infinity();
    for (std::size_t c = 0; c < chunked.chunks.size(); ++c) {
      double& bound = parts_[static_cast<std::size_t>(chunked.chunks[c].part)].bound;
      bound = std::min(bound, bounds(c));
    }
  }

  std::vector<LinearPart> find() {
    std::size_t dofs = 0;
    for (const LinearPart& part : parts_) dofs = std::max(dofs, part.mass.size());
    for (std::size_t d = 0; d < dofs; ++d) add_columns(d);
    return parts_;
  }

 private:
  template <class Masses>
  void set_base(std::size_t p, const Masses& mass) {
    const Lattice& lattice = lattices_[p];
    for (const std::size_t n : lattice.nodes) {
      for (std::size_t k = 0; k < 3; ++k) {
        parts_[p].mass.push_back(mass(n));
        base_[n][k] = -shapes_[p].compression * (x_[n][k] - lattice.center[k]);
      }
    }
  }

  /// Column d of both matrices of every part that has as many.
  void add_columns(std::size_t d) {
    std::vector<std::vector<double>> stiffness(parts_.size()), damping(parts_.size());
    double bound = 0;
    for (const LinearPart& part : parts_) bound = std::max(bound, part.bound);
    const double dt = endless_step * bound;
    for (const double sign : {1.0, -1.0}) {
      std::vector<Vec3> x = x_, slow(x_.size()), v = base_;
      for (std::size_t p = 0; p < parts_.size(); ++p) {
        if (d >= parts_[p].mass.size()) continue;
        const std::size_t n = lattices_[p].nodes[d / 3];
        const double move = sign * find_change(p, Input::displacement);
        x[n][d % 3] += move;
        slow[n][d % 3] = move / dt;
        v[n][d % 3] += sign * find_change(p, Input::velocity);
      }
      collect(elements_.find_forces(x, slow, dt), sign, d, Input::displacement, stiffness);
      collect(elements_.find_forces(x_, v, 0), sign, d, Input::velocity, damping);
    }
    for (std::size_t p = 0; p < parts_.size(); ++p) {
      parts_[p].stiffness.insert(parts_[p].stiffness.end(), stiffness[p].begin(), stiffness[p].end());
      parts_[p].damping.insert(parts_[p].damping.end(), damping[p].begin(), damping[p].end());
    }
  }

  /// Half the difference that is taken of the input.
  double find_change(std::size_t p, Input input) const {
    const double length = difference * lattices_[p].shortest_edge;
    return input == Input::displacement ? length : length / parts_[p].bound;
  }

  /// Adds the share of one side of the central difference to a column of each part.
  void collect(const std::vector<Vec3>& force, double sign, std::size_t d, Input input,
               std::vector<std::vector<double>>& columns) const {
    for (std::size_t p = 0; p < parts_.size(); ++p) {
      if (d >= parts_[p].mass.size()) continue;
      columns[p].resize(parts_[p].mass.size(), 0);
      const double factor = sign / (2 * find_change(p, input));
      for (std::size_t i = 0; i < columns[p].size(); ++i) {
        columns[p][i] += factor * force[lattices_[p].nodes[i / 3]][i % 3];
      }
    }
  }

  const std::vector<Lattice>& lattices_;
  const std::vector<LinearShape>& shapes_;
  RestingElements elements_;
  std::vector<Vec3> x_, base_;
  std::vector<LinearPart> parts_;
};

}  // namespace

std::vector<LinearPart> find_linear_parts(const Deck& deck, const std::vector<LinearShape>& shapes) {
  ChunkedMesh chunked = load_mesh(deck, Communicator(MPI_COMM_SELF));
  std::vector<Lattice> lattices;
  for (std::size_t p = 0; p < deck.parts.size(); ++p) lattices.push_back(find_lattice(chunked.mesh, deck.parts[p]));
  for (std::size_t p = 0; p < deck.parts.size(); ++p) set_shape(shapes[p], lattices[p], chunked.mesh);
  const Model model = build_model(deck, chunked);
  return PartMeasurement(chunked, model, lattices, shapes).find();
}

}  // namespace percuss
