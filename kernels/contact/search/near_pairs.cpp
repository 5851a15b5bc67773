#include "kernels/contact/search/near_pairs.hpp"

#include "kernels/contact/surface/listed_faces.hpp"

namespace percuss {
namespace {

/// Largest approach of node and face to the reach of the check, in travels: each by one, and the reach grows with the
/// edges of the face, which grow by two.
constexpr double approach_in_travel = 2 * (1 + contact_limits::capture);
/// Room for round-off.
constexpr double near_slack = 1e-3;

/// How near a pair can come. A node has its histories from faces that it comes near ever, and they pass from face to
/// face by common corners: where no such way leads, a pair is unlinked and never near.
enum Nearness : int { never, unlinked, with_history, linked_now, ever };

/// Faces at n as nodes see them, one a lane: their normals and two axes along them.
struct FaceSlabs {
  static constexpr int lanes = packed_lanes, rows = 5;  // of four values in memory
  PackedPoint origin, axis[3];
  Packed low[3], high[3];  // least and greatest height of a corner over the origin, by axis
  Packed capture;          // reach of the check, without thickness
  Packed turn;             // what the sine of the angle that a normal turns by is at most; 1: no bound
};

/// Adds an axis of the slabs: any unit vector, or none.
PERCUSS_FORCE_INLINE void set_axis(const FaceOf<Packed>& face, int k, const PackedPoint& axis, FaceSlabs& slabs) {
  slabs.axis[k] = axis;
  for (int i = 0; i < 4; ++i) {
    const Packed height = dot(axis, face.corner[i]);
    slabs.low[k] = i == 0 ? height : smaller(slabs.low[k], height);
    slabs.high[k] = i == 0 ? height : larger(slabs.high[k], height);
  }
}

/// size: h; travel: how far each corner may move.
PERCUSS_FORCE_INLINE FaceSlabs find_slabs(const FaceOf<Packed>& at, const Packed& size, const Packed& travel) {
  const FaceOf<Packed> face = find_relative(at);
  const PackedPoint a = face.corner[2] - face.corner[0], b = face.corner[3] - face.corner[1], area = cross(a, b),
                    along = (face.corner[1] - face.corner[0]) + (face.corner[2] - face.corner[3]);
  const PackedPoint normal = normalize(area), first = normalize(along);
  FaceSlabs slabs{};
  slabs.origin = at.corner[0];
  slabs.capture = Packed(contact_limits::capture) * size;
  set_axis(face, 0, normal, slabs);
  set_axis(face, 1, first, slabs);
  set_axis(face, 2, cross(normal, first), slabs);
  // Each diagonal changes by twice the travel at most.
  const Packed whole = norm(area), change = Packed(2) * travel * (norm(a) + norm(b) + Packed(2) * travel);
  slabs.turn = select(change < whole, change / whole, Packed(1));
  return slabs;
}

/// face: by lane, -1: not to be stored.
PERCUSS_FORCE_INLINE void store_slabs(const FaceSlabs& slabs, const int (&face)[FaceSlabs::lanes],
                                      const Rows4<double>& to) {
  const Packed values[FaceSlabs::rows][4] = {{slabs.origin.x, slabs.origin.y, slabs.origin.z, slabs.capture},
                                             {slabs.axis[0].x, slabs.axis[0].y, slabs.axis[0].z, slabs.turn},
                                             {slabs.axis[1].x, slabs.axis[1].y, slabs.axis[1].z, slabs.low[1]},
                                             {slabs.axis[2].x, slabs.axis[2].y, slabs.axis[2].z, slabs.high[1]},
                                             {slabs.low[0], slabs.high[0], slabs.low[2], slabs.high[2]}};
  for (int r = 0; r < FaceSlabs::rows; ++r) {
    alignas(64) double packs[4][FaceSlabs::lanes];
    int row[FaceSlabs::lanes];
    for (int k = 0; k < 4; ++k) store_pack(packs[k], values[r][k]);
    for (int lane = 0; lane < FaceSlabs::lanes; ++lane)
      row[lane] = face[lane] < 0 ? -1 : FaceSlabs::rows * face[lane] + r;
    store_rows_of_four(packs, row, to.data());
  }
}

PERCUSS_FORCE_INLINE FaceSlabs load_slabs(const Rows4<const double>& from, const int (&face)[FaceSlabs::lanes]) {
  Packed values[FaceSlabs::rows][4];
  for (int r = 0; r < FaceSlabs::rows; ++r) {
    alignas(64) double packs[4][FaceSlabs::lanes];
    int row[FaceSlabs::lanes];
    for (int lane = 0; lane < FaceSlabs::lanes; ++lane) row[lane] = FaceSlabs::rows * face[lane] + r;
    load_rows_of_four(from.data(), row, packs);
    for (int k = 0; k < 4; ++k) values[r][k] = load_pack(packs[k]);
  }
  const auto& [first, normal, along, across, heights] = values;
  return {{first[0], first[1], first[2]},
          {{normal[0], normal[1], normal[2]}, {along[0], along[1], along[2]}, {across[0], across[1], across[2]}},
          {heights[0], along[3], heights[2]},
          {heights[1], across[3], heights[3]},
          first[3],
          normal[3]};
}

/// How near pairs of a node and the faces of the lanes can come while each side moves by what `approach` has for it.
/// offset: the distance that they keep by lane. Without a history, a node is accepted within the capture of the face
/// moved outward by thickness; with one, by the offset farther behind it as well.
PERCUSS_FORCE_INLINE void find_nearness(const FaceSlabs& slabs, const Point3& place, double approach,
                                        const Packed& offset, int (&nearness)[FaceSlabs::lanes]) {
  const PackedPoint from = spread_to_pack(place) - slabs.origin;
  const Packed nearer = slabs.capture + Packed(approach), capture = nearer + Packed(near_slack) * (nearer + offset);
  const Packed reach = capture + Packed(1 + longest_mitre) * offset, one(1), zero(0);
  Packed low[3], high[3];  // of the faces over the node
  for (int k = 0; k < 3; ++k) {
    const Packed height = dot(slabs.axis[k], from);
    low[k] = slabs.low[k] - height;
    high[k] = slabs.high[k] - height;
  }
  const auto is_out =
      low[0] > reach || high[0] < -reach || low[1] > reach || high[1] < -reach || low[2] > reach || high[2] < -reach;
  // The moved face is higher by the offset along a normal that turns, and its corners by as much along it at most.
  const Packed least = offset * (one - Packed(2) * slabs.turn), most = offset * (one + slabs.turn);
  const auto is_apart =
      offset > zero && slabs.turn < Packed(0.5) && (low[0] + least > capture || high[0] + most < -capture);
  alignas(64) double found[FaceSlabs::lanes];
  const auto spread = [](int value) { return Packed(value); };
  store_pack(found, select(is_out, spread(never), select(is_apart, spread(unlinked), spread(ever))));
  for (int lane = 0; lane < FaceSlabs::lanes; ++lane) nearness[lane] = static_cast<int>(found[lane]);
}

/// Whether the face pushed the node in the last step.
KOKKOS_INLINE_FUNCTION bool is_in_history(const Array<const int>& history_face, int node, int face) {
  for (int slot = 0; slot < contact_limits::max_touches; ++slot)
    if (history_face(contact_limits::max_touches * node + slot) == face) return true;
  return false;
}

/// Links what shares a corner with candidate `b`: nothing of another body, as the other layers of a stack.
KOKKOS_INLINE_FUNCTION void link_to(const ContactSurface& surface, const Array<const int>& face,
                                    const Array<int>& nearness, int b, int first, int last) {
  const int body = surface.face_body(face(b));
  for (int c = first; c < last; ++c) {
    if (nearness(c) != unlinked || surface.face_body(face(c)) != body) continue;
    if (share_corner(surface, face(b), face(c))) nearness(c) = linked_now;
  }
}

/// Follows these ways from the pairs that are near ever, from each pair once.
KOKKOS_INLINE_FUNCTION void link_histories(const ContactSurface& surface, const Array<const int>& face,
                                           const Array<int>& nearness, int first, int last) {
  for (int b = first; b < last; ++b)
    if (nearness(b) == ever) link_to(surface, face, nearness, b, first, last);
  for (bool any = true; any;) {
    any = false;
    for (int b = first; b < last; ++b) {
      if (nearness(b) != linked_now) continue;
      nearness(b) = with_history;
      link_to(surface, face, nearness, b, first, last);
      any = true;
    }
  }
}

}  // namespace

namespace {

/// Stores the faces of the candidate pairs as nodes see them.
void store_face_slabs(const WorkSpace& space, const CheckInputs& inputs, const CandidateList& all, double travel,
                      const Rows4<double>& slabs) {
  const ContactSurface s = inputs.surface;
  const Rows3<const double> places = inputs.motion.x;
  const Array<const double> size = inputs.faces.size;
  const Array<const int> list = all.faces, is_candidate = all.is_candidate;
  const int num_faces = all.num_faces;
  parallel_for(
      "contact::find_slabs", RangeOf(space, 0, ListedFaces::count_packs(num_faces)), KOKKOS_LAMBDA(int pack) {
        const ListedFaces listed(s, list, is_candidate, pack, num_faces);
        if (!listed.any_candidate) return;
        int stored[ListedFaces::lanes];
        alignas(64) double h[ListedFaces::lanes];
        for (int lane = 0; lane < ListedFaces::lanes; ++lane) {
          const bool is_listed = lane < listed.count && listed.is_candidate[lane];
          stored[lane] = is_listed ? listed.face[lane] : -1;
          h[lane] = is_listed ? size(listed.face[lane]) : 0;
        }
        store_slabs(find_slabs(load_corners(places, listed.corner), load_pack(h), Packed(travel)), stored, slabs);
      });
}

/// Finds how near each pair is. count: out, [contact nodes] pairs that are to be listed; nearness: out, [pairs].
void measure_nearness(const WorkSpace& space, const CheckInputs& inputs, const CandidateList& all, double travel,
                      const NearScratch& scratch) {
  const ContactSurface s = inputs.surface;
  const Rows3<const double> places = inputs.motion.x;
  const Array<const int> history = inputs.history_face, offset = all.offset, face = all.face;
  const Array<int> count = scratch.count, nearness = scratch.nearness;
  const Rows4<double> slabs = scratch.slabs;
  const double approach = approach_in_travel * travel;
  parallel_for(
      "contact::find_near_pairs", RangeOf(space, 0, s.num_nodes), KOKKOS_LAMBDA(int node) {
        const int first = offset(node), last = offset(node + 1);
        count(node) = 0;
        if (first == last) return;
        bool any = false, any_unlinked = false;
        const Point3 place = load_row(places, s.nodes(node));
        for (int c = first; c < last; c += FaceSlabs::lanes) {
          const int pairs = last - c < FaceSlabs::lanes ? last - c : FaceSlabs::lanes;
          int one[FaceSlabs::lanes], own[FaceSlabs::lanes];
          alignas(64) double apart[FaceSlabs::lanes];
          for (int lane = 0; lane < FaceSlabs::lanes; ++lane) {
            one[lane] = face(lane < pairs ? c + lane : c);
            apart[lane] = find_offset(s.offsets, node, one[lane]);
          }
          find_nearness(load_slabs(slabs, one), place, approach, load_pack(apart), own);
          for (int lane = 0; lane < pairs; ++lane) {
            if (own[lane] != ever && is_in_history(history, node, one[lane])) own[lane] = ever;
            nearness(c + lane) = own[lane];
            any = any || own[lane] == ever;
            any_unlinked = any_unlinked || own[lane] == unlinked;
          }
        }
        if (any && any_unlinked) link_histories(s, face, nearness, first, last);
        for (int c = first; c < last; ++c) count(node) += nearness(c) >= with_history ? 1 : 0;
      });
}

/// Lists the pairs that are near, at the offsets of `near`.
void fill_near_list(const WorkSpace& space, const ContactSurface& surface, const CandidateList& all,
                    const Array<const int>& nearness, CandidateList& near) {
  const bool has_thickness = surface.offsets.largest > 0;
  reserve(near.face, near.num_pairs);
  if (has_thickness) reserve(near.with_history, near.num_pairs);
  const Array<const int> offset = all.offset, face = all.face, near_offset = near.offset, measured = nearness;
  const Array<int> near_face = near.face, flag = near.with_history;
  parallel_for(
      "contact::list_near_pairs", RangeOf(space, 0, surface.num_nodes), KOKKOS_LAMBDA(int node) {
        int place = near_offset(node);
        for (int c = offset(node); c < offset(node + 1); ++c) {
          if (measured(c) < with_history) continue;
          if (has_thickness) flag(place) = measured(c) == with_history ? 1 : 0;
          near_face(place++) = face(c);
        }
      });
}

}  // namespace

bool list_near_pairs(const WorkSpace& space, const CheckInputs& inputs, const CandidateList& all,
                     const NearLimits& limits, NearScratch& scratch, CandidateList& near) {
  const ContactSurface& surface = inputs.surface;
  const int num_nodes = surface.num_nodes;
  reserve(scratch.count, num_nodes);
  reserve(scratch.nearness, all.num_pairs);
  reserve(scratch.slabs, FaceSlabs::rows * surface.num_faces);
  reserve(near.offset, num_nodes + 1);
  store_face_slabs(space, inputs, all, limits.travel, scratch.slabs);
  measure_nearness(space, inputs, all, limits.travel, scratch);
  const Array<const int> count = scratch.count;
  const Array<int> near_offset = near.offset;
  parallel_scan(
      "contact::near_offset", RangeOf(space, 0, num_nodes + 1),
      KOKKOS_LAMBDA(int n, int& place, bool final_pass) {
        if (final_pass) near_offset(n) = place;
        if (n < num_nodes) place += count(n);
      },
      near.num_pairs);
  if (near.num_pairs > limits.most_pairs) return false;
  fill_near_list(space, surface, all, Array<const int>(scratch.nearness), near);
  list_concerned(space, surface, scratch.concerned, near);
  return true;
}

}  // namespace percuss
