#pragma once
// Reads the records of beams for output. Internal to element_fields.cpp.

#include "kernels/element/element_records.hpp"
#include "src/step/model/element_blocks.hpp"
#include "src/step/model/model.hpp"
#include "src/step/model/state.hpp"

namespace percuss {

/// Tables of a reader of beams besides the records; empty in a scene without beams.
struct BeamTables {
  Rows3<const double> x;
  Kokkos::View<BeamParameters*, MemSpace> parameters;

  BeamTables(const Model& model, const State& state) : x(state.x), parameters(model.others->beams.parameters) {}
};

/// Unit vector along element e of chunk c, from its first node to its second.
KOKKOS_INLINE_FUNCTION Vector3<double> find_beam_axis(const BeamTables& tables, const ElementChunks& chunks, int c,
                                                      int e) {
  Vector3<double> ends[2];
  for (int k = 0; k < 2; ++k) {
    const int n = chunks.slots_to_nodes(number_corner_slot(chunks, c, e - chunks.first_element(c), k));
    ends[k] = {tables.x(n, 0), tables.x(n, 1), tables.x(n, 2)};
  }
  const Vector3<double> line = ends[1] - ends[0];
  return (1 / norm(line)) * line;
}

/// The mean normal stress of the section, in space axes: xx, yy, zz, xy, yz, zx.
KOKKOS_INLINE_FUNCTION void read_beam_stress(const BeamTables& tables, const ElementChunks& chunks, int c, int e,
                                             const ElementRecord& record, double* row) {
  const double stress = record[BeamRecord::forces] / tables.parameters(chunks.parameters(c)).area;
  const Vector3<double> a = find_beam_axis(tables, chunks, c, e);
  row[0] = stress * a.x * a.x;
  row[1] = stress * a.y * a.y;
  row[2] = stress * a.z * a.z;
  row[3] = stress * a.x * a.y;
  row[4] = stress * a.y * a.z;
  row[5] = stress * a.z * a.x;
}

/// The largest plastic strain of the fibres.
KOKKOS_INLINE_FUNCTION double read_beam_plastic_strain(const ElementChunks& chunks, int c,
                                                       const ElementRecord& record) {
  double largest = 0;
  for (int i = 0; i < chunks.points(c); ++i) largest = larger(largest, record.get(BeamRecord::fibres + 2 * i + 1));
  return largest;
}

}  // namespace percuss
