#include "kernels/contact/enforcement/cone_problem.hpp"

#include <algorithm>
#include <limits>
#include <string>

#include "kernels/contact/enforcement/anderson.hpp"
#include "kernels/contact/enforcement/cone_row.hpp"
#include "kernels/core/host_copy.hpp"
#include "kernels/core/small_space.hpp"
#include "kernels/core/view_copy.hpp"

namespace percuss {
namespace {

/// The problem on the host, for set-up.
struct HostProblem {
  explicit HostProblem(const ConeProblem& problem)
      : num_rows(problem.num_rows),
        first(to_host(problem.first)),
        offset(to_host(problem.a.offset)),
        column(to_host(problem.a.column)),
        value(to_host(problem.a.value)),
        friction(to_host(problem.friction)),
        row_of(static_cast<std::size_t>(problem.a.num_rows)) {
    for (int r = 0; r < num_rows; ++r)
      for (int i = first(r); i < first(r + 1); ++i) row_of[static_cast<std::size_t>(i)] = r;
  }

  double find(int row, int unknown) const {
    for (int i = offset(row); i < offset(row + 1); ++i)
      if (column(i) == unknown) return value(i);
    return 0;
  }
  bool is_tied(int row) const { return friction(row) >= contact_limits::no_friction_limit; }
  /// Calls visit(row) for the rows that are coupled with row r, perhaps more than once. A's pattern is symmetric.
  template <class Visit>
  void for_neighbours(int r, const Visit& visit) const {
    for (int u = first(r); u < first(r + 1); ++u)
      for (int i = offset(u); i < offset(u + 1); ++i) visit(row_of[static_cast<std::size_t>(column(i))]);
  }

  int num_rows;
  decltype(to_host(ConeProblem().first)) first, offset, column;
  decltype(to_host(SparseMatrix().value)) value, friction;
  std::vector<int> row_of;  // of each unknown
};

/// Blocks of the sweep in the order of rows: each row with the first later one that is its twin, if that is free.
std::vector<RowTwins> pair_twins(const HostProblem& problem) {
  constexpr double alike = 1e-3;  // square of the difference of two rows / that of the smaller
  std::vector<RowTwins> blocks;
  std::vector<char> is_taken(static_cast<std::size_t>(problem.num_rows), 0);
  for (int r = 0; r < problem.num_rows; ++r) {
    if (is_taken[static_cast<std::size_t>(r)] != 0) continue;
    RowTwins block;
    block.row = r;
    const int f = problem.first(r);
    block.a11 = problem.find(f, f);
    if (problem.is_tied(r)) {
      blocks.push_back(block);
      continue;
    }
    for (int i = problem.offset(f); i < problem.offset(f + 1) && block.twin < 0 && block.a11 > 0; ++i) {
      const int g = problem.column(i), other = problem.row_of[static_cast<std::size_t>(g)];
      if (other <= r || is_taken[static_cast<std::size_t>(other)] != 0 || problem.first(other) != g ||
          problem.is_tied(other))
        continue;
      block.a12 = problem.value(i);
      block.a21 = problem.find(g, f);
      block.a22 = problem.find(g, g);
      const double difference = block.a11 + block.a22 - block.a12 - block.a21;
      if (difference <= alike * std::min(block.a11, block.a22)) block.twin = other;
    }
    if (block.twin >= 0) is_taken[static_cast<std::size_t>(block.twin)] = 1;
    blocks.push_back(block);
  }
  return blocks;
}

/// Blocks in colours: no two of one colour are coupled, so that they may be corrected at once with the same bits.
struct ColouredBlocks {
  std::vector<int> first{0};  // [colours + 1]
  Array<RowTwins> blocks;     // by colour
};

/// Each block in its order gets the lowest colour that no coupled earlier one has.
ColouredBlocks colour_blocks(const HostProblem& problem, const std::vector<RowTwins>& blocks) {
  std::vector<int> colour(static_cast<std::size_t>(problem.num_rows), -1), taken;
  std::vector<std::vector<RowTwins>> by_colour;
  for (int k = 0; k < static_cast<int>(blocks.size()); ++k) {
    const RowTwins& block = blocks[static_cast<std::size_t>(k)];
    for (const int row : {block.row, block.twin})
      if (row >= 0)
        problem.for_neighbours(row, [&](int other) {
          const int c = colour[static_cast<std::size_t>(other)];
          if (c >= 0) taken[static_cast<std::size_t>(c)] = k;
        });
    std::size_t c = 0;
    while (c < taken.size() && taken[c] == k) ++c;
    if (c == taken.size()) {
      taken.push_back(-1);
      by_colour.emplace_back();
    }
    by_colour[c].push_back(block);
    for (const int row : {block.row, block.twin})
      if (row >= 0) colour[static_cast<std::size_t>(row)] = static_cast<int>(c);
  }
  ColouredBlocks coloured;
  std::vector<RowTwins> all;
  for (const std::vector<RowTwins>& of_colour : by_colour) {
    all.insert(all.end(), of_colour.begin(), of_colour.end());
    coloured.first.push_back(static_cast<int>(all.size()));
  }
  coloured.blocks = to_view("contact::coloured_blocks", all);
  return coloured;
}

/// The block of each row, and the weight of each unknown.
void fill_blocks(const ConeProblem& p, const Array<ConeBlock>& blocks, const Array<double>& weight) {
  parallel_for(
      "contact::cone_blocks", RangeOf(ExecSpace(), 0, p.num_rows), KOKKOS_LAMBDA(int r) {
        blocks(r) = find_block(p, r);
        const int f = p.first(r);
        for (int i = f; i < p.first(r + 1); ++i) weight(i) = i == f ? blocks(r).normal : blocks(r).tangential;
      });
}

/// Data of the sweeps besides the problem.
struct Sweeper {
  Sweeper(const ConeProblem& of, double tolerance)
      : problem(of),
        slack(0.2 * tolerance),
        blocks("contact::cone_blocks", static_cast<std::size_t>(of.num_rows)),
        weight("contact::cone_weight", static_cast<std::size_t>(of.a.num_rows)) {
    const HostProblem host(of);
    const std::vector<RowTwins> twins = pair_twins(host);
    colours = colour_blocks(host, twins);
    std::vector<int> leader(static_cast<std::size_t>(of.num_rows), -1), follower(leader);
    for (const RowTwins& t : twins) {
      if (t.twin < 0) continue;
      follower[static_cast<std::size_t>(t.row)] = t.twin;
      leader[static_cast<std::size_t>(t.twin)] = t.row;
    }
    problem.leader = to_view("contact::leaders", leader);
    problem.follower = to_view("contact::followers", follower);
    fill_blocks(of, blocks, weight);
  }

  void correct_colour(const WorkSpace& space, int colour, const Array<double>& z) const {
    const ConeProblem p = problem;
    const Array<const ConeBlock> b = blocks;
    const Array<const RowTwins> twins = colours.blocks;
    const double s = slack;
    const auto c = static_cast<std::size_t>(colour);
    parallel_for(
        "contact::cone_sweep", RangeOf(space, colours.first[c], colours.first[c + 1]),
        KOKKOS_LAMBDA(int i) { correct_twins(p, b, twins(i), s, z); });
  }

  /// All colours up, then down.
  void operator()(const Array<double>& z) const {
    const int count = static_cast<int>(colours.first.size()) - 1;
    // A row costs some dozen couplings.
    run_where_it_pays(4 * problem.num_rows / std::max(count, 1), [&](const auto& space) {
      for (int c = 0; c < count; ++c) correct_colour(space, c, z);
      for (int c = count; c-- > 0;) correct_colour(space, c, z);
      space.fence();
    });
  }

  /// The largest deviation of a row; the largest number where one is none.
  double find_residual(const Array<double>& z) const {
    constexpr double most_of_all = std::numeric_limits<double>::max();
    const ConeProblem p = problem;
    const Array<const ConeBlock> b = blocks;
    double residual = 0;
    parallel_reduce(
        "contact::cone_residual", RangeOf(ExecSpace(), 0, p.num_rows),
        KOKKOS_LAMBDA(int r, double& most) {
          const double deviation = find_deviation(p, b(r), r, z);
          if (!(deviation <= most)) most = deviation <= most_of_all ? deviation : most_of_all;
        },
        Kokkos::Max<double>(residual));
    return residual;
  }

  /// Notes what each row does; returns how many do something else than at the last call.
  int update_status(const Array<double>& z) const {
    const ConeProblem p = problem;
    const Array<int> last = status;
    int changes = 0;
    parallel_reduce(
        "contact::cone_status", RangeOf(ExecSpace(), 0, p.num_rows),
        KOKKOS_LAMBDA(int r, int& sum) {
          const int now = find_status(p, r, z);
          if (now != last(r)) ++sum;
          last(r) = now;
        },
        changes);
    return changes;
  }

  /// Goes from z as far towards `to` as no row changes what it does; to: in and out.
  void stop_at_changes(const Array<double>& z, const Array<double>& to) const {
    const ConeProblem p = problem;
    double way = 1;
    parallel_reduce(
        "contact::cone_open_way", RangeOf(ExecSpace(), 0, p.num_rows),
        KOKKOS_LAMBDA(int r, double& least) {
          const double open = find_open_way(p, r, z, to);
          if (open < least) least = open;
        },
        Kokkos::Min<double>(way));
    parallel_for(
        "contact::cone_go", RangeOf(ExecSpace(), 0, p.a.num_rows),
        KOKKOS_LAMBDA(int i) { to(i) = z(i) + way * (to(i) - z(i)); });
    project(to);
  }

  void project(const Array<double>& z) const {
    const ConeProblem p = problem;
    parallel_for(
        "contact::cone_project_pushes", RangeOf(ExecSpace(), 0, p.num_rows),
        KOKKOS_LAMBDA(int r) { project_push(p, r, z); });
    parallel_for(
        "contact::cone_project_friction", RangeOf(ExecSpace(), 0, p.num_rows),
        KOKKOS_LAMBDA(int r) { project_friction(p, r, z); });
  }

  ConeProblem problem;
  double slack;  // to which twins settle who pushes
  ColouredBlocks colours;
  Array<ConeBlock> blocks;
  Array<double> weight;
  Array<int> status = Array<int>("contact::cone_status", static_cast<std::size_t>(problem.num_rows));
};

/// The best point so far, and when the residual was last halved.
struct BestPoint {
  Array<double> z;
  double halved = std::numeric_limits<double>::infinity();
  int last_gain = 0;  // sweeps

  void take(const Array<double>& now, double residual, ConeReport& report) {
    if (residual < report.residual) {
      report.residual = residual;
      copy_values(z, now);
    }
    if (residual < 0.5 * halved) {
      halved = residual;
      last_gain = report.sweeps;
    }
  }

  /// Goes back from a z that is lost. Where rows depend on each other, as those of rigid bodies do, there are impulses
  /// that change no velocity, along which nothing holds the extrapolation.
  bool take_back(double residual, double tolerance, const Array<double>& now) const {
    constexpr double lost = 1e16;  // residual / tolerance
    if (!(residual > lost * tolerance)) return false;
    copy_values(now, z);
    return true;
  }
};

}  // namespace

ConeReport solve_cone_problem(const ConeProblem& problem, double tolerance, const Array<double>& z) {
  constexpr int max_sweeps = 4000;
  constexpr int patience = 300;  // sweeps without halving of the residual after which nothing more is gained
  constexpr double too_far = 2;  // growth of a sweep's move that shows that the last step led away
  const Sweeper sweep(problem, tolerance);
  const int n = problem.a.num_rows;
  AndersonWindow window(n, sweep.weight);
  const auto make = [n](const std::string& label) { return Array<double>(label, static_cast<std::size_t>(n)); };
  const Array<double> next = make("contact::cone_next"), swept = make("contact::cone_swept");
  BestPoint best{make("contact::cone_best")};
  double last_move = std::numeric_limits<double>::infinity();
  ConeReport report{0, last_move, false};
  sweep.project(z);
  for (;;) {
    const double residual = sweep.find_residual(z);
    best.take(z, residual, report);
    report.converged = residual <= tolerance;
    const bool is_stuck = report.sweeps - best.last_gain > patience;
    if (report.converged || is_stuck || report.sweeps >= max_sweeps) break;
    if (best.take_back(residual, tolerance, z)) {
      window.clear();
      last_move = std::numeric_limits<double>::infinity();
    }
    copy_values(next, z);
    sweep(next);
    report.sweeps += 2;
    copy_values(swept, next);
    const bool is_settled = sweep.update_status(swept) == 0;
    if (!is_settled) window.clear();
    const double move = window.accelerate(z, next);
    if (is_settled && move <= too_far * last_move) {
      sweep.stop_at_changes(swept, next);
    } else {
      window.clear();
      copy_values(next, swept);
    }
    last_move = move;
    copy_values(z, next);
  }
  copy_values(z, best.z);
  return report;
}

}  // namespace percuss
