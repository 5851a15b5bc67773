#include "kernels/contact/search/pair_search.hpp"

#include "kernels/core/index_lists.hpp"

namespace percuss {

template <class Rule>
std::int64_t find_hits(const WorkSpace& space, const PointQuery& query, const Rule& rule, std::int64_t max_pairs,
                       SearchScratch& scratch, CandidateList& list) {
  if (scratch.method == SearchMethod::blocks)
    return find_hits_by_blocks(space, query, rule, max_pairs, scratch.blocks, list);
  return find_hits_by_points_in_box(space, query, rule, max_pairs, scratch.lists, list);
}

std::int64_t find_candidate_pairs(const WorkSpace& space, const ContactSurface& surface, const SearchedPlaces& places,
                                  std::int64_t max_pairs, SearchScratch& scratch, CandidateList& list) {
  const int n = static_cast<int>(surface.searched_nodes.extent(0));
  reserve(scratch.points, n);
  const Array<int> points = scratch.points;
  const ContactSurface s = surface;
  parallel_for(
      "contact::list_points", RangeOf(space, 0, n), KOKKOS_LAMBDA(int i) { points(i) = s.nodes(s.searched_nodes(i)); });
  const Array<const int> rows = Kokkos::subview(points, std::make_pair(0, n));  // without what is to spare
  const PointQuery query{places.x,         rows, surface.searched_nodes, places.boxes, surface.searched_faces,
                         surface.num_nodes};
  return find_hits(space, query, NodeFaceRule{surface}, max_pairs, scratch, list);
}

void list_concerned(const WorkSpace& space, const ContactSurface& surface, ConcernedScratch& scratch,
                    CandidateList& list) {
  reserve(scratch.mark, surface.num_faces);
  reserve(scratch.read_nodes, surface.num_nodes);
  reserve(list.nodes, surface.num_nodes);
  reserve(list.faces, surface.num_faces);
  reserve(list.is_candidate, surface.num_faces);
  const ContactSurface s = surface;
  const Array<int> mark = scratch.mark, offset = list.offset, face = list.face;
  const Array<int> read = scratch.read_nodes;
  parallel_for(
      "contact::clear_marks", RangeOf(space, 0, surface.num_faces), KOKKOS_LAMBDA(int f) { mark(f) = 0; });
  const int num_pairs = list.num_pairs;
  parallel_for(
      "contact::mark_candidates", RangeOf(space, 0, num_pairs),
      KOKKOS_LAMBDA(int c) { Kokkos::atomic_fetch_or(&mark(face(c)), 1); });
  // Nodes around which all faces are read: those with candidates and the corners of candidates.
  parallel_for(
      "contact::mark_nodes", RangeOf(space, 0, surface.num_nodes), KOKKOS_LAMBDA(int n) {
        int any = offset(n) < offset(n + 1) ? 1 : 0;
        for (int j = s.nodes_to_faces_offset(n); j < s.nodes_to_faces_offset(n + 1); ++j)
          any |= mark(s.nodes_to_faces(j));
        read(n) = any;
      });
  parallel_for(
      "contact::mark_faces", RangeOf(space, 0, surface.num_faces), KOKKOS_LAMBDA(int f) {
        int any = 0;
        for (int i = 0; i < 4; ++i) any |= read(s.face_corners(f, i));
        mark(f) |= any << 1;
      });
  list.num_faces = list_where(
      space, surface.num_faces, [mark] KOKKOS_FUNCTION(int f) { return mark(f) != 0; }, list.faces);
  const Array<int> faces = list.faces, is_candidate = list.is_candidate;
  parallel_for(
      "contact::mark_boxed", RangeOf(space, 0, list.num_faces),
      KOKKOS_LAMBDA(int i) { is_candidate(i) = mark(faces(i)) & 1; });
  list.num_nodes = list_where(
      space, surface.num_nodes, [offset] KOKKOS_FUNCTION(int n) { return offset(n) < offset(n + 1); }, list.nodes);
}

template std::int64_t find_hits(const WorkSpace&, const PointQuery&, const EdgePairRule&, std::int64_t, SearchScratch&,
                                CandidateList&);

}  // namespace percuss
