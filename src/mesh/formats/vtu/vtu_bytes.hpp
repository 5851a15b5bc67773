#pragma once
// Bytes of an array of a VTK file: base64 or as they are, compressed with zlib or not (VTK's "XML file formats").

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace percuss {

/// How a file stores its binary arrays.
struct VtuStorage {
  std::size_t header_bytes = 4;  // of a number in front of an array: 4 or 8
  bool is_compressed = false;
};

/// Takes so many bytes off the beginning of what an array has; `encoded` begins with its header. Throws VtuFault with
/// the reason if they are not there, or more are.
std::string take_bytes(std::string_view encoded, bool is_base64, const VtuStorage& storage, std::size_t bytes);

/// Fault of the bytes, in words that follow "the array ".
struct VtuFault {
  std::string reason;
};

}  // namespace percuss
