#pragma once
// Steps (4.3) and (4.4) of the paper: points that lie on the far side of a cut go there.
//
// "Each processor sends its points that fall on the far side of the cut to a partner processor in the other group."
// The lower and the upper rank of the same place in their groups are partners; where the upper side has one rank more,
// that one sends to the last lower rank and receives from none.

#include <cstdint>
#include <vector>

#include "comm/communicator.hpp"
#include "comm/rcb/cut_tree.hpp"
#include "comm/rcb/rcb_points.hpp"
#include "kernels/core/views.hpp"

namespace percuss {

/// A point between ranks.
struct PointRecord {
  double position[3];
  std::int64_t id;
  std::int64_t weight;
};

/// The points that a rank holds while the bisection continues: the caller's own arrays until the first point moves,
/// then copies. Its memory is kept from one bisection to the next.
class TravellingPoints {
 public:
  /// Begins a bisection with the caller's points, which must not change during it.
  void begin(const RcbPoints& points) { points_ = points; }

  const RcbPoints& points() const { return points_; }

  /// (4.3) Send points that lie on far side of cut: takes them out and starts their message. Nobody cuts again on a
  /// side of one rank, so points are not sent there, and its own rank is left without any. group: the ranks that the
  /// cut divides, lower_ranks of them on its lower side. Returns the number sent. Throws MpiError.
  std::int64_t send_far_points(const ExecSpace& space, const Communicator& group, const Cut& cut, int lower_ranks);

  /// (4.4) Receive points that lie on my side of cut: those of the partners. All points held then lie on this rank's
  /// side. Follows send_far_points() on every rank of the group. Throws MpiError.
  void receive_near_points(const ExecSpace& space, const Communicator& group, int lower_ranks);

  // Kernels of its own: nvcc takes none in a private function.
  using Records = Kokkos::View<PointRecord*, Kokkos::LayoutRight, MemSpace>;
  void take_own_copy(const ExecSpace& space);
  void list_leaving(const ExecSpace& space, const Cut& cut, bool is_lower);
  Records pack_leaving(const ExecSpace& space) const;
  void replace_leaving(const ExecSpace& space, const std::vector<PointRecord>& arrived);

 private:
  void make_room(std::size_t count);

  RcbPoints points_;
  HostMirror<Records> sent_;  // under way
  MPI_Request request_ = MPI_REQUEST_NULL;
  Array<int> leaving_;  // [room] ascending, leaving_count_ of them
  int leaving_count_ = 0;
  Rows3<double> own_positions_;  // [room]: what points_ shows the beginning of, once points have moved
  Array<std::int64_t> own_ids_;
  Array<int> own_weights_;
};

}  // namespace percuss
