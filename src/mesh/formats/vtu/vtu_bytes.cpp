#include "src/mesh/formats/vtu/vtu_bytes.hpp"

#include <fmt/format.h>
#include <zlib.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cstring>
#include <vector>

namespace percuss {
namespace {

static_assert(std::endian::native == std::endian::little, "arrays are read as they lie in memory");

/// Value of a character of base64; below 0: it is none.
int find_digit(char c) {
  if (c >= 'A' && c <= 'Z') return c - 'A';
  if (c >= 'a' && c <= 'z') return c - 'a' + 26;
  if (c >= '0' && c <= '9') return c - '0' + 52;
  return c == '+' ? 62 : c == '/' ? 63 : -1;
}

bool is_base64_space(char c) { return c == ' ' || c == '\t' || c == '\r' || c == '\n'; }

/// Bytes one after the other, from base64 or as they are.
class ByteStream {
 public:
  ByteStream(std::string_view encoded, bool is_base64) : encoded_(encoded), is_base64_(is_base64) {}

  /// Bound of the bytes that are left.
  std::size_t most_left() const { return rest_.size() + (is_base64_ ? encoded_.size() / 4 * 3 + 3 : encoded_.size()); }

  std::string take(std::size_t count) {
    if (count > most_left()) throw VtuFault{fmt::format("needs {} bytes more than the file has", count - most_left())};
    if (!is_base64_) {
      std::string bytes(encoded_.substr(0, count));
      encoded_.remove_prefix(count);
      return bytes;
    }
    while (rest_.size() < count) decode_group();
    std::string bytes = rest_.substr(0, count);
    rest_.erase(0, count);
    return bytes;
  }

 private:
  /// Four characters are three bytes, or fewer at the end of what was encoded at once; more may follow that.
  void decode_group() {
    std::array<int, 4> digits{};
    std::size_t count = 0, padding = 0;
    while (count + padding < digits.size()) {
      if (encoded_.empty()) throw VtuFault{"ends too early"};
      const char c = encoded_.front();
      encoded_.remove_prefix(1);
      if (is_base64_space(c)) continue;
      if (c == '=' && count >= 2) {
        ++padding;
        continue;
      }
      if (find_digit(c) < 0 || padding > 0) throw VtuFault{"is no base64"};
      digits[count++] = find_digit(c);
    }
    const int bits = digits[0] << 18 | digits[1] << 12 | digits[2] << 6 | digits[3];
    for (std::size_t i = 0; i + 1 < count; ++i)
      rest_ += static_cast<char>(bits >> (16 - 8 * static_cast<int>(i)) & 0xff);
  }

  std::string_view encoded_;
  bool is_base64_;
  std::string rest_;  // decoded, not yet taken
};

std::uint64_t take_header_number(ByteStream& from, std::size_t bytes) {
  const std::string text = from.take(bytes);
  std::uint64_t value = 0;
  std::memcpy(&value, text.data(), bytes);
  return value;
}

std::string inflate(const std::string& packed, std::size_t bytes) {
  std::string plain(bytes, '\0');
  uLongf length = bytes;
  const int fault = uncompress(reinterpret_cast<Bytef*>(plain.data()), &length,
                               reinterpret_cast<const Bytef*>(packed.data()), packed.size());
  if (fault != Z_OK || length != bytes) throw VtuFault{"has a damaged block"};
  return plain;
}

/// Numbers of blocks, of bytes of a block and of the last one (0: as all), then those of each block once compressed.
std::string take_compressed(ByteStream& from, std::size_t header_bytes, std::size_t bytes) {
  constexpr std::size_t most_ratio = 1100;  // of zlib
  const std::uint64_t blocks = take_header_number(from, header_bytes);
  if (bytes / most_ratio > from.most_left()) throw VtuFault{"cannot be filled by the file"};
  if (blocks > from.most_left() / header_bytes) throw VtuFault{"has more blocks than the file can hold"};
  const std::uint64_t of_block = take_header_number(from, header_bytes),
                      of_last = take_header_number(from, header_bytes);
  std::vector<std::uint64_t> packed(blocks);
  for (std::uint64_t& size : packed) size = take_header_number(from, header_bytes);
  std::string plain;
  for (std::size_t b = 0; b < packed.size(); ++b) {
    const std::uint64_t expected = b + 1 == packed.size() && of_last != 0 ? of_last : of_block;
    if (expected > bytes - plain.size()) throw VtuFault{fmt::format("has more than {} bytes", bytes)};
    plain += inflate(from.take(packed[b]), expected);
  }
  if (plain.size() != bytes) throw VtuFault{fmt::format("has {} bytes ({} are expected)", plain.size(), bytes)};
  return plain;
}

}  // namespace

std::string take_bytes(std::string_view encoded, bool is_base64, const VtuStorage& storage, std::size_t bytes) {
  ByteStream from(encoded, is_base64);
  if (storage.is_compressed) return take_compressed(from, storage.header_bytes, bytes);
  const std::uint64_t given = take_header_number(from, storage.header_bytes);
  if (given != bytes) throw VtuFault{fmt::format("has {} bytes ({} are expected)", given, bytes)};
  return from.take(bytes);
}

}  // namespace percuss
