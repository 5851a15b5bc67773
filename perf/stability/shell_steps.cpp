// Prints how near the step bound of random shells comes to that of their largest eigenvalue, a JSON line a family of
// shapes: shell_steps TRIALS. perf/stability/run drives it.

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>

#include "tests/kernels/shell/exact_step.hpp"

namespace percuss {

namespace {

using test::RandomShapes;
using test::StepShare;

/// Corners are moved by up to `distortion` of the edges, those of every other element out of the plane by up to `warp`
/// of the shorter one.
struct Family {
  const char* name;
  double stretch, offset;
  RandomShapes shapes;
};

const Family families[] = {
    {"corners moved by 0.2", 1, 0, {}},
    {"the same, to 20 times as long as wide", 1, 0, {0.2, 0.2, 20}},
    {"the same, thick: 0.1 to 2 edges", 1, 0, {0.2, 0.2, 5, 0.1, 2}},
    {"the same, shrunk to half", 0.5, 0, {}},
    {"the same, stretched to twice", 2, 0, {}},
    {"the same, stretched to four times", 4, 0, {}},
    {"the same, section off the mesh by t / 2", 1, 1, {}},
    {"strongly warped: by half an edge", 1, 0, {0.2, 0.5}},
    {"squares, corners moved by 0.8, flat", 1, 0, {0.8, 0, 1.01}},
    {"squares, corners moved by 0.8, out of the plane too", 1, 0, {0.8, 0.8, 1.01}},
    {"oblongs, corners moved by 1.3: edges cross", 1, 0, {1.3, 0.3, 3}},
    {"corners moved by 0.5, out of the plane by 1.5", 1, 0, {0.5, 1.5, 2}},
};

void print_share(const char* name, StepShare& share) {
  std::sort(share.all.begin(), share.all.end());
  const auto at = [&](double part) { return share.all[static_cast<std::size_t>(part * double(share.all.size() - 1))]; };
  fmt::print(
      "{{\"family\": \"{}\", \"count\": {}, \"concave\": {}, \"least\": {}, \"percentile\": {}, \"median\": {}, "
      "\"largest\": {}}}\n",
      name, share.all.size(), share.concave, share.least, at(0.01), at(0.5), share.largest);
}

void print_families(int trials) {
  test::Random random(41);
  for (const Family& family : families) {
    StepShare share = test::compare_steps(random, trials, family.stretch, family.offset, family.shapes);
    print_share(family.name, share);
  }
  StepShare triangles = test::compare_triangle_steps(random, trials, 1);
  print_share("triangles, angles down to 5 degrees", triangles);
}

}  // namespace

}  // namespace percuss

int main(int argc, char** argv) {
  if (argc != 2) {
    fmt::print(stderr, "shell_steps TRIALS\n");
    return 2;
  }
  percuss::print_families(std::max(1, std::atoi(argv[1])));
  return 0;
}
