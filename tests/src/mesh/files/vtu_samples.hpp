#pragma once
// The two unit cubes of sample_files.hpp with a shell on the far end, as VTK unstructured grids in every form of
// arrays.

#include <zlib.h>

#include <cstdint>
#include <cstring>
#include <sstream>
#include <string>
#include <vector>

namespace percuss::testing_mesh {

enum class VtuForm : std::uint8_t { ascii, base64, appended_base64, appended_raw };

struct VtuOptions {
  VtuForm form = VtuForm::ascii;
  bool is_compressed = false, has_long_headers = false;
};

inline std::string encode_base64(const std::string& bytes) {
  constexpr char digits[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    unsigned bits = 0;
    for (std::size_t k = 0; k < 3; ++k)
      bits = bits << 8 | (i + k < bytes.size() ? static_cast<unsigned char>(bytes[i + k]) : 0U);
    for (std::size_t k = 0; k < 4; ++k) text += i + k < bytes.size() + 1 ? digits[bits >> (18 - 6 * k) & 63U] : '=';
  }
  return text;
}

class VtuWriter {
 public:
  explicit VtuWriter(VtuOptions options) : options_(options) {}

  /// A DataArray of these numbers, as `Stored` in the file.
  template <class Stored, class T>
  std::string array(const std::string& type, const std::string& name, const std::vector<T>& numbers,
                    int components = 1) {
    std::string attributes = "type=\"" + type + "\" Name=\"" + name + "\"";
    if (components > 1) attributes += " NumberOfComponents=\"" + std::to_string(components) + "\"";
    std::string bytes;
    std::ostringstream text;
    text.precision(17);
    for (const T number : numbers) {
      text << +number << (text.tellp() % 7 == 0 ? "\n" : " ");
      const auto stored = static_cast<Stored>(number);
      bytes.append(reinterpret_cast<const char*>(&stored), sizeof(stored));
    }
    if (options_.form == VtuForm::ascii)
      return "<DataArray " + attributes + " format=\"ascii\">\n" + text.str() + "\n</DataArray>\n";
    const std::string data = pack(bytes);
    if (options_.form == VtuForm::base64)
      return "<DataArray " + attributes + " format=\"binary\">\n  " + data + "\n</DataArray>\n";
    const std::string offset = std::to_string(appended_.size());
    appended_ += data;
    return "<DataArray " + attributes + " format=\"appended\" offset=\"" + offset + "\"/>\n";
  }

  /// The file with these tags within <Piece>.
  std::string file(std::size_t points, std::size_t cells, const std::string& piece) const {
    std::string text =
        "<?xml version=\"1.0\"?>\n<VTKFile type=\"UnstructuredGrid\" version=\"1.0\" byte_order=\"LittleEndian\"";
    if (options_.has_long_headers) text += " header_type=\"UInt64\"";
    if (options_.is_compressed) text += " compressor=\"vtkZLibDataCompressor\"";
    text += ">\n<!-- a remark -->\n<UnstructuredGrid>\n<Piece NumberOfPoints=\"" + std::to_string(points) +
            "\" NumberOfCells = '" + std::to_string(cells) + "'>\n" + piece + "</Piece>\n</UnstructuredGrid>\n";
    const bool is_raw = options_.form == VtuForm::appended_raw;
    if (!appended_.empty())
      text += std::string("<AppendedData encoding=\"") + (is_raw ? "raw" : "base64") + "\">\n_" + appended_ +
              "\n</AppendedData>\n";
    return text + "</VTKFile>\n";
  }

 private:
  std::string encode(const std::string& bytes) const {
    return options_.form == VtuForm::appended_raw ? bytes : encode_base64(bytes);
  }

  std::string number(std::size_t value) const {
    const auto size = static_cast<std::uint64_t>(value);
    return {reinterpret_cast<const char*>(&size), options_.has_long_headers ? std::size_t{8} : std::size_t{4}};
  }

  /// Compressed in blocks of 64 bytes, so that arrays have several.
  std::string pack(const std::string& bytes) const {
    if (!options_.is_compressed) return encode(number(bytes.size()) + bytes);
    constexpr std::size_t size = 64;
    const std::size_t blocks = (bytes.size() + size - 1) / size;
    std::string header = number(blocks) + number(size) + number(bytes.size() % size), data;
    for (std::size_t b = 0; b < blocks; ++b) {
      const std::string block = bytes.substr(b * size, size);
      std::string packed(compressBound(block.size()), '\0');
      uLongf length = packed.size();
      compress(reinterpret_cast<Bytef*>(packed.data()), &length, reinterpret_cast<const Bytef*>(block.data()),
               block.size());
      header += number(length);
      data += packed.substr(0, length);
    }
    return encode(header) + encode(data);
  }

  VtuOptions options_;
  std::string appended_;
};

inline std::string make_vtu(VtuOptions options) {
  VtuWriter to(options);
  const std::vector<double> points = {0, 0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 1, 0, 0, 1, 1, 0,
                                      1, 1, 1, 1, 0, 1, 2, 0, 0, 2, 1, 0, 2, 1, 1, 2, 0, 1};
  const std::vector<int> node_ids = {10, 20, 30, 40, 50, 60, 70, 80, 90, 100, 110, 120};
  const std::vector<int> connectivity = {0, 4, 5, 1, 3, 7, 6, 2, 4, 8, 9, 5, 7, 11, 10, 6, 8, 9, 10, 8, 10, 11};
  std::string piece = "<PointData>\n" + to.array<std::int32_t>("Int32", "node_id", node_ids) +
                      to.array<double>("Float64", "velocity", points, 3) + "</PointData>\n<CellData>\n" +
                      to.array<std::uint8_t>("UInt8", "MaterialIds", std::vector<int>{1, 2, 3, 3}) +
                      to.array<float>("Float32", "Thickness", std::vector<double>{0, 0, 0.5, 0.25}) +
                      to.array<std::int64_t>("Int64", "GlobalElementId", std::vector<int>{3, 4, 5, 6}) +
                      "</CellData>\n<Points>\n" + to.array<float>("Float32", "Points", points, 3) +
                      "</Points>\n<Cells>\n" + to.array<std::int64_t>("Int64", "connectivity", connectivity) +
                      to.array<std::int32_t>("Int32", "offsets", std::vector<int>{8, 16, 19, 22}) +
                      to.array<std::uint8_t>("UInt8", "types", std::vector<int>{12, 12, 5, 5}) + "</Cells>\n";
  return to.file(12, 4, piece);
}

/// Cells of one type, each with these points of the list; without ids of blocks.
inline std::string make_vtu_of(int type, const std::vector<double>& points, const std::vector<int>& cell) {
  VtuWriter to({});
  const std::string piece = "<Points>\n" + to.array<double>("Float64", "Points", points, 3) + "</Points>\n<Cells>\n" +
                            to.array<int>("Int32", "connectivity", cell) +
                            to.array<int>("Int32", "offsets", std::vector<std::size_t>{cell.size()}) +
                            to.array<int>("UInt8", "types", std::vector<int>{type}) + "</Cells>\n";
  return to.file(points.size() / 3, 1, piece);
}

}  // namespace percuss::testing_mesh
