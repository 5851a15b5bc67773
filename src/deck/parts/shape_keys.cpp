#include "src/deck/parts/shape_keys.hpp"

#include "src/deck/keys/file_value.hpp"

namespace percuss {
namespace {

/// Cells of a shape by direction, each with its least number.
template <std::size_t N>
struct CellsValue {
  std::array<std::pair<const char*, int>, N> directions;

  bool read(const Reader& reader, const std::string& name, const Node& node, std::array<int, N>& out) const {
    if (node.kind != Node::Kind::list || node.items.size() != N) {
      reader.refuse(node, name, takes());
      return false;
    }
    bool good = true;
    for (std::size_t i = 0; i < N; ++i) {
      const IntegerValue integer{directions[i].second};
      good = integer.read(reader, fmt::format("{}.{}", name, i), node.items[i], out[i]) && good;
    }
    return good;
  }

  std::string takes() const {
    std::string text;
    for (const auto& [direction, least] : directions) {
      text += fmt::format("{}{} (at least {})", text.empty() ? "" : ", ", direction, least);
    }
    return fmt::format("a list of {} integers: {}", N, text);
  }

  Form form() const {
    std::vector<Form> items;
    for (const auto& [direction, least] : directions) items.push_back(IntegerValue{least}.form());
    return tuple_form(std::move(items));
  }
};

const Keys<BoxShape>& box_keys() {
  static const Keys<BoxShape> keys = {
      need("size", &BoxShape::size, vector3(positive)),
      need("cells", &BoxShape::cells, CellsValue<3>{{{{"along x", 1}, {"along y", 1}, {"along z", 1}}}}),
  };
  return keys;
}

// The core of a disc or ball needs one cell between two rings: see CylinderShape.
constexpr int least_across = 3;

const Keys<CylinderShape>& cylinder_keys() {
  static const Keys<CylinderShape> keys = {
      need("radius", &CylinderShape::radius, NumberValue{positive}),
      need("length", &CylinderShape::length, NumberValue{positive}),
      make_key<CylinderShape>(
          "cells", true, CellsValue<2>{{{{"across", least_across}, {"along", 1}}}},
          [](const auto& value, const Reader& reader, const std::string& name, const Node& node, CylinderShape& out) {
            std::array<int, 2> cells{};
            if (!value.read(reader, name, node, cells)) return false;
            out.across = cells[0];
            out.along = cells[1];
            return true;
          }),
  };
  return keys;
}

const Range turn{"above 0, at most 360", 0, 360, true};

const Keys<TubeShape>& tube_keys() {
  static const Keys<TubeShape> keys = {
      need("inner_radius", &TubeShape::inner_radius, NumberValue{positive}),
      need("outer_radius", &TubeShape::outer_radius, NumberValue{positive}),
      need("length", &TubeShape::length, NumberValue{positive}),
      need("cells", &TubeShape::cells, CellsValue<3>{{{{"through", 1}, {"around", 3}, {"along", 1}}}}),
      may("arc", &TubeShape::arc, NumberValue{turn}),
  };
  return keys;
}

bool check_tube(const Reader& reader, const Node& node, TubeShape& tube) {
  if (tube.inner_radius < tube.outer_radius) return true;
  reader.error(node.find("outer_radius")->spot,
               fmt::format("{} is {}{} (must be larger than inner_radius, {})", reader.name_of("outer_radius"),
                           tube.outer_radius, reader.in(), tube.inner_radius));
  return false;
}

const Keys<SphereShape>& sphere_keys() {
  static const Keys<SphereShape> keys = {
      need("radius", &SphereShape::radius, NumberValue{positive}),
      need("cells", &SphereShape::across, IntegerValue{least_across}),
  };
  return keys;
}

const Keys<ShellPlateShape>& shell_plate_keys() {
  static const Keys<ShellPlateShape> keys = {
      need("size", &ShellPlateShape::size, TupleValue<NumberValue, 2>{{positive}}),
      need("cells", &ShellPlateShape::cells, CellsValue<2>{{{{"along x", 1}, {"along y", 1}}}}),
  };
  return keys;
}

const Keys<ShellTubeShape>& shell_tube_keys() {
  static const Keys<ShellTubeShape> keys = {
      need("radius", &ShellTubeShape::radius, NumberValue{positive}),
      may("end_radius", &ShellTubeShape::end_radius, NumberValue{positive}),
      need("length", &ShellTubeShape::length, NumberValue{positive}),
      need("cells", &ShellTubeShape::cells, CellsValue<2>{{{{"around", 3}, {"along", 1}}}}),
      may("arc", &ShellTubeShape::arc, NumberValue{turn}),
  };
  return keys;
}

const Keys<ShellSphereShape>& shell_sphere_keys() {
  static const Keys<ShellSphereShape> keys = {
      need("radius", &ShellSphereShape::radius, NumberValue{positive}),
      need("cells", &ShellSphereShape::cells, IntegerValue{1}),
  };
  return keys;
}

const Keys<ShellBoxTubeShape>& shell_box_tube_keys() {
  using Closed = ShellBoxTubeShape::Closed;
  static const Keys<ShellBoxTubeShape> keys = {
      need("size", &ShellBoxTubeShape::size, TupleValue<NumberValue, 2>{{positive}}),
      need("length", &ShellBoxTubeShape::length, NumberValue{positive}),
      need("cells", &ShellBoxTubeShape::cells, CellsValue<3>{{{{"along x", 1}, {"along y", 1}, {"along z", 1}}}}),
      may("closed", &ShellBoxTubeShape::closed,
          ChoiceValue<Closed>{
              {{"none", Closed::none}, {"start", Closed::start}, {"end", Closed::end}, {"both", Closed::both}}}),
  };
  return keys;
}

const Keys<LineShape>& line_keys() {
  static const Keys<LineShape> keys = {
      need("from", &LineShape::from, vector3()),
      need("to", &LineShape::to, vector3()),
      need("cells", &LineShape::cells, IntegerValue{1}),
  };
  return keys;
}

bool check_line(const Reader& reader, const Node& node, LineShape& line) {
  if (line.from != line.to) return true;
  reader.error(node.find("to")->spot, fmt::format("{} is where {} is{} (a line of beams needs a length)",
                                                  reader.name_of("to"), reader.name_of("from"), reader.in()));
  return false;
}

const Keys<FileMesh>& file_keys() {
  static const Keys<FileMesh> keys = {
      need("file", &FileMesh::file, FileValue{}),
      may("blocks", &FileMesh::blocks, ListValue<TextValue>{}),
      may("scale", &FileMesh::scale, NumberValue{positive}),
  };
  return keys;
}

template <class S>
Key<PartDeck> shape_key(const char* name, const Keys<S>& (*keys)(),
                        bool (*check)(const Reader&, const Node&, S&) = nullptr) {
  return make_key<PartDeck>(
      name, false, MapValue<S>{keys, check},
      [](const auto& value, const Reader& reader, const std::string& full, const Node& node, PartDeck& part) {
        S shape{};
        const bool good = value.read(reader, full, node, shape);
        part.shape = shape;  // even if bad: its sides have names
        return good;
      });
}

}  // namespace

const Keys<PartDeck>& shape_keys() {
  static const Keys<PartDeck> keys = {
      shape_key<BoxShape>("box", box_keys),
      shape_key<CylinderShape>("cylinder", cylinder_keys),
      shape_key<TubeShape>("tube", tube_keys, check_tube),
      shape_key<SphereShape>("sphere", sphere_keys),
      shape_key<ShellPlateShape>("shell_plate", shell_plate_keys),
      shape_key<ShellTubeShape>("shell_tube", shell_tube_keys),
      shape_key<ShellSphereShape>("shell_sphere", shell_sphere_keys),
      shape_key<ShellBoxTubeShape>("shell_box_tube", shell_box_tube_keys),
      shape_key<LineShape>("line", line_keys, check_line),
      shape_key<FileMesh>("exodus", file_keys),
      shape_key<FileMesh>("mesh", file_keys,
                          [](const Reader&, const Node&, FileMesh& mesh) {
                            mesh.is_exodus = false;
                            return true;
                          }),
  };
  return keys;
}

bool is_shell_shape(const Shape& shape) {
  return std::holds_alternative<ShellPlateShape>(shape) || std::holds_alternative<ShellTubeShape>(shape) ||
         std::holds_alternative<ShellSphereShape>(shape) || std::holds_alternative<ShellBoxTubeShape>(shape);
}

std::vector<std::string> side_names(const Shape& shape) {
  struct Names {
    std::vector<std::string> operator()(const BoxShape&) const {
      return {"x_min", "x_max", "y_min", "y_max", "z_min", "z_max"};
    }
    std::vector<std::string> operator()(const CylinderShape&) const { return {"start", "end", "side"}; }
    std::vector<std::string> operator()(const TubeShape& tube) const {
      if (tube.arc < 360) return {"start", "end", "inner", "outer", "first", "last"};
      return {"start", "end", "inner", "outer"};
    }
    std::vector<std::string> operator()(const SphereShape&) const { return {"surface"}; }
    std::vector<std::string> operator()(const ShellPlateShape&) const {
      return {"x_min", "x_max", "y_min", "y_max", "bottom", "top"};
    }
    std::vector<std::string> operator()(const ShellTubeShape& tube) const {
      if (tube.arc < 360) return {"start", "end", "first", "last", "inner", "outer"};
      return {"start", "end", "inner", "outer"};
    }
    std::vector<std::string> operator()(const ShellSphereShape&) const { return {"inner", "outer"}; }
    std::vector<std::string> operator()(const ShellBoxTubeShape&) const { return {"start", "end", "inner", "outer"}; }
    std::vector<std::string> operator()(const LineShape&) const { return {"start", "end"}; }
    std::vector<std::string> operator()(const FileMesh&) const { return {}; }
  };
  return std::visit(Names{}, shape);
}

}  // namespace percuss
