#pragma once
// fields.vtkhdf: the fields of a run over time, one HDF5 file in VTK's UnstructuredGrid layout (version 2, temporal),
// and an .xdmf beside it over the same datasets. docs/output.md lists every dataset.
//
// The cells are stored once, the positions of the nodes at every frame. Displacement is always among the fields.

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

/// How fields are stored; positions and times are always float64.
enum class FieldPrecision { float64, float32 };

struct FieldsOptions {
  std::string title;  // of the deck
  std::string units;  // of the deck: "m, kg, s"; scripts/render derives the units of fields from it
  FieldPrecision precision = FieldPrecision::float64;
};

class FieldsFile {
 public:
  /// Creates DIR/fields.vtkhdf and DIR/fields.xdmf (old ones are replaced) with the mesh: cells, ids, part numbers.
  /// Throws SystemError with the path and the reason.
  FieldsFile(const std::string& directory, const Mesh& mesh, const FieldsOptions& options = {});
  /// Closes the file if close() was not called; an error is lost then.
  ~FieldsFile();
  FieldsFile(FieldsFile&&) noexcept;
  FieldsFile& operator=(FieldsFile&&) noexcept;

  /// Appends a frame and flushes it: it survives the end of the process, even kill -9, from then on.
  /// positions: [nodes][3] [length] at `time`. Every frame must give the same fields in the same order
  /// (std::logic_error otherwise); names are unique and have neither '/' nor quotes. "displacement" (positions less
  /// those of the mesh) is added unless it is given. Throws SystemError (disk full); the frames before then stay
  /// readable, and the file takes no more.
  void write_frame(double time, long step, std::span<const double> positions, std::span<const FieldData> fields);

  /// Waits until the disk has all and closes the file; errors are thrown here rather than lost in the destructor.
  void close();

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace percuss
