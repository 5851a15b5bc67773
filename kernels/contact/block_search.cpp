#include "kernels/contact/block_search.hpp"

#include <vector>

#include "kernels/contact/index_lists.hpp"
#include "kernels/contact/kd_order.hpp"
#include "kernels/core/host_copy.hpp"

namespace percuss {
namespace {

/// Sixteen points: in float as boxes without extent, in double, and by name.
struct PointBlock {
  BoxBlock boxes;
  FloatBox bounds;
  double x[block_size][3];
  int name[block_size];
  int count = 0;
};

KOKKOS_INLINE_FUNCTION bool is_in_box(const double* x, const Boxes& boxes, int i) {
  return x[0] >= boxes(i, 0) && x[1] >= boxes(i, 1) && x[2] >= boxes(i, 2) && x[0] <= boxes(i, 3) &&
         x[1] <= boxes(i, 4) && x[2] <= boxes(i, 5);
}

/// Finds the hits of one block of points.
template <class Rule>
struct BlockWalk {
  Rule rule;
  PointQuery query;
  Boxes boxes;
  BlockTree tree;
  Array<const int> order;
  Array<HitChunk> chunks;
  Array<int> num_chunks, first_chunk, tests, count;
  int num_points = 0, capacity = 0;
  double origin[3] = {0, 0, 0};

  KOKKOS_INLINE_FUNCTION void load(int b, PointBlock& block) const {
    const int left = num_points - b * block_size;
    block.count = left < block_size ? left : block_size;
    for (int lane = 0; lane < block_size; ++lane) {
      const int place = order(b * block_size + (lane < block.count ? lane : 0)), row = query.points(place);
      for (int axis = 0; axis < 3; ++axis) {
        block.x[lane][axis] = query.x(row, axis);
        block.boxes.low[axis][lane] = block.boxes.high[axis][lane] = to_float(block.x[lane][axis], origin[axis]);
      }
      block.name[lane] = query.point_names(place);
    }
    block.bounds = bound_lanes(block.boxes);
  }

  /// Writes a hit to the chain of block b; without room for it the chunk is only counted.
  KOKKOS_INLINE_FUNCTION void append(int b, const BlockHit& hit, int& chunk, int& used) const {
    if (chunk < 0 || used == HitChunk::capacity) {
      const int fresh = Kokkos::atomic_fetch_add(&num_chunks(0), 1);
      if (fresh < capacity) {
        chunks(fresh).next = chunk;
        first_chunk(b) = fresh;
      }
      chunk = fresh;
      used = 0;
    }
    if (chunk < capacity) {
      chunks(chunk).hit[used] = hit;
      chunks(chunk).count = used + 1;
    }
    ++used;
  }

  KOKKOS_INLINE_FUNCTION void operator()(int b, std::int64_t& found) const {
    PointBlock block;
    load(b, block);
    first_chunk(b) = -1;
    const std::uint32_t in_use = (std::uint32_t{1} << block.count) - 1;
    int chunk = -1, used = 0, tested = 0, hits[block_size] = {};
    visit_meeting_boxes(tree, block.bounds, [&](int place, const FloatBox& box) {
      ++tested;
      std::uint32_t near = find_meeting_lanes(block.boxes, box) & in_use;
      if (near == 0) return;
      const int i = tree.order(place), name = query.box_names(i);
      BlockHit hit{name, 0};
      for (; near != 0; near &= near - 1) {
        const int lane = find_lowest_bit(near);
        if (!is_in_box(block.x[lane], boxes, i) || !rule(block.name[lane], name)) continue;
        hit.points |= std::uint32_t{1} << lane;
        ++hits[lane];
      }
      if (hit.points != 0) append(b, hit, chunk, used);
    });
    for (int lane = 0; lane < block.count; ++lane) {
      count(block.name[lane]) = hits[lane];
      found += hits[lane];
    }
    tests(b) = tested;
  }
};

/// Whether two lists of names are the same.
template <class Space>
bool are_equal(const Space& space, const Array<const int>& a, const Array<const int>& b) {
  if (a.extent(0) != b.extent(0)) return false;
  if (a.data() == b.data()) return true;
  int differ = 0;
  Kokkos::parallel_reduce(
      "contact::compare_names", RangeOf<Space>(space, 0, static_cast<int>(a.extent(0))),
      KOKKOS_LAMBDA(int i, int& d) { d |= a(i) != b(i) ? 1 : 0; }, Kokkos::BOr<int>(differ));
  return differ == 0;
}

Array<int> copy(const Array<const int>& from, const char* label) {
  const Array<int> to(Kokkos::view_alloc(std::string(label), Kokkos::WithoutInitializing), from.extent(0));
  Kokkos::deep_copy(to, from);
  return to;
}

/// Orders points and boxes anew.
void order_blocks(const PointQuery& query, const Boxes& boxes, BlockScratch& scratch) {
  const auto x = to_host(query.x);
  const auto points = to_host(query.points);
  const auto box = to_host(boxes);
  const std::size_t num_points = query.point_names.extent(0), num_boxes = query.box_names.extent(0);
  std::vector<double> places(3 * num_points), centres(3 * num_boxes);
  for (std::size_t i = 0; i < num_points; ++i)
    for (std::size_t axis = 0; axis < 3; ++axis) places[3 * i + axis] = x(points(i), axis);
  for (std::size_t i = 0; i < num_boxes; ++i)
    for (std::size_t axis = 0; axis < 3; ++axis) centres[3 * i + axis] = 0.5 * (box(i, axis) + box(i, axis + 3));
  std::vector<int> order;
  find_kd_order(places, order);
  scratch.order = to_view("contact::point_order", order);
  find_kd_order(centres, order);
  set_order(order, scratch.tree);
  scratch.point_names = copy(query.point_names, "contact::ordered_points");
  scratch.box_names = copy(query.box_names, "contact::ordered_boxes");
}

/// Walks all blocks, again with more room if the hits do not fit; returns the number of pairs.
template <class Space, class Rule>
std::int64_t walk_blocks(const Space& space, BlockWalk<Rule>& walk, int blocks, std::int64_t max_pairs,
                         BlockScratch& scratch) {
  for (;;) {
    walk.chunks = scratch.chunks;
    walk.capacity = static_cast<int>(scratch.chunks.extent(0));
    Kokkos::deep_copy(space, scratch.num_chunks, 0);
    std::int64_t found = 0;
    Kokkos::parallel_reduce("contact::block_search", RangeOf<Space>(space, 0, blocks), walk, found);
    const int wanted = read_value(space, scratch.num_chunks, 0);
    if (wanted <= walk.capacity || found > max_pairs) return found;
    reserve(scratch.chunks, wanted);
  }
}

template <class Space>
double sum_tests(const Space& space, const Array<const int>& tests, int blocks) {
  double sum = 0;  // whole numbers: exact
  Kokkos::parallel_reduce(
      "contact::sum_tests", RangeOf<Space>(space, 0, blocks), KOKKOS_LAMBDA(int b, double& s) { s += tests(b); }, sum);
  return sum;
}

/// Turns the chains of hits into lists by point.
template <class Space, class Rule>
void list_hits(const Space& space, const BlockWalk<Rule>& walk, int blocks, CandidateList& list) {
  const Array<int> offset = list.offset, face = list.face, count = walk.count;
  const int num_names = walk.query.num_names;
  Kokkos::parallel_scan(
      "contact::hit_offsets", RangeOf<Space>(space, 0, num_names + 1),
      KOKKOS_LAMBDA(int n, int& place, bool final_pass) {
        if (final_pass) offset(n) = place;
        if (n < num_names) place += count(n);
      });
  const BlockWalk<Rule> w = walk;
  Kokkos::parallel_for(
      "contact::list_hits", RangeOf<Space>(space, 0, blocks), KOKKOS_LAMBDA(int b) {
        const int left = w.num_points - b * block_size, lanes = left < block_size ? left : block_size;
        int name[block_size], next[block_size];
        for (int lane = 0; lane < lanes; ++lane) {
          name[lane] = w.query.point_names(w.order(b * block_size + lane));
          next[lane] = offset(name[lane]);
        }
        for (int c = w.first_chunk(b); c >= 0; c = w.chunks(c).next)
          for (int i = 0; i < w.chunks(c).count; ++i) {
            const BlockHit hit = w.chunks(c).hit[i];
            for (std::uint32_t points = hit.points; points != 0; points &= points - 1)
              face(next[find_lowest_bit(points)]++) = hit.box;
          }
        for (int lane = 0; lane < lanes; ++lane) sort_run(face, offset(name[lane]), next[lane]);
      });
}

}  // namespace

template <class Space, class Rule>
std::int64_t find_hits_in_blocks(const Space& space, const PointQuery& query, const Boxes& boxes, const Rule& rule,
                                 std::int64_t max_pairs, BlockScratch& scratch, CandidateList& list) {
  constexpr double wear = 1.5;  // tests after which a new order pays, over those that it begins with
  const int num_points = static_cast<int>(query.point_names.extent(0));
  const bool is_new = scratch.is_worn || !are_equal<Space>(space, query.point_names, scratch.point_names) ||
                      !are_equal<Space>(space, query.box_names, scratch.box_names);
  if (is_new) order_blocks(query, boxes, scratch);
  const int blocks = (num_points + block_size - 1) / block_size;
  reserve(scratch.first_chunk, blocks);
  reserve(scratch.tests, blocks);
  reserve(scratch.count, query.num_names);
  reserve(list.offset, query.num_names + 1);
  BlockWalk<Rule> walk{rule, query, boxes, scratch.tree, scratch.order, {}, {}, {}, {}, {}};
  walk.num_chunks = scratch.num_chunks;
  walk.first_chunk = scratch.first_chunk;
  walk.tests = scratch.tests;
  walk.count = scratch.count;
  walk.num_points = num_points;
  if (num_points > 0) {
    const int row = read_value(space, query.points, 0);
    const auto first = to_host(Kokkos::subview(query.x, row, Kokkos::ALL()));
    for (std::size_t axis = 0; axis < 3; ++axis) walk.origin[axis] = first(axis);
  }
  refit(space, boxes, walk.origin, scratch.tree);
  Kokkos::deep_copy(space, scratch.count, 0);
  const std::int64_t found = walk_blocks(space, walk, blocks, max_pairs, scratch);
  if (found > max_pairs) return found;
  const double tests = sum_tests(space, walk.tests, blocks);
  if (is_new) scratch.first_tests = tests;
  scratch.is_worn = tests > wear * scratch.first_tests;
  list.num_pairs = static_cast<int>(found);
  reserve(list.face, list.num_pairs);
  list_hits<Space>(space, walk, blocks, list);
  return found;
}

#define PERCUSS_INSTANTIATE(Space)                                                                              \
  template std::int64_t find_hits_in_blocks(const Space&, const PointQuery&, const Boxes&, const NodeFaceRule&, \
                                            std::int64_t, BlockScratch&, CandidateList&);                       \
  template std::int64_t find_hits_in_blocks(const Space&, const PointQuery&, const Boxes&, const EdgePairRule&, \
                                            std::int64_t, BlockScratch&, CandidateList&);
PERCUSS_INSTANTIATE(ExecSpace)
#if defined(PERCUSS_SMALL_SPACE)
PERCUSS_INSTANTIATE(SmallSpace)
#endif
#undef PERCUSS_INSTANTIATE

}  // namespace percuss
