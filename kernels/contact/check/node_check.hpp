#pragma once
// The detailed check of contact nodes: which of the faces that a node is in contact with does it obey?
//
// One face on a convex neighbourhood; several on a concave one (a corner between faces) and on other bodies, up to
// three independent normals. Candidates are ordered by integer keys: a comparison with tolerances is no strict order.

#include "kernels/contact/check/pair_check.hpp"

namespace percuss {

/// Order of the faces of a node: history, then time, what is kept last; then least penetration, then least distance
/// beside the face, then the face of the last step, then its number.
struct TouchKey {
  int value[6];
};

KOKKOS_INLINE_FUNCTION bool operator<(const TouchKey& a, const TouchKey& b) {
  for (int i = 0; i < 6; ++i)
    if (a.value[i] != b.value[i]) return a.value[i] < b.value[i];
  return false;
}

/// value / quantum to the nearest integer, within the range of int.
KOKKOS_INLINE_FUNCTION int quantise(double value, double quantum) {
  constexpr double largest = 1e9;
  const double ratio = value / quantum;
  if (!(ratio < largest)) return static_cast<int>(largest);
  return static_cast<int>(floor(ratio + 0.5));
}

KOKKOS_INLINE_FUNCTION TouchKey make_key(const Touch& touch) {
  const double depth = touch.gap_end < 0 ? -touch.gap_end : 0;
  TouchKey key;
  key.value[0] = touch.record >= 0 ? 0 : 1;
  key.value[1] = touch.record < 0 ? quantise(touch.tau, contact_limits::time_quantum) : touch.is_kept ? 1 : 0;
  key.value[2] = quantise(depth, contact_limits::depth_quantum * touch.size);
  key.value[3] = quantise(touch.off, contact_limits::off_quantum * touch.size);
  key.value[4] = touch.same_face ? 0 : 1;
  key.value[5] = touch.face;
  return key;
}

/// The best touches of a node in the order of their keys.
struct TouchList {
  static constexpr int capacity = 12;  // more faces than meet at a vertex of two bodies; the worst fall off the end
  int count = 0;
  Touch touch[capacity];
  TouchKey key[capacity];

  KOKKOS_INLINE_FUNCTION void insert(const Touch& t) {
    const TouchKey k = make_key(t);
    if (count == capacity && !(k < key[capacity - 1])) return;
    if (count < capacity) ++count;
    int place = count - 1;
    for (; place > 0 && k < key[place - 1]; --place) {
      touch[place] = touch[place - 1];
      key[place] = key[place - 1];
    }
    touch[place] = t;
    key[place] = k;
  }
};

/// Whether two faces of one body bulge: each one's middle lies behind the other. A node cannot be held by both.
KOKKOS_INLINE_FUNCTION bool are_convex(const ContactSurface& surface, const SurfaceMotion& motion,
                                       const FaceState& faces, int a, int b) {
  if (surface.face_body(a) != surface.face_body(b)) return false;
  const int origin = surface.nodes(surface.face_corners(a, 0));
  const Point3 o = load_row(motion.x, origin), vo = load_row(motion.v, origin);
  Point3 from_a_to_b{};
  for (int i = 0; i < 4; ++i) {
    const int p = surface.nodes(surface.face_corners(a, i)), q = surface.nodes(surface.face_corners(b, i));
    const Point3 at_p = (load_row(motion.x, p) - o) + motion.dt * (load_row(motion.v, p) - vo);
    const Point3 at_q = (load_row(motion.x, q) - o) + motion.dt * (load_row(motion.v, q) - vo);
    from_a_to_b = from_a_to_b + (at_q - at_p);
  }
  return dot(from_a_to_b, load_row(faces.normal, a)) < 0 && dot(from_a_to_b, load_row(faces.normal, b)) > 0;
}

/// Takes found touch `best` into the accepted ones: itself and all that push the same way, of which one is enough, are
/// then decided, and so are the faces that bulge away from any of these: the node passes them by. On a seam between
/// level bodies it is thus not caught by the side of the next one.
KOKKOS_INLINE_FUNCTION void decide_around(const ContactSurface& surface, const SurfaceMotion& motion,
                                          const FaceState& faces, const TouchList& found, int best, bool* decided) {
  bool is_same_way[TouchList::capacity], any_other = false;
  for (int i = 0; i < found.count; ++i) {
    is_same_way[i] = !(dot(found.touch[i].normal, found.touch[best].normal) <= contact_limits::independent);
    any_other = any_other || !(decided[i] || is_same_way[i]);
  }
  for (int i = 0; i < found.count; ++i) {
    if (decided[i] || !is_same_way[i]) continue;
    decided[i] = true;
    for (int j = 0; any_other && j < found.count; ++j)
      if (!decided[j] && are_convex(surface, motion, faces, found.touch[i].face, found.touch[j].face))
        decided[j] = true;
  }
}

/// Finds the gap at n of a touch that was accepted without it.
template <Thickness thickness>
KOKKOS_INLINE_FUNCTION void settle_start(const MovingSurface& moving, const CheckedNode& node, Touch& touch) {
  if (!touch.owes_start) return;
  const double offset =
      thickness == Thickness::of_shells ? find_offset(moving.surface.offsets, node.node, touch.face) : 0;
  measure_start(load_touched_face(moving, node.x, node.v, touch.face, offset).start, touch);
}

/// Whether the face and one that pushed the node in the last step meet in a valley: the node may slide from the one
/// behind the other.
KOKKOS_INLINE_FUNCTION bool is_across_valley(const ContactSurface& surface, const SurfaceMotion& motion,
                                             const FaceState& faces, const KnownFaces& known, int face) {
  for (const int old : known.face)
    if (old >= 0 && old != face && share_corner(surface, old, face) && !are_convex(surface, motion, faces, old, face))
      return true;
  return false;
}

/// A node that slips in just below an edge goes through a face that looks past it. It is lifted over the edge by the
/// neighbour that it then lies behind by a little, rather than caught by the face; without such a neighbour it is
/// caught.
template <Thickness thickness>
KOKKOS_INLINE_FUNCTION bool is_ruled_out(const MovingSurface& moving, const KnownFaces& known, const CheckedNode& node,
                                         TouchList& found, int i) {
  const ContactSurface& surface = moving.surface;
  const SurfaceMotion& motion = moving.motion;
  const FaceState& faces = moving.faces;
  const Touch& touch = found.touch[i];
  if (touch.same_face || (touch.opposed && !touch.beside)) return false;
  if (touch.opposed && is_across_valley(surface, motion, faces, known, touch.face)) return false;
  for (int j = 0; j < found.count; ++j) {
    const Touch& other = found.touch[j];
    const bool is_edge =
        share_corner(surface, touch.face, other.face) && are_convex(surface, motion, faces, touch.face, other.face);
    if (!is_edge || touch.opposed == other.opposed) continue;
    Touch& lift = touch.opposed ? found.touch[i] : found.touch[j];
    settle_start<thickness>(moving, node, lift);
    return (lift.gap_start >= -contact_limits::lift_depth * lift.size) != touch.opposed;
  }
  return touch.beside;
}

/// A history slot is continued by one touch only: the first that asks. The others start anew.
KOKKOS_INLINE_FUNCTION void claim_record(const NodeTouches& accepted, Touch& touch) {
  for (int i = 0; i < accepted.count; ++i)
    if (accepted.touch[i].record == touch.record) touch.record = -1;
}

/// Sorts the accepted touches by face, the order of rows and sums.
KOKKOS_INLINE_FUNCTION void sort_by_face(NodeTouches& touches) {
  for (int i = 1; i < touches.count; ++i)
    for (int j = i; j > 0 && touches.touch[j].face < touches.touch[j - 1].face; --j) {
      const Touch swap = touches.touch[j];
      touches.touch[j] = touches.touch[j - 1];
      touches.touch[j - 1] = swap;
    }
}

/// The faces that a node obeys of those found, in the order of their keys.
template <Thickness thickness>
KOKKOS_INLINE_FUNCTION void accept_touches(const MovingSurface& moving, const KnownFaces& known,
                                           const CheckedNode& node, TouchList& found, NodeTouches& accepted) {
  bool decided[TouchList::capacity];
  for (int i = 0; i < found.count; ++i) decided[i] = is_ruled_out<thickness>(moving, known, node, found, i);
  accepted.count = 0;
  for (int i = 0; i < found.count && accepted.count < contact_limits::max_touches; ++i) {
    if (decided[i]) continue;
    Touch touch = found.touch[i];
    settle_start<thickness>(moving, node, touch);
    claim_record(accepted, touch);
    accepted.touch[accepted.count++] = touch;
    decide_around(moving.surface, moving.motion, moving.faces, found, i, decided);
  }
  sort_by_face(accepted);
}

/// Turn in which candidates are checked: first the faces that pushed the node in the last step; then others, but for
/// those that cannot change what the first hold; at last these, if others are in contact too.
enum class Turn { remembered, others, skipped, all };

/// Whether the faces that are found, which pushed the node in the last step, take precedence over all other faces,
/// whatever those yield: no key is less than theirs, and each of them is obeyed.
KOKKOS_INLINE_FUNCTION bool are_first(const TouchList& found, const NodeTouches& accepted) {
  if (found.count != accepted.count) return false;
  int sum = 0;
  for (int i = 0; i < found.count; ++i)
    for (int k = 0; k < 5; ++k) sum |= found.key[i].value[k];
  return sum == 0;
}

/// Whether a face, if it is in contact too, pushes the same way as one of the first that hold the node (are_first())
/// and takes none of the others away: it is then not obeyed, and changes nothing. Its push direction is a mean of its
/// vertex normals with weights that are not negative, but for the band beside a face.
KOKKOS_INLINE_FUNCTION bool adds_nothing(const MovingSurface& moving, const TouchList& holds, int num_holds, int face) {
  constexpr double same = contact_limits::independent + 2e-3;   // of all vertex normals: so is their mean
  constexpr double other = contact_limits::independent - 0.05;  // divided by `same`: less than independent
  const Point3 normal = load_row(moving.faces.normal, face);
  bool may_be = false;
  for (int i = 0; i < num_holds; ++i) may_be = may_be || dot(normal, holds.touch[i].normal) > same;
  if (!may_be || !moving.faces.has_prepared(face)) return false;
  const CornerDirections& vertex = moving.faces.vertex(face);
  int num_same = 0;
  for (int i = 0; i < num_holds; ++i) {
    double least = 1, most = -1;
    for (int k = 0; k < 4; ++k) {
      const double cosine = dot(vertex.of[k], holds.touch[i].normal);
      least = cosine < least ? cosine : least;
      most = cosine > most ? cosine : most;
    }
    if (least > same)
      ++num_same;
    else if (!(most < other) || moving.surface.face_body(face) == moving.surface.face_body(holds.touch[i].face))
      return false;
  }
  return num_same == 1;
}

/// Faces of candidates whose box the node meets.
struct NearFaces {
  static constexpr int most = 64;
  int count = 0;
  int face[most];

  /// Lists those of candidate c and after, as far as there is room; returns the first that it has not looked at.
  template <class Faces>
  KOKKOS_INLINE_FUNCTION int fill(const CheckedNode& node, const Boxes& box, const Faces& candidates, int c) {
    count = 0;
    for (; c < candidates.last && count < most; ++c)
      if (const int near = candidates(c); near >= 0 && is_in_box(node, box, near)) face[count++] = near;
    return c;
  }
};

/// Places in NearFaces that are skipped.
struct SkippedFaces {
  std::uint64_t bits = 0;
  int count = 0;

  KOKKOS_INLINE_FUNCTION bool has(int i) const { return (bits >> i & 1) != 0; }
  KOKKOS_INLINE_FUNCTION void add(int i) {
    bits |= std::uint64_t{1} << i;
    ++count;
  }
};

/// State of the check of a node, from turn to turn. Faces: its candidates, candidates(candidates.first) to
/// candidates(candidates.last - 1) that are not negative.
template <class Faces>
struct NodeCheck : PairNode {
  Faces candidates;
  NodeTouches* accepted;  // out
  NearFaces near;
  TouchList found;
  SkippedFaces skipped;
  Turn turn;
  int num_first;  // of those found, that hold the node before all others
  int next;       // the first candidate that is not among the near ones yet
  bool is_done;

  KOKKOS_INLINE_FUNCTION void begin(const CheckInputs& inputs, int node, const Faces& faces, NodeTouches& out) {
    at = load_checked_node(inputs.surface, inputs.motion, node);
    known = load_known_faces(inputs.faces, inputs.history_face, at);
    candidates = faces;
    accepted = &out;
    found.count = num_first = 0;
    skipped = {};
    is_done = false;
    next = near.fill(at, inputs.faces.box, faces, faces.first);
    const bool remembers = known.face[0] >= 0 || known.face[1] >= 0 || known.face[2] >= 0;
    turn = remembers && faces.skips && next == faces.last ? Turn::remembered : Turn::all;
  }

  /// Whether the near face at this place is checked in this turn.
  KOKKOS_INLINE_FUNCTION bool is_in_turn(const MovingSurface& moving, int place) {
    if (turn == Turn::all) return true;
    const int face = near.face[place];
    const bool is_remembered = face == known.face[0] || face == known.face[1] || face == known.face[2];
    if (turn == Turn::remembered || is_remembered) return turn == Turn::remembered && is_remembered;
    if (turn == Turn::skipped) return skipped.has(place);
    if (num_first == 0 || !adds_nothing(moving, found, num_first, face)) return true;
    skipped.add(place);
    return false;
  }

  /// Ends a turn and chooses the next one.
  template <Thickness thickness>
  KOKKOS_INLINE_FUNCTION void end_turn(const CheckInputs& inputs) {
    if (next < candidates.last) {
      next = near.fill(at, inputs.faces.box, candidates, next);
      return;
    }
    if (turn == Turn::others && num_first > 0 && found.count == num_first) {  // what was accepted stands
      is_done = true;
      return;
    }
    if (turn == Turn::others && skipped.count > 0) {
      turn = Turn::skipped;
      return;
    }
    accept_touches<thickness>(inputs, known, at, found, *accepted);
    is_done = turn != Turn::remembered;
    if (is_done) {
      skipped.count = 0;
      return;
    }
    num_first = are_first(found, *accepted) ? found.count : 0;
    turn = Turn::others;
  }
};

/// Nodes that are checked together, so that few lanes of a pack of pairs stay empty: a node in contact has one to three
/// faces to check.
template <class Faces>
struct NodeGroup {
  static constexpr int most = FacePack::lanes;
  int count = 0;
  NodeCheck<Faces> of[most];
};

/// A turn of the nodes of a group. pairs: memory.
template <Thickness thickness, class Faces>
KOKKOS_INLINE_FUNCTION void check_turn(const MovingSurface& moving, NodeGroup<Faces>& group, PairPack& pairs) {
  for (int node = 0, place = 0; node < group.count;) {
    pairs.faces.count = 0;  // other lanes keep what they have
    while (node < group.count && pairs.faces.count < FacePack::lanes) {
      NodeCheck<Faces>& check = group.of[node];
      if (check.is_done || place == check.near.count) {
        ++node;
        place = 0;
        continue;
      }
      if (check.is_in_turn(moving, place)) add_pair<thickness>(moving, check, node, check.near.face[place], pairs);
      ++place;
    }
    check_pairs<thickness>(
        moving, [&](int i) -> const PairNode& { return group.of[i]; }, pairs,
        [&](int i, const Touch& t) { group.of[i].found.insert(t); });
  }
}

/// Checks the nodes of a group. Returns how many of their candidates were skipped.
template <Thickness thickness, class Faces>
KOKKOS_INLINE_FUNCTION int check_group(const CheckInputs& inputs, NodeGroup<Faces>& group) {
  PairPack pairs;
  for (int open = group.count; open > 0;) {
    check_turn<thickness>(inputs, group, pairs);
    open = 0;
    for (int i = 0; i < group.count; ++i) {
      NodeCheck<Faces>& check = group.of[i];
      if (!check.is_done) check.template end_turn<thickness>(inputs);
      open += check.is_done ? 0 : 1;
    }
  }
  int skipped = 0;
  for (int i = 0; i < group.count; ++i) skipped += group.of[i].skipped.count;
  return skipped;
}

}  // namespace percuss
