#pragma once
// Mean stresses of the columns of a thick shell while it flows.
//
// The strain across of a column is that of the element's corners, which its neighbours share. Flow keeps the volume, so
// that each of the four columns would ask for a strain across of its own where the strain within a layer differs from
// column to column, as in layers of a stack that bends: the element would lock. Where an element flows, the mean
// stresses of its columns therefore lose what they differ by, at the rate of the radial return with the bulk modulus in
// place of the shear modulus (docs/theory_shells.md).

#include "kernels/core/long_sum.hpp"
#include "kernels/element/hex8/hex8_full.hpp"

namespace percuss {

/// How a column has flowed in a step: means over its points.
template <class T>
struct ColumnFlow {
  T stress = T(0), change = T(0);  // mean stress at n+1, and what the step has added to it
  T elastic = T(0);                // share of the points that have not flowed
  T share = T(0);                  // PlasticReturn::share
  T growth = T(0);                 // what a stress of 1 at n+1 adds to ThickSums::work
  T volume = T(0);                 // of the middle layer

  /// weight: of the point, of 2 a column. before, after: its stress; own_growth: that of its volume; returned: its
  /// PlasticReturn::share.
  PERCUSS_FORCE_INLINE void take(const T& weight, const Symmetric3<T>& before, const Symmetric3<T>& after,
                                 const T& own_growth, const T& returned) {
    const T half = number<T>(0.5) * weight, sixth = number<T>(1.0 / 6.0) * weight;
    stress = stress + sixth * trace(after);
    change = change + sixth * (trace(after) - trace(before));
    elastic = elastic + select(returned < T(1), T(0), half);
    share = share + half * returned;
    growth = growth + weight * own_growth;
  }
};

/// Adds to the mean stress of a point, in some lanes.
template <class T, class Mask, class State>
PERCUSS_FORCE_INLINE void shift_mean_stress(int p, const Mask& lanes, const T& shift, State& state) {
  for (T Symmetric3<T>::*const normal : {&Symmetric3<T>::xx, &Symmetric3<T>::yy, &Symmetric3<T>::zz}) {
    T& stress = state.stress[p].*normal;
    if constexpr (is_short<T>) {
      T& rest = state.stress_rest[p].*normal;
      T sum = stress, left = rest;
      add_to(sum, left, shift);
      stress = select(lanes, sum, stress);
      rest = select(lanes, left, rest);
    } else {
      stress = select(lanes, stress + shift, stress);
    }
  }
}

/// The difference of a column's mean stress from that of the element, and what the step has added to it.
template <class T>
struct StressDifference {
  T now, added;
};

template <class T>
PERCUSS_FORCE_INLINE void find_differences(const ColumnFlow<T> (&columns)[4], StressDifference<T> (&differences)[4]) {
  T stress(0), change(0), volume(0);
  for (const ColumnFlow<T>& column : columns) {
    stress = stress + column.volume * column.stress;
    change = change + column.volume * column.change;
    volume = volume + column.volume;
  }
  stress = stress / volume;
  change = change / volume;
  for (int c = 0; c < 4; ++c) differences[c] = {columns[c].stress - stress, columns[c].change - change};
}

/// Lets the mean stresses of the columns fade towards each other where an element flows: D(n+1) = fading (D(n) + kept
/// dD). Of what the step adds, the elastic share of the column that flows most is kept, but all of it where it lessens
/// the differences: to take less would give energy. Returns what that adds to ThickSums::work.
template <int N, class T, class Material, class State>
PERCUSS_FORCE_INLINE T join_columns(const SolidParameters<Material>& par, const ColumnFlow<T> (&columns)[4],
                                    State& state) {
  T share(1), elastic(1), work(0);
  for (const ColumnFlow<T>& column : columns) {
    share = smaller(share, column.share);
    elastic = smaller(elastic, column.elastic);
  }
  const auto flows = share < T(1);
  if (!any(flows)) return work;
  StressDifference<T> differences[4];
  find_differences(columns, differences);
  T grows(0);
  for (int c = 0; c < 4; ++c)
    grows = grows + columns[c].volume * (differences[c].now - differences[c].added) * differences[c].added;
  const T kept = select(grows < T(0), T(1), elastic);
  const double bulk_over_shear = par.mu > 0 ? 2.0 / 3.0 + par.lambda / par.mu : 1;
  const T fading = larger(T(0), T(1) - number<T>(bulk_over_shear) * (T(1) - share));
  for (int c = 0; c < 4; ++c) {
    const auto& [now, added] = differences[c];
    const T shift = select(flows, fading * (now - (T(1) - kept) * added) - now, T(0));
    work = work + shift * columns[c].growth;
    for (int l = 0; l < N; ++l) shift_mean_stress(4 * l + c, flows, shift, state);
  }
  return work;
}

}  // namespace percuss
