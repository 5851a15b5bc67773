#pragma once
// The mesh of vtu_samples.hpp as legacy VTK files: text and big-endian binary, of version 3 and of version 5.1.

#include <algorithm>
#include <cstdint>
#include <sstream>
#include <string>
#include <vector>

namespace percuss::testing_mesh {

struct LegacyForm {
  bool is_binary = false, has_offsets = false;  // has_offsets: version 5.1
};

class LegacyWriter {
 public:
  explicit LegacyWriter(LegacyForm form) : form_(form) {}

  /// A line, and these numbers below it, in a binary file as `Stored`.
  template <class Stored, class T>
  LegacyWriter& add(const std::string& line, const std::vector<T>& numbers) {
    text_ << line << '\n';
    for (const T number : numbers) {
      auto stored = static_cast<Stored>(number);
      char* const bytes = reinterpret_cast<char*>(&stored);
      std::reverse(bytes, bytes + sizeof(stored));
      if (form_.is_binary)
        text_.write(bytes, sizeof(stored));
      else
        text_ << +number << (text_.tellp() % 7 == 0 ? "\n" : " ");
    }
    text_ << '\n';
    return *this;
  }
  LegacyWriter& add(const std::string& line) {
    text_ << line << '\n';
    return *this;
  }
  std::string text() const { return text_.str(); }

 private:
  LegacyForm form_;
  std::ostringstream text_;
};

inline std::string make_legacy_vtk(LegacyForm form) {
  const std::vector<double> points = {0, 0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 1, 0, 0, 1, 1, 0,
                                      1, 1, 1, 1, 0, 1, 2, 0, 0, 2, 1, 0, 2, 1, 1, 2, 0, 1};
  const std::vector<int> connectivity = {0, 4, 5, 1, 3, 7, 6, 2, 4, 8, 9, 5, 7, 11, 10, 6, 8, 9, 10, 8, 10, 11};
  const std::vector<int> list = {8, 0, 4, 5, 1, 3, 7, 6, 2, 8, 4, 8, 9, 5, 7, 11, 10, 6, 3, 8, 9, 10, 3, 8, 10, 11};
  LegacyWriter to(form);
  to.add(std::string("# vtk DataFile Version ") + (form.has_offsets ? "5.1" : "3.0"))
      .add("two cubes and a shell")
      .add(form.is_binary ? "BINARY" : "ASCII")
      .add("DATASET UNSTRUCTURED_GRID")
      .add("FIELD FieldData 1")
      .add<double>("TIME 1 1 double", std::vector<double>{0.5})
      .add<float>("POINTS 12 float", points)
      .add("METADATA\nINFORMATION 0\n");
  if (form.has_offsets) {
    to.add("CELLS 5 22").add<std::int64_t>("OFFSETS vtktypeint64", std::vector<int>{0, 8, 16, 19, 22});
    to.add<std::int64_t>("CONNECTIVITY vtktypeint64", connectivity);
  } else {
    to.add<std::int32_t>("CELLS 4 26", list);
  }
  to.add<std::int32_t>("CELL_TYPES 4", std::vector<int>{12, 12, 5, 5})
      .add("CELL_DATA 4")
      .add("SCALARS Material%20Ids int 1")
      .add<std::int32_t>("LOOKUP_TABLE default", std::vector<int>{1, 2, 3, 3})
      .add("FIELD FieldData 2")
      .add<double>("Thickness 1 4 double", std::vector<double>{0, 0, 0.5, 0.25})
      .add<std::int64_t>("GlobalElementId 1 4 long", std::vector<int>{3, 4, 5, 6})
      .add("POINT_DATA 12")
      .add<double>("VECTORS velocity double", points)
      .add<std::int32_t>("GLOBAL_IDS node_id int", std::vector<int>{10, 20, 30, 40, 50, 60, 70, 80, 90, 100, 110, 120});
  return to.text();
}

}  // namespace percuss::testing_mesh
