#include "src/output/vtkhdf_file.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <array>

#include "src/output/atomic_file.hpp"
#include "src/output/hdf5_file.hpp"

namespace percuss {
namespace {

using hdf5::check;

constexpr std::uint8_t vtk_hexahedron = 12;  // VTK's number of the cell type
constexpr hsize_t steps_at_once = 512;       // entries of a chunk of the tables that get one number a frame

// Most bytes of metadata (B-tree nodes on two levels, headers) that a table adds with a frame, and that a file starts
// with; counted from the sizes in the HDF5 file format specification for the k above, and rounded up.
constexpr hsize_t metadata_bytes_per_table = hsize_t{64} << 10;
constexpr hsize_t metadata_bytes_of_file = hsize_t{256} << 10;
constexpr hsize_t mesh_bytes_per_node = 8;                      // its id
constexpr hsize_t mesh_bytes_per_element = 8 * 8 + 8 + 1 + 16;  // corners, offset, type, id and part

std::vector<std::int64_t> flatten_connectivity(const Mesh& mesh) {
  std::vector<std::int64_t> corners;
  corners.reserve(8 * mesh.elements.size());
  for (const auto& element : mesh.elements) corners.insert(corners.end(), element.begin(), element.end());
  return corners;
}

void write_whole_numbers(const hdf5::Handle& group, const std::string& name, std::span<const std::int64_t> values) {
  hdf5::write_dataset(group.get(), name, H5T_STD_I64LE, 1, values);
}

}  // namespace

VtkhdfFile::VtkhdfFile(const std::string& path, const Mesh& mesh, const FieldsOptions& options)
    : path_(path), precision_(options.precision), nodes_(mesh.nodes.size()), elements_(mesh.elements.size()) {
  try {
    run_or_abandon("create", [&] { create(mesh, options); });
  } catch (...) {
    ::unlink(path_.c_str());
    throw;
  }
}

VtkhdfFile::~VtkhdfFile() = default;

// Does the work; if that fails, gives the file up as it is on the disk.
template <class Work>
void VtkhdfFile::run_or_abandon(const char* action, Work&& work) {
  try {
    work();
  } catch (const hdf5::Error& error) {
    abandon();
    throw SystemError(fmt::format("cannot {} '{}' ({}; while HDF5 was to {}){}", action, path_, error.reason,
                                  error.what(), suggest_for_errno(error.error_number)));
  } catch (...) {
    abandon();
    throw;
  }
}

void VtkhdfFile::create(const Mesh& mesh, const FieldsOptions& options) {
  file_ = hdf5::create_durable_file(path_);
  disk_ = DiskReservation(path_);
  disk_.reserve(0, metadata_bytes_of_file + nodes_ * mesh_bytes_per_node + elements_ * mesh_bytes_per_element);
  root_ = hdf5::create_group(file_.get(), "VTKHDF");
  hdf5::write_attribute(root_.get(), "Version", std::array<std::int64_t, 2>{2, 0});
  hdf5::write_attribute(root_.get(), "Type", std::string("UnstructuredGrid"));
  point_data_ = hdf5::create_group(root_.get(), "PointData");
  cell_data_ = hdf5::create_group(root_.get(), "CellData");
  steps_ = hdf5::create_group(root_.get(), "Steps");
  point_data_offsets_ = hdf5::create_group(steps_.get(), "PointDataOffsets");
  cell_data_offsets_ = hdf5::create_group(steps_.get(), "CellDataOffsets");
  own_ = hdf5::create_group(file_.get(), "percuss");
  write_mesh(mesh, options);
  create_steps(nodes_);
  flush();
  disk_.trim(file_bytes());
}

void VtkhdfFile::write_mesh(const Mesh& mesh, const FieldsOptions& options) {
  const auto connectivity = flatten_connectivity(mesh);
  std::vector<std::int64_t> offsets(mesh.elements.size() + 1);
  for (std::size_t i = 0; i < offsets.size(); ++i) offsets[i] = static_cast<std::int64_t>(8 * i);
  const std::vector<std::uint8_t> types(mesh.elements.size(), vtk_hexahedron);
  write_whole_numbers(root_, "NumberOfPoints", std::array{static_cast<std::int64_t>(mesh.nodes.size())});
  write_whole_numbers(root_, "NumberOfCells", std::array{static_cast<std::int64_t>(mesh.elements.size())});
  write_whole_numbers(root_, "NumberOfConnectivityIds", std::array{static_cast<std::int64_t>(connectivity.size())});
  write_whole_numbers(root_, "Connectivity", connectivity);
  write_whole_numbers(root_, "Offsets", offsets);
  hdf5::write_dataset(root_.get(), "Types", H5T_STD_U8LE, 1, std::span<const std::uint8_t>(types));
  write_whole_numbers(point_data_, "node_id", mesh.node_ids);
  write_whole_numbers(cell_data_, "element_id", mesh.element_ids);
  write_whole_numbers(cell_data_, "part",
                      std::vector<std::int64_t>(mesh.element_part.begin(), mesh.element_part.end()));

  std::vector<std::string> names;
  for (const auto& part : mesh.parts) names.push_back(part.name);
  hdf5::write_texts(own_.get(), "part_names", names);
  hdf5::write_attribute(own_.get(), "title", options.title);
  hdf5::write_attribute(own_.get(), "units", options.units);
}

void VtkhdfFile::add_constant(const hdf5::Handle& group, const std::string& name, std::int64_t value) {
  constants_.push_back({hdf5::Table(group.get(), name, H5T_STD_I64LE, 1, steps_at_once), value});
}

void VtkhdfFile::create_steps(hsize_t nodes) {
  hdf5::write_attribute(steps_.get(), "NSteps", std::array<std::int64_t, 1>{0});
  points_.emplace(root_.get(), "Points", H5T_IEEE_F64LE, 3, nodes);
  times_.emplace(steps_.get(), "Values", H5T_IEEE_F64LE, 1, steps_at_once);
  point_offsets_.emplace(steps_.get(), "PointOffsets", H5T_STD_I64LE, 1, steps_at_once);
  step_numbers_.emplace(own_.get(), "step", H5T_STD_I64LE, 1, steps_at_once);
  add_constant(steps_, "PartOffsets", 0);
  add_constant(steps_, "NumberOfParts", 1);
  add_constant(steps_, "CellOffsets", 0);
  add_constant(steps_, "ConnectivityIdOffsets", 0);
  add_constant(point_data_offsets_, "node_id", 0);
  add_constant(cell_data_offsets_, "element_id", 0);
  add_constant(cell_data_offsets_, "part", 0);
}

void VtkhdfFile::create_fields(std::span<const FieldData> fields) {
  const hid_t type = precision_ == FieldPrecision::float32 ? H5T_IEEE_F32LE : H5T_IEEE_F64LE;
  for (const auto& field : fields) {
    const bool on_nodes = field.place == FieldPlace::node;
    const auto& group = on_nodes ? point_data_ : cell_data_;
    const auto& offsets = on_nodes ? point_data_offsets_ : cell_data_offsets_;
    fields_.push_back({field.place,
                       hdf5::Table(group.get(), field.name, type, field.components, on_nodes ? nodes_ : elements_),
                       hdf5::Table(offsets.get(), field.name, H5T_STD_I64LE, 1, steps_at_once)});
  }
}

hsize_t VtkhdfFile::frame_bytes(std::span<const FieldData> fields) const {
  const hsize_t tables = 4 + constants_.size() + 2 * fields.size();
  hsize_t bytes = metadata_bytes_per_table * tables + points_->growth_bytes(nodes_);
  for (const auto& table : fields_)
    bytes += table.values.growth_bytes(table.place == FieldPlace::node ? nodes_ : elements_);
  return bytes;
}

void VtkhdfFile::append_frame(double time, std::int64_t step, std::span<const double> positions,
                              std::span<const FieldData> fields) {
  if (!file_) throw SystemError(fmt::format("cannot write '{}' (it was given up after an error)", path_));
  run_or_abandon("write", [&] {
    const hsize_t size = file_bytes();
    if (frames_ == 0) create_fields(fields);
    disk_.reserve(size, frame_bytes(fields));
    append_rows(time, step, positions, fields);
    flush();
    // Only now does the frame exist for a reader.
    hdf5::write_attribute(steps_.get(), "NSteps", std::array<std::int64_t, 1>{frames_ + 1});
    flush();
    ++frames_;
    disk_.trim(file_bytes());
  });
}

void VtkhdfFile::append_rows(double time, std::int64_t step, std::span<const double> positions,
                             std::span<const FieldData> fields) {
  const auto append_one = [](hdf5::Table& table, auto value) {
    table.append(std::span<const decltype(value)>(&value, 1));
  };
  append_one(*point_offsets_, static_cast<std::int64_t>(points_->rows()));
  points_->append(positions);
  for (std::size_t i = 0; i < fields.size(); ++i) {
    append_one(fields_[i].offsets, static_cast<std::int64_t>(fields_[i].values.rows()));
    fields_[i].values.append(fields[i].values);
  }
  for (auto& constant : constants_) append_one(constant.table, constant.value);
  append_one(*step_numbers_, step);
  append_one(*times_, time);
}

void VtkhdfFile::flush() {
  flushing_ = true;
  check(H5Fflush(file_.get(), H5F_SCOPE_GLOBAL), "flush the file");
  flushing_ = false;
}

hsize_t VtkhdfFile::file_bytes() const {
  hsize_t bytes = 0;
  check(H5Fget_filesize(file_.get(), &bytes), "ask for the size of the file");
  return bytes;
}

void VtkhdfFile::close() {
  if (!file_) return;
  run_or_abandon("write", [&] {
    flush();
    release_objects();
    check(file_.reset(), "close the file");
    disk_.sync();
  });
}

// HDF5 closes a file only when nothing within it is open.
void VtkhdfFile::release_objects() {
  fields_.clear();
  constants_.clear();
  for (auto* table : {&points_, &times_, &point_offsets_, &step_numbers_}) table->reset();
  for (auto* group : {&own_, &cell_data_offsets_, &point_data_offsets_, &steps_, &cell_data_, &point_data_, &root_})
    group->reset();
}

void VtkhdfFile::abandon() {
  hdf5::turn_to_memory(file_);
  release_objects();
  hdf5::close_abandoned(file_, flushing_ ? hdf5::Failure::in_a_flush : hdf5::Failure::elsewhere);
}

}  // namespace percuss
