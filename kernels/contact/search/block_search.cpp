#include "kernels/contact/search/block_search.hpp"

#include <vector>

#include "kernels/contact/search/kd_order.hpp"
#include "kernels/core/host_copy.hpp"
#include "kernels/core/index_lists.hpp"
#include "kernels/core/prefetch.hpp"
#include "kernels/core/view_copy.hpp"

namespace percuss {
namespace {

/// Sixteen points: in float, in double, by name, and as the rule sees them.
template <class Rule>
struct PointBlock {
  PointLanes points;
  FloatBox bounds;
  typename Rule::Lanes lanes;
  double x[block_size][3];
  int name[block_size];
  int count = 0;
};

KOKKOS_INLINE_FUNCTION bool is_in_box(const double* x, const Boxes& boxes, int i) {
  return x[0] >= boxes(i, 0) && x[1] >= boxes(i, 1) && x[2] >= boxes(i, 2) && x[0] <= boxes(i, 3) &&
         x[1] <= boxes(i, 4) && x[2] <= boxes(i, 5);
}

/// Boxes to be looked at by a block of points, and which of its points they concern. Looked at in one go, stage by
/// stage, each of which leaves out some boxes without an unpredictable branch.
struct BoxQueue {
  static constexpr int capacity = 256;
  int count = 0;
  int place[capacity];
  std::uint32_t points[capacity];
};

/// The chain of hits of one block of points, and how many each point has.
struct HitChain {
  int chunk = -1, used = 0;
  LaneNumbers hits{};
};

/// Finds the hits of one block of points.
template <class Rule>
struct BlockWalk {
  Rule rule;
  PointQuery query;
  BlockTree tree;
  Array<const int> names, rows;  // of points, in their order
  Array<HitChunk> chunks;
  Array<int> num_chunks, first_chunk, tests, count;
  int num_points = 0, capacity = 0;
  double origin[3] = {0, 0, 0};

  KOKKOS_INLINE_FUNCTION void load(int b, PointBlock<Rule>& block) const {
    const int left = num_points - b * block_size;
    block.count = left < block_size ? left : block_size;
    const int first = b * block_size;
    for (int lane = 0; lane < block_size; ++lane) {
      const int place = first + (lane < block.count ? lane : 0), row = rows(place);
      block.name[lane] = names(place);
      rule.load(lane, block.name[lane], row, block.lanes);
      for (int axis = 0; axis < 3; ++axis) block.x[lane][axis] = query.x(row, axis);
    }
    for (int axis = 0; axis < 3; ++axis) {
      float low = to_float(block.x[0][axis], origin[axis]), high = low;
      for (int lane = 0; lane < block_size; ++lane) {
        const float x = block.points.x[axis][lane] = to_float(block.x[lane][axis], origin[axis]);
        low = x < low ? x : low;
        high = x > high ? x : high;
      }
      block.bounds.low[axis] = low;
      block.bounds.high[axis] = high;
    }
  }

  /// Asks for box i, and for what the rule reads of it.
  KOKKOS_FORCEINLINE_FUNCTION void fetch_box(int i) const {
    fetch_ahead(reinterpret_cast<const double(*)[6]>(&query.boxes(i, 0)));
    rule.fetch(query.box_names(i));
  }

  /// Asks for the places of a block of points, if there is one.
  KOKKOS_FORCEINLINE_FUNCTION void fetch_points(int b) const {
    for (int i = b * block_size; i < num_points && i < (b + 1) * block_size; ++i)
      fetch_ahead(reinterpret_cast<const double(*)[3]>(&query.x(rows(i), 0)));
  }

  /// Writes a hit to the chain of block b; without room for it the chunk is only counted.
  KOKKOS_FORCEINLINE_FUNCTION void append(int b, const BlockHit& hit, HitChain& chain) const {
    if (chain.chunk < 0 || chain.used == HitChunk::capacity) {
      const int fresh = Kokkos::atomic_fetch_add(&num_chunks(0), 1);
      if (fresh < capacity) {
        chunks(fresh).next = chain.chunk;
        first_chunk(b) = fresh;
      }
      chain.chunk = fresh;
      chain.used = 0;
    }
    if (chain.chunk < capacity) {
      chunks(chain.chunk).hit[chain.used] = hit;
      chunks(chain.chunk).count = chain.used + 1;
    }
    ++chain.used;
    count_lanes(hit.points, chain.hits);
  }

  /// Bits of those of `points` that lie in a box, checked in double precision; only those on a face of it in float are
  /// in doubt.
  KOKKOS_INLINE_FUNCTION std::uint32_t check_exactly(const PointBlock<Rule>& block, int place,
                                                     std::uint32_t points) const {
    std::uint32_t in_doubt = points & ~find_lanes_inside<false>(block.points, tree.boxes(place).box);
    for (; in_doubt != 0; in_doubt &= in_doubt - 1) {
      const int lane = find_lowest_bit(in_doubt);
      if (!is_in_box(block.x[lane], query.boxes, tree.order(place))) points &= ~(std::uint32_t{1} << lane);
    }
    return points;
  }

  /// Looks at the boxes of the queue and empties it.
  KOKKOS_FORCEINLINE_FUNCTION void drain(int b, const PointBlock<Rule>& block, BoxQueue& queue, HitChain& chain) const {
    const std::uint32_t in_use = (std::uint32_t{1} << block.count) - 1;
    int near = 0, allowed = 0;
    for (int i = 0; i < queue.count; ++i) {
      const int place = queue.place[i];
      queue.place[near] = place;
      queue.points[near] = find_lanes_inside(block.points, tree.boxes(place).box) & in_use;
      near += queue.points[near] != 0 ? 1 : 0;
    }
    for (int i = 0; i < near; ++i) {
      const int place = queue.place[i];
      queue.place[allowed] = place;
      queue.points[allowed] = rule.find_allowed(block.lanes, tree.boxes(place).mark, queue.points[i]);
      allowed += queue.points[allowed] != 0 ? 1 : 0;
    }
    for (int i = 0; i < allowed; ++i) {
      const int place = queue.place[i];
      const BlockHit hit{tree.boxes(place).mark.name, check_exactly(block, place, queue.points[i])};
      if (hit.points != 0) append(b, hit, chain);
    }
    queue.count = 0;
  }

  KOKKOS_INLINE_FUNCTION void operator()(int b, std::int64_t& found) const {
    PointBlock<Rule> block;
    load(b, block);
    fetch_points(b + 1);
    first_chunk(b) = -1;
    BoxQueue queue;
    HitChain chain;
    int tested = 0;
    visit_meeting_boxes(tree, block.bounds, [&](int first, std::uint32_t mask) {
      tested += count_bits(mask);
      for (; mask != 0; mask &= mask - 1) {
        const int place = first + find_lowest_bit(mask);
        fetch_ahead(&tree.boxes(place));
        queue.place[queue.count++] = place;
      }
      if (queue.count > BoxQueue::capacity - block_size) drain(b, block, queue, chain);
    });
    drain(b, block, queue, chain);
    for (int lane = 0; lane < block.count; ++lane) {
      count(block.name[lane]) = chain.hits.lane[lane];
      found += chain.hits.lane[lane];
    }
    tests(b) = tested;
  }
};

/// Whether two lists of names are the same.
bool are_equal(const WorkSpace& space, const Array<const int>& a, const Array<const int>& b) {
  if (a.extent(0) != b.extent(0)) return false;
  if (a.data() == b.data()) return true;
  int differ = 0;
  parallel_reduce(
      "contact::compare_names", RangeOf(space, 0, static_cast<int>(a.extent(0))),
      KOKKOS_LAMBDA(int i, int& d) { d |= a(i) != b(i) ? 1 : 0; }, Kokkos::BOr<int>(differ));
  return differ == 0;
}

Array<int> copy(const Array<const int>& from, const char* label) {
  const Array<int> to(Kokkos::view_alloc(std::string(label), Kokkos::WithoutInitializing), from.extent(0));
  copy_values(to, from);
  return to;
}

std::vector<int> order_points(const PointQuery& query) {
  const auto x = to_host(query.x);
  const auto points = to_host(query.points);
  const std::size_t count = query.point_names.extent(0);
  std::vector<double> places(3 * count);
  for (std::size_t i = 0; i < count; ++i)
    for (std::size_t axis = 0; axis < 3; ++axis) places[3 * i + axis] = x(points(i), axis);
  return find_kd_order(places);
}

std::vector<int> order_boxes(const PointQuery& query) {
  const auto box = to_host(query.boxes);
  const std::size_t count = query.box_names.extent(0);
  std::vector<double> centres(3 * count);
  for (std::size_t i = 0; i < count; ++i)
    for (std::size_t axis = 0; axis < 3; ++axis) centres[3 * i + axis] = 0.5 * (box(i, axis) + box(i, axis + 3));
  return find_kd_order(centres);
}

/// Whether the order of a list of so many items is one of theirs, whatever their names are now.
bool is_usable(const NumberedOrder& of, std::size_t count) {
  return of.numbers.size() == count && of.order.size() == count;
}

/// Puts points and boxes in order, each anew where it has none that continues. Returns whether both continued.
bool order_blocks(const PointQuery& query, BlockScratch& scratch) {
  const std::size_t num_points = query.point_names.extent(0), num_boxes = query.box_names.extent(0);
  const bool points_go_on = !scratch.is_worn && is_usable(scratch.point_order, num_points);
  const bool boxes_go_on = !scratch.is_worn && is_usable(scratch.box_order, num_boxes);
  std::vector<int>& point_order = scratch.point_order.order;
  std::vector<int>& box_order = scratch.box_order.order;
  if (!points_go_on) point_order = order_points(query);
  if (!boxes_go_on) box_order = order_boxes(query);
  std::vector<int> names(num_points), rows(num_points);
  const auto point_names = to_host(query.point_names), points = to_host(query.points);
  for (std::size_t i = 0; i < num_points; ++i) {
    names[i] = point_names(static_cast<std::size_t>(point_order[i]));
    rows[i] = points(static_cast<std::size_t>(point_order[i]));
  }
  scratch.names = to_view("contact::ordered_names", names);
  scratch.rows = to_view("contact::ordered_rows", rows);
  set_order(box_order, scratch.tree);
  scratch.point_names = copy(query.point_names, "contact::ordered_points");
  scratch.point_rows = copy(query.points, "contact::rows_of_points");
  scratch.box_names = copy(query.box_names, "contact::ordered_boxes");
  scratch.is_other = false;
  return points_go_on && boxes_go_on;
}

/// Brings the boxes of this search into the order of the tree, with what the rule asks of them.
template <class Rule>
void sort_boxes(const WorkSpace& space, const BlockWalk<Rule>& walk) {
  const BlockWalk<Rule> w = walk;
  parallel_for(
      "contact::sort_boxes", RangeOf(space, 0, w.tree.num_boxes), KOKKOS_LAMBDA(int place) {
        constexpr int ahead = 8;  // what lies in the order of the query is asked for before it is needed
        if (place + ahead < w.tree.num_boxes) w.fetch_box(w.tree.order(place + ahead));
        const int i = w.tree.order(place);
        TreeBox& box = w.tree.boxes(place);
        for (int axis = 0; axis < 3; ++axis) {
          box.box.low[axis] = to_float(w.query.boxes(i, axis), w.origin[axis]);
          box.box.high[axis] = to_float(w.query.boxes(i, axis + 3), w.origin[axis]);
        }
        box.mark = w.rule.mark(w.query.box_names(i));
      });
}

/// Walks all blocks, again with more room if the hits do not fit; returns the number of pairs.
template <class Rule>
std::int64_t walk_blocks(const WorkSpace& space, BlockWalk<Rule>& walk, int blocks, std::int64_t max_pairs,
                         BlockScratch& scratch) {
  for (;;) {
    walk.chunks = scratch.chunks;
    walk.capacity = static_cast<int>(scratch.chunks.extent(0));
    set_values(space, scratch.num_chunks, 0);
    std::int64_t found = 0;
    parallel_reduce("contact::block_search", RangeOf(space, 0, blocks), walk, found);
    const int wanted = read_value(space, scratch.num_chunks, 0);
    if (wanted <= walk.capacity || found > max_pairs) return found;
    reserve(scratch.chunks, wanted);
  }
}

double sum_tests(const WorkSpace& space, const Array<const int>& tests, int blocks) {
  double sum = 0;  // whole numbers: exact
  parallel_reduce(
      "contact::sum_tests", RangeOf(space, 0, blocks), KOKKOS_LAMBDA(int b, double& s) { s += tests(b); }, sum);
  return sum;
}

/// Sorts values[first, last), no two of which are equal. Most runs are short: each value is placed by its rank (the
/// number of smaller values), without unpredictable branches.
KOKKOS_INLINE_FUNCTION void sort_distinct(const Array<int>& values, int first, int last) {
  const int n = last - first;
  if (n < 2) return;
  if (n > block_size) {
    sort_run(values, first, last);
    return;
  }
  LaneNumbers numbers;
  const std::uint32_t in_use = (std::uint32_t{1} << n) - 1;
  for (int i = 0; i < block_size; ++i) numbers.lane[i] = i < n ? values(first + i) : 0;
  for (int i = 0; i < n; ++i)
    values(first + count_bits(find_lanes_below(numbers, numbers.lane[i]) & in_use)) = numbers.lane[i];
}

/// Turns the chains of hits into lists by point.
template <class Rule>
void list_hits(const WorkSpace& space, const BlockWalk<Rule>& walk, int blocks, CandidateList& list) {
  const Array<int> offset = list.offset, face = list.face, count = walk.count;
  const int num_names = walk.query.num_names;
  int total = 0;
  parallel_scan(
      "contact::hit_offsets", RangeOf(space, 0, num_names + 1),
      KOKKOS_LAMBDA(int n, int& place, bool final_pass) {
        if (final_pass) offset(n) = place;
        if (n < num_names) place += count(n);
      },
      total);
  const BlockWalk<Rule> w = walk;
  parallel_for(
      "contact::list_hits", RangeOf(space, 0, blocks), KOKKOS_LAMBDA(int b) {
        const int left = w.num_points - b * block_size, lanes = left < block_size ? left : block_size;
        int name[block_size], next[block_size];
        for (int lane = 0; lane < lanes; ++lane) {
          name[lane] = w.names(b * block_size + lane);
          next[lane] = offset(name[lane]);
        }
        for (int c = w.first_chunk(b); c >= 0; c = w.chunks(c).next)
          for (int i = 0; i < w.chunks(c).count; ++i) {
            const BlockHit hit = w.chunks(c).hit[i];
            for (std::uint32_t points = hit.points; points != 0; points &= points - 1)
              face(next[find_lowest_bit(points)]++) = hit.box;
          }
        for (int lane = 0; lane < lanes; ++lane) sort_distinct(face, offset(name[lane]), next[lane]);
      });
}

}  // namespace

void identify(const std::vector<std::int64_t>& points, const std::vector<std::int64_t>& boxes, BlockScratch& scratch) {
  const auto take = [&](const std::vector<std::int64_t>& now, NumberedOrder& of) {
    if (now == of.numbers) return;
    of.order = carry_order(of.order, of.numbers, now);
    of.numbers = now;
    scratch.is_other = true;
  };
  take(points, scratch.point_order);
  take(boxes, scratch.box_order);
}

template <class Rule>
std::int64_t find_hits_by_blocks(const WorkSpace& space, const PointQuery& query, const Rule& rule,
                                 std::int64_t max_pairs, BlockScratch& scratch, CandidateList& list) {
  constexpr double wear = 1.5;  // tests after which a new order pays, over those that it begins with
  const int num_points = static_cast<int>(query.point_names.extent(0));
  const bool is_known =
      !scratch.is_worn && !scratch.is_other && are_equal(space, query.point_names, scratch.point_names) &&
      are_equal(space, query.points, scratch.point_rows) && are_equal(space, query.box_names, scratch.box_names);
  const bool goes_on = is_known || order_blocks(query, scratch);
  const int blocks = (num_points + block_size - 1) / block_size;
  reserve(scratch.first_chunk, blocks);
  reserve(scratch.tests, blocks);
  reserve(scratch.count, query.num_names);
  reserve(list.offset, query.num_names + 1);
  BlockWalk<Rule> walk{rule, query, scratch.tree, scratch.names, scratch.rows, {}, {}, {}, {}, {}};
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
  sort_boxes(space, walk);
  refit(space, scratch.tree);
  set_values(space, scratch.count, 0);
  const std::int64_t found = walk_blocks(space, walk, blocks, max_pairs, scratch);
  if (found > max_pairs) return found;
  const double tests = sum_tests(space, walk.tests, blocks);
  if (!goes_on) scratch.first_tests = tests;
  scratch.is_worn = tests > wear * scratch.first_tests;
  list.num_pairs = static_cast<int>(found);
  reserve(list.face, list.num_pairs);
  list_hits(space, walk, blocks, list);
  return found;
}

template std::int64_t find_hits_by_blocks(const WorkSpace&, const PointQuery&, const NodeFaceRule&, std::int64_t,
                                          BlockScratch&, CandidateList&);
template std::int64_t find_hits_by_blocks(const WorkSpace&, const PointQuery&, const EdgePairRule&, std::int64_t,
                                          BlockScratch&, CandidateList&);

}  // namespace percuss
