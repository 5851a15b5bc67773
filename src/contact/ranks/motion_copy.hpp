#pragma once
// Positions and velocities of nodes that other ranks own, in every step.

#include <cstdint>
#include <vector>

#include "kernels/contact/surface/contact_state.hpp"
#include "kernels/core/views.hpp"
#include "src/contact/ranks/remote_items.hpp"
#include "src/contact/surface/contact_ranks.hpp"

namespace percuss {

/// Nodes whose motion is requested.
struct MotionPart {
  ItemPart items;  // the nodes, on the host
  ExchangePlan request;
  Array<int> rows, published;      // in messages: rows of the copy, mesh nodes of this rank
  Array<int> own_rows, own_nodes;  // of this rank itself
};

/// Position and velocity of a node, on its way.
struct NodeMotion {
  double x[3], v[3];
};

/// The motion of nodes by number, one row a node.
class MotionCopy {
 public:
  /// Names the nodes to their FE owners. Collective.
  void name(const ContactRanks& ranks, UnstructuredExchange& exchange, DataExchange& data,
            const std::vector<std::int64_t>& numbers);

  /// All of them, those requested: [named nodes], and those of a part that holds all that is wanted. The latter two are
  /// collective.
  MotionPart all() const;
  MotionPart select(DataExchange& data, const std::vector<char>& is_wanted) const;
  static MotionPart select_among(const MotionPart& part, DataExchange& data, const std::vector<char>& is_wanted);

  /// Starts getting the motion of a part. motion: of this rank's mesh nodes. Collective.
  void begin(DataExchange& data, const MotionPart& part, const SurfaceMotion& motion);

  /// The motion in this step; rows as named, those of no node of the part are of earlier steps. Collective.
  SurfaceMotion end(DataExchange& data, const MotionPart& part, const SurfaceMotion& motion);

  SurfaceMotion receive(DataExchange& data, const MotionPart& part, const SurfaceMotion& motion) {
    begin(data, part, motion);
    return end(data, part, motion);
  }

 private:
  RemoteItems nodes_;
  Array<NodeMotion> sent_ = Array<NodeMotion>("contact::sent_motion", 0);
  Array<NodeMotion> received_ = Array<NodeMotion>("contact::received_motion", 0);
  HostMirror<Array<NodeMotion>> send_buffer_, receive_buffer_;
  Rows3<double> x_ = Rows3<double>("contact::check_x", 0), v_ = Rows3<double>("contact::check_v", 0);
};

}  // namespace percuss
