#pragma once
// The end of a weld that several nodes share: their mean rigid motion, and what an impulse and a moment on it give
// them.
//
// A patch has weights w_i, and vectors g_i of their moments about its centre c = sum w_i x_i. Its velocity is
// V = sum w_i v_i, its spin W = T^-1 sum g_i x v_i. An impulse P and a moment M about c give node i the impulse
// w_i P + (T^-1 M) x g_i. These have the sum P and the moment M to round-off.

#include <vector>

#include "src/step/model/spring_model.hpp"
#include "src/step/springs/weld_solve.hpp"

namespace percuss {

/// Sums over the welds of a node.
struct NodeImpulse {
  Vector3<double> impulse{}, moment{};
};

class MovingPatch {
 public:
  /// nodes: [WeldModel::nodes] at n; masses: likewise, which are weights where the patch has none. What has no mass
  /// takes no part there.
  MovingPatch(const WeldPatch& patch, const std::vector<WeldNode>& nodes, const std::vector<double>& masses);

  /// Whether it has inertia about every axis.
  bool turns() const { return turns_; }

  /// As one end of a weld. place: of the end.
  WeldNode find_end(const std::vector<WeldNode>& nodes, const Vector3<double>& place) const;
  WeldNode find_end(const std::vector<WeldNode>& nodes) const { return find_end(nodes, center_); }

  /// Impulse and moment about the centre. on_nodes: [WeldModel::nodes], which get their shares.
  void give(const Vector3<double>& impulse, const Vector3<double>& moment, std::vector<WeldNode>& nodes,
            std::vector<NodeImpulse>& on_nodes) const;

 private:
  struct Share {
    std::size_t node = 0;
    double weight = 0;
    Vector3<double> moment{};  // g
  };
  void set_moments(const WeldPatch& patch, const std::vector<WeldNode>& nodes);
  void set_tensor(const std::vector<WeldNode>& nodes);
  Vector3<double> find_share(const Share& of, const Vector3<double>& impulse, const Vector3<double>& turning) const;
  PatchResponse find_response(const std::vector<WeldNode>& nodes) const;

  std::vector<Share> shares_;
  Vector3<double> center_{};
  Symmetric3<double> inverse_tensor_{};
  PatchResponse response_;
  bool turns_ = false;
};

}  // namespace percuss
