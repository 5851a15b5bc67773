#pragma once
// Curves of a material for several rates, with interpolation between the rates.

#include "kernels/material/material_table.hpp"

namespace percuss {

/// y(x, rate): a curve for each rate, each with its own rows. Rates ascend strictly, and rows in x; there is at least
/// one row at each rate. All rows are in one list.
struct RateCurves {
  static constexpr int most_rates = 12;
  static constexpr int most_rows = 240;  // of all curves together
  int rates = 0;
  int first[most_rates + 1] = {};  // row of each curve; [rates]: the number of rows
  double rate[most_rates] = {};
  double x[most_rows] = {};
  double y[most_rows] = {};
  double lowest = 0;  // y

  template <class T>
  struct Value {
    T y;
    T slope;       // over x
    T rate_slope;  // over the rate; 0 outside the rates
  };

  /// Appends a curve, on the host; rows: a range of [x, y]. There must be room.
  template <class Rows>
  void add_curve(double at_rate, const Rows& rows) {
    int row = first[rates];
    for (const auto& values : rows) {
      x[row] = values[0];
      y[row] = values[1];
      lowest = row == 0 || y[row] < lowest ? y[row] : lowest;
      ++row;
    }
    rate[rates++] = at_rate;
    first[rates] = row;
  }

  /// y of curve k.
  template <class T>
  KOKKOS_INLINE_FUNCTION MaterialTable::Value<T> find_on(int k, const T& at) const {
    return interpolate_rows(x + first[k], y + first[k], first[k + 1] - first[k], at);
  }

  /// y at each lane's x and rate: straight between the curves over the rate, or over its logarithm.
  template <class T>
  KOKKOS_INLINE_FUNCTION Value<T> find(const T& at, const T& at_rate, bool logarithmic) const {
    int k = 0;
    while (k + 1 < rates && !any(at_rate < T(rate[k + 1]))) ++k;  // all lanes are past those before
    MaterialTable::Value<T> low = find_on(k, at);
    Value<T> value{low.y, low.slope, T(0)};
    for (; k + 1 < rates; ++k) {
      const auto past = at_rate > T(rate[k]), beyond = at_rate >= T(rate[k + 1]);
      if (!any(past)) break;
      const MaterialTable::Value<T> high = find_on(k + 1, at);
      const ValueOfRate<T> share = find_share(k, at_rate, logarithmic);
      const T more = high.y - low.y;
      value.y = select(beyond, high.y, select(past, low.y + share.value * more, value.y));
      value.slope =
          select(beyond, high.slope, select(past, low.slope + share.value * (high.slope - low.slope), value.slope));
      value.rate_slope = select(beyond, T(0), select(past, share.slope * more, value.rate_slope));
      low = high;
    }
    return value;
  }

 private:
  template <class T>
  struct ValueOfRate {
    T value, slope;
  };

  /// How far a rate is from rate k to the next.
  template <class T>
  KOKKOS_INLINE_FUNCTION ValueOfRate<T> find_share(int k, const T& at_rate, bool logarithmic) const {
    if (!logarithmic) {
      const double slope = 1 / (rate[k + 1] - rate[k]);
      return {(at_rate - T(rate[k])) * T(slope), T(slope)};
    }
    const double slope = 1 / logarithm(rate[k + 1] / rate[k]);
    const T inside = larger(at_rate, T(rate[k]));
    return {logarithm(inside * T(1 / rate[k])) * T(slope), T(slope) / inside};
  }
};

}  // namespace percuss
