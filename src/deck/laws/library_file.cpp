#include "src/deck/laws/library_file.hpp"

#include <elf.h>
#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <vector>

namespace percuss {
namespace {

/// Reads numbers at a place of the file; false: they are not there.
template <class T>
bool read_at(std::ifstream& file, std::uint64_t place, std::vector<T>& values) {
  file.seekg(static_cast<std::streamoff>(place));
  file.read(reinterpret_cast<char*>(values.data()), static_cast<std::streamsize>(values.size() * sizeof(T)));
  return static_cast<bool>(file);
}

/// Where a range ends; beyond all files where that is no number.
std::uint64_t find_end(std::uint64_t first, std::uint64_t size) {
  return first > UINT64_MAX - size ? UINT64_MAX : first + size;
}

}  // namespace

std::string find_library_fault(const std::string& file) {
  std::error_code no_size;
  const std::uint64_t size = std::filesystem::file_size(file, no_size);
  std::ifstream stream(file, std::ios::binary);
  std::vector<Elf64_Ehdr> head(1);
  if (no_size || !read_at(stream, 0, head)) return {};
  const Elf64_Ehdr& header = head.front();
  const bool is_of_64_bits =
      std::memcmp(header.e_ident, ELFMAG, SELFMAG) == 0 && header.e_ident[EI_CLASS] == ELFCLASS64;
  if (!is_of_64_bits || header.e_phentsize != sizeof(Elf64_Phdr)) return {};
  std::uint64_t end = std::max(find_end(header.e_phoff, header.e_phnum * std::uint64_t{header.e_phentsize}),
                               find_end(header.e_shoff, header.e_shnum * std::uint64_t{header.e_shentsize}));
  std::vector<Elf64_Phdr> segments(header.e_phnum);
  if (end <= size && read_at(stream, header.e_phoff, segments)) {
    for (const Elf64_Phdr& segment : segments) end = std::max(end, find_end(segment.p_offset, segment.p_filesz));
  }
  if (end <= size) return {};
  return fmt::format("it is cut off: {} bytes of at least {}", size, end);
}

}  // namespace percuss
