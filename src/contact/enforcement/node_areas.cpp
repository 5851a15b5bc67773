#include "src/contact/enforcement/node_areas.hpp"

#include <algorithm>
#include <array>

#include "kernels/core/host_copy.hpp"
#include "kernels/core/small_space.hpp"
#include "kernels/core/view_copy.hpp"
#include "src/index.hpp"

namespace percuss {
namespace {

bool has_number(const FaceTopology& face) { return face.number >= 0; }  // particles have none

}  // namespace

NodeAreas::NodeAreas(const ContactRanks& ranks, const SurfaceShare& share)
    : has_many_ranks_(ranks.ranks.size() > 1), data_(ranks.ranks), num_own_(static_cast<int>(share.faces.size())) {
  corners_ = to_rows("contact::area_corners", share.face_corners);
  areas_ = Rows3<double>("contact::corner_areas", share.faces.size() + share.foreign_faces.size());
  nodes_.around.first = to_view("contact::area_first_face", share.nodes.first_face);
  nodes_.around.faces = to_view("contact::area_faces", share.nodes.faces);
  nodes_.around.areas = areas_;
  nodes_.numbers = to_view("contact::area_node_numbers", share.nodes.numbers);
  std::vector<std::int64_t> numbers;
  std::vector<int> owners;
  for (const FaceTopology& face : share.foreign_faces) {
    // The area of a particle stays zero: it requests that of no face.
    if (!has_number(face)) continue;
    numbers.push_back(face.number);
    owners.push_back(ranks.numbering.find_element_owner(find_element_of_face(face.number)));
  }
  UnstructuredExchange exchange(ranks.ranks);
  foreign_.name(exchange, data_, owners, numbers, [&](std::int64_t number) {
    const auto found = std::lower_bound(share.faces.begin(), share.faces.end(), number,
                                        [](const FaceTopology& face, std::int64_t n) { return face.number < n; });
    return static_cast<int>(found - share.faces.begin());
  });
  int place = num_own_;
  for (const FaceTopology& face : share.foreign_faces) {
    if (has_number(face)) places_.push_back(place);
    ++place;
  }
}

void NodeAreas::update(const Rows3<const double>& x) {
  const Rows4<const int> corners = corners_;
  const Rows3<double> areas = areas_;
  loop_where_it_pays(
      "contact::corner_areas", num_own_, num_own_ / 4, KOKKOS_LAMBDA(int f) {
        Point3 corner[4];
        bool is_triangle = false;
        for (int i = 0; i < 4; ++i) {
          corner[i] = load_row(x, corners(f, i));
          is_triangle = is_triangle || corners(f, i) == corners(f, (i + 1) % 4);
        }
        store_row(areas, f, find_corner_area(corner, is_triangle));
      });
  receive_areas();
}

/// Receives the areas of other ranks' faces.
void NodeAreas::receive_areas() {
  if (!has_many_ranks_) return;
  const auto areas = to_host(areas_);
  const auto load = [&](int face) {
    return std::array<double, 3>{areas(at(face), 0), areas(at(face), 1), areas(at(face), 2)};
  };
  std::vector<std::array<double, 3>> sent;
  for (const int face : foreign_.all().published) sent.push_back(load(face));
  const std::vector<std::array<double, 3>> received = data_.exchange(reverse(foreign_.all().request), sent);
  for (std::size_t k = 0; k < received.size(); ++k) {
    const auto face = at(places_[at(foreign_.all().asked[k])]);
    for (std::size_t d = 0; d < 3; ++d) areas(face, d) = received[k][d];
  }
  copy_values(areas_, areas);
}

}  // namespace percuss
