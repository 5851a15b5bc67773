#include "comm/rcb/far_side.hpp"

#include <algorithm>
#include <cstddef>
#include <utility>

#include "comm/exchange/exchange_buffers.hpp"
#include "kernels/core/host_copy.hpp"
#include "kernels/core/small_space.hpp"

namespace percuss {

namespace {

constexpr int far_side_tag = 1;

/// A point as MPI counts it, so that its counts are points and not bytes.
struct RecordType {
  RecordType() {
    check_mpi(MPI_Type_contiguous(static_cast<int>(sizeof(PointRecord)), MPI_BYTE, &handle), "MPI_Type_contiguous");
    check_mpi(MPI_Type_commit(&handle), "MPI_Type_commit");
  }
  ~RecordType() { MPI_Type_free(&handle); }
  RecordType(const RecordType&) = delete;
  RecordType& operator=(const RecordType&) = delete;
  MPI_Datatype handle = MPI_DATATYPE_NULL;
};

/// Places in the group that a rank exchanges points with.
struct Partners {
  int to = -1;            // -1: no rank
  std::vector<int> from;  // ascending
  bool is_alone = false;  // on its side of the cut
};

Partners find_partners(int rank, int rank_count, int lower_ranks) {
  const int upper_ranks = rank_count - lower_ranks;
  const bool is_lower = rank < lower_ranks;
  Partners partners;
  if ((is_lower ? upper_ranks : lower_ranks) > 1) {
    partners.to = is_lower ? lower_ranks + rank : std::min(rank - lower_ranks, lower_ranks - 1);
  }
  partners.is_alone = (is_lower ? lower_ranks : upper_ranks) == 1;
  if (partners.is_alone) return partners;
  if (!is_lower && rank - lower_ranks < lower_ranks) partners.from.push_back(rank - lower_ranks);
  if (is_lower) partners.from.push_back(lower_ranks + rank);
  if (is_lower && rank == lower_ranks - 1 && upper_ranks > lower_ranks) partners.from.push_back(rank_count - 1);
  return partners;
}

/// Receives what partners send, in the order of their ranks; how much is learnt from the messages.
std::vector<PointRecord> receive_points(const Communicator& group, const std::vector<int>& from, MPI_Datatype record) {
  std::vector<PointRecord> arrived;
  for (const int rank : from) {
    MPI_Message message = MPI_MESSAGE_NULL;
    MPI_Status status;
    int count = 0;
    wait_mpi([&] { return MPI_Mprobe(rank, far_side_tag, group.handle(), &message, &status); }, "MPI_Mprobe");
    check_mpi(MPI_Get_count(&status, record, &count), "MPI_Get_count");
    const std::size_t first = arrived.size();
    arrived.resize(first + static_cast<std::size_t>(count));
    wait_mpi([&] { return MPI_Mrecv(arrived.data() + first, count, record, &message, MPI_STATUS_IGNORE); },
             "MPI_Mrecv");
  }
  return arrived;
}

/// Where points go when `leaving` (ascending) of n points are replaced by `arrived_count` others without a gap.
struct Refill {
  std::vector<int> arrival_places;  // [arrived]
  std::vector<int> moved_from;      // points of the end that fill the gaps left...
  std::vector<int> moved_to;        // ... and those gaps
};

template <class HostView>
Refill plan_refill(int n, const HostView& leaving, int leaving_count, int arrived_count) {
  Refill refill;
  const int filled = std::min(leaving_count, arrived_count);
  for (int i = 0; i < filled; ++i) refill.arrival_places.push_back(leaving(i));
  for (int i = filled; i < arrived_count; ++i) refill.arrival_places.push_back(n + i - filled);
  const int end = n - leaving_count + filled;  // of what stays, once the gaps are filled
  int gap = filled, next = filled;
  while (next < leaving_count && leaving(next) < end) ++next;
  for (int i = end; i < n; ++i) {
    if (next < leaving_count && leaving(next) == i) {
      ++next;
      continue;
    }
    refill.moved_from.push_back(i);
    refill.moved_to.push_back(leaving(gap++));
  }
  return refill;
}

}  // namespace

void TravellingPoints::make_room(std::size_t count) {
  if (own_positions_.extent(0) >= count) return;
  const std::size_t room = count + count / 4;
  Kokkos::resize(own_positions_, room);
  Kokkos::resize(own_ids_, room);
  Kokkos::resize(own_weights_, room);
}

void TravellingPoints::take_own_copy(const ExecSpace& space) {
  if (points_.positions.data() == own_positions_.data() && points_.count() > 0) return;
  make_room(static_cast<std::size_t>(points_.count()));
  const AxisPoints source{points_, 0};
  const auto positions = own_positions_;
  const auto ids = own_ids_;
  const auto weights = own_weights_;
  parallel_for(
      "percuss::rcb_copy", RangeOf(space, 0, points_.count()), KOKKOS_LAMBDA(const int i) {
        for (int k = 0; k < 3; ++k) positions(i, k) = source.points.positions(i, k);
        ids(i) = source.points.ids(i);
        weights(i) = source.weight(i);
      });
}

void TravellingPoints::list_leaving(const ExecSpace& space, const Cut& cut, bool is_lower) {
  const int n = points_.count();
  if (leaving_.extent(0) < static_cast<std::size_t>(n)) {
    leaving_ = Array<int>(Kokkos::view_alloc("percuss::rcb_leaving", Kokkos::WithoutInitializing),
                          static_cast<std::size_t>(n + n / 4));
  }
  const AxisPoints source{points_, cut.axis};
  const auto leaving = leaving_;
  const CoordinateKey cut_key = cut.key;
  leaving_count_ = 0;
  parallel_scan(
      "percuss::rcb_leaving", RangeOf(space, 0, n),
      KOKKOS_LAMBDA(const int i, int& place, const bool is_final) {
        if ((source.key(i) < cut_key) == is_lower) return;
        if (is_final) leaving(place) = i;
        ++place;
      },
      leaving_count_);
}

TravellingPoints::Records TravellingPoints::pack_leaving(const ExecSpace& space) const {
  Records records(Kokkos::view_alloc("percuss::rcb_sent", Kokkos::WithoutInitializing),
                  static_cast<std::size_t>(leaving_count_));
  const AxisPoints source{points_, 0};
  const auto leaving = leaving_;
  parallel_for(
      "percuss::rcb_pack", RangeOf(space, 0, leaving_count_), KOKKOS_LAMBDA(const int i) {
        const int p = leaving(i);
        for (int k = 0; k < 3; ++k) records(i).position[k] = source.points.positions(p, k);
        records(i).id = source.points.ids(p);
        records(i).weight = source.weight(p);
      });
  space.fence();
  return records;
}

void TravellingPoints::replace_leaving(const ExecSpace& space, const std::vector<PointRecord>& arrived) {
  const int n = points_.count();
  const int count = n - leaving_count_ + static_cast<int>(arrived.size());
  const auto leaving = to_host(leaving_);
  const Refill refill = plan_refill(n, leaving, leaving_count_, static_cast<int>(arrived.size()));
  take_own_copy(space);
  make_room(static_cast<std::size_t>(std::max(n, count)));
  const auto from = copy_to_view("percuss::rcb_moved_from", refill.moved_from);
  const auto to = copy_to_view("percuss::rcb_moved_to", refill.moved_to);
  const auto places = copy_to_view("percuss::rcb_places", refill.arrival_places);
  const auto records = copy_to_view("percuss::rcb_arrived", arrived);
  const auto positions = own_positions_;
  const auto ids = own_ids_;
  const auto weights = own_weights_;
  parallel_for(
      "percuss::rcb_close_gaps", RangeOf(space, 0, static_cast<int>(from.extent(0))), KOKKOS_LAMBDA(const int i) {
        for (int k = 0; k < 3; ++k) positions(to(i), k) = positions(from(i), k);
        ids(to(i)) = ids(from(i));
        weights(to(i)) = weights(from(i));
      });
  parallel_for(
      "percuss::rcb_unpack", RangeOf(space, 0, static_cast<int>(places.extent(0))), KOKKOS_LAMBDA(const int i) {
        const int p = places(i);
        for (int k = 0; k < 3; ++k) positions(p, k) = records(i).position[k];
        ids(p) = records(i).id;
        weights(p) = static_cast<int>(records(i).weight);
      });
  const auto held = std::make_pair(0, count);
  points_.positions = Kokkos::subview(own_positions_, held, Kokkos::ALL);
  points_.ids = Kokkos::subview(own_ids_, held);
  points_.weights = Kokkos::subview(own_weights_, held);
}

std::int64_t TravellingPoints::send_far_points(const ExecSpace& space, const Communicator& group, const Cut& cut,
                                               int lower_ranks) {
  const Partners partners = find_partners(group.rank(), group.size(), lower_ranks);
  if (partners.to < 0 && partners.is_alone) return 0;
  list_leaving(space, cut, group.rank() < lower_ranks);
  if (partners.to < 0) return 0;
  const RecordType record;
  sent_ = to_host(pack_leaving(space));
  check_mpi(
      MPI_Isend(sent_.data(), leaving_count_, record.handle, partners.to, far_side_tag, group.handle(), &request_),
      "MPI_Isend");
  return leaving_count_;
}

void TravellingPoints::receive_near_points(const ExecSpace& space, const Communicator& group, int lower_ranks) {
  const Partners partners = find_partners(group.rank(), group.size(), lower_ranks);
  if (partners.is_alone) {
    points_ = RcbPoints{};
  } else {
    const RecordType record;
    replace_leaving(space, receive_points(group, partners.from, record.handle));
  }
  wait_mpi([&] { return MPI_Wait(&request_, MPI_STATUS_IGNORE); }, "MPI_Wait");
  sent_ = {};
}

}  // namespace percuss
