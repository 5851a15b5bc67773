#include "comm/halo/halo_swap.hpp"

#include <cstddef>
#include <utility>

#include "comm/exchange/exchange_buffers.hpp"
#include "kernels/core/contract.hpp"
#include "kernels/core/view_copy.hpp"

namespace percuss {

HaloSwap::HaloSwap(const Communicator& ranks, const HaloPlan& plan)
    : exchange_(plan.exchange),
      first_remote_slot_(plan.first_remote_slot),
      send_slots_(copy_to_view("percuss::halo_send_slots", plan.send_slots)),
      send_values_(make_rows("percuss::halo_send", plan.send_slots.size())),
      send_buffer_(Kokkos::create_mirror_view(send_values_)),
      data_(ranks) {}

void HaloSwap::begin(const ExecSpace& space, const Rows3<double>& slot_values) {
  const auto first = static_cast<std::size_t>(first_remote_slot_);
  PERCUSS_EXPECT(slot_values.extent(0) == first + static_cast<std::size_t>(exchange_.receive_count()));
  const std::pair<std::size_t, std::size_t> remote{first, first + static_cast<std::size_t>(exchange_.receive_count())};
  remote_values_ = Kokkos::subview(slot_values, remote, Kokkos::ALL);
  receive_buffer_ = Kokkos::create_mirror_view(remote_values_);
  pack_rows(space, send_slots_, slot_values, send_values_);
  copy_values(send_buffer_, send_values_);
  data_.begin<RowItem>(exchange_, as_items(send_buffer_), as_items(receive_buffer_));
}

void HaloSwap::end() {
  data_.end();
  copy_values(remote_values_, receive_buffer_);
}

}  // namespace percuss
