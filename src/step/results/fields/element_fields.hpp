#pragma once
// Reads element records for output: stress in space axes and what follows from it.

#include <vector>

#include "src/step/model/model.hpp"
#include "src/step/model/state.hpp"

namespace percuss {

/// Elements that are read: all, or some in their order.
class ElementChoice {
 public:
  ElementChoice() = default;
  /// some: outlives this.
  ElementChoice(const std::vector<int>& some) : some_(&some) {}
  /// None: all.
  const std::vector<int>* some() const { return some_; }

 private:
  const std::vector<int>* some_ = nullptr;
};

/// Cauchy stress in space axes, one row of xx, yy, zz, xy, yz, zx an element. Bulk viscosity is not part of it. Of an
/// element that fails it is the share that is left, of a dead one zero.
/// Stresses of elements; for a shell the mean across its thickness, for a beam the force along it over its area.
std::vector<double> find_stresses(const Model& model, const State& state, const ElementChoice& of = {});

/// A point across the thickness of a shell: a number from 0, the lowest, or one of these.
struct ShellPoint {
  static constexpr int mean = -1, highest = -2, lowest = 0;
};

/// Stresses at one point of shells, 0 where they have no such point; of hexahedra as find_stresses().
std::vector<double> find_point_stresses(const Model& model, const State& state, int point,
                                        const ElementChoice& of = {});

/// Thickness of shells; 0 of others.
std::vector<double> find_thicknesses(const Model& model, const State& state, const ElementChoice& of = {});

/// Normal forces of beams, positive where they pull; 0 of others.
std::vector<double> find_axial_forces(const Model& model, const State& state, const ElementChoice& of = {});

/// Forces and moments of the sections of beams, in their axes: the force along, then across in y and z; the torque,
/// then the moments about y and z. 0 of others.
std::vector<double> find_section_forces(const Model& model, const State& state, const ElementChoice& of = {});
std::vector<double> find_section_moments(const Model& model, const State& state, const ElementChoice& of = {});
/// All six.
std::vector<double> find_section_results(const Model& model, const State& state, const ElementChoice& of);

/// Equivalent plastic strain an element, the mean of its points, of a beam the largest; 0 where the material has none.
std::vector<double> find_plastic_strains(const Model& model, const State& state, const ElementChoice& of = {});

/// Plastic strains at one point of shells, 0 where they have no such point; of hexahedra as find_plastic_strains().
std::vector<double> find_point_plastic_strains(const Model& model, const State& state, int point,
                                               const ElementChoice& of = {});

/// A named scalar of the materials' history an element, at several points their mean, or of shells that at one point; 0
/// where the material has none.
std::vector<double> find_history(const Model& model, const State& state, HistoryScalar name,
                                 const ElementChoice& of = {}, int point = ShellPoint::mean);

/// State variable `number`, from 0, of a user's law, the mean of the points of an element; 0 where there is none.
std::vector<double> find_state_variables(const Model& model, const State& state, int number,
                                         const ElementChoice& of = {});

/// 1 for elements that have any force, 0 for dead ones.
std::vector<double> find_alive(const Model& model, const State& state, const ElementChoice& of = {});

/// How far an element has come on the way to failure by plastic strain, time at yield or Johnson-Cook's damage, the
/// largest of these; 1: failed, by whatever criterion.
std::vector<double> find_damage(const Model& model, const State& state, const ElementChoice& of = {});

/// One point of an element, from 0: across the thickness of a shell from the lowest, or of 2x2x2 of a hexahedron like
/// its corners. 0 where it has no such point.
struct ElementPoint {
  int element = 0, point = 0;
};
std::vector<double> find_point_stress(const Model& model, const State& state, const ElementPoint& of);
double find_point_plastic_strain(const Model& model, const State& state, const ElementPoint& of);

/// How many points an element has.
int count_points(const Model& model, int element);

/// Pressure -tr(stress)/3 of each row.
std::vector<double> find_pressures(const std::vector<double>& stresses);

/// von Mises equivalent stress of each row.
std::vector<double> find_von_mises(const std::vector<double>& stresses);

}  // namespace percuss
