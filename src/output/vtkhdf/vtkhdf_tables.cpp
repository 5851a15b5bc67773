#include "src/output/vtkhdf/vtkhdf_tables.hpp"

#include <array>

#include "src/output/frame/field_units.hpp"
#include "src/output/hdf5/hdf5_reading.hpp"

namespace percuss {
namespace {

constexpr hsize_t steps_at_once = 512;  // entries of a chunk of the tables that get one number a frame

constexpr const char* wall_table = "wall_displacements";

// Tables of Steps to which every frame adds the same number: their group, name and number.
struct StepConstantPlace {
  enum class Group { steps, point_data, cell_data } group;
  const char* name;
  std::int64_t value;
};
constexpr StepConstantPlace step_constants[] = {
    {StepConstantPlace::Group::steps, "PartOffsets", 0},  {StepConstantPlace::Group::steps, "NumberOfParts", 1},
    {StepConstantPlace::Group::steps, "CellOffsets", 0},  {StepConstantPlace::Group::steps, "ConnectivityIdOffsets", 0},
    {StepConstantPlace::Group::point_data, "node_id", 0}, {StepConstantPlace::Group::cell_data, "element_id", 0},
    {StepConstantPlace::Group::cell_data, "part", 0},
};

}  // namespace

void VtkhdfTables::create_groups(hid_t file) {
  root = hdf5::create_group(file, "VTKHDF");
  hdf5::write_attribute(root.get(), "Version", std::array<std::int64_t, 2>{2, 0});
  hdf5::write_attribute(root.get(), "Type", std::string("UnstructuredGrid"));
  point_data = hdf5::create_group(root.get(), "PointData");
  cell_data = hdf5::create_group(root.get(), "CellData");
  steps = hdf5::create_group(root.get(), "Steps");
  point_data_offsets = hdf5::create_group(steps.get(), "PointDataOffsets");
  cell_data_offsets = hdf5::create_group(steps.get(), "CellDataOffsets");
  own = hdf5::create_group(file, "percuss");
}

/// make(group, name) gives each table of the constants.
template <class Make>
void VtkhdfTables::add_constants(const Make& make) {
  for (const StepConstantPlace& c : step_constants) {
    using Group = StepConstantPlace::Group;
    const auto& group = c.group == Group::steps        ? steps
                        : c.group == Group::point_data ? point_data_offsets
                                                       : cell_data_offsets;
    constants.push_back({make(group.get(), c.name), c.value});
  }
}

void VtkhdfTables::create_steps(hsize_t nodes, const FieldsOptions& options) {
  hdf5::write_attribute(steps.get(), "NSteps", std::array<std::int64_t, 1>{0});
  points.emplace(root.get(), "Points", H5T_IEEE_F64LE, 3, nodes);
  times.emplace(steps.get(), "Values", H5T_IEEE_F64LE, 1, steps_at_once);
  point_offsets.emplace(steps.get(), "PointOffsets", H5T_STD_I64LE, 1, steps_at_once);
  step_numbers.emplace(own.get(), "step", H5T_STD_I64LE, 1, steps_at_once);
  points->note_unit(name_field_unit("Points", options.units));
  times->note_unit(name_field_unit("time", options.units));
  const std::size_t moving = options.moving_walls.size() + options.moving_round_walls.size();
  if (moving > 0) wall_displacements.emplace(own.get(), wall_table, hdf5::FrameTable::Shape{moving});
  add_constants(
      [](hid_t group, const char* name) { return hdf5::Table(group, name, H5T_STD_I64LE, 1, steps_at_once); });
}

void VtkhdfTables::open(hid_t file) {
  root = hdf5::open_group(file, "VTKHDF");
  point_data = hdf5::open_group(root.get(), "PointData");
  cell_data = hdf5::open_group(root.get(), "CellData");
  steps = hdf5::open_group(root.get(), "Steps");
  point_data_offsets = hdf5::open_group(steps.get(), "PointDataOffsets");
  cell_data_offsets = hdf5::open_group(steps.get(), "CellDataOffsets");
  own = hdf5::open_group(file, "percuss");
  points.emplace(root.get(), "Points");
  times.emplace(steps.get(), "Values");
  point_offsets.emplace(steps.get(), "PointOffsets");
  step_numbers.emplace(own.get(), "step");
  if (hdf5::check(H5Lexists(own.get(), wall_table, H5P_DEFAULT), "look for walls") > 0)
    wall_displacements.emplace(own.get(), wall_table);
  add_constants([](hid_t group, const char* name) { return hdf5::Table(group, name); });
}

bool VtkhdfTables::has_fields() const {
  return hdf5::check(H5Lexists(point_data.get(), "displacement", H5P_DEFAULT), "look for fields") > 0;
}

void VtkhdfTables::open_fields(std::span<const FieldData> described) {
  for (const auto& field : described) {
    const bool on_nodes = field.place == FieldPlace::node;
    fields.push_back({field.place, hdf5::Table((on_nodes ? point_data : cell_data).get(), field.name),
                      hdf5::Table((on_nodes ? point_data_offsets : cell_data_offsets).get(), field.name)});
    if (fields.back().values.components() != field.components)
      throw hdf5::Error("go on with field " + field.name, "it has another number of components");
  }
}

void VtkhdfTables::create_fields(std::span<const FieldData> described, const FieldsOptions& options, hsize_t nodes,
                                 hsize_t elements) {
  const hid_t real = options.precision == FieldPrecision::float32 ? H5T_IEEE_F32LE : H5T_IEEE_F64LE;
  for (const auto& field : described) {
    const hid_t type = field.number == FieldNumber::byte ? H5T_STD_U8LE : real;
    const bool on_nodes = field.place == FieldPlace::node;
    const auto& group = on_nodes ? point_data : cell_data;
    const auto& offsets = on_nodes ? point_data_offsets : cell_data_offsets;
    fields.push_back({field.place,
                      hdf5::Table(group.get(), field.name, type, field.components, on_nodes ? nodes : elements),
                      hdf5::Table(offsets.get(), field.name, H5T_STD_I64LE, 1, steps_at_once)});
    fields.back().values.note_unit(name_field_unit(field.name, options.units));
  }
}

void VtkhdfTables::release() {
  fields.clear();
  constants.clear();
  wall_displacements.reset();
  for (auto* table : {&points, &times, &point_offsets, &step_numbers}) table->reset();
  for (auto* group : {&own, &cell_data_offsets, &point_data_offsets, &steps, &cell_data, &point_data, &root})
    group->reset();
}

}  // namespace percuss
