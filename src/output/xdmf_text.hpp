#pragma once
// The text of fields.xdmf: an index, in XML, of the datasets of fields.vtkhdf for readers of XDMF version 2 and 3.

#include <cstdint>
#include <string>
#include <vector>

#include "src/output/fields_file.hpp"

namespace percuss {

/// What the index must know of a field that every frame has.
struct XdmfField {
  std::string name;
  FieldPlace place = FieldPlace::node;
  int components = 1;
  int bytes = 8;  // of one number in the file: a float of 8 or 4, or a whole number of 1
};

struct XdmfIndex {
  std::string file;  // name of the HDF5 file, relative to the .xdmf
  std::string title, units;
  std::vector<std::string> parts;
  std::int64_t nodes = 0, elements = 0;
  std::int64_t shells = 0, triangles = 0;  // of the elements; triangles are shells too
  std::vector<XdmfField> fields;
  std::vector<double> times;  // one a frame
};

/// The whole text, for all frames of the index.
std::string make_xdmf_text(const XdmfIndex& index);

}  // namespace percuss
