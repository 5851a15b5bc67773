#pragma once
// The texts of fields.xdmf and fields.xdmf2: indexes, in XML, of the datasets of fields.vtkhdf for readers of XDMF
// version 2.

#include <cstdint>
#include <string>
#include <vector>

#include "src/output/vtkhdf/fields_file.hpp"
#include "src/output/vtkhdf/mesh_extents.hpp"

namespace percuss {

/// A field that every frame has, for the index.
struct XdmfField {
  std::string name;
  FieldPlace place = FieldPlace::node;
  int components = 1;
  int bytes = 8;  // of one number in the file: a float of 8 or 4, or a whole number of 1
  std::string unit = {};
};

struct XdmfIndex {
  std::string file;  // name of the HDF5 file, relative to the .xdmf
  std::string title, units;
  std::vector<std::string> parts;
  std::vector<WallPlane> walls;
  std::vector<MeshExtent> extents;  // [parts]
  MeshExtent mesh;                  // all of them
  std::vector<XdmfField> fields;
  std::vector<double> times;  // one a frame
};

/// The text of fields.xdmf: for each frame one grid of the whole mesh.
std::string make_xdmf_text(const XdmfIndex& index);

/// The text of fields.xdmf2: for each part a grid with its name, which has frames. Names of fields end with their unit,
/// "velocity [m/s]".
std::string make_xdmf_text_by_parts(const XdmfIndex& index);

}  // namespace percuss
