#include "kernels/contact/rows/row_system.hpp"

#include "kernels/contact/rows/body_rows.hpp"
#include "kernels/contact/rows/row_filling.hpp"
#include "kernels/contact/rows/tie_row.hpp"
#include "kernels/core/index_lists.hpp"
#include "kernels/core/view_copy.hpp"

namespace percuss {
namespace {

/// The mesh node of an entry, < 0: foreign, or no entry. Walls touch their node alone.
struct EntryNodes {
  Array<const RowTouch> touches;
  int num_touches, num_rows;
  Array<const int> near_walls, wall_node, remote_node;

  /// Whether row r has a node in a slot, and which one. -1 - k: foreign node k.
  KOKKOS_INLINE_FUNCTION bool has_slot(int r, int slot) const {
    return slot < (r < num_touches ? touches(r).count : 1);
  }
  KOKKOS_INLINE_FUNCTION int get_node(int r, int slot) const {
    return r < num_touches ? touches(r).node[slot] : wall_node(near_walls(r - num_touches));
  }

  KOKKOS_INLINE_FUNCTION int operator()(int entry) const {
    const int r = entry / row_nodes, slot = entry % row_nodes;
    if (r >= num_rows) return remote_node(entry - num_rows * row_nodes);
    return has_slot(r, slot) ? get_node(r, slot) : -1;
  }
};

EntryNodes list_entry_nodes(const Array<const RowTouch>& touches, int num_touches, const WallPairs& walls,
                            const RowSystem& system) {
  return {touches, num_touches, system.num_rows, system.near_walls, walls.node, system.remote_node};
}

/// Touches of edges come after those of faces and number their records from 0.
int count_edge_touches(const WorkSpace& space, const Array<const RowTouch>& touches, int num_touches) {
  if (num_touches == 0) return 0;
  const RowTouch last = read_value(space, touches, num_touches - 1);
  return last.kind == RowKind::edges ? last.record + 1 : 0;
}

/// Lists the wall pairs in reach; returns how many.
int list_near_walls(const WorkSpace& space, const WallPairs& walls, const RowInputs& inputs, RowSystem& system) {
  const int pairs = walls.count_looked_at();
  if (pairs == 0) return 0;
  const WallPairs w = walls;
  const SurfaceMotion m = inputs.motion;
  const bool leaves_out_inner = !inputs.looks_inside && walls.is_inner.extent(0) > 0;
  // A spring gives back what it holds as it ends, however fast.
  const bool keeps_pressed = inputs.springs == SpringRows::all;
  reserve(system.near_walls, pairs);
  const int num_near = list_where(
      space, pairs,
      [w, m, leaves_out_inner, keeps_pressed] KOKKOS_FUNCTION(int i) {
        const int p = w.look_at(i);
        if (leaves_out_inner && w.is_inner(p) != 0) return false;
        const bool is_near = find_wall_gap(w, m, p, 1) <= contact_limits::row_gap * w.size(p);
        return (is_near || (keeps_pressed && find_wall_gap(w, m, p, 0) < 0)) && can_stop(w, m, p);
      },
      system.near_walls);
  const Array<int> near = system.near_walls;
  if (walls.num_awake >= 0)
    parallel_for(
        "contact::near_walls", RangeOf(space, 0, num_near), KOKKOS_LAMBDA(int i) { near(i) = w.look_at(near(i)); });
  return num_near;
}

/// Numbers the nodes of this rank that rows and remote entries touch, in the order in which these do: a thread then
/// moves the nodes that its rows push.
void number_nodes(const WorkSpace& space, int num_mesh_nodes, const EntryNodes& entries, RowSystem& system) {
  if (static_cast<int>(system.place_of_node.extent(0)) < num_mesh_nodes) {
    reserve(system.place_of_node, num_mesh_nodes);
    set_values(space, system.place_of_node, -1);
  }
  const int num_entries = system.num_rows * row_nodes + static_cast<int>(system.remote_node.extent(0));
  reserve(system.first_entry, num_entries);
  reserve(system.nodes, num_entries);
  const Array<int> place = system.place_of_node, nodes = system.nodes, first = system.first_entry;
  const EntryNodes touched = entries;
  const bool is_alone = space.concurrency() == 1;
  // A node's first entry has the largest of these marks (num_entries - e), which a maximum by atomics finds; untouched
  // nodes have -1.
  parallel_for(
      "contact::mark_nodes", RangeOf(space, 0, num_entries), KOKKOS_LAMBDA(int e) {
        const int node = touched(e), mark = num_entries - e;
        if (node < 0) return;
        if (is_alone)
          place(node) = place(node) < 0 ? mark : place(node);
        else
          Kokkos::atomic_fetch_max(&place(node), mark);
      });
  system.num_nodes = list_where(
      space, num_entries,
      [touched, place, num_entries] KOKKOS_FUNCTION(int e) {
        const int node = touched(e);
        return node >= 0 && place(node) == num_entries - e;
      },
      first);
  parallel_for(
      "contact::number_nodes", RangeOf(space, 0, system.num_nodes), KOKKOS_LAMBDA(int a) {
        nodes(a) = touched(first(a));
        place(nodes(a)) = a;
      });
}

void gather_nodes(const WorkSpace& space, const RowInputs& inputs, RowSystem& system) {
  RowNodes& all = system.at;
  for (Rows3<double>* rows : {&all.x, &all.v, &all.v_before, &all.v_checked, &all.inverse_mass})
    reserve(*rows, system.num_places() + 1);
  const bool with_springs = has_springs(inputs), has_impulses = inputs.last_impulse.extent(0) > 0;
  if (with_springs) {
    reserve(system.at.spring, system.num_places());
    reserve(system.at.growth, system.num_places());
  }
  const RowNodes at = system.at;
  const RowInputs in = inputs;
  const Array<const int> nodes = system.nodes;
  parallel_for(
      "contact::gather_nodes", RangeOf(space, 0, system.num_nodes), KOKKOS_LAMBDA(int a) {
        const int n = nodes(a);
        store_row(at.x, a, load_row(in.motion.x, n));
        store_row(at.v, a, load_row(in.motion.v, n));
        store_row(at.v_before, a, load_row(in.v_before, n));
        const bool goes_on = has_impulses && was_pushed(in.last_impulse, n);
        store_row(at.v_checked, a, load_row(goes_on ? in.v_before : in.motion.v, n));
        store_row(at.inverse_mass, a, load_row(in.inverse_mass, n));
        if (!with_springs) return;
        at.spring(a) = in.spring(n);
        at.growth(a) = in.growth.extent(0) > 0 ? in.growth(n) : 1;
      });
}

/// ContactRow::key of the rows of this rank.
struct RowKeys {
  Array<const RowTouch> touches;
  int num_touches;
  Array<const int> near_walls;
  WallPairs walls;
  Array<const std::int64_t> node_numbers;  // [mesh nodes]

  KOKKOS_INLINE_FUNCTION std::int64_t operator()(int r) const {
    if (r < num_touches) return touches(r).key;
    const int p = near_walls(r - num_touches);
    return make_wall_row_key(node_numbers(walls.node(p)), walls.wall(p));
  }
};

/// Places of the entries, and these by place, ascending in their rows' keys: local ones ascend with the row;
/// remote ones find their place.
void group_entries(const WorkSpace& space, const EntryNodes& entries, const RowKeys& keys, RowSystem& system) {
  const int num_local = system.num_rows * row_nodes, num_entries = num_local + system.num_remote;
  reserve(system.place_of_entry, num_entries);
  reserve(system.entry_value, num_entries);
  reserve(system.entry, num_entries);
  reserve(system.shares, num_entries);
  reserve(system.share_of_slot, num_local);
  reserve(system.share_of_remote, system.num_remote);
  reserve(system.count, system.num_places());
  reserve(system.offset, system.num_places() + 1);
  const Array<int> share_of_slot = system.share_of_slot, share_of_remote = system.share_of_remote;
  const Array<int> place_of_entry = system.place_of_entry, value = system.entry_value, place = system.place_of_node;
  const Array<const int> foreign = system.foreign, remote_place = system.remote_place;
  const EntryNodes touched = entries;
  const int num_nodes = system.num_nodes, nowhere = system.num_places();
  parallel_for(
      "contact::list_entries", RangeOf(space, 0, system.num_rows), KOKKOS_LAMBDA(int r) {
        for (int slot = 0; slot < row_nodes; ++slot) {
          const int e = r * row_nodes + slot;
          value(e) = e;
          share_of_slot(e) = -1;
          place_of_entry(e) = nowhere;
          if (!touched.has_slot(r, slot)) continue;
          const int node = touched.get_node(r, slot);
          place_of_entry(e) = node >= 0 ? place(node) : num_nodes + foreign(-1 - node);
        }
      });
  parallel_for(
      "contact::list_remote_entries", RangeOf(space, 0, system.num_remote), KOKKOS_LAMBDA(int k) {
        place_of_entry(num_local + k) = remote_place(k);
        value(num_local + k) = num_local + k;
      });
  // Slots not in use have no key.
  group_by_key(space, {num_entries, place_of_entry, value, nowhere}, {system.count, system.offset, system.entry});
  const Array<int> nodes = system.nodes, entry = system.entry, offset = system.offset;
  const Array<const std::int64_t> remote_key = system.remote_key;
  const RowKeys row_key = keys;
  parallel_for(
      "contact::merge_entries", RangeOf(space, 0, nowhere), KOKKOS_LAMBDA(int a) {
        if (a < num_nodes) place(nodes(a)) = -1;  // as it was before the set-up
        const auto get_key = [&](int e) { return e < num_local ? row_key(e / row_nodes) : remote_key(e - num_local); };
        int first = offset(a);
        const int last = offset(a + 1);
        while (first < last && entry(first) < num_local) ++first;
        for (int i = first; i < last; ++i) {
          const int e = entry(i);
          int j = i;
          for (; j > offset(a) && get_key(entry(j - 1)) > get_key(e); --j) entry(j) = entry(j - 1);
          entry(j) = e;
        }
        for (int i = offset(a); i < last; ++i) {
          if (entry(i) < num_local)
            share_of_slot(entry(i)) = i;
          else
            share_of_remote(entry(i) - num_local) = i;
        }
      });
}

}  // namespace

void collect_touches(const WorkSpace& space, const ContactSurface& surface, const CandidateList& candidates,
                     const TouchTable& table, const SurfaceNumbers& numbers_of, Array<RowTouch>& touches) {
  reserve(touches, table.count);
  const ContactSurface s = surface;
  const Array<const int> nodes = candidates.nodes, first = table.first;
  const Array<const NodeTouches> by_node = table.by_node;
  const Array<const std::int64_t> faces = numbers_of.faces, numbers = numbers_of.nodes;
  const Array<RowTouch> out = touches;
  parallel_for(
      "contact::collect_touches", RangeOf(space, 0, candidates.num_nodes), KOKKOS_LAMBDA(int i) {
        const int node = nodes(i);
        for (int j = 0; j < by_node(node).count; ++j) {
          const Touch& touch = by_node(node).touch[j];
          RowTouch row = make_row_touch(touch);
          row.face = faces(touch.face);
          row.key = make_face_row_key(numbers(node), j);
          row.friction = find_friction(s, node, touch.face);
          row.pair = find_pair(s, node, touch.face);
          row.record = contact_limits::max_touches * node + j;
          row.old_record = touch.record < 0 ? -1 : contact_limits::max_touches * node + touch.record;
          row.node[0] = s.nodes(node);
          for (int k = 0; k < 4; ++k) row.node[k + 1] = s.nodes(s.face_corners(touch.face, k));
          out(first(i) + j) = row;
        }
      });
}

void count_rows(const WorkSpace& space, const RowInputs& inputs, const RowSources& sources, RowSystem& system) {
  const int num_ties = static_cast<int>(inputs.ties.extent(0));
  system.num_edge_rows = count_edge_touches(space, sources.touches, sources.num_touches - num_ties);
  system.num_rows = sources.num_touches + list_near_walls(space, sources.walls, inputs, system);
}

void start_rows(const WorkSpace& space, const RowInputs& inputs, const RowSources& sources, RowSystem& system) {
  const auto& [touches, num_touches, walls] = sources;
  system.has_springs = has_springs(inputs);
  number_nodes(space, static_cast<int>(inputs.motion.x.extent(0)),
               list_entry_nodes(touches, num_touches, walls, system), system);
  gather_nodes(space, inputs, system);
  start_bodies(space, inputs.bodies, system);
  for (Rows3<double>* rows : {&system.correction, &system.abs_sum}) reserve(*rows, system.num_places() + 1);
}

namespace {

/// Makes rows that are not of nodes on faces, one by one, and those a pack at a time.
struct RowMaker {
  RowInputs inputs;
  WallPairs walls;
  ContactHistory history;
  RowNodes at;
  Array<const RowTouch> touches;
  Array<const int> place_of_entry, near_walls;
  Array<ContactRow> rows;
  Array<int> wants;
  Array<TurningRow> turning;
  SpringChoice choose_spring;
  int num_touches = 0, num_rows = 0;

  /// A touch as its row takes it. place: of its nodes; has_spring: out.
  KOKKOS_FUNCTION RowTouch load_touch(int r, const int* place, bool& has_spring) const {
    RowTouch touch = touches(r);
    has_spring = choose_spring(touch.kind, place, touch.count, touch.offset);
    if (has_spring && inputs.springs == SpringRows::of_sheets)
      measure_between_sheets(at, inputs.motion.dt, place, touch);
    return touch;
  }

  /// Makes the row of a tie, two edges or a wall.
  KOKKOS_FUNCTION void make_row(int r) const {
    ContactRow& row = rows(r);
    row = ContactRow{};
    const int count = r < num_touches ? touches(r).count : 1;
    for (int slot = 0; slot < count; ++slot) row.place[slot] = place_of_entry(r * row_nodes + slot);
    if (r >= num_touches) {
      row.has_spring = choose_spring(RowKind::wall, row.place, count, 0);
      fill_wall_row(walls, history, inputs, at, near_walls(r - num_touches), row);
    } else if (touches(r).kind == RowKind::tie) {
      make_tie_row(touches(r), row);
    } else {
      const RowTouch touch = load_touch(r, row.place, row.has_spring);
      fill_touch_row(history, inputs, at, touch, row);
    }
  }

  KOKKOS_FUNCTION void make_tie_row(const RowTouch& touch, ContactRow& row) const {
    const int t = touch.record;
    if (inputs.ties(t).turns)
      turning(t) = fill_turning_row(inputs.ties(t), inputs, at, touch, load_row(history.ties, t), row);
    else
      fill_tie_row(inputs.ties(t), inputs, at, touch, load_row(history.ties, t), row);
  }

  /// Makes the rows of a pack.
  KOKKOS_INLINE_FUNCTION void operator()(int pack) const {
    const int first = pack * TouchPack::lanes;
    const int end = first + TouchPack::lanes < num_rows ? first + TouchPack::lanes : num_rows;
    TouchPack on_faces;
    for (int r = first; r < end; ++r) {
      if (r >= num_touches || touches(r).kind != RowKind::face) {
        make_row(r);
        continue;
      }
      const int* const place = &place_of_entry(r * row_nodes);
      bool has_spring = false;
      const RowTouch touch = load_touch(r, place, has_spring);
      on_faces.add(touch, r, place, load_last_contact(history, touch), has_spring);
    }
    if (on_faces.count > 0) {
      on_faces.fill_up();
      make_face_rows(on_faces, inputs, at, touches, rows);
    }
    for (int r = first; r < end; ++r) wants(r) = wants_something(rows(r)) ? 1 : 0;
  }
};

}  // namespace

void make_rows(const WorkSpace& space, const RowInputs& inputs, const RowSources& sources,
               const ContactHistory& history, RowSystem& system) {
  const auto& [touches, num_touches, walls] = sources;
  reserve(system.rows, system.num_rows);
  reserve(system.wants, system.num_rows);
  if (inputs.spins.inertia.extent(0) > 0) reserve(system.turning, static_cast<int>(inputs.ties.extent(0)));
  group_entries(space, list_entry_nodes(touches, num_touches, walls, system),
                {touches, num_touches, system.near_walls, walls, inputs.node_numbers}, system);
  const RowMaker maker{inputs,
                       walls,
                       history,
                       system.at,
                       touches,
                       system.place_of_entry,
                       system.near_walls,
                       system.rows,
                       system.wants,
                       system.turning,
                       SpringChoice(inputs, system),
                       num_touches,
                       system.num_rows};
  const int packs = (system.num_rows + TouchPack::lanes - 1) / TouchPack::lanes;
  parallel_for("contact::make_rows", RangeOf(space, 0, packs), maker);
}

void share_impulses(const WorkSpace& space, const RowSystem& system) {
  const Array<const ContactRow> rows = system.rows;
  const Array<const int> share_of_slot = system.share_of_slot;
  const Rows4<double> shares = system.shares;
  parallel_for(
      "contact::share_impulses", RangeOf(space, 0, system.num_rows), KOKKOS_LAMBDA(int r) {
        const ContactRow& row = rows(r);
        for (int slot = 0; slot < count_nodes(row); ++slot)
          store_row(shares, share_of_slot(r * row_nodes + slot), spread_impulse(row, slot, row.force, row.couple));
      });
}

void get_sent_shares(const WorkSpace& space, const RowSystem& system, const Rows3<double>& values) {
  const Rows4<const double> shares = system.shares;
  const Array<const int> entry = system.sent, share = system.share_of_slot;
  const Rows3<double> out = values;
  parallel_for(
      "contact::sent_shares", RangeOf(space, 0, system.num_sent),
      KOKKOS_LAMBDA(int k) { store_row(out, k, load_row(shares, share(entry(k)))); });
}

void place_remote_shares(const WorkSpace& space, const RowSystem& system) {
  const Array<const int> share = system.share_of_remote;
  const Rows3<const double> remote = system.remote;
  const Rows4<double> shares = system.shares;
  parallel_for(
      "contact::remote_shares", RangeOf(space, 0, system.num_remote),
      KOKKOS_LAMBDA(int k) { store_row(shares, share(k), load_row(remote, k)); });
}

void sum_coefficients(const WorkSpace& space, RowSystem& system) {
  place_remote_shares(space, system);
  const ShareSums sums(system);
  const Rows3<double> sum = system.abs_sum;
  parallel_for(
      "contact::sum_coefficients", RangeOf(space, 0, system.num_places()),
      KOKKOS_LAMBDA(int a) { store_row(sum, a, sums(a)); });
}

}  // namespace percuss
