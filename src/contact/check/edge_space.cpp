#include "src/contact/check/edge_space.hpp"

#include <algorithm>
#include <numeric>

#include "kernels/core/host_copy.hpp"

namespace percuss {

EdgeSurface make_edge_surface(const std::vector<EdgeTopology>& edges, const FindRow& find_row,
                              const SurfaceShare& share) {
  std::vector<std::int64_t> numbers;
  std::vector<std::array<int, 2>> ends;
  std::vector<std::array<int, 4>> wings;
  std::vector<std::array<std::int64_t, 2>> elements;
  std::vector<int> classes;
  std::vector<double> offsets;
  std::vector<int> blunt;
  std::vector<EdgeScale> scales;
  for (const EdgeTopology& edge : edges) {
    numbers.push_back(edge.number);
    ends.push_back({find_row(edge.ends[0]), find_row(edge.ends[1])});
    wings.push_back(
        {find_row(edge.wings[0]), find_row(edge.wings[1]), find_row(edge.wings[2]), find_row(edge.wings[3])});
    elements.push_back({edge.elements[0], edge.elements[1]});
    classes.push_back(edge.surface_class);
    if (share.largest_offset > 0) offsets.push_back(edge.offset);
    blunt.push_back(edge.is_blunt);
    scales.push_back(edge.scale);
  }
  if (std::count(blunt.begin(), blunt.end(), 0) == static_cast<std::ptrdiff_t>(blunt.size())) blunt.clear();
  if (std::none_of(blunt.begin(), blunt.end(), [](int kind) { return kind >= smooth_line; })) scales.clear();
  EdgeSurface surface;
  surface.num_edges = static_cast<int>(edges.size());
  surface.numbers = to_view("contact::edge_numbers", numbers);
  surface.ends = to_rows("contact::edge_ends", ends);
  surface.wings = to_rows("contact::edge_wings", wings);
  surface.elements = to_rows("contact::edge_elements", elements);
  surface.edge_class = to_view("contact::edge_class", classes);
  surface.offset = to_view("contact::edge_offset", offsets);
  surface.is_blunt = to_view("contact::blunt_edges", blunt);
  surface.scale = to_view("contact::edge_scale", scales);
  surface.springs = share.springs;
  surface.num_classes = share.num_classes;
  surface.pair_friction = share.pair_friction;
  surface.pair_number = share.pair_number;
  return surface;
}

bool divide_again(const Rows2<const int>& ends, const Rows3<const double>& x, double piece,
                  std::vector<EdgeTopology>& edges) {
  const Array<double> lengths("contact::edge_lengths", edges.size());
  const int count = static_cast<int>(edges.size());
  loop_where_it_pays(
      "contact::edge_lengths", count, count / 2,
      KOKKOS_LAMBDA(int e) { lengths(e) = norm(load_row(x, ends(e, 1)) - load_row(x, ends(e, 0))); });
  const auto length = to_host(lengths);
  bool has_changed = false;
  for (std::size_t e = 0; e < edges.size(); ++e) {
    const int pieces = count_pieces(length(e), piece);
    has_changed = has_changed || pieces != edges[e].pieces;
    edges[e].pieces = pieces;
  }
  return has_changed;
}

EdgePointLists list_edge_points(const std::vector<EdgeTopology>& edges, const Rows2<const int>& ends,
                                const std::vector<char>& points_of) {
  std::vector<int> pieces, first{0}, edge_of_point;
  for (std::size_t e = 0; e < edges.size(); ++e) {
    const bool is_searched = points_of.empty() || points_of[e] != 0;
    pieces.push_back(is_searched ? edges[e].pieces : 0);
    first.push_back(first.back() + pieces.back());
    edge_of_point.insert(edge_of_point.end(), static_cast<std::size_t>(pieces.back()), static_cast<int>(e));
  }
  const auto count_up = [](std::size_t n) {
    std::vector<int> list(n);
    std::iota(list.begin(), list.end(), 0);
    return list;
  };
  EdgePointLists lists;
  lists.names.first_point = to_view("contact::first_edge_point", first);
  lists.names.edge_of_point = to_view("contact::edge_of_point", edge_of_point);
  lists.names.points = to_view("contact::edge_points", count_up(edge_of_point.size()));
  lists.names.edges = to_view("contact::searched_edges", count_up(edges.size()));
  lists.points = {first.back(), ends, to_view("contact::edge_pieces", pieces), lists.names.first_point};
  return lists;
}

void set_edge_surface(const EdgeSurface& surface, EdgeSpace& space) {
  space.surface = surface;
  space.pairs.num_pairs = 0;
  space.pairs.num_edges = 0;
  space.near.forget();
  space.still.forget();
  const auto edges = static_cast<std::size_t>(surface.num_edges);
  if (space.state.boxes.extent(0) < edges) space.state.boxes = Boxes("contact::edge_step_boxes", edges);
  if (surface.offset.extent(0) == 0)
    space.state.faces = Array<EdgeFaces>("contact::edge_faces", 0);
  else if (space.state.faces.extent(0) < edges)
    space.state.faces = Array<EdgeFaces>("contact::edge_faces", edges);
}

void NearEdges::make(const EdgeSurface& surface, const SurfaceMotion& motion, const EdgePairs& all) {
  near_.make(all, [&](double most_pairs, EdgePairs& list) {
    bool is_listed = false;
    run_where_it_pays(all.num_pairs / 4, [&](const auto& where) {
      is_listed = list_near_edges(where, {surface, motion, {}, {}}, all, {travel_, most_pairs}, scratch_, list);
      where.fence();
    });
    list.list = std::min(list.list, -1) - 1;  // no search has such numbers
    return is_listed;
  });
}

int check_edge_pairs(const SurfaceMotion& motion, const EdgeHistory& history, EdgeSpace& space) {
  space.touches.count = space.touches.num_new = 0;
  space.still.begin(space.keeps_still, space.surface.num_edges);
  if (space.checked_pairs().num_pairs == 0) return 0;
  run_where_it_pays(space.checked_pairs().num_pairs, [&](const auto& where) {
    update_edges(where, space.surface, motion, space.checked_pairs(), space.still, space.state);
    where.fence();
  });
  if (space.near.is_asked()) space.near.make(space.surface, motion, space.pairs);
  if (space.checked_pairs().num_pairs == 0) return 0;
  run_where_it_pays(space.checked_pairs().num_pairs, [&](const auto& where) {
    find_edge_touches(where, {space.surface, motion, space.state, history}, space.checked_pairs(), space.still,
                      space.touches);
  });
  return space.touches.count;
}

void append_edge_touches(const EdgeSpace& space, int count, Array<RowTouch>& touches) {
  const int added = space.touches.count;
  if (added == 0) return;
  run_where_it_pays(added, [&](const auto& where) { keep_and_reserve(where, touches, count, count + added); });
  const EdgeSurface s = space.surface;
  const Array<const int> a = space.checked_pairs().a, b = space.checked_pairs().b, list = space.touches.list;
  const Array<const EdgeTouch> by_pair = space.touches.by_pair;
  const Array<RowTouch> out = touches;
  loop_where_it_pays(
      "contact::append_edge_touches", added, added, KOKKOS_LAMBDA(int k) {
        const int pair = list(k), edge = a(pair), other = b(pair);
        int order = 0;
        while (order < k && a(list(k - order - 1)) == edge) ++order;
        RowTouch row = make_edge_row_touch(by_pair(pair));
        row.key = make_edge_row_key(s.numbers(edge), order);
        row.face = s.numbers(other);
        row.friction = find_edge_friction(s, edge, other);
        row.pair = find_edge_pair_number(s, edge, other);
        row.record = k;
        for (int i = 0; i < 2; ++i) {
          row.node[i] = s.ends(edge, i);
          row.node[i + 2] = s.ends(other, i);
        }
        out(count + k) = row;
      });
}

std::vector<EdgePenetration> measure_edge_pairs(const SurfaceMotion& motion, EdgeSpace& space) {
  std::vector<EdgePenetration> found;
  if (space.pairs.num_pairs == 0) return found;
  space.still.forget();
  run_where_it_pays(space.pairs.num_pairs, [&](const auto& where) {
    find_edge_depths(where, space.surface, motion, space.pairs, space.touches);
    where.fence();
  });
  const auto list = to_host(space.touches.list), a = to_host(space.pairs.a), b = to_host(space.pairs.b);
  const auto touches = to_host(space.touches.by_pair);
  const auto numbers = to_host(space.surface.numbers);
  for (int k = 0; k < space.touches.count; ++k) {
    const int pair = list(k);
    const EdgeTouch& touch = touches(pair);
    found.push_back({numbers(a(pair)), numbers(b(pair)), touch.normal, -touch.gap_start, touch.size,
                     std::max(contact_limits::history_depth * touch.size, static_cast<double>(touch.offset))});
  }
  return found;
}

}  // namespace percuss
