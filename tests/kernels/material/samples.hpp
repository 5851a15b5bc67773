#pragma once
// Constants of every law and equation of state, for the tests that go through all of them. The test of a law provides
// its sample; without one those tests fail.

#include <algorithm>
#include <optional>
#include <stdexcept>
#include <string>

namespace percuss::test {

inline constexpr double sample_density = 2000;

template <class Law>
struct ConstantsOf {
  using Type = Law;
};
template <class Law>
requires requires { typename Law::Constants; }
struct ConstantsOf<Law> {
  using Type = typename Law::Constants;
};

template <class Law>
std::optional<typename ConstantsOf<Law>::Type>& provided_sample() {
  static std::optional<typename ConstantsOf<Law>::Type> sample;
  return sample;
}

/// The law should yield, crush, relax and feel its rate within some hundredths of strain at about 1 / s. Always true.
template <class Law>
bool provide_sample(const typename ConstantsOf<Law>::Type& constants) {
  provided_sample<Law>() = constants;
  return true;
}

/// A law with directions, which are oblique.
template <class Law>
Law with_oblique_axes(Law law) {
  const double first[3] = {1, 0.5, 0.2}, second[3] = {-0.3, 1, 0};
  std::copy(first, first + 3, law.first_axis);
  std::copy(second, second + 3, law.second_axis);
  return law;
}

/// What provide_sample() got. Throws std::logic_error if no test has called it for this law.
template <class Law>
const typename ConstantsOf<Law>::Type& sample() {
  if (!provided_sample<Law>())
    throw std::logic_error(std::string("no sample (") + Law::name + "): call provide_sample() in the test of the law");
  return *provided_sample<Law>();
}

}  // namespace percuss::test
