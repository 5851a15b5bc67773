#pragma once
// A swap of slots with more numbers than a force: groups of four.
//
// As HaloSwap (comm/halo/halo_swap.hpp), over the same plan.

#include <array>
#include <cstddef>
#include <span>

#include "comm/exchange/data_exchange.hpp"
#include "comm/exchange/exchange_buffers.hpp"
#include "comm/halo/halo_plan.hpp"
#include "kernels/core/small_space.hpp"
#include "kernels/core/view_copy.hpp"
#include "kernels/core/views.hpp"

namespace percuss {

template <int Groups>
class GroupSwap {
 public:
  using Rows = Kokkos::View<double * [4 * Groups], Kokkos::LayoutRight, MemSpace>;

  /// Collective over `ranks`, which are those of the plan. Throws MpiError.
  GroupSwap(const Communicator& ranks, const HaloPlan& plan)
      : exchange_(plan.exchange),
        first_remote_slot_(plan.first_remote_slot),
        send_slots_(copy_to_view("percuss::group_send_slots", plan.send_slots)),
        remote_count_(static_cast<int>(plan.exchange.receive_count())),
        send_("percuss::group_send", plan.send_slots.size()),
        receive_("percuss::group_receive", static_cast<std::size_t>(remote_count_)),
        send_buffer_(Kokkos::create_mirror_view(send_)),
        receive_buffer_(Kokkos::create_mirror_view(receive_)),
        data_(ranks) {}

  /// Packs the slots that others need and starts the messages. rows: [plan.slot_count()], the local part filled. Throws
  /// MpiError.
  void begin(const ExecSpace& space, const Rows& rows) {
    const Array<int> slots = send_slots_;
    const Packed packed = send_;
    parallel_for(
        "percuss::pack_groups", RangeOf(space, 0, static_cast<int>(slots.extent(0))), KOKKOS_LAMBDA(const int i) {
          for (int k = 0; k < 4 * Groups; ++k) packed(i, k) = rows(slots(i), k);
        });
    space.fence();
    copy_values(send_buffer_, send_);
    data_.begin<Item>(exchange_, as_items(send_buffer_), as_items(receive_buffer_));
    rows_ = rows;
  }

  /// Returns when the remote part of the rows is filled. Throws MpiError.
  void end() {
    data_.end();
    copy_values(receive_, receive_buffer_);
    const Rows rows = rows_;
    const Packed packed = receive_;
    const int first = first_remote_slot_;
    parallel_for(
        "percuss::unpack_groups", RangeOf(ExecSpace(), 0, remote_count_), KOKKOS_LAMBDA(const int i) {
          for (int k = 0; k < 4 * Groups; ++k) rows(first + i, k) = packed(i, k);
        });
  }

  const Traffic& traffic() const { return data_.traffic(); }

 private:
  using Item = std::array<double, 4 * Groups>;
  using Packed = Kokkos::View<double * [4 * Groups], Kokkos::LayoutRight, MemSpace>;

  static std::span<Item> as_items(const HostMirror<Packed>& rows) {
    return {reinterpret_cast<Item*>(rows.data()), rows.extent(0)};
  }

  ExchangePlan exchange_;
  int first_remote_slot_;
  Array<int> send_slots_;
  int remote_count_;
  Packed send_, receive_;
  HostMirror<Packed> send_buffer_, receive_buffer_;  // copies of both on the host
  Rows rows_;                                        // of the swap under way
  DataExchange data_;
};

}  // namespace percuss
