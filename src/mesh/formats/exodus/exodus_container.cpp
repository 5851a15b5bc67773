#include "src/mesh/formats/exodus/exodus_container.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cmath>
#include <cstring>
#include <fstream>
#include <limits>
#include <string>
#include <string_view>
#include <system_error>
#include <vector>

#include "src/error.hpp"

namespace percuss {
namespace {

/// Deflate cannot shrink data by more (zlib's technical notes: 1032 to 1).
constexpr std::uintmax_t most_compression = 1032;

[[noreturn]] void refuse_damaged_header(const char* detail) {
  throw InputError(fmt::format("the file is damaged ({}): write or copy it again", detail));
}

/// Reads unsigned integers of a file from front to back. Past the end of the file it refuses.
class HeaderReader {
 public:
  explicit HeaderReader(std::ifstream& stream) : stream_(stream) {}

  void seek(std::uint64_t position) { stream_.seekg(static_cast<std::streamoff>(position)); }
  void skip(std::uint64_t bytes) {
    if (bytes > static_cast<std::uint64_t>(std::numeric_limits<std::int32_t>::max()))
      refuse_damaged_header("a length in its header is absurd");
    stream_.seekg(static_cast<std::streamoff>(bytes), std::ios::cur);
  }
  std::uint64_t big_endian(int width) {
    std::uint64_t value = 0;
    for (int i = 0; i < width; ++i) value = value << 8U | byte();
    return value;
  }
  std::uint64_t little_endian(int width) {
    std::uint64_t value = 0;
    for (int i = 0; i < width; ++i) value |= std::uint64_t{byte()} << (8U * static_cast<unsigned>(i));
    return value;
  }

 private:
  unsigned char byte() {
    const int c = stream_.get();
    if (c == std::char_traits<char>::eof()) refuse_damaged_header("it ends within its header");
    return static_cast<unsigned char>(c);
  }
  std::ifstream& stream_;
};

/// Header of the classic formats CDF-1, CDF-2 and CDF-5 (netCDF "File Format Specifications").
class ClassicHeader {
 public:
  ClassicHeader(std::ifstream& stream, int version) : in_(stream), version_(version) {}

  /// First byte after the data of all variables without records.
  std::uint64_t find_end() {
    in_.seek(4);
    records_ = number();
    read_dimensions();
    skip_attributes();
    const std::uint64_t count = list_length(0x0B);
    for (std::uint64_t v = 0; v < count; ++v) read_variable();
    return end_;
  }

  /// First byte after all records; of a count that makes no sense more than any file has. Call after find_end().
  double find_records_end() const {
    if (records_ == 0 || record_bytes_ == 0) return 0;
    return record_begin_ + static_cast<double>(records_ - 1) * record_bytes_ + last_record_;
  }

 private:
  std::uint64_t number() { return in_.big_endian(version_ == 5 ? 8 : 4); }

  std::uint64_t list_length(std::uint64_t wanted_tag) {
    const std::uint64_t tag = in_.big_endian(4), length = number();
    if (tag != wanted_tag && (tag != 0 || length != 0)) refuse_damaged_header("its header makes no sense");
    return length;
  }

  void skip_padded(std::uint64_t count, std::uint64_t width) {
    if (count > std::numeric_limits<std::uint32_t>::max()) refuse_damaged_header("a length in its header is absurd");
    in_.skip((count * width + 3) / 4 * 4);
  }

  void skip_name() { skip_padded(number(), 1); }

  void read_dimensions() {
    const std::uint64_t count = list_length(0x0A);
    for (std::uint64_t d = 0; d < count; ++d) {
      skip_name();
      dimensions_.push_back(number());
    }
  }

  void skip_attributes() {
    const std::uint64_t count = list_length(0x0C);
    for (std::uint64_t a = 0; a < count; ++a) {
      skip_name();
      const std::uint64_t width = read_type_width(), length = number();
      skip_padded(length, width);
    }
  }

  std::uint64_t read_type_width() {
    // byte, char, short, int, float, double, unsigned byte, short, int, 64-bit, unsigned 64-bit
    constexpr std::array<std::uint64_t, 12> widths{0, 1, 1, 2, 4, 4, 8, 1, 2, 4, 8, 8};
    const std::uint64_t type = in_.big_endian(4);
    if (type < 1 || type >= widths.size()) refuse_damaged_header("its header makes no sense");
    return widths[type];
  }

  void read_variable() {
    skip_name();
    const std::uint64_t rank = number();
    double values = 1;  // in double: products of damaged lengths must not wrap
    bool has_records = false;
    for (std::uint64_t d = 0; d < rank; ++d) {
      const std::uint64_t id = number();
      if (id >= dimensions_.size()) refuse_damaged_header("its header makes no sense");
      if (dimensions_[id] != 0) values *= static_cast<double>(dimensions_[id]);
      has_records = has_records || dimensions_[id] == 0;
    }
    skip_attributes();
    const std::uint64_t width = read_type_width();
    number();  // its size, which overflows for large variables
    const std::uint64_t begin = in_.big_endian(version_ == 1 ? 4 : 8);
    const double bytes = values * static_cast<double>(width);
    if (has_records) return add_record(static_cast<double>(begin), bytes);
    if (static_cast<double>(begin) + bytes > 9e18) refuse_damaged_header("a length in its header is absurd");
    end_ = std::max(end_, begin + static_cast<std::uint64_t>(bytes));
  }

  /// What a variable has in each record; those of one record follow each other.
  void add_record(double begin, double bytes) {
    if (record_bytes_ == 0) record_begin_ = begin;
    record_begin_ = std::min(record_begin_, begin);
    record_bytes_ += 4 * std::ceil(bytes / 4);
    last_record_ = record_bytes_ - (4 * std::ceil(bytes / 4) - bytes);
  }

  HeaderReader in_;
  int version_;
  std::uint64_t records_ = 0;
  double record_begin_ = 0, record_bytes_ = 0, last_record_ = 0;  // where the first begins; of a record; of the last
  std::vector<std::uint64_t> dimensions_;
  std::uint64_t end_ = 0;
};

/// End of file that the superblock of an HDF5 file gives ("HDF5 File Format Specification", II.A); 0 if the superblock
/// is of a version unknown here.
std::uint64_t find_hdf5_end(std::ifstream& stream) {
  HeaderReader in(stream);
  in.seek(8);
  const std::uint64_t version = in.little_endian(1);
  if (version > 3) return 0;
  in.seek(version < 2 ? 13 : 9);
  const int width = static_cast<int>(in.little_endian(1));
  if (width != 2 && width != 4 && width != 8) refuse_damaged_header("its header makes no sense");
  constexpr std::array<std::uint64_t, 4> base_address{24, 28, 12, 12};
  in.seek(base_address[version] + 2 * static_cast<std::uint64_t>(width));
  return in.little_endian(width);
}

std::uintmax_t find_length(const std::filesystem::path& file) {
  std::error_code error;
  const std::filesystem::file_status status = std::filesystem::status(file, error);
  if (status.type() == std::filesystem::file_type::not_found) throw InputError("the file does not exist");
  if (error) throw SystemError(fmt::format("the file cannot be read ({})", error.message()));
  if (status.type() != std::filesystem::file_type::regular)
    throw InputError("this is not a file (an Exodus II file is needed)");
  const std::uintmax_t length = std::filesystem::file_size(file, error);
  if (error) throw SystemError(fmt::format("the file cannot be read ({})", error.message()));
  return length;
}

}  // namespace

ExodusContainer inspect_exodus_container(const std::filesystem::path& file) {
  const std::uintmax_t length = find_length(file);
  if (length == 0) throw InputError("the file is empty");
  std::ifstream stream(file, std::ios::binary);
  if (!stream) throw SystemError(fmt::format("the file cannot be opened ({})", std::strerror(errno)));
  std::array<char, 8> magic{};
  stream.read(magic.data(), magic.size());
  stream.clear();
  const std::string_view text(magic.data(), magic.size());
  const bool classic = text.substr(0, 3) == "CDF" && (magic[3] == 1 || magic[3] == 2 || magic[3] == 5);
  if (!classic && text != "\x89HDF\r\n\x1a\n") {
    throw InputError("this is not an Exodus II file (it begins like neither netCDF nor HDF5)");
  }
  double records_end = 0;
  std::uint64_t promised = 0;
  if (classic) {
    ClassicHeader header(stream, magic[3]);
    promised = header.find_end();
    records_end = header.find_records_end();
  } else {
    promised = find_hdf5_end(stream);
  }
  if (promised > length) {
    throw InputError(fmt::format("the file is truncated (it has {} bytes, its header promises {}): copy it again",
                                 length, promised));
  }
  return {!classic, length, classic ? length : length * most_compression, records_end};
}

}  // namespace percuss
