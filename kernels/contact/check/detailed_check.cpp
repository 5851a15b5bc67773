#include "kernels/contact/check/detailed_check.hpp"

#include "kernels/contact/check/node_check.hpp"
#include "kernels/contact/surface/listed_faces.hpp"
#include "kernels/core/index_lists.hpp"
#include "kernels/core/view_copy.hpp"

namespace percuss {
namespace {

/// Further data of the faces.
struct MeasuredFaces : ListedFaces {
  int back[4][lanes];                    // mesh nodes; behind faces that are not boxed the corners
  alignas(64) double offset[lanes];      // of the thickness of shells
  alignas(64) double box_offset[lanes];  // by how much more the box reaches for it

  KOKKOS_INLINE_FUNCTION MeasuredFaces(const ContactSurface& surface, const Array<const int>& list,
                                       const Array<const int>& boxed, int pack, int num_faces)
      : ListedFaces(surface, list, boxed, pack, num_faces) {
    for (int lane = 0; lane < lanes; ++lane) {
      for (int k = 0; k < 4; ++k)
        back[k][lane] = is_candidate[lane] ? surface.face_backs(face[lane], k) : corner[k][lane];
      offset[lane] = find_face_offset(surface.offsets, face[lane]);
      box_offset[lane] = find_offset_reach(offset[lane], surface.offsets.largest);
    }
  }
};

KOKKOS_INLINE_FUNCTION void store_box(const Boxes& boxes, int face, const Point3& low, const Point3& high) {
  boxes(face, 0) = low.x, boxes(face, 1) = low.y, boxes(face, 2) = low.z;
  boxes(face, 3) = high.x, boxes(face, 4) = high.y, boxes(face, 5) = high.z;
}

/// The motion of their corners, by itself and relative to the first, and their normals at the predicted place.
struct CornerMotions {
  const FaceOf<Packed>&at, &velocity;
  const RelativeFaceOf<Packed>& relative;
  const PackedPoint& normal;
};

/// Size, box and slab of those faces that are boxed.
PERCUSS_FORCE_INLINE void measure_boxed(const SurfaceOffsets& offsets, const SurfaceMotion& motion,
                                        const MeasuredFaces& faces, const CornerMotions& corners,
                                        const FaceState& out) {
  const auto& [at, velocity, relative, normal] = corners;
  // Distance from the middle of a face to that of the opposite side of its element.
  const FaceOf<Packed> behind = load_corners(motion.x, faces.back);
  PackedPoint sum = at.corner[0] - behind.corner[0];
  for (int k = 1; k < 4; ++k) sum = sum + (at.corner[k] - behind.corner[k]);
  const Packed offset = load_pack(faces.offset), dt(motion.dt);
  const Packed thickness = select(offset > Packed(0), Packed(2) * offset, Packed(0.25) * norm(sum));
  const Packed size = smaller(thickness, find_shortest_edge(relative.start));
  const Packed reach = Packed(contact_limits::capture) * size + load_pack(faces.box_offset);
  const BoxOf<Packed> box = bound_corners(at, velocity, dt, reach);
  const LaneValues sizes(size);
  const LanePoints lows(box.low), highs(box.high);
  for (int lane = 0; lane < faces.count; ++lane) {
    if (!faces.is_candidate[lane]) continue;
    out.size(faces.face[lane]) = sizes[lane];
    store_box(out.box, faces.face[lane], lows[lane], highs[lane]);
  }
  if (!(offsets.largest > 0)) return;
  const FaceSlabOf<Packed> slab = find_slab(at.corner[0], dt * velocity.corner[0], relative, normal);
  const LanePoints origin(slab.origin), move(slab.move), normal_at_start(slab.normal_at_start);
  const LaneValues low_start(slab.low_start), high_start(slab.high_start), low_end(slab.low_end),
      high_end(slab.high_end), turn(slab.turn);
  for (int lane = 0; lane < faces.count; ++lane) {
    if (!faces.is_candidate[lane]) continue;
    out.slab(faces.face[lane]) = {origin[lane],  move[lane],     low_start[lane],       high_start[lane],
                                  low_end[lane], high_end[lane], normal_at_start[lane], turn[lane]};
  }
}

PERCUSS_NO_INLINE void measure_faces(const SurfaceOffsets& offsets, const SurfaceMotion& motion,
                                     const MeasuredFaces& faces, const FaceState& out) {
  const FaceOf<Packed> at = load_corners(motion.x, faces.corner), velocity = load_corners(motion.v, faces.corner);
  // Relative to the first corner, so that nothing degrades far from the origin of the coordinates.
  RelativeFaceOf<Packed> relative{find_relative(at), find_relative(velocity)};
  for (int k = 0; k < 4; ++k) relative.move.corner[k] = Packed(motion.dt) * relative.move.corner[k];
  const PackedPoint normal = find_face_normal(find_end(relative));
  const LanePoints normals(normal);
  for (int lane = 0; lane < faces.count; ++lane) {
    store_row(out.normal, faces.face[lane], normals[lane]);
    if (faces.is_candidate[lane]) continue;
    constexpr double beyond = 1e300;  // a box that meets nothing
    store_box(out.box, faces.face[lane], {beyond, beyond, beyond}, {-beyond, -beyond, -beyond});
  }
  if (faces.any_candidate) measure_boxed(offsets, motion, faces, {at, velocity, relative, normal}, out);
}

/// The candidate faces of a node: of the list those from first to last - 1.
struct NodeCandidates {
  const int* face;
  const int* with_history;  // null: none is left out; else those that only a node with a history is checked against are
  bool skips;               // whether faces that cannot change what holds the node are left out
  int first, last;

  /// -1: left out.
  KOKKOS_INLINE_FUNCTION int operator()(int c) const {
    return with_history != nullptr && with_history[c] != 0 ? -1 : face[c];
  }
};

KOKKOS_INLINE_FUNCTION bool has_history(const Array<const int>& history_face, int node) {
  for (int slot = 0; slot < contact_limits::max_touches; ++slot)
    if (history_face(contact_limits::max_touches * node + slot) >= 0) return true;
  return false;
}

using Group = NodeGroup<NodeCandidates>;

/// Flattened: a pair is checked by some fifty small functions.
template <Thickness thickness>
PERCUSS_FLATTEN KOKKOS_FUNCTION int check_group_flat(const CheckInputs& inputs, Group& group) {
  return check_group<thickness>(inputs, group);
}

/// The first of the candidates whose box the node meets in the step, or `last`: for most nodes, in most steps, there is
/// none.
KOKKOS_INLINE_FUNCTION int find_first_near(const MovingSurface& moving, int node, const NodeCandidates& candidates) {
  const CheckedNode checked = load_checked_node(moving.surface, moving.motion, node);
  int first = candidates.first;
  for (; first < candidates.last; ++first)
    if (const int face = candidates(first); face >= 0 && is_in_box(checked, moving.faces.box, face)) break;
  return first;
}

/// Marks the faces that the check before read often enough; returns how many.
int mark_read_faces(const WorkSpace& space, const FaceState& state, const CandidateList& candidates) {
  const FaceState faces = state;
  const Array<const int> list = candidates.faces, is_candidate = candidates.is_candidate;
  int count = 0;
  parallel_reduce(
      "contact::mark_read_faces", RangeOf(space, 0, candidates.num_faces),
      KOKKOS_LAMBDA(int i, int& marked) {
        const int face = list(i);
        const bool is_worth_it = is_candidate(i) != 0 && faces.reads(face) >= faces.worth_preparing();
        faces.is_prepared(face) = is_worth_it ? 1 : 0;
        faces.reads(face) = 0;
        marked += is_worth_it ? 1 : 0;
      },
      count);
  return count;
}

/// Whether of the faces around a node that are prepared this one comes first.
KOKKOS_INLINE_FUNCTION bool is_first_prepared(const ContactSurface& surface, const FaceState& faces, int node,
                                              int face) {
  int j = surface.nodes_to_faces_offset(node);
  while (faces.is_prepared(surface.nodes_to_faces(j)) == 0) ++j;
  return surface.nodes_to_faces(j) == face;
}

/// Finds the directions of faces that the check before read. In: normals and slabs of this step.
void prepare_faces(const WorkSpace& space, const MovingSurface& surface, const CandidateList& candidates) {
  if (surface.faces.is_prepared.extent(0) == 0 || mark_read_faces(space, surface.faces, candidates) == 0) return;
  const MovingSurface moving = surface;
  const Array<const int> list = candidates.faces;
  const bool has_shells = surface.surface.offsets.largest > 0;
  parallel_for(
      "contact::prepare_faces", RangeOf(space, 0, candidates.num_faces), KOKKOS_LAMBDA(int i) {
        const int face = list(i);
        if (moving.faces.is_prepared(face) == 0) return;
        if (has_shells) {  // half of the faces around a node are those of the other side, which little touches
          moving.faces.vertex(face) = find_vertex_normals(moving.surface, moving.faces, face, [](int) { return true; });
          moving.faces.outward(face) = find_outward_directions(moving, face);
          return;
        }
        for (int k = 0; k < 4; ++k) {
          const int corner = moving.surface.face_corners(face, k);
          if (is_first_prepared(moving.surface, moving.faces, corner, face))
            set_vertex_normals_at(moving.surface, moving.faces, corner);
        }
      });
}

}  // namespace

void update_faces(const WorkSpace& space, const ContactSurface& surface, const SurfaceMotion& motion,
                  const CandidateList& candidates, const StillFaces& still, const FaceState& faces) {
  const ContactSurface s = surface;
  const SurfaceMotion m = motion;
  const FaceState out = faces;
  const StillFaces resting = still;
  const bool is_watched = still.is_watched();
  const Array<const int> list = candidates.faces, is_candidate = candidates.is_candidate;
  const int num_faces = candidates.num_faces;
  parallel_for(
      "contact::update_faces", RangeOf(space, 0, ListedFaces::count_packs(num_faces)), KOKKOS_LAMBDA(int pack) {
        const MeasuredFaces measured(s, list, is_candidate, pack, num_faces);
        bool has_moved = !is_watched;
        for (int lane = 0; is_watched && lane < measured.count; ++lane) {
          const auto row = [&](int k) { return k < 4 ? measured.corner[k][lane] : measured.back[k - 4][lane]; };
          const bool is_still = resting.look(m, measured.face[lane], measured.is_candidate[lane] ? 8 : 4, row);
          has_moved = has_moved || !is_still;
        }
        if (has_moved) measure_faces(s.offsets, m, measured, out);
      });
  prepare_faces(space, {surface, motion, faces}, candidates);
}

namespace {

/// Whether some face around a node has moved since the last check. Nothing is known of a particle, which has none.
KOKKOS_INLINE_FUNCTION bool has_moved_around(const ContactSurface& surface, const StillFaces& still, int node) {
  const int first = surface.nodes_to_faces_offset(node), last = surface.nodes_to_faces_offset(node + 1);
  for (int j = first; j < last; ++j)
    if (still.has_moved(surface.nodes_to_faces(j))) return true;
  return first == last;
}

/// Candidate faces, and how many of them lie still with all around them.
struct StillCount {
  int still = 0, faces = 0;
};

/// Marks the candidate faces around whose corners some face has moved.
StillCount mark_near_moved(const WorkSpace& space, const ContactSurface& surface, const CandidateList& candidates,
                           const StillFaces& still, const Array<int>& near_moved) {
  const ContactSurface s = surface;
  const StillFaces resting = still;
  const Array<const int> list = candidates.faces, is_candidate = candidates.is_candidate;
  StillCount count;
  parallel_reduce(
      "contact::near_moved", RangeOf(space, 0, candidates.num_faces),
      KOKKOS_LAMBDA(int i, int& still_faces, int& faces) {
        if (is_candidate(i) == 0) return;
        bool has_moved = resting.has_moved(list(i));
        for (int k = 0; k < 4 && !has_moved; ++k) has_moved = has_moved_around(s, resting, s.face_corners(list(i), k));
        near_moved(list(i)) = has_moved ? 1 : 0;
        still_faces += has_moved ? 0 : 1;
        ++faces;
      },
      count.still, count.faces);
  return count;
}

/// Memory of the nodes and faces for the watch of what lies still.
void reserve_watch(const ContactSurface& surface, const CandidateList& candidates, TouchTable& table) {
  reserve(table.near_moved, surface.num_faces);
  reserve(table.checked, candidates.num_nodes);
  if (static_cast<int>(table.checked_at.extent(0)) >= surface.num_nodes) return;
  reserve(table.checked_at, surface.num_nodes);
  reserve(table.is_still, surface.num_nodes);
  reserve(table.known, contact_limits::max_touches * surface.num_nodes);
  set_values(table.checked_at, std::int64_t{-1});
}

/// Marks the nodes for which what the last check found still holds: TouchTable::checked_at is then this check, and -1
/// for the others. Notes what all of them remember.
void mark_kept_nodes(const WorkSpace& space, const CheckInputs& inputs, const CandidateList& candidates,
                     const StillFaces& still, const TouchTable& table) {
  const ContactSurface s = inputs.surface;
  const StillFaces resting = still;
  const Array<const int> nodes = candidates.nodes, offset = candidates.offset, face = candidates.face;
  const Array<const int> history = inputs.history_face, near_moved = table.near_moved;
  const Array<int> known = table.known, is_still = table.is_still;
  const Array<std::int64_t> checked_at = table.checked_at;
  const std::int64_t now = still.now(), before = still.before();
  parallel_for(
      "contact::find_kept_nodes", RangeOf(space, 0, candidates.num_nodes), KOKKOS_LAMBDA(int i) {
        const int node = nodes(i);
        bool is_kept = checked_at(node) == before;
        for (int slot = 0; slot < contact_limits::max_touches; ++slot) {
          const int record = contact_limits::max_touches * node + slot;
          is_kept = is_kept && known(record) == history(record);
          known(record) = history(record);
        }
        is_kept = is_kept && !has_moved_around(s, resting, node);
        is_still(node) = is_kept ? 1 : 0;
        for (int c = offset(node); is_kept && c < offset(node + 1); ++c) is_kept = near_moved(face(c)) == 0;
        checked_at(node) = is_kept ? now : -1;
      });
}

/// The nodes to be checked: those that moved, or something near them, or that remember other faces than in the last
/// check. Returns how many, of them or of all nodes if still faces are not watched and none are listed.
int list_checked_nodes(const WorkSpace& space, const CheckInputs& inputs, const CandidateList& candidates,
                       StillFaces& still, TouchTable& table) {
  table.num_kept_pairs = 0;
  if (!still.is_watched()) return candidates.num_nodes;
  reserve_watch(inputs.surface, candidates, table);
  const StillCount count = mark_near_moved(space, inputs.surface, candidates, still, table.near_moved);
  still.count_still(count.still, count.faces);
  mark_kept_nodes(space, inputs, candidates, still, table);
  const Array<const int> nodes = candidates.nodes, offset = candidates.offset;
  const Array<std::int64_t> checked_at = table.checked_at;
  const Array<int> checked = table.checked;
  const std::int64_t now = still.now();
  const int num_checked = list_where(
      space, candidates.num_nodes, [nodes, checked_at] KOKKOS_FUNCTION(int i) { return checked_at(nodes(i)) < 0; },
      table.checked);
  std::int64_t checked_pairs = 0;
  parallel_reduce(
      "contact::count_checked_pairs", RangeOf(space, 0, num_checked),
      KOKKOS_LAMBDA(int k, std::int64_t& pairs) {
        const int node = nodes(checked(k));
        pairs += offset(node + 1) - offset(node);
        checked_at(node) = now;
      },
      checked_pairs);
  table.num_kept_pairs = candidates.num_pairs - checked_pairs;
  return num_checked;
}

/// Touches of a node in the check before, if it and its faces are at rest.
struct StillTouches {
  int count = -1;  // -1: the node does not lie still
  int face[contact_limits::max_touches]{}, record[contact_limits::max_touches]{};

  StillTouches() = default;
  KOKKOS_FUNCTION explicit StillTouches(const NodeTouches* touches) {
    if (touches == nullptr) return;
    count = touches->count;
    for (int i = 0; i < count; ++i) {
      face[i] = touches->touch[i].face;
      record[i] = touches->touch[i].record;
    }
  }

  /// Whether these are the same: of a face that lies still, with those around it, nothing else can have changed.
  KOKKOS_FUNCTION bool are(const NodeTouches& touches, const Array<const int>& near_moved) const {
    if (count != touches.count) return false;
    for (int i = 0; i < count; ++i)
      if (face[i] != touches.touch[i].face || record[i] != touches.touch[i].record || near_moved(face[i]) != 0)
        return false;
    return true;
  }
};

/// The kernel of the detailed check: a block of nodes, those that have a candidate near in groups.
template <Thickness thickness>
struct CheckNodes {
  static constexpr int block_nodes = Group::most > 1 ? 4 * Group::most : 1;
  CheckInputs inputs;
  Array<const int> nodes, offset, face, with_history;  // CandidateList
  Array<const int> checked, is_still, near_moved;      // TouchTable
  Array<NodeTouches> by_node;
  int num_checked = 0;
  bool is_listed = false;  // whether `checked` names the nodes to be checked, or it is all of them
  bool skips = false;      // candidates that cannot change what holds a node

  /// found: touches that may not be those of the check before.
  KOKKOS_FUNCTION void operator()(int block, int& found, std::int64_t& skipped) const {
    const int last = block_nodes * (block + 1), end = last < num_checked ? last : num_checked;
    Group group;
    for (int k = block_nodes * block; k < end; ++k) {
      const int node = nodes(is_listed ? checked(k) : k);
      const NodeCandidates near = list_near(node);
      if (near.first == near.last)
        by_node(node).count = 0;
      else
        group.of[group.count++].begin(inputs, node, near, by_node(node));
      if (group.count == Group::most) check(group, found, skipped);
    }
    check(group, found, skipped);
  }

  /// The candidates of a node from the first that is near.
  KOKKOS_FUNCTION NodeCandidates list_near(int node) const {
    const bool leaves_out = with_history.extent(0) > 0 && !has_history(inputs.history_face, node);
    NodeCandidates own{face.data(), leaves_out ? with_history.data() : nullptr, skips, offset(node), offset(node + 1)};
    own.first = find_first_near(inputs, node, own);
    return own;
  }

  KOKKOS_FUNCTION void check(Group& group, int& found, std::int64_t& skipped) const {
    if (group.count == 0) return;
    StillTouches before[Group::most];
    for (int i = 0; i < group.count; ++i) {
      const int node = group.of[i].at.node;
      before[i] = StillTouches(is_listed && is_still(node) != 0 ? &by_node(node) : nullptr);
    }
    skipped += check_group_flat<thickness>(inputs, group);
    for (int i = 0; i < group.count; ++i) {
      const NodeTouches& touches = by_node(group.of[i].at.node);
      found += before[i].are(touches, near_moved) ? 0 : touches.count;
    }
    group.count = 0;
  }
};

/// is_listed: whether TouchTable::checked names the nodes to be checked, or it is all of them.
template <Thickness thickness>
void check_nodes(const WorkSpace& space, const CheckInputs& inputs, const CandidateList& candidates, bool is_listed,
                 int num_checked, TouchTable& table) {
  // Where nothing may be left out, nothing is watched. Nodes of shells seldom have anything to skip.
  const bool skips = thickness == Thickness::none && table.checked_at.extent(0) > 0;
  using Kernel = CheckNodes<thickness>;
  const int blocks = (num_checked + Kernel::block_nodes - 1) / Kernel::block_nodes;
  std::int64_t num_skipped = 0;
  parallel_reduce("contact::detailed_check", RangeOf(space, 0, blocks),
                  Kernel{inputs, candidates.nodes, candidates.offset, candidates.face, candidates.with_history,
                         table.checked, table.is_still, table.near_moved, table.by_node, num_checked, is_listed, skips},
                  table.num_new, num_skipped);
  table.num_kept_pairs += num_skipped;
}

}  // namespace

void find_touches(const WorkSpace& space, const CheckInputs& inputs, const CandidateList& candidates, StillFaces& still,
                  TouchTable& table) {
  const ContactSurface& surface = inputs.surface;
  if (static_cast<int>(table.by_node.extent(0)) < surface.num_nodes) still.forget();
  reserve(table.by_node, surface.num_nodes);
  reserve(table.first, candidates.num_nodes);
  const int num_checked = list_checked_nodes(space, inputs, candidates, still, table);
  const bool is_listed = still.is_watched();
  if (surface.offsets.largest > 0)
    check_nodes<Thickness::of_shells>(space, inputs, candidates, is_listed, num_checked, table);
  else
    check_nodes<Thickness::none>(space, inputs, candidates, is_listed, num_checked, table);
  const Array<const int> nodes = candidates.nodes;
  const Array<NodeTouches> by_node = table.by_node;
  const Array<int> place_of_first = table.first;
  parallel_scan(
      "contact::first_touch", RangeOf(space, 0, candidates.num_nodes),
      KOKKOS_LAMBDA(int i, int& place, bool final_pass) {
        if (final_pass) place_of_first(i) = place;
        place += by_node(nodes(i)).count;
      },
      table.count);
}

}  // namespace percuss
