#pragma once
// A beam or a truss over one step: from the motion of its nodes to what they exert on it, as a pure function.
//
// Place in the step: (1.3) to (1.5) of the paper. Positions are at n+1, velocities and spins at n+1/2. Rates are taken
// on the geometry of n+1/2, forces act on that of n+1. Formulas and their sources: docs/theory_line_elements.md.

#include "kernels/beam/beam_fibres.hpp"
#include "kernels/beam/beam_limits.hpp"
#include "kernels/beam/fibre_laws.hpp"

namespace percuss {

/// Numbers that are the same for all elements of a part.
struct BeamParameters {
  BeamStiffness stiffness;
  double area = 0;
  double polar_square = 0;  // rotary inertia about the beam over mass [length^2]
  bool bends = false;       // else a truss
  FibreLaw law;             // of linear hardening; its Young's modulus also of other laws
  CalledFibreLaw called;    // in place of it
  BeamFibres fibres;        // none: the section is elastic
  BeamLimits limits;        // of an element that can fail
};

/// Scalars of each fibre besides its stress and plastic strain.
KOKKOS_INLINE_FUNCTION int count_more_history(const BeamParameters& par) {
  return par.called.history_count > 1 ? par.called.history_count - 1 : 0;
}

/// What an element remembers between steps. In the record follow the stress and plastic strain of each fibre, then what
/// else each remembers.
struct BeamState {
  double mass = 0, gyration_square = 0;  // gyration_square: rotary inertia across over mass; both constant
  Vector3<double> e2{};                  // the axis y of the section, at n
  BeamForces<double> forces{};           // at n
};

/// The motion of an element's nodes in a step.
struct BeamMotion {
  BeamEnds<double> x;     // at n+1
  BeamEnds<double> v, w;  // velocities and spins at n+1/2
  double dt = 0;
};

struct BeamResult {
  double work = 0;         // that the step put into the element [energy]
  double stable_step = 0;  // bound for the next step, without the deck's scale
  double length = 0;       // at n+1
  BeamNodalForces<double> on{};
};

KOKKOS_INLINE_FUNCTION double find_section_work(const BeamForces<double>& f, const BeamRates<double>& strain) {
  return f.normal * strain.stretch + f.shear_y * strain.shear_y + f.shear_z * strain.shear_z + f.torque * strain.twist +
         f.moment_y * strain.curvature_y + f.moment_z * strain.curvature_z;
}

/// The fibres of a law that is called; adds to the forces.
KOKKOS_INLINE_FUNCTION void advance_called_fibres(const BeamParameters& par, const BeamRates<double>& strain, double dt,
                                                  double* fibres, BeamForces<double>& f) {
  const int count = par.fibres.count, more = count_more_history(par);
  const FibreStep step{par.law.youngs_modulus, par.called.density, dt};
  visit_any_of(par.called.law, FibreLaws(), [&](const auto& law) {
    for (int i = 0; i < count; ++i) {
      double* const rest = fibres + 2 * count + more * i;
      double history[most_fibre_history] = {fibres[2 * i + 1]};
      for (int k = 0; k < more; ++k) history[1 + k] = rest[k];
      if (dt > 0) {
        const double along = find_fibre_strain(par.fibres.fibre[i], strain);
        fibres[2 * i] = advance_fibre(law, step, fibres[2 * i], along, history);
      }
      fibres[2 * i + 1] = history[0];
      for (int k = 0; k < more; ++k) rest[k] = history[1 + k];
      add_fibre(par.fibres.fibre[i], fibres[2 * i], f);
    }
  });
}

/// The fibres of linear hardening; adds to the forces.
KOKKOS_INLINE_FUNCTION void advance_linear_fibres(const BeamParameters& par, const BeamRates<double>& strain,
                                                  double* fibres, BeamForces<double>& f) {
  for (int i = 0; i < par.fibres.count; ++i) {
    double &stress = fibres[2 * i], &plastic_strain = fibres[2 * i + 1];
    const BeamFibre& fibre = par.fibres.fibre[i];
    const FibreState now = par.law.advance({stress, plastic_strain}, find_fibre_strain(fibre, strain));
    stress = now.stress;
    plastic_strain = now.plastic_strain;
    add_fibre(fibre, stress, f);
  }
}

/// fibres: stress and plastic strain of each, then what else each remembers; in and out. Not read without fibres.
KOKKOS_INLINE_FUNCTION BeamForces<double> advance_section(const BeamParameters& par, const BeamForces<double>& before,
                                                          const BeamRates<double>& strain, double dt, double* fibres) {
  BeamForces<double> f = add_elastic(before, par.stiffness, strain);
  if (par.fibres.count == 0) return f;
  f.normal = f.moment_y = f.moment_z = 0;
  if (par.called.history_count > 0)
    advance_called_fibres(par, strain, dt, fibres, f);
  else
    advance_linear_fibres(par, strain, fibres, f);
  if (!par.bends) f.moment_y = f.moment_z = 0;
  return f;
}

KOKKOS_INLINE_FUNCTION double find_beam_step(const BeamParameters& par, const BeamState& state, double length) {
  const double normal = state.forces.normal;
  if (!par.bends) return 2 / std::sqrt(find_truss_eigenvalue(par.stiffness.axial, state.mass, length, normal));
  const BeamInertia inertia{0.5 * state.mass * state.gyration_square, 0.5 * state.mass * par.polar_square};
  return 2 / std::sqrt(find_beam_eigenvalue(par.stiffness, state.mass, inertia, length, normal));
}

/// A truss: the stretch alone.
KOKKOS_INLINE_FUNCTION BeamResult advance_truss(const BeamParameters& par, const BeamMotion& m, BeamState& state,
                                                double* fibres) {
  const double half = 0.5 * m.dt;
  const Vector3<double> end = m.x.second - m.x.first, change = m.v.second - m.v.first, middle = end - half * change;
  const double length = norm(end), middle_square = dot(middle, middle);
  BeamRates<double> strain{};
  strain.stretch = m.dt * dot(middle, change) / middle_square;
  const BeamForces<double> before = state.forces;
  state.forces = advance_section(par, before, strain, m.dt, fibres);
  const double mean = 0.5 * (before.normal + state.forces.normal);
  return {std::sqrt(middle_square) * mean * strain.stretch,
          find_beam_step(par, state, length),
          length,
          {(state.forces.normal / length) * end, {}}};
}

/// Advances the element from n to n+1. With dt = 0 it evaluates forces and step only.
KOKKOS_INLINE_FUNCTION BeamResult advance_beam(const BeamParameters& par, const BeamMotion& m, BeamState& state,
                                               double* fibres) {
  if (!par.bends) return advance_truss(par, m, state, fibres);
  const double half = 0.5 * m.dt;
  const Vector3<double> spin = 0.5 * (m.w.first + m.w.second);
  const BeamFrame<double> middle = find_beam_frame<double>(
      {m.x.first - half * m.v.first, m.x.second - half * m.v.second}, turn_by_spin(state.e2, spin, half));
  const BeamRates<double> rate = find_beam_rates(middle, m.v, m.w);
  const BeamRates<double> strain{m.dt * rate.stretch, m.dt * rate.shear_y,     m.dt * rate.shear_z,
                                 m.dt * rate.twist,   m.dt * rate.curvature_y, m.dt * rate.curvature_z};
  const BeamForces<double> before = state.forces;
  state.forces = advance_section(par, before, strain, m.dt, fibres);
  const BeamFrame<double> end = find_beam_frame(m.x, turn_by_spin(middle.e2, spin, half));
  state.e2 = end.e2;
  const double work = 0.5 * (find_section_work(before, strain) + find_section_work(state.forces, strain));
  return {middle.length * work, find_beam_step(par, state, end.length), end.length,
          find_beam_nodal_forces(end, state.forces)};
}

}  // namespace percuss
