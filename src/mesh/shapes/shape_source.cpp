#include "src/mesh/shapes/shape_source.hpp"

namespace percuss {

std::unique_ptr<ShapeSource> make_source(const Shape& shape) {
  struct Make {
    std::unique_ptr<ShapeSource> operator()(const BoxShape& box) const { return make_box_source(box); }
    std::unique_ptr<ShapeSource> operator()(const CylinderShape& rod) const { return make_cylinder_source(rod); }
    std::unique_ptr<ShapeSource> operator()(const TubeShape& tube) const { return make_tube_source(tube); }
    std::unique_ptr<ShapeSource> operator()(const SphereShape& ball) const { return make_sphere_source(ball); }
    std::unique_ptr<ShapeSource> operator()(const ShellPlateShape& plate) const { return make_shell_source(plate); }
    std::unique_ptr<ShapeSource> operator()(const ShellTubeShape& tube) const { return make_shell_source(tube); }
    std::unique_ptr<ShapeSource> operator()(const ShellSphereShape& ball) const { return make_shell_source(ball); }
    std::unique_ptr<ShapeSource> operator()(const ShellBoxTubeShape& tube) const { return make_shell_source(tube); }
    std::unique_ptr<ShapeSource> operator()(const LineShape& line) const { return make_line_source(line); }
    std::unique_ptr<ShapeSource> operator()(const FileMesh&) const { return nullptr; }
  };
  return std::visit(Make{}, shape);
}

}  // namespace percuss
