#pragma once
// A ply of a laminate: orthotropic and linear until it fails, fibres and matrix each in tension or compression.
//
// Criteria of Hashin (1980) in plane stress; with one strength for both shears they are those of Chang and Chang
// (1987). That of the matrix may be Tsai and Wu's (1971). Damage softens linearly with the strain, by an energy per
// area of crack whatever the size of the element (Matzenmiller, Lubliner and Taylor 1995; Lapczyk and Hurtado 2007).
// Formulas: docs/theory_shells.md.

#include "kernels/material/laws/orthotropic.hpp"
#include "kernels/shell/plane_stress.hpp"

namespace percuss {

/// What a ply remembers of a layer's point, in its own axes but for the last row: the direction of the reference axis
/// of the laminate in the element's frame.
struct PlyHistory {
  static constexpr int strain = 1;  // 11, 22, 2 12; place 0 is the plastic strain of plies of metal
  static constexpr int fibre_tension = 4, fibre_compression = 5, matrix_tension = 6, matrix_compression = 7;
  static constexpr int fibre_damage = 8, matrix_damage = 9;  // the larger of the two
  static constexpr int cosine = 10, sine = 11;
  static constexpr int count = 12;
};

/// In the plane of a layer, by two directions at right angles and 2 xy of strains.
template <class T>
struct PlaneDirection {
  T cosine, sine;

  PERCUSS_FORCE_INLINE void turn_strain(const T (&e)[3], T (&own)[3]) const {
    const T cc = cosine * cosine, ss = sine * sine, cs = cosine * sine;
    own[0] = cc * e[0] + ss * e[1] + cs * e[2];
    own[1] = ss * e[0] + cc * e[1] - cs * e[2];
    own[2] = T(2) * cs * (e[1] - e[0]) + (cc - ss) * e[2];
  }
  PERCUSS_FORCE_INLINE void turn_stress(const T (&s)[3], T (&own)[3]) const {
    const T cc = cosine * cosine, ss = sine * sine, cs = cosine * sine;
    own[0] = cc * s[0] + ss * s[1] + T(2) * cs * s[2];
    own[1] = ss * s[0] + cc * s[1] - T(2) * cs * s[2];
    own[2] = cs * (s[1] - s[0]) + (cc - ss) * s[2];
  }
  PERCUSS_FORCE_INLINE PlaneDirection back() const { return {cosine, T(0) - sine}; }
};

/// The step of a layer's point of a laminate. along_x, along_y: the gradient operator of the element
/// (ShellGeometry::b1, b2).
template <class T>
struct PlyStep {
  T dt;
  T along_x[2], along_y[2];

  /// How far the element reaches along a direction, over which a crack across it opens: 2 over the sum of the corners'
  /// gradients (Oliver 1989); of a rectangle its side.
  PERCUSS_FORCE_INLINE T find_length(const T& x, const T& y) const {
    const T first = x * along_x[0] + y * along_y[0], second = x * along_x[1] + y * along_y[1];
    return T(1) / (larger(first, -first) + larger(second, -second));
  }
};

/// What a ply tells the element.
template <class T>
struct PlyResponse {
  LayerResponse<T> layer;
  T left_before, left;  // by damage at n and n+1
};

/// Damage variables that act now, each between 0 and 1.
template <class T>
struct ActingDamage {
  T fibre, matrix, shear;
};

struct OrthotropicPly {
  static constexpr double brittle_growth = 0.02;   // growth of damage in a step where no energy spreads it
  static constexpr double least_softening = 1.02;  // last strain over that of the first damage
  double e1 = 0, e2 = 0, nu12 = 0, nu21 = 0, g12 = 0;
  double across_1 = 0, across_2 = 0;  // nu13 / E1, nu23 / E2
  double fibre_tension = 0, fibre_compression = 0, matrix_tension = 0, matrix_compression = 0, shear = 0;  // 0: none
  double transverse_shear = 0, shear_in_fibre_tension = 0;
  double energy[4] = {};  // of cracks: fibres in tension and compression, matrix likewise
  bool can_fail = false, is_tsai_wu = false;

  static OrthotropicPly make(const OrthotropicConstants& c) {
    OrthotropicPly ply;
    ply.e1 = c.moduli[0];
    ply.e2 = c.moduli[1];
    ply.nu12 = c.poissons_ratios[0];
    ply.nu21 = ply.nu12 * ply.e2 / ply.e1;
    ply.g12 = c.shear_moduli[0];
    ply.across_1 = c.poissons_ratios[2] / ply.e1;
    ply.across_2 = c.poissons_ratios[1] / ply.e2;
    ply.fibre_tension = c.fibre_tension;
    ply.fibre_compression = c.fibre_compression;
    ply.matrix_tension = c.matrix_tension;
    ply.matrix_compression = c.matrix_compression;
    ply.shear = c.shear;
    ply.transverse_shear = c.transverse_shear > 0 ? c.transverse_shear : c.shear;
    ply.shear_in_fibre_tension = c.shear_in_fibre_tension;
    const double energies[4] = {c.fibre_tension_energy, c.fibre_compression_energy, c.matrix_tension_energy,
                                c.matrix_compression_energy};
    for (int k = 0; k < 4; ++k) ply.energy[k] = energies[k];
    ply.can_fail = c.has_strength();
    ply.is_tsai_wu = c.is_tsai_wu;
    return ply;
  }

  static OrthotropicPly make(const PlaneElasticity& elastic) {
    OrthotropicPly ply;
    ply.e1 = ply.e2 = elastic.youngs_modulus;
    ply.nu12 = ply.nu21 = elastic.poissons_ratio;
    ply.g12 = elastic.shear_modulus;
    ply.across_1 = ply.across_2 = elastic.poissons_ratio / elastic.youngs_modulus;
    return ply;
  }

  /// Advances the stress xx, yy, xy, in the frame of the element, by the strain increment xx, yy, 2 xy.
  template <class T>
  PERCUSS_FORCE_INLINE PlyResponse<T> update(const PlaneDirection<T>& axes, T (&stress)[3], T* history,
                                             const T (&de)[3], const PlyStep<T>& step) const {
    T own[3], before[3], after[3];
    axes.turn_strain(de, own);
    axes.turn_stress(stress, before);
    T* const strain = history + PlyHistory::strain;
    for (int k = 0; k < 3; ++k) strain[k] = strain[k] + own[k];
    PlyResponse<T> response{{T(0), T(1), T(1)}, T(1), T(1)};
    ActingDamage<T> damage{T(0), T(0), T(0)};
    if (can_fail) damage = advance_damage(strain, history, axes, step, response);
    find_stress(strain, damage, after);
    axes.back().turn_stress(after, stress);
    response.layer.across = T(0) - T(across_1) * (after[0] - before[0]) - T(across_2) * (after[1] - before[1]);
    return response;
  }

 private:
  /// Stress by the compliance whose 11, 22 and 12 are divided by what damage leaves.
  template <class T>
  PERCUSS_FORCE_INLINE void find_stress(const T* e, const ActingDamage<T>& damage, T (&s)[3]) const {
    const T fibre = T(1) - damage.fibre, matrix = T(1) - damage.matrix;
    const T over = T(1) / (T(1) - fibre * matrix * T(nu12 * nu21));
    s[0] = fibre * T(e1) * over * (e[0] + matrix * T(nu21) * e[1]);
    s[1] = matrix * T(e2) * over * (e[1] + fibre * T(nu12) * e[0]);
    s[2] = (T(1) - damage.shear) * T(g12) * e[2];
  }

  /// The load factor over that of failure of a x^2 + b x = 1.
  template <class T>
  PERCUSS_FORCE_INLINE static T find_load(const T& a, const T& b) {
    return T(0.5) * (b + square_root(b * b + T(4) * a));
  }

  /// Where damage grows: load 1 at its begin, and the energy of the element's volume there.
  template <class T>
  struct Mode {
    T load, energy;
    T length;  // over which its crack opens
  };

  template <class T>
  PERCUSS_FORCE_INLINE static T find_square(const T& stress, double strength) {
    return strength > 0 ? T(1 / (strength * strength)) * stress * stress : T(0);
  }

  /// s: stress over what damage leaves.
  template <class T, class Mask>
  PERCUSS_FORCE_INLINE Mode<T> find_fibre_mode(const T (&s)[3], const Mask& pulls, const T& length) const {
    const T in_shear = T(shear_in_fibre_tension) * find_square(s[2], shear);
    const T tension = fibre_tension > 0 ? find_square(s[0], fibre_tension) + in_shear : T(0);
    const T load = square_root(select(pulls, tension, find_square(s[0], fibre_compression)));
    const T of_shear = select(pulls, T(shear_in_fibre_tension), T(0));
    return {load, T(0.5 / e1) * s[0] * s[0] + T(0.5 / g12) * of_shear * s[2] * s[2], length};
  }

  template <class T, class Mask>
  PERCUSS_FORCE_INLINE Mode<T> find_matrix_mode(const T (&s)[3], const Mask& pulls, const T& length) const {
    const T in_shear = find_square(s[2], shear);
    const T tension = find_square(s[1], matrix_tension) + in_shear;
    T square = in_shear, linear = T(0);
    if (is_tsai_wu) {  // in tension and compression alike
      const double both = matrix_tension * matrix_compression;
      square = square + T(1 / both) * s[1] * s[1];
      linear = T((matrix_compression - matrix_tension) / both) * s[1];
    } else if (matrix_compression > 0) {
      const double across = 0.5 * matrix_compression / transverse_shear;
      square = square + find_square(s[1], 2 * transverse_shear);
      linear = T((across * across - 1) / matrix_compression) * s[1];
    }
    const T failing = find_load(square, linear),
            load = is_tsai_wu ? failing : select(pulls, square_root(tension), failing);
    return {load, T(0.5 / e2) * s[1] * s[1] + T(0.5 / g12) * s[2] * s[2], length};
  }

  /// The damage of a mode that is active; that of others stays.
  template <class T, class Mask>
  PERCUSS_FORCE_INLINE T grow(const T& damage, const Mask& active, const Mode<T>& mode, double crack) const {
    const auto grows = active && mode.load > T(1);
    const T load = select(grows, mode.load, T(1));
    const T at_begin = select(grows, mode.energy, T(1)) / (load * load);
    const T last = T(crack) / (at_begin * mode.length);  // strain at the end over that at the begin
    const auto brittle = last < T(least_softening);
    const T softening = select(brittle, T(least_softening), last);
    const T target = smaller(softening / (softening - T(1)) * (T(1) - T(1) / load), T(1));
    const T reached = select(brittle, smaller(target, damage + T(brittle_growth)), target);
    return select(grows, larger(damage, reached), damage);
  }

  /// The larger damage of fibres and of matrix, and what they leave of what belongs to no ply.
  template <class T>
  PERCUSS_FORCE_INLINE static void summarize(T* history, PlyResponse<T>& response) {
    using H = PlyHistory;
    const T before = (T(1) - history[H::fibre_damage]) * (T(1) - history[H::matrix_damage]);
    history[H::fibre_damage] = larger(history[H::fibre_tension], history[H::fibre_compression]);
    history[H::matrix_damage] = larger(history[H::matrix_tension], history[H::matrix_compression]);
    const T left = (T(1) - history[H::fibre_damage]) * (T(1) - history[H::matrix_damage]);
    response.left_before = before;
    response.left = response.layer.secant = left;
    response.layer.share = select(left < before, left / larger(before, T(1e-300)), T(1));
  }

  template <class T>
  PERCUSS_FORCE_INLINE ActingDamage<T> advance_damage(const T* e, T* history, const PlaneDirection<T>& axes,
                                                      const PlyStep<T>& step, PlyResponse<T>& response) const {
    using H = PlyHistory;
    // Whether fibres and matrix pull: by their stresses, each of which has the damage of the other.
    ActingDamage<T> old{T(0), T(0), T(0)};
    auto fibres_pull = e[0] + T(nu21) * e[1] >= T(0), matrix_pulls = e[1] + T(nu12) * e[0] >= T(0);
    const auto find_fibre = [&] {
      return select(fibres_pull, history[H::fibre_tension], history[H::fibre_compression]);
    };
    const auto find_matrix = [&] {
      return select(matrix_pulls, history[H::matrix_tension], history[H::matrix_compression]);
    };
    for (int pass = 0; pass < 2; ++pass) {
      old.fibre = find_fibre();
      matrix_pulls = e[1] + (T(1) - old.fibre) * T(nu12) * e[0] >= T(0);
      old.matrix = find_matrix();
      fibres_pull = e[0] + (T(1) - old.matrix) * T(nu21) * e[1] >= T(0);
    }
    old.fibre = find_fibre();
    const T fibre = T(1) - old.fibre, matrix = T(1) - old.matrix;
    const T over = T(1) / (T(1) - fibre * matrix * T(nu12 * nu21));
    const T s[3] = {T(e1) * over * (e[0] + matrix * T(nu21) * e[1]), T(e2) * over * (e[1] + fibre * T(nu12) * e[0]),
                    T(g12) * e[2]};
    const auto moves = step.dt > T(0);
    const Mode<T> of_fibres = find_fibre_mode(s, fibres_pull, step.find_length(axes.cosine, axes.sine));
    const Mode<T> of_matrix = find_matrix_mode(s, matrix_pulls, step.find_length(-axes.sine, axes.cosine));
    const auto grow_at = [&](int place, const auto& active, const Mode<T>& mode, double crack) {
      history[place] = grow(history[place], moves && active, mode, crack);
    };
    grow_at(H::fibre_tension, fibres_pull, of_fibres, energy[0]);
    grow_at(H::fibre_compression, !fibres_pull, of_fibres, energy[1]);
    grow_at(H::matrix_tension, matrix_pulls, of_matrix, energy[2]);
    grow_at(H::matrix_compression, !matrix_pulls, of_matrix, energy[3]);
    summarize(history, response);
    ActingDamage<T> now{find_fibre(), find_matrix(), T(0)};
    now.shear = T(1) - (T(1) - history[H::fibre_tension]) * (T(1) - history[H::fibre_compression]) *
                           (T(1) - history[H::matrix_tension]) * (T(1) - history[H::matrix_compression]);
    return now;
  }
};

}  // namespace percuss
