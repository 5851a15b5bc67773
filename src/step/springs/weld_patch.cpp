#include "src/step/springs/weld_patch.hpp"

#include <cmath>

#include "src/index.hpp"

namespace percuss {
namespace {

/// Least determinant over the mean of the second moments cubed: below it the nodes lie on a line.
constexpr double least_determinant = 1e-6;

Vector3<double> unit_along(int k) { return {k == 0 ? 1.0 : 0.0, k == 1 ? 1.0 : 0.0, k == 2 ? 1.0 : 0.0}; }

/// g.r - (g r + r g) / 2: what a share adds to T.
Symmetric3<double> find_second_moment(const Vector3<double>& g, const Vector3<double>& r) {
  return {g.y * r.y + g.z * r.z,          g.z * r.z + g.x * r.x,          g.x * r.x + g.y * r.y,
          -0.5 * (g.x * r.y + g.y * r.x), -0.5 * (g.y * r.z + g.z * r.y), -0.5 * (g.z * r.x + g.x * r.z)};
}

Vector3<double> change_of(const WeldNode& node, const Vector3<double>& impulse) {
  return {node.inverse_mass.x * impulse.x, node.inverse_mass.y * impulse.y, node.inverse_mass.z * impulse.z};
}

/// Twice the kinetic energy in directions that are not held.
double find_twice_energy(const WeldNode& node) {
  const Vector3<double>&v = node.velocity, &inverse = node.inverse_mass;
  const auto add = [](double speed, double of) { return of > 0 ? speed * speed / of : 0; };
  return add(v.x, inverse.x) + add(v.y, inverse.y) + add(v.z, inverse.z);
}

}  // namespace

MovingPatch::MovingPatch(const WeldPatch& patch, const std::vector<WeldNode>& nodes,
                         const std::vector<double>& masses) {
  double sum = 0;
  for (std::size_t i = 0; i < patch.nodes.size(); ++i) {
    const std::size_t n = at(patch.nodes[i]);
    const double weight = patch.is_region() ? patch.weights[i] : masses[n];
    sum += weight;
    shares_.push_back({n, weight, {}});
  }
  if (!(sum > 0)) return;
  for (Share& share : shares_) {
    share.weight /= sum;
    center_ = center_ + share.weight * nodes[share.node].place;
  }
  set_moments(patch, nodes);
  set_tensor(nodes);
  if (turns_) response_ = find_response(nodes);
}

void MovingPatch::set_moments(const WeldPatch& patch, const std::vector<WeldNode>& nodes) {
  const auto lever = [&](const Share& share) { return nodes[share.node].place - center_; };
  for (Share& share : shares_)
    share.moment = patch.is_region() ? Vector3<double>{0, 0, 0} : share.weight * lever(share);
  for (const ShapeProduct& product : patch.products) {
    Share& share = shares_[at(product.node)];
    share.moment = share.moment + product.mean * lever(shares_[at(product.other)]);
  }
}

void MovingPatch::set_tensor(const std::vector<WeldNode>& nodes) {
  Symmetric3<double> tensor{0, 0, 0, 0, 0, 0};
  for (const Share& share : shares_)
    tensor = tensor + find_second_moment(share.moment, nodes[share.node].place - center_);
  const Adjugate<double> adjugate = find_adjugate(tensor);
  const double size = trace(tensor) / 3;
  turns_ = adjugate.determinant > least_determinant * size * size * size;
  if (turns_) inverse_tensor_ = (1 / adjugate.determinant) * adjugate.matrix;
}

Vector3<double> MovingPatch::find_share(const Share& of, const Vector3<double>& impulse,
                                        const Vector3<double>& turning) const {
  return of.weight * impulse + cross(turning, of.moment);
}

PatchResponse MovingPatch::find_response(const std::vector<WeldNode>& nodes) const {
  PatchResponse response;
  const Vector3<double> zero{0, 0, 0};
  for (int column = 0; column < 6; ++column) {
    const Vector3<double> impulse = column < 3 ? unit_along(column) : zero,
                          turning = column < 3 ? zero : inverse_tensor_ * unit_along(column - 3);
    Vector3<double> velocity{0, 0, 0}, spin{0, 0, 0};
    for (const Share& share : shares_) {
      const Vector3<double> change = change_of(nodes[share.node], find_share(share, impulse, turning));
      velocity = velocity + share.weight * change;
      spin = spin + cross(share.moment, change);
    }
    response.column[at(column)] = {velocity, inverse_tensor_ * spin};
  }
  return response;
}

WeldNode MovingPatch::find_end(const std::vector<WeldNode>& nodes, const Vector3<double>& place) const {
  WeldNode end;
  end.place = place;
  end.arm = place - center_;
  end.turns = end.is_patch = true;
  end.response = response_;
  Vector3<double> turning{0, 0, 0};
  for (const Share& share : shares_) {
    const WeldNode& node = nodes[share.node];
    end.velocity = end.velocity + share.weight * node.velocity;
    turning = turning + cross(share.moment, node.velocity);
    end.twice_energy += find_twice_energy(node);
  }
  end.spin = inverse_tensor_ * turning;
  const auto& column = response_.column;
  end.inverse_mass = {column[0].velocity.x, column[1].velocity.y, column[2].velocity.z};
  return end;
}

void MovingPatch::give(const Vector3<double>& impulse, const Vector3<double>& moment, std::vector<WeldNode>& nodes,
                       std::vector<NodeImpulse>& on_nodes) const {
  const Vector3<double> turning = inverse_tensor_ * moment;
  for (const Share& share : shares_) {
    const Vector3<double> own = find_share(share, impulse, turning);
    nodes[share.node].velocity = nodes[share.node].velocity + change_of(nodes[share.node], own);
    on_nodes[share.node].impulse = on_nodes[share.node].impulse + own;
  }
}

}  // namespace percuss
