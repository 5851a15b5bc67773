#include "kernels/contact/search/near_cells.hpp"

#include "kernels/core/index_lists.hpp"

namespace percuss {
namespace {

/// NearCells::nearness: out of reach, near, or to be looked at more closely: as a contact that is new, or goes on, or
/// both.
constexpr int is_far = 0, is_near = 1, may_be_new = 2, may_go_on = 4;
/// NearCells::is_bounded.
constexpr int to_be_bounded = 1, bounded = 2;

/// The nodes of a cell, among those with candidates.
struct CellNodes {
  int first, last;
  KOKKOS_INLINE_FUNCTION CellNodes(int cell, int num_nodes) : first(NearCells::cell_nodes * cell) {
    last = first + NearCells::cell_nodes < num_nodes ? first + NearCells::cell_nodes : num_nodes;
  }
};

/// The patches of a node and, where thickness moves faces, of all nodes of the faces around it; -1: no more.
KOKKOS_INLINE_FUNCTION void list_patches_around(const ContactSurface& s, int node, int* patches) {
  int count = 0;
  const auto add = [&](int patch) {
    for (int i = 0; i < count && i < NearCells::most_around; ++i)
      if (patches[i] == patch) return;
    if (count < NearCells::most_around) patches[count] = patch;
    ++count;
  };
  add(CellTravels::find_patch(node));
  for (int j = s.nodes_to_faces_offset(node); s.offsets.largest > 0 && j < s.nodes_to_faces_offset(node + 1); ++j)
    for (int k = 0; k < 4; ++k) add(CellTravels::find_patch(s.face_corners(s.nodes_to_faces(j), k)));
  if (count > NearCells::most_around) patches[0] = -1;  // too many
  for (int i = count; i < NearCells::most_around; ++i) patches[i] = -1;
}

/// The patches of nodes on which it depends whether nodes of a cell can be in contact: these, the corners of their
/// candidates, and where thickness moves faces those of the faces around. -1: they are too many.
KOKKOS_INLINE_FUNCTION int watch_cell(const ContactSurface& s, const CandidateList& all, const CellNodes& cell,
                                      const Array<const int>& around, int* watched) {
  constexpr int most_nodes = 384;
  int list[most_nodes];
  NumberSet nodes(list, most_nodes);
  for (int i = cell.first; i < cell.last; ++i) {
    const int node = all.nodes(i);
    nodes.add(node);
    for (int c = all.offset(node); c < all.offset(node + 1); ++c)
      for (int k = 0; k < 4; ++k) nodes.add(s.face_corners(all.face(c), k));
  }
  NumberSet patches(watched, CellTravels::most_watched);
  for (int i = 0; i < nodes.count; ++i) {
    const int first = NearCells::most_around * list[i];
    if (around(first) < 0) return -1;
    for (int k = 0; k < NearCells::most_around && around(first + k) >= 0; ++k) patches.add(around(first + k));
  }
  return nodes.find_count() < 0 ? -1 : patches.find_count();
}

/// Faces where travels begin.
PlacedFaces place_faces(const ContactSurface& surface, const NearCells& cells) {
  return {surface, cells.travels.origin, cells.normal, cells.turn};
}

void store_slabs_of_all(const WorkSpace& space, const CheckInputs& inputs, const CandidateList& all,
                        const NearCells& cells) {
  const ContactSurface s = inputs.surface;
  const Rows3<const double> places = inputs.motion.x;
  const Array<const int> list = all.faces, is_candidate = all.is_candidate;
  const Rows4<double> slabs = cells.slabs;
  const Rows3<double> normal = cells.normal;
  const Array<double> turn = cells.turn;
  const Array<int> is_bounded = cells.is_bounded;
  const int num_faces = all.num_faces;
  parallel_for(
      "contact::find_slabs", RangeOf(space, 0, ListedFaces::count_packs(num_faces)), KOKKOS_LAMBDA(int pack) {
        const ListedFaces listed(s, list, is_candidate, pack, num_faces);
        const FaceOf<Packed> at = load_corners(places, listed.corner);
        int stored[ListedFaces::lanes];
        alignas(64) double thickness[ListedFaces::lanes];
        for (int lane = 0; lane < ListedFaces::lanes; ++lane) {
          stored[lane] = lane < listed.count ? listed.face[lane] : -1;
          thickness[lane] = 2 * find_face_offset(s.offsets, listed.face[lane]);
        }
        const Packed edge = find_shortest_edge(find_relative(at)), thick = load_pack(thickness);
        const FaceSlabs found = find_slabs(at, select(thick > Packed(0) && thick < edge, thick, edge));
        store_slabs(found, stored, slabs);
        const LanePoints normals(found.axis[0]);
        const LaneValues turns(found.turn);
        for (int lane = 0; lane < listed.count; ++lane) {
          store_row(normal, listed.face[lane], normals[lane]);
          turn(listed.face[lane]) = turns[lane];
          is_bounded(listed.face[lane]) = 0;
        }
      });
}

MovingPoints list_points(const CheckInputs& inputs) {
  return {inputs.motion, inputs.surface.nodes, inputs.surface.num_nodes};
}

/// Marks the cells of nodes that have other histories than when they were listed.
void mark_new_histories(const WorkSpace& space, const Array<const int>& history_face, const CandidateList& all,
                        const NearCells& cells) {
  const Array<const int> nodes = all.nodes, history = history_face, known = cells.known;
  const Array<int> is_due = cells.travels.is_due;
  const int num_nodes = all.num_nodes;
  parallel_for(
      "contact::find_new_histories", RangeOf(space, 0, cells.travels.num_cells), KOKKOS_LAMBDA(int cell) {
        const CellNodes of(cell, num_nodes);
        int any = 0;
        for (int i = of.first; i < of.last; ++i)
          for (int slot = 0; slot < contact_limits::max_touches; ++slot) {
            const int record = contact_limits::max_touches * nodes(i) + slot;
            any |= history(record) != known(record) ? 1 : 0;
          }
        is_due(cell) = any;
      });
}

}  // namespace

void watch_cells(const WorkSpace& space, const ContactSurface& surface, const CandidateList& all, NearCells& cells) {
  const int num_nodes = surface.num_nodes, num_faces = surface.num_faces;
  reserve_cells((all.num_nodes + NearCells::cell_nodes - 1) / NearCells::cell_nodes, num_nodes, cells.travels);
  reserve(cells.known, contact_limits::max_touches * num_nodes);
  reserve(cells.count, num_nodes);
  reserve(cells.around, NearCells::most_around * num_nodes);
  reserve(cells.slabs, FaceSlabs::rows * num_faces);
  reserve(cells.normal, num_faces);
  reserve(cells.turn, num_faces);
  reserve(cells.is_bounded, num_faces);
  reserve(cells.to_bound, num_faces);
  reserve(cells.outward, num_faces);
  reserve(cells.nearness, all.num_pairs);
  reserve(cells.near_face, all.num_pairs);
  const ContactSurface s = surface;
  const CandidateList list = all;
  const Array<int> watched = cells.travels.watched, num_watched = cells.travels.num_watched, count = cells.count;
  const Array<int> is_bounded = cells.is_bounded;
  parallel_for(
      "contact::clear_counts", RangeOf(space, 0, num_nodes), KOKKOS_LAMBDA(int n) { count(n) = 0; });
  parallel_for(
      "contact::clear_bounds", RangeOf(space, 0, num_faces), KOKKOS_LAMBDA(int f) { is_bounded(f) = 0; });
  const Array<int> around = cells.around;
  parallel_for(
      "contact::list_patches", RangeOf(space, 0, num_nodes),
      KOKKOS_LAMBDA(int n) { list_patches_around(s, n, &around(NearCells::most_around * n)); });
  parallel_for(
      "contact::watch_cells", RangeOf(space, 0, cells.travels.num_cells), KOKKOS_LAMBDA(int cell) {
        num_watched(cell) =
            watch_cell(s, list, CellNodes(cell, list.num_nodes), around, &watched(CellTravels::most_watched * cell));
      });
}

void restart_cells(const WorkSpace& space, const CheckInputs& inputs, const CandidateList& all, double steps,
                   NearCells& cells) {
  restart_travels(space, list_points(inputs), steps, cells.travels);
  store_slabs_of_all(space, inputs, all, cells);
  cells.due_pairs = all.num_pairs;
}

void find_due_cells(const WorkSpace& space, const CheckInputs& inputs, const CandidateList& all, double steps,
                    double ahead, NearCells& cells) {
  mark_new_histories(space, inputs.history_face, all, cells);
  find_due_cells(space, list_points(inputs), steps, ahead, cells.travels);
  const Array<const int> due = cells.travels.due, nodes = all.nodes, offset = all.offset;
  const int num_nodes = all.num_nodes;
  parallel_reduce(
      "contact::count_due_pairs", RangeOf(space, 0, cells.travels.num_due),
      KOKKOS_LAMBDA(int i, int& pairs) {
        const CellNodes of(due(i), num_nodes);
        pairs += offset(nodes(of.last - 1) + 1) - offset(nodes(of.first));
      },
      cells.due_pairs);
}

namespace {

/// What the listing of a cell reads and writes.
struct ListedCells {
  ContactSurface surface;
  CandidateList all;
  Array<const int> history;
  NearCells cells;
  PlacedFaces faces;
  Rows4<const double> slabs;  // NearCells::slabs, not to be converted by each reading

  KOKKOS_INLINE_FUNCTION bool has_history(int node) const {
    bool any = false;
    for (int slot = 0; slot < contact_limits::max_touches; ++slot)
      any = any || history(contact_limits::max_touches * node + slot) >= 0;
    return any;
  }

  /// Whether the record of a face that pushed the node in the last step may pass on to this one within the travel.
  KOKKOS_INLINE_FUNCTION bool may_inherit(int node, int face, double travel) const {
    for (int slot = 0; slot < contact_limits::max_touches; ++slot) {
      const int old = history(contact_limits::max_touches * node + slot);
      if (old < 0 || !share_corner(surface, old, face)) continue;
      const double turns = chord_of_turn * travel * (cells.turn(old) + cells.turn(face));
      if (dot(load_row(cells.normal, old), load_row(cells.normal, face)) > contact_limits::inherited - turns)
        return true;
    }
    return false;
  }
  KOKKOS_INLINE_FUNCTION bool pushed(int node, int face) const {
    bool any = false;
    for (int slot = 0; slot < contact_limits::max_touches; ++slot)
      any = any || history(contact_limits::max_touches * node + slot) == face;
    return any;
  }

  /// Measures a node's candidates by their slabs. Faces that are to be looked at are marked.
  KOKKOS_INLINE_FUNCTION void measure(int node, double travel) const {
    const bool remembers = has_history(node);
    const int first = all.offset(node), last = all.offset(node + 1);
    const Point3 place = load_row(cells.travels.origin, node);
    for (int c = first; c < last; c += FaceSlabs::lanes) {
      const int pairs = last - c < FaceSlabs::lanes ? last - c : FaceSlabs::lanes;
      int one[FaceSlabs::lanes], own[FaceSlabs::lanes];
      alignas(64) double apart[FaceSlabs::lanes];
      for (int lane = 0; lane < FaceSlabs::lanes; ++lane) {
        one[lane] = all.face(lane < pairs ? c + lane : c);
        apart[lane] = find_offset(surface.offsets, node, one[lane]);
      }
      find_nearness(load_slabs(slabs, one), place, travel, load_pack(apart), own);
      for (int lane = 0; lane < pairs; ++lane) {
        const int face = one[lane];
        int& nearness = cells.nearness(c + lane);
        nearness = own[lane] == ever ? may_be_new : is_far;
        if (remembers && own[lane] != never && may_inherit(node, face, travel)) nearness |= may_go_on;
        if (remembers && pushed(node, face)) nearness = is_near;
        if (nearness > is_near && cells.is_bounded(face) != bounded)
          Kokkos::atomic_fetch_or(&cells.is_bounded(face), to_be_bounded);
      }
    }
  }

  /// Looks at those that are asked for, and lists the near ones.
  KOKKOS_INLINE_FUNCTION void look(int node, double travel) const {
    const int first = all.offset(node);
    int count = 0;
    for (int c = first; c < all.offset(node + 1); ++c) {
      if (cells.nearness(c) == is_far) continue;
      const int face = all.face(c);
      if (cells.nearness(c) > is_near) {
        PlacedPair pair;
        pair.face = face;
        for (int i = 0; i < 4; ++i) pair.corners.corner[i] = faces(surface.face_corners(face, i)) - faces(node);
        pair.offset = find_offset(surface.offsets, node, face);
        pair.size = slabs(FaceSlabs::rows * face, 3) / contact_limits::capture;
        pair.may_be_new = (cells.nearness(c) & may_be_new) != 0;
        pair.may_be_known = (cells.nearness(c) & may_go_on) != 0;
        if (stays_apart(faces, cells.outward(face), pair, travel)) continue;
      }
      cells.near_face(first + count++) = face;
    }
    cells.count(node) = count;
  }

  KOKKOS_INLINE_FUNCTION void list_all(int node) const {
    const int first = all.offset(node);
    for (int c = first; c < all.offset(node + 1); ++c) cells.near_face(c) = all.face(c);
    cells.count(node) = all.offset(node + 1) - first;
  }

  KOKKOS_INLINE_FUNCTION void note_history(int node) const {
    for (int slot = 0; slot < contact_limits::max_touches; ++slot) {
      const int record = contact_limits::max_touches * node + slot;
      cells.known(record) = history(record);
    }
  }
};

/// Finds how the faces that are marked are moved outward.
void bound_marked_faces(const WorkSpace& space, const ContactSurface& surface, const NearCells& cells) {
  const Array<int> is_bounded = cells.is_bounded;
  const int marked = list_where(
      space, surface.num_faces, [is_bounded] KOKKOS_FUNCTION(int f) { return is_bounded(f) == to_be_bounded; },
      cells.to_bound);
  const PlacedFaces faces = place_faces(surface, cells);
  const Array<const int> list = cells.to_bound;
  const Array<OutwardBound> outward = cells.outward;
  const bool has_offsets = surface.offsets.largest > 0;
  parallel_for(
      "contact::bound_outward", RangeOf(space, 0, marked), KOKKOS_LAMBDA(int i) {
        constexpr double any_travel = 1e300;
        const int face = list(i);
        is_bounded(face) = bounded;
        outward(face) = has_offsets ? find_outward_bound(faces, face) : OutwardBound{{}, 0, 0, 0, any_travel};
      });
}

void list_due_cells(const WorkSpace& space, const CheckInputs& inputs, const CandidateList& all,
                    const NearCells& cells) {
  const ListedCells listed{inputs.surface, all, inputs.history_face, cells, place_faces(inputs.surface, cells),
                           cells.slabs};
  parallel_for(
      "contact::measure_cells", RangeOf(space, 0, cells.travels.num_due), KOKKOS_LAMBDA(int i) {
        const int cell = listed.cells.travels.due(i);
        const CellNodes of(cell, listed.all.num_nodes);
        for (int k = of.first; k < of.last; ++k) {
          const int node = listed.all.nodes(k);
          listed.note_history(node);
          if (listed.cells.travels.num_watched(cell) >= 0) listed.measure(node, listed.cells.travels.allowed(cell));
        }
      });
  bound_marked_faces(space, inputs.surface, cells);
  parallel_for(
      "contact::list_cells", RangeOf(space, 0, cells.travels.num_due), KOKKOS_LAMBDA(int i) {
        const int cell = listed.cells.travels.due(i);
        const CellNodes of(cell, listed.all.num_nodes);
        for (int k = of.first; k < of.last; ++k) {
          const int node = listed.all.nodes(k);
          if (listed.cells.travels.num_watched(cell) >= 0)
            listed.look(node, listed.cells.travels.allowed(cell));
          else
            listed.list_all(node);
        }
      });
}

/// Fills `near` with the near pairs of all cells.
void gather_cells(const WorkSpace& space, const ContactSurface& surface, const CandidateList& all, NearCells& cells,
                  CandidateList& near) {
  const int num_nodes = surface.num_nodes;
  reserve(near.offset, num_nodes + 1);
  const Array<const int> count = cells.count, near_face = cells.near_face, begin = all.offset;
  const Array<int> offset = near.offset;
  parallel_scan(
      "contact::near_offset", RangeOf(space, 0, num_nodes + 1),
      KOKKOS_LAMBDA(int n, int& place, bool final_pass) {
        if (final_pass) offset(n) = place;
        if (n < num_nodes) place += count(n);
      },
      near.num_pairs);
  reserve(near.face, near.num_pairs);
  const Array<int> face = near.face;
  parallel_for(
      "contact::gather_near_pairs", RangeOf(space, 0, num_nodes), KOKKOS_LAMBDA(int n) {
        for (int i = 0; i < count(n); ++i) face(offset(n) + i) = near_face(begin(n) + i);
      });
  list_concerned(space, surface, cells.concerned, near);
}

}  // namespace

void list_near(const WorkSpace& space, const CheckInputs& inputs, const CandidateList& all, NearCells& cells,
               CandidateList& near) {
  if (cells.travels.num_due == 0) return;
  list_due_cells(space, inputs, all, cells);
  gather_cells(space, inputs.surface, all, cells, near);
}

}  // namespace percuss
