#pragma once
// What a frame of results holds, whatever the format of the file.

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "comm/communicator.hpp"
#include "src/mesh/ordering.hpp"

namespace percuss {

enum class FieldPlace { node, element };

/// How the numbers of a field are stored: as FieldsOptions says, or, of whole numbers from 0 to 255, in a byte each.
enum class FieldNumber { real, byte };

/// One field of one frame; values has components * (local nodes or elements) numbers, item by item. Of a node that
/// several ranks hold, the values of its owner are written.
struct FieldData {
  std::string name;
  FieldPlace place = FieldPlace::node;
  int components = 1;  // 1, 3 (vector) or 6 (xx, yy, zz, xy, yz, zx)
  std::span<const double> values;
  FieldNumber number = FieldNumber::real;
};

/// How real fields are stored; positions and times are always float64.
enum class FieldPrecision { float64, float32 };

/// A rigid plane; bodies live on the side to which the unit normal points.
struct WallPlane {
  Vec3 point{};  // [length] at time 0
  Vec3 normal{};
  std::array<Vec3, 2> edges{};  // of a rectangle with the point as its corner; zeros: the wall does not end
};

/// A rigid cylinder or sphere; bodies live outside of it.
struct RoundWall {
  Vec3 point{};                   // an end of the axis, or the centre [length], at time 0
  Vec3 axis{};                    // unit vector; zero of a sphere
  double radius = 0, length = 0;  // [length]; length 0: a cylinder without ends
  Vec3 direction{};               // of its motion: unit vector; zero of one that does not move
};

struct FieldsOptions {
  std::string title;  // of the deck
  std::string units;  // of the deck: "m, kg, s"; units of fields follow from it (src/output/frame/field_units.hpp)
  FieldPrecision precision = FieldPrecision::float64;
  std::vector<WallPlane> walls{}, moving_walls{};  // for pictures
  std::vector<RoundWall> round_walls{}, moving_round_walls{};
  std::vector<std::string> node_sets{}, side_sets{};  // of the mesh, by their names there; for Exodus II
  std::string name{};  // of the output: its files begin with name_fields() of it (src/output/formats/result_names.hpp)
  bool are_faces = false;  // whether elements of the mesh are faces, of which several have the same id
};

/// Frames of an output that an earlier run has written.
struct EarlierFrames {
  const std::string& directory;
  const std::string& name;              // of the output
  std::int64_t frames = 0;              // that the run continues behind
  std::span<const std::string> fields;  // that every frame will have
};

/// The nodes of this rank's share that it brings, ascending: each node is brought by the rank that owns it. Empty where
/// one rank has them all.
std::vector<int> find_owned_nodes(const ChunkedMesh& chunked, const Communicator& ranks);

/// 0, 1 ... count - 1.
std::vector<int> count_up(std::size_t count);

/// The fields of each frame with the displacement.
class FrameFields {
 public:
  explicit FrameFields(const Mesh& mesh) : initial_(mesh.nodes), elements_(mesh.elements.size()) {}

  std::size_t local_nodes() const { return initial_.size(); }

  /// The given fields, with the displacement before them unless it is among them; valid until the next call. Throws
  /// std::logic_error if a field has a wrong number of values, or if the fields are not those of the frame before.
  std::vector<FieldData> complete(std::span<const double> positions, std::span<const FieldData> given);

 private:
  struct Known {
    std::string name;
    FieldPlace place;
    int components;
  };
  void check(std::span<const FieldData> fields);

  std::vector<Vec3> initial_;         // [local nodes] positions of the mesh
  std::size_t elements_;              // local ones
  std::vector<double> displacement_;  // [local nodes][3]
  std::vector<Known> known_;          // of the frame before
};

}  // namespace percuss
