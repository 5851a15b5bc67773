#include "src/mesh/formats/nastran/nastran_systems.hpp"

#include <fmt/format.h>

#include <cmath>
#include <numbers>
#include <utility>

#include "src/mesh/hex_geometry.hpp"

namespace percuss {
namespace {

constexpr int deepest_system = 20;

double norm_of(const Vec3& a) { return std::hypot(a[0], a[1], a[2]); }

Vec3 divide(const Vec3& a, double by) { return {a[0] / by, a[1] / by, a[2] / by}; }

/// Cosine and sine of an angle in degrees, exact at quarter turns.
std::pair<double, double> find_turn(double degrees) {
  const double turn = std::fmod(degrees, 360.0);
  const double quarter = turn / 90;
  if (quarter == std::floor(quarter)) {
    constexpr std::array<double, 4> cosines{1, 0, -1, 0};
    const auto q = static_cast<std::size_t>((static_cast<int>(quarter) + 4) % 4);
    return {cosines[q], cosines[(q + 3) % 4]};
  }
  const double angle = turn / 180 * std::numbers::pi;
  return {std::cos(angle), std::sin(angle)};
}

}  // namespace

void NastranSystems::define(std::int64_t id, System system) {
  if (id <= 0) names_.refuse(system.place, fmt::format("a coordinate system has the id {} (it must be positive)", id));
  const TextPlace place = system.place;
  if (!systems_.emplace(id, std::move(system)).second)
    names_.refuse(place, fmt::format("coordinate system {} is defined twice", id));
}

void NastranSystems::add(const NastranCards& card) {
  System system;
  system.name = card.name();
  system.place = card.place();
  if (card.name() == "CORD2R") system.kind = Kind::rectangular;
  if (card.name() == "CORD2C") system.kind = Kind::cylindrical;
  if (card.name() == "CORD2S") system.kind = Kind::spherical;
  if (system.kind == Kind::other) {
    define(card.integer(0), system);
    const bool has_two = card.name().starts_with("CORD1") && !card.is_blank(4);
    if (has_two) define(card.integer(4), system);
    return;
  }
  system.reference = card.integer(1);
  for (std::size_t i = 0; i < 9; ++i) system.points[i / 3][i % 3] = card.real(2 + i);
  define(card.integer(0), std::move(system));
}

NastranSystems::Frame NastranSystems::make_frame(const System& system, std::int64_t id, int depth) {
  constexpr double least = 1e-10;  // sine of an angle that counts as none
  std::array<Vec3, 3> points{};
  for (std::size_t i = 0; i < 3; ++i)
    points[i] = find_place(system.reference, system.points[i], system.place, depth + 1);
  const Vec3 along = subtract(points[1], points[0]), across = subtract(points[2], points[0]);
  const Vec3 normal = cross(along, across);
  const double sine = norm_of(normal) / (norm_of(along) * norm_of(across));
  if (!(sine > least))
    names_.refuse(system.place, fmt::format("the three points of coordinate system {} lie on one line", id));
  Frame frame;
  frame.origin = points[0];
  frame.axes[2] = divide(along, norm_of(along));
  frame.axes[1] = divide(normal, norm_of(normal));
  frame.axes[0] = cross(frame.axes[1], frame.axes[2]);
  return frame;
}

Vec3 NastranSystems::find_place(std::int64_t system, const Vec3& x, TextPlace place, int depth) {
  if (system == 0) return x;
  const auto found = systems_.find(system);
  if (found == systems_.end()) names_.refuse(place, fmt::format("there is no coordinate system {}", system));
  System& in = found->second;
  if (in.kind == Kind::other)
    names_.refuse(in.place,
                  fmt::format("coordinate system {} is a {} (CORD2R, CORD2C and CORD2S are read)", system, in.name));
  if (depth > deepest_system)
    names_.refuse(in.place, fmt::format("coordinate system {} refers to itself, or to others too deep", system));
  if (!in.frame) in.frame = make_frame(in, system, depth);
  Vec3 local = x;
  if (in.kind != Kind::rectangular) {
    const bool is_spherical = in.kind == Kind::spherical;
    const auto [cosine, sine] = find_turn(x[is_spherical ? 2 : 1]);
    const auto [height, width] = is_spherical ? find_turn(x[1]) : std::pair(0.0, 1.0);
    local = {x[0] * width * cosine, x[0] * width * sine, is_spherical ? x[0] * height : x[2]};
  }
  Vec3 at = in.frame->origin;
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t k = 0; k < 3; ++k) at[k] += local[i] * in.frame->axes[i][k];
  return at;
}

}  // namespace percuss
