#pragma once
// A scalar that counts what is done with it: the physics of the elements, which is templated on its scalar, tells its
// own number of operations.

#include <cmath>

namespace percuss {

/// Floating-point operations so far. Comparisons, choices and changes of sign are free.
struct OperationCounts {
  long add = 0;  // and subtract
  long multiply = 0;
  long divide = 0;
  long root = 0;
  long all() const { return add + multiply + divide + root; }
};

struct Counted {
  static inline OperationCounts counts;
  double value = 0;

  constexpr Counted() = default;
  constexpr explicit Counted(double v) : value(v) {}
};

inline Counted operator+(Counted a, Counted b) { return ++Counted::counts.add, Counted(a.value + b.value); }
inline Counted operator-(Counted a, Counted b) { return ++Counted::counts.add, Counted(a.value - b.value); }
inline Counted operator*(Counted a, Counted b) { return ++Counted::counts.multiply, Counted(a.value * b.value); }
inline Counted operator*(double a, Counted b) { return Counted(a) * b; }
inline Counted operator/(Counted a, Counted b) { return ++Counted::counts.divide, Counted(a.value / b.value); }
inline Counted operator-(Counted a) { return Counted(-a.value); }
inline bool operator<(Counted a, Counted b) { return a.value < b.value; }
inline bool operator>(Counted a, Counted b) { return a.value > b.value; }
inline Counted select(bool mask, Counted yes, Counted no) { return mask ? yes : no; }
inline Counted larger(Counted a, Counted b) { return a < b ? b : a; }
inline Counted smaller(Counted a, Counted b) { return b < a ? b : a; }
inline Counted square_root(Counted a) { return ++Counted::counts.root, Counted(std::sqrt(a.value)); }

}  // namespace percuss
