#include "src/contact/check/check_space.hpp"

#include <algorithm>

#include "kernels/core/counting_sort.hpp"
#include "kernels/core/host_copy.hpp"
#include "kernels/core/view_copy.hpp"
#include "src/contact/surface/face_corners.hpp"
#include "src/contact/surface/surface_sides.hpp"

namespace percuss {
namespace {

/// Faces around each node.
Buckets list_node_faces(const std::vector<std::array<int, 4>>& corners, std::size_t num_nodes) {
  return collect_buckets<int>(num_nodes, [&](auto&& put) {
    for (std::size_t f = 0; f < corners.size(); ++f)
      for (std::size_t i = 0; i < 4; ++i)
        if (corners[f][i] >= 0 && !is_repeated(corners[f], i))
          put(static_cast<std::size_t>(corners[f][i]), static_cast<int>(f));
  });
}

/// Half the thickness of each node: that of the thickest shell around it, or the radius of its beam.
std::vector<double> find_node_offsets(const SurfaceLists& lists, const Buckets& node_faces) {
  const std::vector<double>& face_offset = lists.face_offset;
  std::vector<double> offset = lists.node_radius;
  offset.resize(node_faces.first.size() - 1, 0);
  for (std::size_t n = 0; n < offset.size(); ++n)
    for (int f = node_faces.first[n]; f < node_faces.first[n + 1]; ++f)
      offset[n] =
          std::max(offset[n], face_offset[static_cast<std::size_t>(node_faces.items[static_cast<std::size_t>(f)])]);
  return offset;
}

SurfaceOffsets make_offsets(const SurfaceLists& lists, const Buckets& node_faces, double largest) {
  const SideRings rings = find_side_rings(lists.corners, lists.face_offset, node_faces);
  return {largest,
          to_view("contact::face_offset", lists.face_offset),
          to_view("contact::node_offset", find_node_offsets(lists, node_faces)),
          to_view("contact::first_in_ring", rings.first),
          to_view("contact::side_rings", rings.faces),
          to_view("contact::open_corners", rings.is_open)};
}

/// The body of each node is that of its faces; -1 for nodes of no face here.
std::vector<int> find_node_bodies(const Buckets& node_faces, const std::vector<int>& face_body) {
  std::vector<int> body(node_faces.first.size() - 1, -1);
  for (std::size_t n = 0; n < body.size(); ++n) {
    if (node_faces.first[n] == node_faces.first[n + 1]) continue;
    body[n] = face_body[static_cast<std::size_t>(node_faces.items[static_cast<std::size_t>(node_faces.first[n])])];
  }
  return body;
}

}  // namespace

ContactSurface make_contact_surface(const SurfaceLists& lists, const SurfaceShare& share) {
  const Buckets node_faces = list_node_faces(lists.corners, lists.nodes.size());
  ContactSurface surface;
  surface.num_nodes = static_cast<int>(lists.nodes.size());
  surface.num_faces = static_cast<int>(lists.corners.size());
  surface.nodes = to_view("contact::surface_nodes", lists.nodes);
  surface.nodes_to_faces_offset = to_view("contact::nodes_to_faces_offset", node_faces.first);
  surface.nodes_to_faces = to_view("contact::nodes_to_faces", node_faces.items);
  surface.face_corners = to_rows("contact::face_corners", lists.corners);
  surface.face_backs = to_rows("contact::face_backs", lists.backs);
  surface.face_body = to_view("contact::face_body", lists.face_body);
  surface.node_body = to_view("contact::node_body", find_node_bodies(node_faces, lists.face_body));
  surface.node_class = to_view("contact::node_class", lists.node_class);
  surface.face_class = to_view("contact::face_class", lists.face_class);
  surface.num_classes = share.num_classes;
  surface.searched_nodes = to_view("contact::searched_nodes", lists.searched_nodes);
  surface.searched_faces = to_view("contact::searched_faces", lists.searched_faces);
  surface.pair_friction = share.pair_friction;
  surface.pair_number = share.pair_number;
  if (share.largest_offset > 0 && !lists.face_offset.empty())
    surface.offsets = make_offsets(lists, node_faces, share.largest_offset);
  return surface;
}

void set_surface(const ContactSurface& surface, const std::vector<std::int64_t>& face_numbers, CheckSpace& check) {
  set_surface(surface, to_view("contact::face_numbers", face_numbers), check);
}

void set_surface(const ContactSurface& surface, const Array<const std::int64_t>& face_numbers, CheckSpace& check) {
  check.surface = surface;
  check.face_numbers = face_numbers;
  const auto faces = static_cast<std::size_t>(surface.num_faces);
  if (check.faces.size.extent(0) < faces) {
    check.faces = {};
    check.faces = {Rows3<double>("contact::face_normal", faces), Array<double>("contact::face_size", faces),
                   Boxes("contact::face_box", faces)};
    check.faces.is_prepared = Array<int>("contact::prepared_faces", faces);
    check.faces.reads = Array<int>("contact::face_reads", faces);
    check.faces.vertex = Array<CornerDirections>("contact::vertex_normals", faces);
    if (surface.offsets.largest > 0) {
      check.faces.slab = Array<FaceSlab>("contact::face_slab", faces);
      check.faces.outward = Array<OutwardDirections>("contact::outward_directions", faces);
    }
  }
  reserve(check.history_face, contact_limits::max_touches * surface.num_nodes);
  set_values(check.history_face, -1);
  check.still.forget();
}

void NearPairs::ask(const NearWay& way) {
  way_ = way;
  reachable_.ask(way.search > 0, way.keeps_first);
  near_.ask(way.near > 0, false);
}

void NearPairs::fill(const CheckInputs& inputs, const CandidateList& of, double travel, NearList<CandidateList>& part) {
  part.make(of, [&](double most_pairs, CandidateList& list) {
    bool is_listed = false;
    run_where_it_pays(inputs.surface.num_faces / 2, [&](const auto& space) {
      is_listed = list_near_pairs(space, inputs, of, {travel, most_pairs}, scratch_, list);
    });
    return is_listed;
  });
}

void NearPairs::make(const CheckInputs& inputs, const CandidateList& all) {
  fill(inputs, all, way_.search, reachable_);
  fill(inputs, reachable_pairs(all), way_.near, near_);
}

void check_candidates(const SurfaceMotion& motion, CheckSpace& check) {
  check.touches.count = check.touches.num_new = 0;
  check.counts.candidates += check.candidates.num_pairs;
  check.counts.left_out += check.candidates.num_pairs - check.read_pairs().num_pairs;
  check.still.begin(check.keeps_still, check.surface.num_faces);
  if (check.read_pairs().num_pairs == 0) return;
  run_where_it_pays(check.read_pairs().num_pairs, [&](const auto& space) {
    update_faces(space, check.surface, motion, check.read_pairs(), check.still, check.faces);
    space.fence();
  });
  const CheckInputs inputs = check.make_inputs(motion);
  if (check.near.is_asked()) check.near.make(inputs, check.candidates);
  run_where_it_pays(check.checked_pairs().num_pairs, [&](const auto& space) {
    find_touches(space, inputs, check.checked_pairs(), check.still, check.touches);
  });
  check.counts.left_out += check.touches.num_kept_pairs;
}

void measure_all_faces(const SurfaceMotion& motion, CheckSpace& check) {
  check.still.forget();  // what is known of faces is no longer of the last check
  run_where_it_pays(check.candidates.num_pairs, [&](const auto& space) {
    update_faces(space, check.surface, motion, check.candidates, StillFaces(), check.faces);
    space.fence();
  });
}

PenetrationTable measure_candidates(const SurfaceMotion& motion, CheckSpace& check) {
  PenetrationTable table;
  measure_all_faces(motion, check);
  run_where_it_pays(check.candidates.num_pairs, [&](const auto& space) {
    find_penetrations(space, check.surface, motion, check.candidates, check.faces, table);
  });
  return table;
}

void add_gap(const PartGap& more, std::vector<PartGap>& gaps) {
  const auto is_before = [](const PartGap& a, const PartGap& b) {
    return a.part != b.part ? a.part < b.part : a.other < b.other;
  };
  const auto place = std::lower_bound(gaps.begin(), gaps.end(), more, is_before);
  if (place == gaps.end() || is_before(more, *place))
    gaps.insert(place, more);
  else
    place->gap = std::min(place->gap, more.gap);
}

std::vector<PartGap> measure_gaps(const SurfaceMotion& motion, CheckSpace& check, const std::vector<int>& face_part) {
  const CandidateList& candidates = check.candidates;
  std::vector<PartGap> found;
  if (candidates.num_pairs == 0) return found;
  Array<double> gaps("contact::gaps", 0);
  measure_all_faces(motion, check);
  run_where_it_pays(candidates.num_pairs,
                    [&](const auto& space) { find_gaps(space, check.surface, motion, candidates, check.faces, gaps); });
  const auto gap = to_host(gaps);
  const auto nodes = to_host(candidates.nodes), offset = to_host(candidates.offset), face = to_host(candidates.face);
  const auto first_face = to_host(check.surface.nodes_to_faces_offset), faces = to_host(check.surface.nodes_to_faces);
  const auto part_of = [&](int f) { return face_part[static_cast<std::size_t>(f)]; };
  for (int i = 0; i < candidates.num_nodes; ++i) {
    const int node = nodes(i);
    if (first_face(node) == first_face(node + 1)) continue;  // of a particle or a beam
    const int part = part_of(faces(first_face(node)));
    for (int c = offset(node); c < offset(node + 1); ++c) {
      if (gap(c) < 0) continue;
      const int other = part_of(face(c));
      add_gap({std::min(part, other), std::max(part, other), gap(c)}, found);
    }
  }
  return found;
}

}  // namespace percuss
