#include <fmt/format.h>

#include "src/contact/stage_memory.hpp"
#include "src/error.hpp"

namespace percuss {
namespace {

/// Margin of capture boxes in mean face edges: searches less often against more pairs to check.
constexpr double margin_edges = 0.5;

/// Travel of any node that uses up the margin: node and face may each move by it, and the reach of the check grows with
/// the edges of a face, 2 sqrt(3) * contact_limits::capture < 1 times as much.
constexpr double travels_in_margin = 3;

}  // namespace

SearchMemory::SearchMemory(const ContactSurface& surface)
    : boxes("contact::boxes", static_cast<std::size_t>(surface.num_faces)),
      faces{Rows3<double>("contact::face_normal", static_cast<std::size_t>(surface.num_faces)),
            Array<double>("contact::face_size", static_cast<std::size_t>(surface.num_faces)),
            Boxes("contact::face_box", static_cast<std::size_t>(surface.num_faces))} {}

void search_pairs(const ContactSurface& surface, const SurfaceMotion& motion, double margin,
                  const Array<const int>& history_face, SearchMemory& memory) {
  const auto searched = static_cast<int>(surface.searched_faces.extent(0));
  // A search is some eighty launches, most of them of the sorts.
  run_where_it_pays(searched / 2, [&](const auto& space) {
    bound_faces(space, surface, motion, margin, memory.boxes);
    const std::int64_t limit = find_pair_limit(surface);
    const std::int64_t pairs =
        find_points_in_boxes(space, surface, motion.x, memory.boxes, limit, memory.scratch, memory.candidates);
    if (pairs > limit)
      throw RunError(fmt::format(
          "contact search found {} pairs of a node and a face (capture boxes are {:.3g} wide beyond their faces: nodes "
          "move many faces a step) is the run unstable? try a smaller time.step_scale",
          pairs, margin));
    list_concerned(space, surface, history_face, memory.scratch, memory.candidates);
  });
}

ReuseBound::ReuseBound(const ContactSurface& surface, bool enabled)
    : enabled_(enabled), origin_("contact::search_origin", static_cast<std::size_t>(surface.num_nodes)) {}

bool ReuseBound::covers(const ContactSurface& surface, const SurfaceMotion& motion) const {
  if (!enabled_ || !valid_) return false;
  double travel = 0;
  run_where_it_pays(surface.num_nodes / 10,
                    [&](const auto& space) { travel = find_largest_travel(space, surface, motion, origin_); });
  return travels_in_margin * travel <= margin_;
}

double ReuseBound::restart(const ContactSurface& surface, const SurfaceMotion& motion) {
  run_where_it_pays(surface.num_nodes / 10, [&](const auto& space) {
    const double move = find_largest_move(space, surface, motion);
    // Without reuse the boxes only need what a node moves in this step.
    margin_ = move + (enabled_ ? margin_edges * find_mean_edge(space, surface, motion.x) : 0);
    store_places(space, surface, motion.x, origin_);
  });
  valid_ = true;
  return margin_;
}

}  // namespace percuss
