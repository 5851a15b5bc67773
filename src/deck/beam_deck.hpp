#pragma once
// Cross sections of beams, as a deck gives them.

#include <array>
#include <cmath>
#include <numbers>
#include <variant>

#include "kernels/beam/beam_section.hpp"

namespace percuss {

struct RoundSection {
  double radius = 0;
};

struct TubeSection {
  double outer_radius = 0, inner_radius = 0;
};

/// A solid rectangle.
struct RectangleSection {
  std::array<double, 2> size{};  // along y and z of the section
};

/// A rectangle with walls of one thickness.
struct BoxSection {
  std::array<double, 2> size{};  // outer, along y and z of the section
  double wall = 0;
};

/// A symmetric I: flanges along y of the section, a web along z.
struct IShapeSection {
  std::array<double, 2> size{};  // outer, along y and z of the section
  double flange = 0, web = 0;    // thicknesses
};

/// A bar that carries nothing but a force along it.
struct TrussSection {
  double area = 0;
};

/// BeamSection: its constants one by one.
using BeamSectionDeck =
    std::variant<TrussSection, RoundSection, TubeSection, RectangleSection, BoxSection, IShapeSection, BeamSection>;

/// Whether its nodes have rotations.
inline bool bends(const BeamSectionDeck& section) { return !std::holds_alternative<TrussSection>(section); }

/// Whether it matters how it is turned about the beam.
inline bool has_axes(const BeamSectionDeck& section) {
  if (const auto* of = std::get_if<BeamSection>(&section))
    return of->inertia_y != of->inertia_z || of->shear_area_y != of->shear_area_z;
  return std::holds_alternative<RectangleSection>(section) || std::holds_alternative<BoxSection>(section) ||
         std::holds_alternative<IShapeSection>(section);
}

inline BeamSection make_beam_section(const BeamSectionDeck& section) {
  struct Make {
    BeamSection operator()(const TrussSection& s) const { return {s.area}; }
    BeamSection operator()(const RoundSection& s) const { return make_round(s.radius); }
    BeamSection operator()(const TubeSection& s) const { return make_tube(s.outer_radius, s.inner_radius); }
    BeamSection operator()(const RectangleSection& s) const { return make_rectangle(s.size[0], s.size[1]); }
    BeamSection operator()(const BoxSection& s) const { return make_box(s.size[0], s.size[1], s.wall); }
    BeamSection operator()(const IShapeSection& s) const { return make_i_shape(s.size[0], s.size[1], s.flange, s.web); }
    BeamSection operator()(const BeamSection& s) const { return s; }
  };
  return std::visit(Make{}, section);
}

/// Radius with which a beam touches: of a circle and a tube that of their outside, of a rectangle, a box and
/// an I that of the circle with the area of their outline, else of the circle with the area of the section.
inline double find_contact_radius(const BeamSectionDeck& section) {
  struct Find {
    static double round(double area) { return std::sqrt(area / std::numbers::pi); }
    double operator()(const TrussSection& s) const { return round(s.area); }
    double operator()(const RoundSection& s) const { return s.radius; }
    double operator()(const TubeSection& s) const { return s.outer_radius; }
    double operator()(const RectangleSection& s) const { return round(s.size[0] * s.size[1]); }
    double operator()(const BoxSection& s) const { return round(s.size[0] * s.size[1]); }
    double operator()(const IShapeSection& s) const { return round(s.size[0] * s.size[1]); }
    double operator()(const BeamSection& s) const { return round(s.area); }
  };
  return std::visit(Find{}, section);
}

}  // namespace percuss
