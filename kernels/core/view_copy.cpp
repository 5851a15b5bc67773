#include "kernels/core/view_copy.hpp"

#include <cstring>

namespace percuss {

#ifndef PERCUSS_ON_DEVICE
void copy_bytes(void* to, const void* from, std::size_t count) {
  constexpr std::size_t block = std::size_t{1} << 16, worth_threads = 16 * block;
  if (count == 0 || to == from) return;
  if (count < worth_threads) {
    std::memcpy(to, from, count);
    return;
  }
  parallel_for("percuss::copy_bytes", RangeOf(ExecSpace(), 0, static_cast<int>((count + block - 1) / block)),
               [=](int b) {
                 const std::size_t begin = block * static_cast<std::size_t>(b);
                 std::memcpy(static_cast<char*>(to) + begin, static_cast<const char*>(from) + begin,
                             std::min(block, count - begin));
               });
}
#endif

}  // namespace percuss
