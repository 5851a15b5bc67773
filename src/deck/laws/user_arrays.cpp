// Arrays that code of a user makes in one call and finds in another, by numbers: the allocatable arrays of Abaqus.

#include <climits>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>
#include <map>
#include <mutex>
#include <utility>
#include <vector>

#include "src/deck/laws/user_routines.hpp"

namespace percuss {
namespace {

/// Memory for anything. Not std::max_align_t itself: nvcc 13.0 breaks off on a vector of it, whose class has no name.
struct AlignedBlock {
  alignas(std::max_align_t) std::byte bytes[sizeof(std::max_align_t)];
};

/// Arrays of a kind, by number. A thread finds its own alone.
struct UserArrays {
  struct Kept {
    std::vector<AlignedBlock> blocks;
    std::int64_t size = 0;  // items
  };
  std::mutex busy;
  std::map<int, Kept> kept;

  /// Keeps what an array of this number had. item: initial value of each; null: zeros.
  std::int64_t make(int id, int size, std::size_t item_size, const void* item) {
    const std::scoped_lock lock(busy);
    Kept& one = kept[id];
    const std::size_t bytes = static_cast<std::size_t>(size > 0 ? size : 0) * item_size;
    one.blocks.resize(bytes / sizeof(AlignedBlock) + 1);
    char* const first = reinterpret_cast<char*>(one.blocks.data());
    for (std::int64_t i = one.size; item != nullptr && i < size; ++i)
      std::memcpy(first + static_cast<std::size_t>(i) * item_size, item, item_size);
    one.size = size;
    return reinterpret_cast<std::int64_t>(first);
  }
  std::int64_t find(int id) {
    const std::scoped_lock lock(busy);
    const auto found = kept.find(id);
    return found == kept.end() ? 0 : reinterpret_cast<std::int64_t>(found->second.blocks.data());
  }
  int count(int id) {
    const std::scoped_lock lock(busy);
    const auto found = kept.find(id);
    return found == kept.end() ? 0 : static_cast<int>(found->second.size);
  }
  void drop(int id) {
    const std::scoped_lock lock(busy);
    kept.erase(id);
  }
};

enum class ArrayKind { integers, reals, structures };
UserArrays& arrays(ArrayKind kind) {
  static UserArrays all[3];
  return all[static_cast<std::size_t>(kind)];
}
UserArrays& own_arrays(ArrayKind kind) {
  thread_local UserArrays all[3];
  return all[static_cast<std::size_t>(kind)];
}

constexpr int no_integer = INT_MAX;  // what Abaqus sets where no value is given
constexpr double no_real = std::numeric_limits<double>::quiet_NaN();

std::int64_t make_integers(UserArrays& of, const int* id, const int* size, const int* value) {
  return of.make(*id, *size, sizeof(int), value == nullptr ? &no_integer : value);
}
std::int64_t make_reals(UserArrays& of, const int* id, const int* size, const double* value) {
  return of.make(*id, *size, sizeof(double), value == nullptr ? &no_real : value);
}

}  // namespace
}  // namespace percuss

using percuss::ArrayKind;
using percuss::arrays;
using percuss::own_arrays;
using std::int64_t;

PERCUSS_USER_ROUTINE int64_t smaintarraycreate_(const int* id, const int* size, const int* value) {
  return percuss::make_integers(arrays(ArrayKind::integers), id, size, value);
}
PERCUSS_USER_ROUTINE int64_t smaintarrayaccess_(const int* id) { return arrays(ArrayKind::integers).find(*id); }
PERCUSS_USER_ROUTINE int smaintarraysize_(const int* id) { return arrays(ArrayKind::integers).count(*id); }
PERCUSS_USER_ROUTINE void smaintarraydelete_(const int* id) { arrays(ArrayKind::integers).drop(*id); }

PERCUSS_USER_ROUTINE int64_t smarealarraycreatedp_(const int* id, const int* size, const double* value) {
  return percuss::make_reals(arrays(ArrayKind::reals), id, size, value);
}
PERCUSS_USER_ROUTINE int64_t smarealarrayaccess_(const int* id) { return arrays(ArrayKind::reals).find(*id); }
PERCUSS_USER_ROUTINE int64_t smafloatarraycreatedp_(const int* id, const int* size, const double* value) {
  return smarealarraycreatedp_(id, size, value);
}
PERCUSS_USER_ROUTINE int64_t smafloatarrayaccess_(const int* id) { return smarealarrayaccess_(id); }
PERCUSS_USER_ROUTINE int smafloatarraysize_(const int* id) { return arrays(ArrayKind::reals).count(*id); }
PERCUSS_USER_ROUTINE void smafloatarraydelete_(const int* id) { arrays(ArrayKind::reals).drop(*id); }

PERCUSS_USER_ROUTINE int64_t smastructarraycreatenoinit_(const int* id, const int* size, const int64_t* item_size) {
  return arrays(ArrayKind::structures).make(*id, *size, static_cast<std::size_t>(*item_size), nullptr);
}
/// item: a CLASS(*), whose first word is the place of the structure.
PERCUSS_USER_ROUTINE int64_t smastructarraycreateinit_(const int* id, const int* size, const int64_t* item_size,
                                                       const void* const* item) {
  return arrays(ArrayKind::structures).make(*id, *size, static_cast<std::size_t>(*item_size), *item);
}
PERCUSS_USER_ROUTINE int64_t smastructarrayaccess_(const int* id) { return arrays(ArrayKind::structures).find(*id); }
PERCUSS_USER_ROUTINE int smastructarraysize_(const int* id) { return arrays(ArrayKind::structures).count(*id); }
PERCUSS_USER_ROUTINE void smastructarraydelete_(const int* id) { arrays(ArrayKind::structures).drop(*id); }

PERCUSS_USER_ROUTINE int64_t smalocalintarraycreate_(const int* id, const int* size, const int* value) {
  return percuss::make_integers(own_arrays(ArrayKind::integers), id, size, value);
}
PERCUSS_USER_ROUTINE int64_t smalocalintarraycreateinit_(const int* id, const int* size, const int* value) {
  return smalocalintarraycreate_(id, size, value);
}
PERCUSS_USER_ROUTINE int64_t smalocalintarraycreatenoinit_(const int* id, const int* size) {
  return smalocalintarraycreate_(id, size, nullptr);
}
PERCUSS_USER_ROUTINE int64_t smalocalintarrayaccess_(const int* id) {
  return own_arrays(ArrayKind::integers).find(*id);
}
PERCUSS_USER_ROUTINE int smalocalintarraysize_(const int* id) { return own_arrays(ArrayKind::integers).count(*id); }
PERCUSS_USER_ROUTINE void smalocalintarraydelete_(const int* id) { own_arrays(ArrayKind::integers).drop(*id); }

PERCUSS_USER_ROUTINE int64_t smalocalfloatarraycreatedp_(const int* id, const int* size, const double* value) {
  return percuss::make_reals(own_arrays(ArrayKind::reals), id, size, value);
}
PERCUSS_USER_ROUTINE int64_t smalocalfloatarrayaccess_(const int* id) { return own_arrays(ArrayKind::reals).find(*id); }
PERCUSS_USER_ROUTINE int smalocalfloatarraysize_(const int* id) { return own_arrays(ArrayKind::reals).count(*id); }
PERCUSS_USER_ROUTINE void smalocalfloatarraydelete_(const int* id) { own_arrays(ArrayKind::reals).drop(*id); }
