#include "kernels/contact/enforcement/coupled_rows.hpp"

#include <KokkosSparse_CrsMatrix.hpp>
#include <KokkosSparse_spgemm.hpp>

#include <algorithm>
#include <numeric>

#include "kernels/contact/enforcement/cone_problem.hpp"
#include "kernels/core/counting_sort.hpp"
#include "kernels/core/host_copy.hpp"

namespace percuss {
namespace {

using Matrix = KokkosSparse::CrsMatrix<double, int, Kokkos::Device<ExecSpace, MemSpace>, void, int>;

std::size_t at(int index) { return static_cast<std::size_t>(index); }

/// A sparse matrix under construction on the host, row by row.
struct MatrixRows {
  std::vector<int> offset{0}, column;
  std::vector<double> value;

  void end_row() { offset.push_back(static_cast<int>(column.size())); }
  int num_rows() const { return static_cast<int>(offset.size()) - 1; }

  Matrix make(const char* label, int num_columns) const {
    return Matrix(label, num_rows(), num_columns, static_cast<int>(column.size()), to_view("contact::values", value),
                  to_view("contact::offsets", offset), to_view("contact::columns", column));
  }
};

/// The transpose, its columns ascending.
MatrixRows transpose(const MatrixRows& a, int num_columns) {
  struct Entry {
    int row = 0;
    double value = 0;
  };
  auto by_column = collect_buckets<Entry>(at(num_columns), [&](auto&& put) {
    for (int r = 0; r < a.num_rows(); ++r)
      for (int i = a.offset[at(r)]; i < a.offset[at(r) + 1]; ++i) put(at(a.column[at(i)]), Entry{r, a.value[at(i)]});
  });
  MatrixRows t;
  t.offset = std::move(by_column.first);
  for (const Entry& entry : by_column.items) {
    t.column.push_back(entry.row);
    t.value.push_back(entry.value);
  }
  return t;
}

/// Nodes of all rows, numbered 0, 1, ... in the order of their numbers.
class NodeNumbering {
 public:
  explicit NodeNumbering(const std::vector<CoupledRow>& rows) {
    for (const CoupledRow& r : rows) numbers_.insert(numbers_.end(), r.node, r.node + count_nodes(r.row));
    std::sort(numbers_.begin(), numbers_.end());
    numbers_.erase(std::unique(numbers_.begin(), numbers_.end()), numbers_.end());
  }
  int count() const { return static_cast<int>(numbers_.size()); }
  int find(std::int64_t number) const {
    return static_cast<int>(std::lower_bound(numbers_.begin(), numbers_.end(), number) - numbers_.begin());
  }

 private:
  std::vector<std::int64_t> numbers_;
};

/// G M^-1 and H, a row for each direction of each contact row, three columns a node, then six a rigid body, then
/// three a row for the rotation that it ties.
struct Coefficients {
  MatrixRows impulses, gaps;

  void add(int first, const Point3& impulse, const Point3& gap) {
    impulses.column.insert(impulses.column.end(), {first, first + 1, first + 2});
    impulses.value.insert(impulses.value.end(), {impulse.x, impulse.y, impulse.z});
    gaps.column.insert(gaps.column.end(), {first, first + 1, first + 2});
    gaps.value.insert(gaps.value.end(), {gap.x, gap.y, gap.z});
  }
};

/// Coefficients of one direction of a row on one rigid body: all its slots on it together, which one column must not
/// have twice.
struct BodyCoefficients {
  int body = -1, slot = 0;  // the first of them
  Wrench impulse, gap;
};

/// Adds the share of a slot to that of its body.
void add_to_body(const CoupledRow& row, int slot, const Point3& c, const Point3& h,
                 std::vector<BodyCoefficients>& bodies) {
  auto place = std::find_if(bodies.begin(), bodies.end(), [&](const auto& b) { return b.body == row.body[slot]; });
  if (place == bodies.end()) place = bodies.insert(place, {row.body[slot], slot, {}, {}});
  const Wrench of_c = find_wrench(row.arm[slot], c), of_h = find_wrench(row.arm[slot], h);
  place->impulse = {place->impulse.impulse + of_c.impulse, place->impulse.moment + of_c.moment};
  place->gap = {place->gap.impulse + of_h.impulse, place->gap.moment + of_h.moment};
}

/// The number of bodies that rows touch, and of those before them.
int count_bodies(const std::vector<CoupledRow>& rows) {
  int last = -1;
  for (const CoupledRow& r : rows) last = std::max(last, *std::max_element(r.body, r.body + row_nodes));
  return last + 1;
}

Coefficients list_coefficients(const std::vector<CoupledRow>& rows, const NodeNumbering& nodes) {
  Coefficients list;
  const int first_own = 3 * nodes.count() + 6 * count_bodies(rows);
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const CoupledRow& r = rows[i];
    for (int d = 0; d < count_directions(r.row); ++d) {
      const Point3 &push = get_direction(r.row, d), &watched = d == 0 ? r.row.gap_gradient : push;
      const Point3 push_couple = find_couple(r.row, push), watched_couple = find_couple(r.row, watched);
      std::vector<BodyCoefficients> bodies;
      for (int slot = 0; slot < count_nodes(r.row); ++slot) {
        const Point3 c = spread_impulse(r.row, slot, push, push_couple);
        const Point3 h = spread_impulse(r.row, slot, watched, watched_couple);
        const Point3& w = r.inverse_mass[slot];
        if (r.body[slot] < 0)
          list.add(3 * nodes.find(r.node[slot]), {w.x * c.x, w.y * c.y, w.z * c.z}, h);
        else
          add_to_body(r, slot, c, h, bodies);
      }
      for (const BodyCoefficients& b : bodies) {
        const BodyResponse response{{}, r.inverse_mass[b.slot], r.inverse_inertia[b.slot]};
        const BodyChange change = find_change(response, b.impulse);
        const int first = 3 * nodes.count() + 6 * b.body;
        list.add(first, change.velocity, b.gap.impulse);
        list.add(first + 3, change.spin, b.gap.moment);
      }
      const Point3& own = r.own;
      if (ties_rotation(r.row))
        list.add(first_own + 3 * static_cast<int>(i), {own.x * push.x, own.y * push.y, own.z * push.z}, push);
      list.impulses.end_row();
      list.gaps.end_row();
    }
  }
  return list;
}

template <class T, class View>
std::vector<T> list_values(const View& view) {
  const auto host = to_host(view);
  return {host.data(), host.data() + host.extent(0)};
}

/// The matrix with the columns of each row ascending. Transposing twice is what every version of Kokkos Kernels allows:
/// where its own sort is found, and whether it is public, depends on the version.
Matrix sort_columns(const Matrix& a) {
  MatrixRows rows;
  rows.offset = list_values<int>(a.graph.row_map);
  rows.column = list_values<int>(a.graph.entries);
  rows.value = list_values<double>(a.values);
  const int num_columns = a.numCols();
  return transpose(transpose(rows, num_columns), rows.num_rows()).make("contact::A", num_columns);
}

/// The slots of a row that belong to rigid bodies. A row within one body moves nothing.
template <class Places, class Rows, class Responses>
void set_bodies(const Places& of_place, const Rows& x, const Responses& responses, CoupledRow& coupled) {
  const ContactRow& row = coupled.row;
  const int first_body = of_place(row.place[0]);
  bool is_within = row.kind != RowKind::wall && first_body >= 0;
  for (int slot = 0; slot < count_nodes(row); ++slot) is_within = is_within && of_place(row.place[slot]) == first_body;
  for (int slot = 0; slot < count_nodes(row); ++slot) {
    const int body = of_place(row.place[slot]);
    if (is_within) coupled.inverse_mass[slot] = {};
    if (body < 0 || is_within) continue;
    const BodyResponse& response = responses(body);
    coupled.body[slot] = body;
    coupled.arm[slot] = load_row(x, row.place[slot]) - response.center;
    coupled.inverse_mass[slot] = response.inverse_mass;
    coupled.inverse_inertia[slot] = response.inverse_inertia;
  }
}

Matrix multiply(const Matrix& a, const Matrix& b) {
  KokkosKernels::Experimental::KokkosKernelsHandle<int, int, double, ExecSpace, MemSpace, MemSpace> handle;
  handle.create_spgemm_handle(KokkosSparse::SPGEMM_KK);
  Matrix c;
  KokkosSparse::spgemm_symbolic(handle, a, false, b, false, c);
  KokkosSparse::spgemm_numeric(handle, a, false, b, false, c);
  handle.destroy_spgemm_handle();
  return sort_columns(c);  // sums over a row have one order
}

}  // namespace

std::vector<CoupledRow> list_coupled_rows(const RowSystem& system, const Array<const std::int64_t>& node_numbers) {
  const auto rows = to_host(system.rows);
  const auto nodes = to_host(system.nodes);
  const auto numbers = to_host(node_numbers);
  const auto foreign = to_host(system.foreign_number);
  const auto inverse_mass = to_host(system.at.inverse_mass);
  const auto of_place = to_host(system.bodies.of_place);
  const auto x = to_host(system.at.x);
  const auto responses = to_host(system.bodies.inputs.responses);
  const auto turning = to_host(system.turning);
  std::vector<CoupledRow> list(at(system.num_rows));
  for (std::size_t r = 0; r < list.size(); ++r) {
    list[r].row = rows(r);
    for (int slot = 0; slot < count_nodes(rows(r)); ++slot) {
      const int place = rows(r).place[slot];
      const bool is_own = place < system.num_nodes;
      list[r].node[slot] = is_own ? numbers(at(nodes(at(place)))) : foreign(at(place - system.num_nodes));
      list[r].inverse_mass[slot] = load_row(inverse_mass, place);
    }
    if (ties_rotation(rows(r))) list[r].own = turning(at(rows(r).record)).compliance;
    if (system.bodies.count() > 0) set_bodies(of_place, x, responses, list[r]);
  }
  return list;
}

std::vector<int> order_by_key(const std::vector<CoupledRow>& rows) {
  std::vector<int> order(rows.size());
  std::iota(order.begin(), order.end(), 0);
  std::sort(order.begin(), order.end(), [&](int a, int b) { return rows[at(a)].row.key < rows[at(b)].row.key; });
  return order;
}

CoupledReport solve_in_key_order(const std::vector<CoupledRow>& rows, double dt, std::vector<RowImpulse>& impulses) {
  const std::vector<int> order = order_by_key(rows);
  std::vector<CoupledRow> sorted;
  sorted.reserve(rows.size());
  for (const int r : order) sorted.push_back(rows[at(r)]);
  std::vector<RowImpulse> found;
  const CoupledReport report = solve_coupled_rows(sorted, dt, found);
  impulses.resize(rows.size());
  for (std::size_t i = 0; i < order.size(); ++i) impulses[at(order[i])] = found[i];
  return report;
}

void set_impulses(const WorkSpace& space, const std::vector<RowImpulse>& impulses, const RowSystem& system) {
  const Array<ContactRow> rows = system.rows;
  const Array<const RowImpulse> values = to_view("contact::impulses", impulses);
  parallel_for(
      "contact::set_impulses", RangeOf(space, 0, system.num_rows),
      KOKKOS_LAMBDA(int r) { set_impulse(rows(r), values(r)); });
  space.fence();
}

/// Largest of n absolute values.
double find_largest(const double* values, int n) {
  double largest = 0;
  for (int i = 0; i < n; ++i) largest = std::max(largest, std::fabs(values[i]));
  return largest;
}

namespace {

/// The unknowns of all rows: pushes, and behind each with friction the tangential ones; of ties three of a kind.
struct CoupledUnknowns {
  std::vector<int> first;  // [rows + 1] of each row
  std::vector<double> friction;
  std::vector<double> b, guess;  // [unknowns]
  double closing = 0;            // largest closing velocity
};

CoupledUnknowns list_unknowns(const std::vector<CoupledRow>& rows, double dt) {
  CoupledUnknowns of;
  for (const CoupledRow& r : rows) {
    of.first.push_back(static_cast<int>(of.b.size()));
    of.friction.push_back(r.row.friction);
    const double velocity = (r.row.gap - r.row.target) / dt;
    of.b.push_back(velocity);
    of.guess.push_back(r.row.impulse.normal);
    for (int d = 1; d < count_directions(r.row); ++d) {
      of.b.push_back(r.row.slide[d - 1] / dt);
      of.guess.push_back(r.row.impulse.tangential[d - 1]);
    }
    of.closing = std::max(of.closing, is_tie(r.row) ? find_largest(of.b.data() + of.first.back(), 3) : -velocity);
  }
  of.first.push_back(static_cast<int>(of.b.size()));
  return of;
}

ConeProblem make_cone_problem(const std::vector<CoupledRow>& rows, const CoupledUnknowns& of) {
  const NodeNumbering nodes(rows);
  const Coefficients coefficients = list_coefficients(rows, nodes);
  const int unknowns = static_cast<int>(of.b.size()),
            columns = 3 * (nodes.count() + static_cast<int>(rows.size())) + 6 * count_bodies(rows);
  const Matrix a = multiply(coefficients.gaps.make("contact::H", columns),
                            transpose(coefficients.impulses, columns).make("contact::MGT", unknowns));
  ConeProblem problem;
  problem.a = {unknowns, a.graph.row_map, a.graph.entries, a.values};
  problem.b = to_view("contact::cone_b", of.b);
  problem.num_rows = static_cast<int>(rows.size());
  problem.first = to_view("contact::cone_first", of.first);
  problem.friction = to_view("contact::cone_friction", of.friction);
  return problem;
}

}  // namespace

CoupledReport solve_coupled_rows(const std::vector<CoupledRow>& rows, double dt, std::vector<RowImpulse>& impulses) {
  constexpr double tolerance = 1e-10;  // share of the largest closing velocity
  const CoupledUnknowns unknowns = list_unknowns(rows, dt);
  impulses.assign(rows.size(), {});
  CoupledReport report;
  report.rows = static_cast<std::int64_t>(rows.size());
  if (!(unknowns.closing > 0)) return report;  // nothing closes: no impulse is the solution
  const Array<double> z = to_view("contact::cone_z", unknowns.guess);
  const ConeReport solved = solve_cone_problem(make_cone_problem(rows, unknowns), tolerance * unknowns.closing, z);
  const auto solution = to_host(z);
  for (std::size_t r = 0; r < rows.size(); ++r) {
    const std::size_t f = at(unknowns.first[r]);
    impulses[r].normal = solution(f);
    if (count_directions(rows[r].row) == 1) continue;
    for (std::size_t d = 0; d < 2; ++d) impulses[r].tangential[d] = solution(f + 1 + d);
  }
  report.sweeps = solved.sweeps;
  report.converged = solved.converged;
  report.complementarity = solved.residual / unknowns.closing;
  return report;
}

}  // namespace percuss
