#pragma once
// fields.vtkhdf: the fields of a run over time, one HDF5 file in VTK's UnstructuredGrid layout (version 2, temporal),
// and an .xdmf beside it over the same datasets.

#include <memory>
#include <span>
#include <string>
#include <vector>

#include "src/mesh/mesh.hpp"

namespace percuss {

enum class FieldPlace { node, element };

/// One field of one frame; values has components * (nodes or elements) numbers, item by item.
struct FieldData {
  std::string name;
  FieldPlace place = FieldPlace::node;
  int components = 1;  // 1, 3 (vector) or 6 (xx, yy, zz, xy, yz, zx)
  std::span<const double> values;
};

class FieldsFile {
 public:
  /// Creates DIR/fields.vtkhdf and DIR/fields.xdmf with the mesh: points, cells, ids, part numbers.
  /// Every frame must give the same fields. Throws SystemError with the path and the reason.
  FieldsFile(const std::string& directory, const Mesh& mesh);
  ~FieldsFile();
  FieldsFile(FieldsFile&&) noexcept;
  FieldsFile& operator=(FieldsFile&&) noexcept;

  /// Appends a frame and flushes it, so that what was computed survives a crash. positions: [nodes][3] at `time` [s].
  void write_frame(double time, long step, std::span<const double> positions, std::span<const FieldData> fields);

  /// Closes the file; errors are thrown here rather than lost in the destructor.
  void close();

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace percuss
