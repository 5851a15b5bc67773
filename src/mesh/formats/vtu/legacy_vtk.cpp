#include "src/mesh/formats/vtu/legacy_vtk.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "src/mesh/files/text_numbers.hpp"
#include "src/mesh/formats/vtu/legacy_data.hpp"
#include "src/mesh/formats/vtu/vtk_grid.hpp"

namespace percuss {
namespace {

constexpr std::string_view first_words = "# vtk DataFile Version";

using Words = std::vector<std::string_view>;

/// Names have their blanks as "%20".
std::string decode_name(std::string_view text) {
  const auto find_digit = [](char c) {
    return c >= '0' && c <= '9'   ? c - '0'
           : c >= 'A' && c <= 'F' ? c - 'A' + 10
           : c >= 'a' && c <= 'f' ? c - 'a' + 10
                                  : -1;
  };
  std::string name;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const bool is_code =
        text[i] == '%' && i + 2 < text.size() && find_digit(text[i + 1]) >= 0 && find_digit(text[i + 2]) >= 0;
    if (!is_code) {
      name += text[i];
      continue;
    }
    const auto c = static_cast<char>(16 * find_digit(text[i + 1]) + find_digit(text[i + 2]));
    name += c >= ' ' && c <= '~' ? c : ' ';
    i += 2;
  }
  return name;
}

class LegacyReader {
 public:
  explicit LegacyReader(const std::string& path) : source_(path, names_), scan_(source_.text(), names_) {}

  std::unique_ptr<MeshFile> read() {
    read_grid();
    return VtkGridMesh(names_, grid_).take_mesh();
  }

  FileResults read_results(const ResultsWish& wish) {
    read_grid();
    if (grid_.types.empty()) names_.refuse({0, 1}, "the file has no cells");
    return VtkGridMesh(names_, grid_).take_results(wish);
  }

 private:
  enum class Section { none, points, cells };

  void read_grid() {
    read_head();
    for (Words words = scan_.next_words(); !words.empty(); words = scan_.next_words()) read_section(words);
    if (!has_dataset_) names_.refuse({0, 1}, "the file has no DATASET");
    if (grid_.types.size() != grid_.ends.size())
      names_.refuse(grid_.place, fmt::format("{} cells have {} types", grid_.ends.size(), grid_.types.size()));
  }

  void read_head() {
    std::string_view line;
    if (!scan_.next_line(line) || !line.starts_with(first_words))
      names_.refuse({0, 1}, "the file does not begin with # vtk DataFile Version");
    const auto version = parse_real(line.substr(first_words.size()));
    if (!version || *version < 1 || *version >= 6)
      scan_.refuse(fmt::format("the version is {} (1 to 5 are read)", quote_field(line.substr(first_words.size()))));
    has_offsets_ = *version >= 5.1 - 1e-9;
    scan_.next_line(line);  // the title
    if (!scan_.next_line(line) || (to_upper(line) != "ASCII" && to_upper(line) != "BINARY"))
      scan_.refuse(fmt::format("{} stands where ASCII or BINARY is expected", quote_field(line)));
    scan_.is_binary = to_upper(line) == "BINARY";
  }

  void read_section(const Words& words) {
    const std::string key = to_upper(words[0]);
    if (key == "DATASET") return read_dataset(words);
    if (key == "FIELD") return read_fields(words);
    if (key == "METADATA") return skip_metadata();
    if (!has_dataset_) scan_.refuse(fmt::format("{} stands where DATASET is expected", quote_field(words[0])));
    if (key == "POINTS") return read_points(words);
    if (key == "CELLS") return read_cells(words);
    if (key == "CELL_TYPES") {
      grid_.types =
          scan_.take_data("int", find_count(words, 1), "CELL_TYPES").read_integers(find_count(words, 1), names_);
      return;
    }
    if (key == "POINT_DATA" || key == "CELL_DATA")
      return begin_data(key == "CELL_DATA" ? Section::cells : Section::points, words);
    read_attribute(key, words);
  }

  std::string_view find_word(const Words& words, std::size_t place) const {
    if (place >= words.size())
      scan_.refuse(fmt::format("{} has {} words ({} are expected)", quote_field(words[0]), words.size(), place + 1));
    return words[place];
  }

  std::size_t find_count(const Words& words, std::size_t place) const {
    constexpr std::int64_t most = std::int64_t{1} << 40;
    const std::string_view word = find_word(words, place);
    const auto value = parse_integer(word);
    if (!value || *value < 0 || *value > most)
      scan_.refuse(fmt::format("{} stands where a number of {} is expected", quote_field(word), quote_field(words[0])));
    return static_cast<std::size_t>(*value);
  }

  void read_dataset(const Words& words) {
    if (to_upper(find_word(words, 1)) != "UNSTRUCTURED_GRID")
      scan_.refuse(fmt::format("the file is a {} (UNSTRUCTURED_GRID is read)", quote_field(words[1])));
    if (has_dataset_) scan_.refuse("DATASET comes again");
    has_dataset_ = true;
  }

  void read_points(const Words& words) {
    const std::size_t count = find_count(words, 1);
    const std::vector<double> x =
        scan_.take_data(find_word(words, 2), 3 * count, "POINTS").read_reals(3 * count, names_);
    grid_.points.resize(count);
    for (std::size_t n = 0; n < count; ++n) grid_.points[n] = {x[3 * n], x[3 * n + 1], x[3 * n + 2]};
  }

  void read_cells(const Words& words) {
    grid_.place = scan_.place();
    const std::size_t first = find_count(words, 1), second = find_count(words, 2);
    if (has_offsets_) return read_offsets(first, second);
    const std::vector<std::int64_t> list = scan_.take_data("int", second, "CELLS").read_integers(second, names_);
    for (std::size_t at = 0; at < list.size(); at += static_cast<std::size_t>(list[at]) + 1) {
      if (list[at] < 0 || static_cast<std::size_t>(list[at]) >= list.size() - at)
        names_.refuse(grid_.place,
                      fmt::format("cell {} has {} points, more than CELLS has left", grid_.ends.size(), list[at]));
      const auto begin = list.begin() + static_cast<std::ptrdiff_t>(at) + 1;
      grid_.connectivity.insert(grid_.connectivity.end(), begin, begin + list[at]);
      grid_.ends.push_back(static_cast<std::int64_t>(grid_.connectivity.size()));
    }
    if (grid_.ends.size() != first)
      names_.refuse(grid_.place, fmt::format("CELLS has {} cells ({} are expected)", grid_.ends.size(), first));
  }

  /// Reads cells of version 5.1: where each cell begins, and the points of all.
  void read_offsets(std::size_t offsets, std::size_t points) {
    std::vector<std::int64_t> first = take_list("OFFSETS", offsets);
    grid_.connectivity = take_list("CONNECTIVITY", points);
    if (offsets == 0) return;
    if (first.front() != 0 || first.back() != static_cast<std::int64_t>(points))
      names_.refuse(grid_.place,
                    fmt::format("OFFSETS are {} to {} (0 to {} are expected)", first.front(), first.back(), points));
    grid_.ends.assign(first.begin() + 1, first.end());
  }

  std::vector<std::int64_t> take_list(const std::string& key, std::size_t count) {
    const Words words = scan_.next_words();
    if (words.empty() || to_upper(words[0]) != key)
      scan_.refuse(
          fmt::format("{} stands where {} is expected", words.empty() ? "nothing" : quote_field(words[0]), key));
    return scan_.take_data(find_word(words, 1), count, key).read_integers(count, names_);
  }

  void begin_data(Section section, const Words& words) {
    section_ = section;
    rows_ = find_count(words, 1);
    const std::size_t expected = section == Section::cells ? grid_.ends.size() : grid_.points.size();
    if (rows_ != expected)
      scan_.refuse(fmt::format("{} is of {} (there are {})", quote_field(words[0]), rows_, expected));
  }

  /// COMPONENT_NAMES and INFORMATION, up to an empty line.
  void skip_metadata() {
    for (std::string_view line; scan_.next_line(line) && !line.empty();) {
    }
  }

  std::size_t multiply(std::size_t a, std::size_t b) const {
    constexpr std::size_t most = std::size_t{1} << 40;
    if (b > 0 && a > most / b) scan_.refuse("an array has more numbers than the file can hold");
    return a * b;
  }

  void add_array(std::string_view name, std::size_t components, const LegacyData& data) {
    if (section_ == Section::none) return;
    VtkArray array{decode_name(name), static_cast<std::int64_t>(components), data.has_integers(), {}, {}};
    array.read_integers = [this, data](std::size_t count) { return data.read_integers(count, names_); };
    array.read_reals = [this, data](std::size_t count) { return data.read_reals(count, names_); };
    (section_ == Section::cells ? grid_.of_cells : grid_.of_points).push_back(std::move(array));
  }

  void read_fields(const Words& words) {
    const std::size_t count = find_count(words, 2);
    for (std::size_t i = 0; i < count; ++i) {
      Words head = scan_.next_words();
      while (!head.empty() && to_upper(head[0]) == "METADATA") {
        skip_metadata();
        head = scan_.next_words();
      }
      if (head.empty()) scan_.refuse("the file ends within FIELD");
      const std::size_t components = find_count(head, 1), rows = find_count(head, 2);
      const LegacyData data = scan_.take_data(find_word(head, 3), multiply(components, rows), "FIELD");
      if (section_ != Section::none && rows != rows_)
        names_.refuse(data.place,
                      fmt::format("array {} has {} rows ({} are expected)", quote_field(head[0]), rows, rows_));
      add_array(head[0], components, data);
    }
  }

  /// An array of POINT_DATA or CELL_DATA, by the word that it begins with.
  void read_attribute(const std::string& key, const Words& words) {
    const auto take = [&](std::size_t components, std::string_view type) {
      add_array(words[1], components, scan_.take_data(type, multiply(components, rows_), key));
    };
    if (words.size() < 2) scan_.refuse(fmt::format("{} stands where a section is expected", quote_field(words[0])));
    if (key == "SCALARS") return read_scalars(words);
    if (key == "VECTORS" || key == "NORMALS") return take(3, find_word(words, 2));
    if (key == "TENSORS") return take(9, find_word(words, 2));
    if (key == "TENSORS6") return take(6, find_word(words, 2));
    if (key == "GLOBAL_IDS" || key == "PEDIGREE_IDS" || key == "EDGE_FLAGS") return take(1, find_word(words, 2));
    if (key == "TEXTURE_COORDINATES") return take(find_count(words, 2), find_word(words, 3));
    if (key == "COLOR_SCALARS") return take(find_count(words, 2), scan_.is_binary ? "unsigned_char" : "float");
    if (key == "LOOKUP_TABLE") {
      scan_.take_data(scan_.is_binary ? "unsigned_char" : "float", multiply(4, find_count(words, 2)), key);
      return;
    }
    scan_.refuse(fmt::format("{} {} is not read", quote_field(words[0]), quote_field(words[1])));
  }

  void read_scalars(const Words& words) {
    const std::size_t components = words.size() > 3 ? find_count(words, 3) : 1;
    const std::string_view type = find_word(words, 2);
    const Words table = scan_.is_binary || has_table() ? scan_.next_words() : Words();
    if (!table.empty() && to_upper(table[0]) != "LOOKUP_TABLE")
      scan_.refuse(fmt::format("{} stands where LOOKUP_TABLE is expected", quote_field(table[0])));
    add_array(words[1], components, scan_.take_data(type, multiply(components, rows_), "SCALARS"));
  }

  /// Some writers of text leave it out.
  bool has_table() {
    const Words next = scan_.next_words();
    scan_.step_back();
    return !next.empty() && to_upper(next[0]) == "LOOKUP_TABLE";
  }

  TextNames names_;
  TextSource source_;
  LegacyScanner scan_;
  VtkGrid grid_;
  Section section_ = Section::none;
  std::size_t rows_ = 0;
  bool has_dataset_ = false, has_offsets_ = false;
};

}  // namespace

bool is_legacy_vtk_file(std::string_view first_bytes) { return first_bytes.starts_with(first_words); }

std::unique_ptr<MeshFile> open_legacy_vtk_file(const std::string& path) { return LegacyReader(path).read(); }

FileResults read_legacy_vtk_results(const std::string& path, const ResultsWish& wish) {
  return LegacyReader(path).read_results(wish);
}

}  // namespace percuss
