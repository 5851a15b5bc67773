// Keys of `parts`.

#include <cmath>
#include <filesystem>
#include <numbers>

#include "src/deck/deck_keys.hpp"
#include "src/deck/mesh_size.hpp"

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

const Keys<TubeShape>& tube_keys() {
  static const Keys<TubeShape> keys = {
      need("inner_radius", &TubeShape::inner_radius, NumberValue{positive}),
      need("outer_radius", &TubeShape::outer_radius, NumberValue{positive}),
      need("length", &TubeShape::length, NumberValue{positive}),
      need("cells", &TubeShape::cells, CellsValue<3>{{{{"through", 1}, {"around", 3}, {"along", 1}}}}),
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

/// A file that the deck names: relative paths are relative to the deck.
struct FileValue {
  bool read(const Reader& reader, const std::string& name, const Node& node, std::string& out) const {
    if (!reader.expect(node, Node::Kind::scalar, name, takes())) return false;
    const std::filesystem::path path = std::filesystem::path(reader.reading().folder) / node.text;
    std::error_code unreadable;
    if (node.text.empty() || !std::filesystem::exists(path, unreadable) ||
        std::filesystem::is_directory(path, unreadable)) {
      reader.error(node.spot,
                   fmt::format("{} is {}{} (there is no file {})", name, describe(node), reader.in(), path.string()));
      return false;
    }
    out = path.string();
    return true;
  }
  std::string takes() const { return "a file, relative to the deck"; }
};

const Keys<ExodusMesh>& exodus_keys() {
  static const Keys<ExodusMesh> keys = {
      need("file", &ExodusMesh::file, FileValue{}),
      may("blocks", &ExodusMesh::blocks, ListValue<TextValue>{}),
      may("scale", &ExodusMesh::scale, NumberValue{positive}),
  };
  return keys;
}

const Keys<ArrayCopies>& array_keys() {
  static const Keys<ArrayCopies> keys = {
      need("count", &ArrayCopies::count, TupleValue<IntegerValue, 3>{}),
      need("pitch", &ArrayCopies::pitch, vector3()),
      may("stagger", &ArrayCopies::stagger, NumberValue{{"from -1 to 1", -1, 1}}),
  };
  return keys;
}

bool check_array(const Reader& reader, const Node& node, ArrayCopies& array) {
  bool good = true;
  for (std::size_t i = 0; i < 3; ++i) {
    if (array.count[i] == 1 || array.pitch[i] != 0) continue;
    reader.error(node.find("pitch")->items[i].spot,
                 fmt::format("{}.{} is 0{} (the {} copies along {} would coincide)", reader.name_of("pitch"), i,
                             reader.in(), array.count[i], "xyz"[i]));
    good = false;
  }
  return good;
}

const Keys<Rotation>& rotation_keys() {
  static const Keys<Rotation> keys = {
      need("axis", &Rotation::axis, DirectionValue{}),
      need("angle", &Rotation::degrees, NumberValue{}),
      may("center", &Rotation::center, vector3()),
  };
  return keys;
}

// The shortest turn that takes local +z onto a direction; none if it is +z already.
std::optional<Rotation> turn_z_onto(const Vec3& direction) {
  const double sine = std::hypot(direction[0], direction[1]);
  if (sine == 0 && direction[2] > 0) return std::nullopt;
  if (sine == 0) return Rotation{{1, 0, 0}, 180, {}};
  const double cosine = direction[2];
  const double degrees = cosine == 0 ? 90 : std::atan2(sine, cosine) * (180 / std::numbers::pi);
  return Rotation{{-direction[1] / sine, direction[0] / sine, 0}, degrees, {}};
}

struct MaterialNameValue {
  bool read(const Reader& reader, const std::string& name, const Node& node, std::string& out) const {
    if (!TextValue{}.read(reader, name, node, out)) return false;
    reader.reading().materials.push_back({node.spot, out, reader.in()});
    return true;
  }
  std::string takes() const { return "a name from materials"; }
};

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

const Keys<PartDeck>& shape_keys() {
  static const Keys<PartDeck> keys = {
      shape_key<BoxShape>("box", box_keys),
      shape_key<CylinderShape>("cylinder", cylinder_keys),
      shape_key<TubeShape>("tube", tube_keys, check_tube),
      shape_key<SphereShape>("sphere", sphere_keys),
      shape_key<ExodusMesh>("exodus", exodus_keys),
  };
  return keys;
}

bool read_axis(const DirectionValue& value, const Reader& reader, const std::string& name, const Node& node,
               PartDeck& part) {
  Vec3 direction{};
  if (!value.read(reader, name, node, direction)) return false;
  if (const auto turn = turn_z_onto(direction)) part.rotate.insert(part.rotate.begin(), *turn);
  return true;
}

const Keys<PartDeck>& part_keys() {
  static const Keys<PartDeck> keys = [] {
    Keys<PartDeck> all = shape_keys();
    all.push_back(need("material", &PartDeck::material, MaterialNameValue{}));
    all.push_back(may("array", &PartDeck::array, MapValue<ArrayCopies>{array_keys, check_array}));
    all.push_back(make_key<PartDeck>("axis", false, DirectionValue{}, read_axis));
    all.push_back(may("rotate", &PartDeck::rotate, ListValue<MapValue<Rotation>>{{rotation_keys}}));
    all.push_back(may("at", &PartDeck::at, vector3()));
    return all;
  }();
  return keys;
}

bool check_one_shape(const Reader& reader, const Node& node) {
  std::vector<std::string> given, known;
  for (const Key<PartDeck>& key : shape_keys()) {
    known.push_back(key.name);
    if (node.find(key.name) != nullptr) given.push_back(key.name);
  }
  if (given.size() == 1) return true;
  const std::string what =
      given.empty() ? "no shape" : fmt::format("{} shapes, {}", given.size(), fmt::join(given, " and "));
  const Spot spot = given.empty() ? node.key : node.find(given[1])->key;
  reader.error(spot, fmt::format("{} has {} (must be one of {})", reader.self(), what, fmt::join(known, ", ")));
  return false;
}

}  // namespace

bool PartValue::read_inside(const Reader& reader, const Node& node, PartDeck& out) const {
  const bool good = read_keys(reader, node, part_keys(), out);
  if (!check_one_shape(reader, node)) {
    reader.reading().shapeless.insert(out.name);
    return false;
  }
  if (!good) return false;
  const MeshSize size = count_cells(out);
  if (size.elements <= largest_mesh && size.nodes <= largest_mesh) return true;
  reader.error(node.key,
               fmt::format("{} has {:.4g} elements and {:.4g} nodes (a mesh can have {:.0f} of each) make it coarser",
                           reader.self(), size.elements, size.nodes, largest_mesh));
  return false;
}

void PartValue::list(const std::string& path, std::vector<DeckKey>& out) const { list_keys(part_keys(), path, out); }

std::vector<std::string> side_names(const Shape& shape) {
  struct Names {
    std::vector<std::string> operator()(const BoxShape&) const {
      return {"x_min", "x_max", "y_min", "y_max", "z_min", "z_max"};
    }
    std::vector<std::string> operator()(const CylinderShape&) const { return {"start", "end", "side"}; }
    std::vector<std::string> operator()(const TubeShape&) const { return {"start", "end", "inner", "outer"}; }
    std::vector<std::string> operator()(const SphereShape&) const { return {"surface"}; }
    std::vector<std::string> operator()(const ExodusMesh&) const { return {}; }
  };
  return std::visit(Names{}, shape);
}

}  // namespace percuss
