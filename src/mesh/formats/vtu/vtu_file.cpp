#include "src/mesh/formats/vtu/vtu_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "src/mesh/files/text_numbers.hpp"
#include "src/mesh/formats/vtu/vtk_grid.hpp"
#include "src/mesh/formats/vtu/vtu_arrays.hpp"
#include "src/mesh/formats/vtu/xml_scanner.hpp"

namespace percuss {
namespace {

class VtuReader {
 public:
  explicit VtuReader(const std::string& path) : source_(path, names_), scanner_(source_.text(), names_) {}

  std::unique_ptr<MeshFile> read() {
    read_grid();
    return VtkGridMesh(names_, grid_).take_mesh();
  }

  FileResults read_results(const ResultsWish& wish) {
    read_grid();
    if (!has_piece_) names_.refuse({0, 1}, "the file has no cells");
    return VtkGridMesh(names_, grid_).take_results(wish);
  }

 private:
  void read_grid() {
    read_tags();
    if (!has_piece_) return;
    read_points();
    read_cells();
    grid_.place = place_;
    grid_.of_points = list_arrays("PointData");
    grid_.of_cells = list_arrays("CellData");
  }

  std::vector<VtkArray> list_arrays(const char* section) {
    std::vector<VtkArray> arrays;
    for (const VtuArray& array : found_[section])
      arrays.push_back({array.name, array.components, array.has_integers(),
                        [&](std::size_t count) { return arrays_.read_integers(array, count); },
                        [&](std::size_t count) { return arrays_.read_reals(array, count); }});
    return arrays;
  }

  void read_tags() {
    XmlTag tag;
    bool is_vtk = false;
    while (scanner_.next(tag)) {
      if (scanner_.open_tags().size() <= 1 && !tag.closes && !std::exchange(is_vtk, true) && tag.name != "VTKFile")
        names_.refuse(tag.place, fmt::format("the file begins with <{}> (<VTKFile> is expected)", tag.name));
      if (!tag.closes) read_tag(tag);
    }
    if (!is_vtk) names_.refuse({0, 1}, "the file has no <VTKFile>");
  }

  void read_tag(const XmlTag& tag) {
    if (tag.name == "VTKFile") arrays_.read_file_tag(tag);
    if (tag.name == "AppendedData") arrays_.read_appended_tag(tag);
    if (tag.name == "Piece") read_piece(tag);
    if (tag.name != "DataArray" || !takes_arrays_) return;
    const auto& open = scanner_.open_tags();
    const std::string_view section = open.size() < 2 ? std::string_view() : open[open.size() - 2];
    if (section == "Points" || section == "Cells" || section == "PointData" || section == "CellData")
      found_[std::string(section)].push_back(arrays_.read_array_tag(tag));
  }

  /// Pieces without cells are passed over.
  void read_piece(const XmlTag& tag) {
    const auto count = [&](const char* key) {
      constexpr std::int64_t most = std::int64_t{1} << 40;
      const auto value = parse_integer(tag.attribute(key));
      if (!value || *value < 0 || *value > most)
        names_.refuse(tag.place,
                      fmt::format("{} is {} (a whole number is expected)", key, quote_field(tag.attribute(key))));
      return static_cast<std::size_t>(*value);
    };
    takes_arrays_ = count("NumberOfCells") > 0;
    if (!takes_arrays_) return;
    if (has_piece_) names_.refuse(tag.place, "the file has several pieces (one is read): merge them into one");
    has_piece_ = true;
    point_count_ = count("NumberOfPoints");
    cell_count_ = count("NumberOfCells");
    place_ = tag.place;
  }

  const VtuArray& find_of_cells(const char* name) {
    for (const VtuArray& array : found_["Cells"])
      if (array.name == name) return array;
    names_.refuse(place_, fmt::format("the piece has no array '{}' of its cells", name));
  }

  void read_points() {
    if (found_["Points"].empty()) names_.refuse(place_, "the piece has no array of points");
    const VtuArray& array = found_["Points"].front();
    if (array.components != 3 && array.components != 1)
      names_.refuse(array.place, fmt::format("points have {} components (3 are expected)", array.components));
    const std::vector<double> x = arrays_.read_reals(array, 3 * point_count_);
    grid_.points.resize(point_count_);
    for (std::size_t n = 0; n < point_count_; ++n) grid_.points[n] = {x[3 * n], x[3 * n + 1], x[3 * n + 2]};
  }

  void read_cells() {
    const VtuArray &offsets = find_of_cells("offsets"), &connectivity = find_of_cells("connectivity");
    grid_.ends = arrays_.read_integers(offsets, cell_count_);
    grid_.types = arrays_.read_integers(find_of_cells("types"), cell_count_);
    const std::int64_t last = grid_.ends.empty() ? 0 : grid_.ends.back();
    grid_.connectivity = arrays_.read_integers(connectivity, static_cast<std::size_t>(std::max<std::int64_t>(last, 0)));
  }

  TextNames names_;
  TextSource source_;
  XmlScanner scanner_;
  VtuArrays arrays_{names_};
  std::map<std::string, std::vector<VtuArray>> found_;  // by section
  std::size_t point_count_ = 0, cell_count_ = 0;
  TextPlace place_{0, 1};  // of the piece
  bool has_piece_ = false, takes_arrays_ = false;
  VtkGrid grid_;
};

}  // namespace

bool is_vtu_file(std::string_view first_bytes) { return first_bytes.find("<VTKFile") != std::string_view::npos; }

std::unique_ptr<MeshFile> open_vtu_file(const std::string& path) { return VtuReader(path).read(); }

FileResults read_vtu_results(const std::string& path, const ResultsWish& wish) {
  return VtuReader(path).read_results(wish);
}

}  // namespace percuss
