#pragma once
// The records of elements on the host, in which files of the start set stresses and histories.

#include <cstdint>
#include <string>
#include <utility>

#include "kernels/core/host_copy.hpp"
#include "kernels/core/view_copy.hpp"
#include "kernels/element/element_records.hpp"
#include "kernels/material/elastic.hpp"
#include "kernels/material/pressure/pressed_fluid.hpp"
#include "src/index.hpp"
#include "src/mesh/mesh.hpp"
#include "src/step/model/state.hpp"

namespace percuss {

/// Values that a row of a file gives an element, or a layer of one; null: absent.
struct StartRow {
  std::int64_t layer = 0;  // from 1, the lowest; 0: all of the element
  const double* stress = nullptr;
  const double* plastic_strain = nullptr;
  const double* temperature = nullptr;
};

/// An element and its elasticity.
struct StartElement {
  int chunk;
  int element;
  LameConstants moduli;
};

/// Where the elements of a chunk keep what files give them.
struct RecordLayout {
  int points;
  int layer_size;                                    // of shells; 0: these are none
  int plastic_strain, temperature, internal_energy;  // places of the first point's, -1: the material has none
  int log_volume;                                    // place of it, which tetrahedra, wedges and pyramids keep; -1
};

class StartRecords {
 public:
  /// All of it outlives this.
  StartRecords(const Mesh& mesh, const Model& model, const State& state);

  /// Sets what a row says of an element that begins without it. energy: out, what the stress adds to that of the
  /// element. Returns why the element cannot have it, as "has no layer 4 (it has 3)"; empty: it can.
  std::string write(const StartElement& of, const StartRow& row, double& energy);

  /// Sets the state of a fluid under pressure, which the first evaluation takes its stress from. Returns what the
  /// pressure has added to the internal energy of the element.
  double press(const StartElement& of, const PressedFluid& pressed);

  void give_back(const State& state) const { copy_values(state.elements, records_); }

 private:
  /// Lanes past the last element of a chunk repeat it: so many records have the element's values.
  struct Lanes {
    int first = 0, last = 0;
  };
  Lanes find_lanes(const StartElement& of) const;
  std::string set_history(const StartElement& of, HistoryScalar name, std::int64_t layer, double value);
  double set_solid_stress(const StartElement& of, const double* stress);
  std::string set_shell_stress(const StartElement& of, const StartRow& row, double& energy);
  std::string find_obstacle(const StartElement& of, const StartRow& row) const;
  void set(const StartElement& of, int place, double value);
  double get(const StartElement& of, int place) const;
  const RecordLayout& layout(const StartElement& of) const { return layouts_(at(of.chunk)); }

  const Mesh& mesh_;
  HostChunks chunks_;
  HostMirror<Array<RecordLayout>> layouts_;
  decltype(to_host(std::declval<const Array<Real>&>())) records_;
};

}  // namespace percuss
