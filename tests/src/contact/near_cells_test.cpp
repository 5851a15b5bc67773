// Pairs that cells leave out of the check: none that it would have accepted, whatever sheets and bodies do.

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "kernels/contact/search/near_cells.hpp"
#include "src/contact/check/cell_list.hpp"
#include "src/contact/check/check_space.hpp"

namespace percuss::test {
namespace {

/// Two square layers of nodes that face each other, both crooked: shells of half thickness `half`, or the surfaces of
/// solids (half = 0), whose nodes behind are two layers more.
class CrookedLayers {
 public:
  static constexpr int edge = 9, layer = edge * edge, behind = 2 * layer;

  CrookedLayers(double half, unsigned seed) : half_(half), random_(seed) {
    const ContactSurface surface = make_surface();
    std::vector<std::int64_t> numbers(static_cast<std::size_t>(surface.num_faces));
    for (std::size_t f = 0; f < numbers.size(); ++f) numbers[f] = static_cast<std::int64_t>(f);
    for (CheckSpace* check : {&near, &all}) set_surface(surface, numbers, *check);
    boxes_ = Boxes("test::boxes", numbers.size());
    place();
    draw_motion();
  }

  /// Goes on by a step. Candidates are searched for again every 24 steps.
  void advance(int step) {
    if (step % 48 == 0) draw_motion();
    for (int n = 0; n < 2 * behind; ++n) {
      store_row(x, n, load_row(x, n) + load_row(v, n));
      const Point3 p = load_row(x, n);
      const double phase = std::cos(0.05 * step);
      store_row(v, n,
                flight_ + phase * (std::sin(pace_ * p.x + p.y) * waves_[n / layer % 2] + cross(spin_, p)) +
                    draw_point(noise_));
    }
    if (step % 24 == 0) search();
    const SurfaceMotion motion{x, v, 1};
    cells_.update(near.make_inputs(motion), all.candidates);
    near.candidates = cells_.choose(all.candidates);
    check_candidates(motion, near);
    check_candidates(motion, all);
  }

  /// What both checks have found of a node.
  NodeTouches find(const CheckSpace& check, int node) const {
    const CandidateList& list = check.checked_pairs();
    return list.num_pairs > 0 && list.offset(node) < list.offset(node + 1) ? check.touches.by_node(node)
                                                                           : NodeTouches{};
  }

  /// The nodes remember what they touch.
  void remember() {
    for (int n = 0; n < behind; ++n) {
      const NodeTouches touches = find(all, n);
      for (int i = 0; i < contact_limits::max_touches; ++i)
        near.history_face(contact_limits::max_touches * n + i) = all.history_face(contact_limits::max_touches * n + i) =
            i < touches.count ? touches.touch[i].face : -1;
    }
  }

  CheckSpace near, all;

 private:
  double draw(double largest) { return largest * (2 * (static_cast<double>(random_()) / 4294967295.0) - 1); }
  Point3 draw_point(double largest) { return {draw(largest), draw(largest), draw(largest)}; }

  ContactSurface make_surface() const {
    SurfaceLists lists;
    SurfaceShare share;
    for (int n = 0; n < behind; ++n) {
      lists.nodes.push_back(n);
      lists.searched_nodes.push_back(n);
    }
    lists.node_class.assign(lists.nodes.size(), 0);
    for (int k = 0; k < 2; ++k)
      for (int j = 0; j + 1 < edge; ++j)
        for (int i = 0; i + 1 < edge; ++i) {
          const int a = layer * k + edge * j + i, b = a + 1, c = b + edge, d = a + edge;
          const std::array<int, 4> up{a, b, c, d}, down{a, d, c, b};
          if (half_ > 0 || k == 0) add_face(up, k, lists);
          if (half_ > 0 || k == 1) add_face(down, k, lists);
        }
    share.largest_offset = half_;
    share.pair_friction = Array<double>("test::friction", 1);
    return make_contact_surface(lists, share);
  }

  void add_face(const std::array<int, 4>& corners, int k, SurfaceLists& lists) const {
    lists.searched_faces.push_back(static_cast<int>(lists.corners.size()));
    lists.corners.push_back(corners);
    lists.backs.push_back(corners);
    if (half_ == 0)
      for (int& back : lists.backs.back()) back += behind;
    lists.face_class.push_back(0);
    lists.face_body.push_back(k);
    lists.face_offset.push_back(half_);
  }

  /// Wavy layers, and nodes behind them.
  void place() {
    const double gap = 2 * half_ + 0.15, fold = 0.25 + draw(0.2), turn = draw(0.2);
    for (int n = 0; n < behind; ++n) {
      const int k = n / layer, i = n % edge, j = n % layer / edge;
      const double z = k * gap + fold * std::sin(0.9 * i + turn * j);
      const Point3 p = Point3{1.0 * i + 0.4 * k, 1.0 * j + 0.3 * k, z} + draw_point(0.1);
      store_row(x, n, p);
      store_row(x, n + behind, p + Point3{0, 0, k == 0 ? -1.0 : 1.0});
    }
  }

  /// A flight of all, waves and turns to and fro, at a draw of paces.
  void draw_motion() {
    const double pace = std::pow(10.0, -2 - 2 * std::fabs(draw(1)));
    flight_ = draw_point(0.3);
    for (Point3& wave : waves_) wave = pace * draw_point(1);
    spin_ = 0.2 * pace * draw_point(1);
    noise_ = 0.02 * pace * std::fabs(draw(1));
    pace_ = 0.5 + std::fabs(draw(1));
  }

  void search() {
    constexpr double margin = 1;
    const SmallSpace space;
    const ContactSurface& s = all.surface;
    bound_faces(space, {s.face_corners, s.offsets.largest > 0 ? offsets() : Array<const double>()}, {x, v, 1}, margin,
                boxes_);
    find_candidate_pairs(space, s, {x, boxes_}, 1'000'000, scratch_, all.candidates);
    list_concerned(space, s, scratch_.concerned, all.candidates);
    cells_.forget();
  }

  Array<const double> offsets() const {
    Array<double> reach("test::reach", static_cast<std::size_t>(near.surface.num_faces));
    Kokkos::deep_copy(reach, 3 * half_);
    return reach;
  }

  double half_;
  std::mt19937 random_;
  Rows3<double> x = Rows3<double>("test::x", 2 * behind), v = Rows3<double>("test::v", 2 * behind);
  Boxes boxes_;
  SearchScratch scratch_;
  CellList<NearCells, CandidateList> cells_;
  Point3 flight_{}, waves_[2]{}, spin_{};
  double noise_ = 0, pace_ = 1;
};

struct Counts {
  std::int64_t near = 0, all = 0, touches = 0;
};

/// Checks the pairs that cells say are near, and all, side by side.
Counts compare_checks(double half) {
  Counts counts;
  for (unsigned seed = 1; seed <= 4; ++seed) {
    CrookedLayers layers(half, seed);
    for (int step = 0; step < 144; ++step) {
      layers.advance(step);
      counts.near += layers.near.checked_pairs().num_pairs;
      counts.all += layers.all.candidates.num_pairs;
      for (int n = 0; n < CrookedLayers::behind; ++n) {
        const NodeTouches some = layers.find(layers.near, n), every = layers.find(layers.all, n);
        counts.touches += every.count;
        EXPECT_EQ(some.count, every.count) << "seed " << seed << " step " << step << " node " << n;
        for (int i = 0; i < some.count && i < every.count; ++i) {
          EXPECT_EQ(some.touch[i].face, every.touch[i].face);
          EXPECT_EQ(some.touch[i].record, every.touch[i].record);
          EXPECT_EQ(some.touch[i].gap_end, every.touch[i].gap_end);
        }
      }
      layers.remember();
    }
  }
  return counts;
}

TEST(NearCells, ShellsAreCheckedAlike) {
  const Counts counts = compare_checks(0.2);
  EXPECT_GT(counts.touches, 3000);
  EXPECT_LT(2 * counts.near, counts.all);
}

TEST(NearCells, SolidsAreCheckedAlike) {
  const Counts counts = compare_checks(0);
  EXPECT_GT(counts.touches, 3000);
  EXPECT_LT(2 * counts.near, counts.all);
}

}  // namespace
}  // namespace percuss::test
