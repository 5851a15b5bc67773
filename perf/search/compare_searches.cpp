// Nanoseconds of a core a contact node and search by both methods, everything counted but the capture boxes: ranking or
// refitting, the query, the list sorted by node and face. Arguments: numbers of nodes (default 40000 250000 1000000);
// names of surfaces (default all); --blocks: only blocks whose order is kept, many times, for profiles.
//
// On a device: nanoseconds that pass, instead of those of a core. "kept": the order of the last search serves, as it
// nearly always does in a run; "ordered": a new order is made.

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <string>
#include <vector>

#include "kernels/contact/search/capture_boxes.hpp"
#include "kernels/contact/search/pair_search.hpp"
#include "kernels/core/host_copy.hpp"
#include "perf/search/clouds.hpp"

namespace percuss::perf {
namespace {

struct Scene {
  ContactSurface surface;
  Rows3<const double> x;
  Boxes boxes;
};

Array<const int> count_up(std::size_t n) {
  std::vector<int> numbers(n);
  for (std::size_t i = 0; i < n; ++i) numbers[i] = static_cast<int>(i);
  return to_view("perf::numbers", numbers);
}

/// All nodes and faces may touch; boxes reach 0.15 beyond their faces.
Scene make_scene(const Cloud& cloud) {
  Scene scene;
  ContactSurface& s = scene.surface;
  s.num_nodes = static_cast<int>(cloud.nodes.size());
  s.num_faces = static_cast<int>(cloud.faces.size());
  s.nodes = s.searched_nodes = count_up(cloud.nodes.size());
  s.searched_faces = count_up(cloud.faces.size());
  s.face_corners = to_rows("perf::corners", cloud.faces);
  s.face_backs = to_rows("perf::backs", std::vector<std::array<int, 4>>(cloud.faces.size(), {-1, -1, -1, -1}));
  s.node_class = to_view("perf::node_class", std::vector<int>(cloud.nodes.size(), 0));
  s.face_class = to_view("perf::face_class", std::vector<int>(cloud.faces.size(), 0));
  s.pair_friction = to_view("perf::friction", std::vector<double>{0});
  scene.x = to_rows("perf::x", cloud.nodes);
  scene.boxes = Boxes("perf::boxes", cloud.faces.size());
  const SurfaceMotion at_rest{scene.x, scene.x, 0};
  const Rows4<const int> corners = s.face_corners;
  const Boxes boxes = scene.boxes;
  Kokkos::parallel_for(
      "perf::boxes", Range(0, s.num_faces), KOKKOS_LAMBDA(const int f) {
        constexpr double reach = 0.15;
        bound_face(
            at_rest, [&](int i) { return corners(f, i); }, reach, boxes, f);
      });
  Kokkos::fence();
  return scene;
}

/// Median of the times of some searches [ns a node]. prepare: what happens before each.
template <class Prepare>
double time_searches(const Scene& scene, std::size_t repeats, SearchScratch& scratch, CandidateList& list,
                     const Prepare& prepare) {
  std::vector<double> times;
  for (std::size_t i = 0; i <= repeats; ++i) {
    prepare();
    const std::clock_t start = std::clock();
    const Kokkos::Timer timer;
    find_candidate_pairs(ExecSpace(), scene.surface, {scene.x, scene.boxes}, 1'000'000'000, scratch, list);
    Kokkos::fence();
    const double passed =
        1e9 * (is_host_memory ? static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC : timer.seconds());
    if (i > 0) times.push_back(passed / scene.surface.num_nodes);
  }
  std::nth_element(times.begin(), times.begin() + static_cast<std::ptrdiff_t>(repeats / 2), times.end());
  return times[repeats / 2];
}

/// Blocks alone.
void report_blocks(const std::string& name, int num_nodes) {
  const Scene scene = make_scene(make_cloud(name, num_nodes));
  SearchScratch blocks;
  CandidateList list;
  const double kept = time_searches(scene, 8'000'000 / static_cast<std::size_t>(num_nodes), blocks, list, [] {});
  std::printf("%-8s %9d %11.1f %14s %7.1f\n", name.c_str(), scene.surface.num_nodes,
              static_cast<double>(list.num_pairs) / scene.surface.num_nodes, "", kept);
}

void report(const std::string& name, int num_nodes) {
  const Scene scene = make_scene(make_cloud(name, num_nodes));
  SearchScratch lists, blocks;
  lists.method = SearchMethod::points_in_box;
  CandidateList list;
  constexpr std::size_t repeats = 5;
  const double by_lists = time_searches(scene, repeats, lists, list, [] {});
  const int pairs = list.num_pairs;
  const double kept = time_searches(scene, repeats, blocks, list, [] {});
  const double ordered = time_searches(scene, repeats, blocks, list, [&] { blocks.blocks.is_worn = true; });
  std::printf("%-8s %9d %11.1f %14.1f %7.1f %9.1f %s\n", name.c_str(), scene.surface.num_nodes,
              static_cast<double>(pairs) / scene.surface.num_nodes, by_lists, kept, ordered,
              pairs == list.num_pairs ? "" : "NOT THE SAME PAIRS");
  std::fflush(stdout);
}

}  // namespace
}  // namespace percuss::perf

int main(int argc, char** argv) {
  Kokkos::ScopeGuard kokkos(argc, argv);
  const std::vector<std::string>& all = percuss::perf::cloud_names();
  std::vector<std::string> names;
  std::vector<int> sizes;
  bool only_blocks = false;
  for (int i = 1; i < argc; ++i) {
    const std::string argument = argv[i];
    if (argument == "--blocks") {
      only_blocks = true;
    } else if (std::find(all.begin(), all.end(), argument) != all.end()) {
      names.push_back(argument);
    } else if (const int nodes = std::atoi(argv[i]); nodes > 0) {
      sizes.push_back(nodes);
    } else {
      std::fprintf(stderr, "compare_searches: error: '%s' is no number of nodes and none of", argv[i]);
      for (const std::string& name : all) std::fprintf(stderr, " %s", name.c_str());
      std::fprintf(stderr, "\n");
      return 2;
    }
  }
  if (sizes.empty()) sizes = {40'000, 250'000, 1'000'000};
  std::printf("%-8s %9s %11s %14s %7s %9s\n", "cloud", "nodes", "pairs/node", "points-in-box", "kept", "ordered");
  for (const std::string& name : names.empty() ? all : names)
    for (const int nodes : sizes)
      only_blocks ? percuss::perf::report_blocks(name, nodes) : percuss::perf::report(name, nodes);
  return 0;
}
