#include "kernels/contact/row_system.hpp"

#include "kernels/contact/index_lists.hpp"
#include "kernels/contact/row_geometry.hpp"

namespace percuss {
namespace {

/// Writes the rows of the touches.
template <class Space>
void write_face_rows(const Space& space, const ContactSurface& surface, const CandidateList& candidates,
                     const TouchTable& touches, const ContactHistory& history, const RowInputs& inputs,
                     const Array<ContactRow>& rows) {
  const ContactSurface s = surface;
  const ContactHistory h = history;
  const RowInputs in = inputs;
  const Array<const int> nodes = candidates.nodes, first = touches.first;
  const Array<const NodeTouches> by_node = touches.by_node;
  Kokkos::parallel_for(
      "contact::face_rows", RangeOf<Space>(space, 0, candidates.num_nodes), KOKKOS_LAMBDA(int i) {
        for (int j = 0; j < by_node(i).count; ++j)
          rows(first(i) + j) = make_face_row(s, h, in, nodes(i), j, by_node(i).touch[j]);
      });
}

/// Writes the rows of the walls in reach after those of the faces; returns how many rows there are now.
template <class Space>
int write_wall_rows(const Space& space, const ContactSurface& surface, const WallPairs& walls,
                    const ContactHistory& history, const RowInputs& inputs, int first, RowSystem& system) {
  const int pairs = static_cast<int>(walls.node.extent(0));
  if (pairs == 0) return first;
  const ContactSurface s = surface;
  const WallPairs w = walls;
  const RowInputs in = inputs;
  reserve(system.entry_value, pairs);
  const Array<int> near = system.entry_value;
  const int count = list_where<Space>(
      space, pairs,
      [s, w, in] KOKKOS_FUNCTION(int p) {
        return find_wall_gap(s, w, in.motion, p, 1) <= contact_limits::row_gap * w.size(p);
      },
      near);
  keep_and_reserve(space, system.rows, first, first + count);
  const Array<ContactRow> rows = system.rows;
  const ContactHistory h = history;
  Kokkos::parallel_for(
      "contact::wall_rows", RangeOf<Space>(space, 0, count),
      KOKKOS_LAMBDA(int i) { rows(first + i) = make_wall_row(s, w, h, in, near(i)); });
  return first + count;
}

/// Numbers the nodes that the rows touch and writes their place into the rows.
template <class Space>
void number_nodes(const Space& space, int num_mesh_nodes, RowSystem& system) {
  if (static_cast<int>(system.place_of_node.extent(0)) < num_mesh_nodes) {
    reserve(system.place_of_node, num_mesh_nodes);
    Kokkos::deep_copy(space, system.place_of_node, -1);
  }
  reserve(system.nodes, system.num_rows * row_nodes);
  const Array<ContactRow> rows = system.rows;
  const Array<int> place = system.place_of_node, nodes = system.nodes, total = system.total;
  Kokkos::deep_copy(space, total, 0);
  Kokkos::parallel_for(
      "contact::collect_nodes", RangeOf<Space>(space, 0, system.num_rows), KOKKOS_LAMBDA(int r) {
        for (int slot = 0; slot < count_nodes(rows(r)); ++slot) {
          const int node = rows(r).node[slot];
          constexpr int free = -1, taken = -2;
          if (Kokkos::atomic_compare_exchange(&place(node), free, taken) != free) continue;
          nodes(Kokkos::atomic_fetch_add(&total(0), 1)) = node;
        }
      });
  system.num_nodes = read_value(space, total, 0);
  Kokkos::parallel_for(
      "contact::number_nodes", RangeOf<Space>(space, 0, system.num_nodes),
      KOKKOS_LAMBDA(int a) { place(nodes(a)) = a; });
}

/// Entries (row, slot) by touched node, in the order of rows.
template <class Space>
void group_entries(const Space& space, RowSystem& system) {
  const int num_entries = system.num_rows * row_nodes;
  reserve(system.entry_key, num_entries);
  reserve(system.entry_value, num_entries);
  reserve(system.entry, num_entries);
  reserve(system.count, system.num_nodes + 1);
  reserve(system.offset, system.num_nodes + 2);
  const Array<ContactRow> rows = system.rows;
  const Array<int> place = system.place_of_node, key = system.entry_key, value = system.entry_value;
  const int nowhere = system.num_nodes;  // the key of the four slots that a wall's row does not use
  Kokkos::parallel_for(
      "contact::list_entries", RangeOf<Space>(space, 0, system.num_rows), KOKKOS_LAMBDA(int r) {
        for (int slot = 0; slot < row_nodes; ++slot) {
          const bool used = slot < count_nodes(rows(r));
          if (used) rows(r).place[slot] = place(rows(r).node[slot]);
          key(r * row_nodes + slot) = used ? rows(r).place[slot] : nowhere;
          value(r * row_nodes + slot) = r * row_nodes + slot;
        }
      });
  group_by_key<Space>(space, num_entries, key, value, system.num_nodes + 1, system.count, system.offset, system.entry);
  const Array<int> nodes = system.nodes;
  Kokkos::parallel_for(
      "contact::release_nodes", RangeOf<Space>(space, 0, system.num_nodes),
      KOKKOS_LAMBDA(int a) { place(nodes(a)) = -1; });
}

/// S of each touched node: sums of absolute coefficients, in row order.
template <class Space>
void sum_coefficients(const Space& space, const RowSystem& system) {
  const Array<const ContactRow> rows = system.rows;
  const Array<const int> offset = system.offset, entry = system.entry;
  const Rows3<double> sum = system.abs_sum;
  Kokkos::parallel_for(
      "contact::sum_coefficients", RangeOf<Space>(space, 0, system.num_nodes), KOKKOS_LAMBDA(int a) {
        Point3 s{};
        for (int e = offset(a); e < offset(a + 1); ++e) {
          const ContactRow& row = rows(entry(e) / row_nodes);
          for (int d = 0; d < count_directions(row); ++d) s = s + find_abs_coefficient(row, entry(e) % row_nodes, d);
        }
        store_row(sum, a, s);
      });
}

/// D of each row: sum over its nodes of |c| S / m, a bound of the row sum of |G M^-1 G^T|.
template <class Space>
void sum_stiffness(const Space& space, const Rows3<const double>& inverse_mass, const RowSystem& system) {
  const Array<ContactRow> rows = system.rows;
  const Array<int> awake = system.awake;
  const Rows3<const double> sum = system.abs_sum;
  Kokkos::parallel_for(
      "contact::sum_stiffness", RangeOf<Space>(space, 0, system.num_rows), KOKKOS_LAMBDA(int r) {
        ContactRow& row = rows(r);
        double stiffness[3] = {0, 0, 0};
        for (int d = 0; d < count_directions(row); ++d)
          for (int slot = 0; slot < count_nodes(row); ++slot) {
            const Point3 c = find_abs_coefficient(row, slot, d);
            const Point3 s = load_row(sum, row.place[slot]), w = load_row(inverse_mass, row.node[slot]);
            stiffness[d] += (c.x * s.x * w.x + c.y * s.y * w.y) + c.z * s.z * w.z;
          }
        set_stiffness(row, stiffness);
        awake(r) = row.impulse.push > 0 ? pushes_now | pushed_before : 0;
      });
}

}  // namespace

template <class Space>
void build_rows(const Space& space, const ContactSurface& surface, const CandidateList& candidates,
                const TouchTable& touches, const WallPairs& walls, const ContactHistory& history,
                const RowInputs& inputs, RowSystem& system) {
  reserve(system.rows, touches.count);
  if (touches.count > 0) write_face_rows(space, surface, candidates, touches, history, inputs, system.rows);
  system.num_rows = write_wall_rows(space, surface, walls, history, inputs, touches.count, system);
  system.num_nodes = 0;
  if (system.num_rows == 0) return;
  number_nodes(space, static_cast<int>(inputs.motion.x.extent(0)), system);
  group_entries(space, system);
  reserve(system.awake, system.num_rows);
  reserve(system.abs_sum, system.num_nodes);
  reserve(system.correction, system.num_nodes);
  reserve(system.extrapolated, system.num_nodes);
  sum_coefficients(space, system);
  sum_stiffness(space, inputs.inverse_mass, system);
}

template void build_rows(const ExecSpace&, const ContactSurface&, const CandidateList&, const TouchTable&,
                         const WallPairs&, const ContactHistory&, const RowInputs&, RowSystem&);
#if defined(PERCUSS_SMALL_SPACE)
template void build_rows(const SmallSpace&, const ContactSurface&, const CandidateList&, const TouchTable&,
                         const WallPairs&, const ContactHistory&, const RowInputs&, RowSystem&);
#endif

}  // namespace percuss
