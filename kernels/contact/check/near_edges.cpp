#include "kernels/contact/check/near_edges.hpp"

#include "kernels/contact/check/edge_check.hpp"
#include "kernels/contact/geometry/contact_limits.hpp"
#include "kernels/contact/search/capture_boxes.hpp"
#include "kernels/core/index_lists.hpp"

namespace percuss {
namespace {

/// Room for round-off.
constexpr double near_slack = 1e-3;

/// Boxes of the edges in pairs that hold their boxes over any step before the travel is used up, as update_edges()
/// makes these: an end moves by one travel, and the edge grows by two.
void bound_ways(const WorkSpace& space, const EdgeSurface& surface, const SurfaceMotion& motion, const EdgePairs& all,
                double travel, const Boxes& boxes) {
  const EdgeSurface s = surface;
  const SurfaceMotion at_rest{motion.x, motion.v, 0};
  const Array<const int> list = all.edges;
  const double way = (1 + contact_limits::capture) * travel;
  parallel_for(
      "contact::bound_edge_ways", RangeOf(space, 0, all.num_edges), KOKKOS_LAMBDA(int i) {
        const int e = list(i);
        const double reach =
            (1 + near_slack) * (0.5 * find_edge_reach(s.ends, at_rest.x, e) + find_edge_offset(s, e) + way);
        bound_edge(s.ends, at_rest, e, {reach, reach, reach}, boxes);
      });
}

}  // namespace

void list_edges(const WorkSpace& space, int num_edges, const Array<int>& mark, EdgePairs& pairs) {
  const Array<const int> a = pairs.a, b = pairs.b;
  parallel_for(
      "contact::clear_edge_marks", RangeOf(space, 0, num_edges), KOKKOS_LAMBDA(int e) { mark(e) = 0; });
  parallel_for(
      "contact::mark_near_edges", RangeOf(space, 0, pairs.num_pairs), KOKKOS_LAMBDA(int i) {
        Kokkos::atomic_fetch_or(&mark(a(i)), 1);
        Kokkos::atomic_fetch_or(&mark(b(i)), 1);
      });
  const Array<const int> marked = mark;
  pairs.num_edges = list_where(
      space, num_edges, [marked] KOKKOS_FUNCTION(int e) { return marked(e) != 0; }, pairs.edges);
}

bool list_near_edges(const WorkSpace& space, const EdgeCheckInputs& inputs, const EdgePairs& all,
                     const NearLimits& limits, NearEdgeScratch& scratch, EdgePairs& near) {
  const EdgeSurface& surface = inputs.surface;
  if (static_cast<int>(scratch.boxes.extent(0)) < surface.num_edges)
    scratch.boxes = Boxes("contact::near_edge_boxes", static_cast<std::size_t>(surface.num_edges));
  reserve(scratch.kept, all.num_pairs);
  bound_ways(space, surface, inputs.motion, all, limits.travel, scratch.boxes);
  const Boxes boxes = scratch.boxes;
  const Array<const int> a = all.a, b = all.b;
  near.num_pairs = list_where(
      space, all.num_pairs, [=] KOKKOS_FUNCTION(int i) { return do_boxes_meet(boxes, a(i), b(i)); }, scratch.kept);
  if (near.num_pairs > limits.most_pairs) return false;
  reserve(near.a, near.num_pairs);
  reserve(near.b, near.num_pairs);
  reserve(near.edges, surface.num_edges);
  reserve(scratch.mark, surface.num_edges);
  const Array<const int> kept = scratch.kept;
  const Array<int> near_a = near.a, near_b = near.b;
  parallel_for(
      "contact::keep_near_edges", RangeOf(space, 0, near.num_pairs), KOKKOS_LAMBDA(int i) {
        near_a(i) = a(kept(i));
        near_b(i) = b(kept(i));
      });
  list_edges(space, surface.num_edges, scratch.mark, near);
  return true;
}

}  // namespace percuss
