#pragma once
// Arrays of a VTK XML file, in each form that it has: as text, as base64, or behind all tags as base64 or as bytes.

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "src/mesh/files/text_source.hpp"
#include "src/mesh/formats/vtu/vtu_bytes.hpp"
#include "src/mesh/formats/vtu/xml_scanner.hpp"

namespace percuss {

/// A DataArray.
struct VtuArray {
  std::string name, type, format;
  std::int64_t components = 1, offset = 0;
  std::string_view text;
  TextPlace place;

  bool has_integers() const { return type.starts_with("Int") || type.starts_with("UInt"); }
};

class VtuArrays {
 public:
  explicit VtuArrays(const TextNames& names) : names_(names) {}

  /// Reads the tag VTKFile, a tag DataArray or the tag AppendedData. Throws InputError.
  void read_file_tag(const XmlTag& tag);
  VtuArray read_array_tag(const XmlTag& tag) const;
  void read_appended_tag(const XmlTag& tag);

  /// So many numbers. Throws InputError if the array has more or fewer, or others.
  std::vector<std::int64_t> read_integers(const VtuArray& array, std::size_t count) const;
  std::vector<double> read_reals(const VtuArray& array, std::size_t count) const;

 private:
  template <class T>
  std::vector<T> read(const VtuArray& array, std::size_t count) const;
  template <class T, class Parse>
  std::vector<T> read_text(const VtuArray& array, std::size_t count, const Parse& parse) const;
  std::string read_bytes(const VtuArray& array, std::size_t bytes) const;
  [[noreturn]] void refuse(const VtuArray& array, const std::string& why) const;

  const TextNames& names_;
  VtuStorage storage_;
  bool is_big_endian_ = false;
  std::string_view appended_;  // behind the underscore
  bool is_appended_base64_ = false, has_appended_ = false;
};

}  // namespace percuss
