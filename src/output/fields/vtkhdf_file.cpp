#include "src/output/fields/vtkhdf_file.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <numeric>

#include "comm/all_reduce.hpp"
#include "src/output/fields/mesh_extents.hpp"
#include "src/output/files/atomic_file.hpp"
#include "src/output/files/first_rank.hpp"
#include "src/output/hdf5/hdf5_file.hpp"
#include "src/output/hdf5/hdf5_reading.hpp"

namespace percuss {
namespace {

using hdf5::check;

// Most bytes of metadata (B-tree nodes on two levels, headers) that a table adds with a frame, and that a file starts
// with; counted from the sizes in the HDF5 file format specification for the k above, and rounded up.
constexpr hsize_t metadata_bytes_per_table = hsize_t{64} << 10;
constexpr hsize_t metadata_bytes_of_file = hsize_t{256} << 10;
constexpr hsize_t mesh_bytes_per_node = 8;                      // its id
constexpr hsize_t mesh_bytes_per_element = 8 * 8 + 8 + 1 + 16;  // corners, offset, type, id and part

// Each node is brought by the rank that owns it, each element by the rank that holds it.
std::vector<int> find_owned_nodes(const ChunkedMesh& chunked, const Communicator& ranks) {
  std::vector<int> owned;
  if (ranks.size() == 1) return owned;
  const auto& numbers = chunked.mesh.node_numbers;
  for (std::size_t n = 0; n < numbers.size(); ++n) {
    if (chunked.numbering.find_node_owner(numbers[n]) == ranks.rank()) owned.push_back(static_cast<int>(n));
  }
  return owned;
}

std::vector<int> count_up(std::size_t count) {
  std::vector<int> items(count);
  std::iota(items.begin(), items.end(), 0);
  return items;
}

// Whether the cells of all ranks are of more than one kind.
bool has_several_kinds(const Communicator& ranks, const Cells& cells) {
  std::array<int, topology_count> kinds{};  // whether there are any of each
  for (const TopologyKind kind : cells.kinds) kinds[static_cast<std::size_t>(kind)] = 1;
  all_reduce(ranks, Reduce::largest, kinds);
  return std::count(kinds.begin(), kinds.end(), 1) > 1;
}

// What a rank writes of a dataset to which each rank brings some rows, rank after rank.
hdf5::RowBlock join_blocks(const Communicator& ranks, std::size_t count, hid_t transfer) {
  std::uint64_t all = count, first = count;
  all_reduce(ranks, Reduce::sum, all);
  wait_mpi([&] { return MPI_Scan(MPI_IN_PLACE, &first, 1, MPI_UINT64_T, MPI_SUM, ranks.handle()); }, "MPI_Scan");
  return {all, first - count, count, transfer};
}

}  // namespace

VtkhdfFile::VtkhdfFile(Unopened, const std::string& path, const ChunkedMesh& chunked, const FieldsOptions& options,
                       const Communicator& ranks)
    : path_(path),
      ranks_(ranks),
      options_(options),
      nodes_(static_cast<hsize_t>(chunked.numbering.node_count())),
      elements_(static_cast<hsize_t>(chunked.numbering.element_count())),
      node_rows_(ranks, find_owned_nodes(chunked, ranks), chunked.mesh.node_numbers, chunked.numbering.node_count()),
      element_rows_(ranks, count_up(chunked.mesh.elements.size()), list_element_numbers(chunked),
                    chunked.numbering.element_count()) {
  if (ranks.size() > 1) transfer_ = hdf5::create_collective_transfer();
}

VtkhdfFile::VtkhdfFile(const std::string& path, const ChunkedMesh& chunked, const FieldsOptions& options,
                       const Communicator& ranks)
    : VtkhdfFile(Unopened{}, path, chunked, options, ranks) {
  try {
    run_or_abandon("create", [&] { create(chunked.mesh); });
  } catch (...) {
    if (ranks_.rank() == 0) ::unlink(path_.c_str());
    throw;
  }
}

VtkhdfFile::VtkhdfFile(const std::string& path, const ChunkedMesh& chunked, const FieldsOptions& options,
                       const Communicator& ranks, std::int64_t frames)
    : VtkhdfFile(Unopened{}, path, chunked, options, ranks) {
  run_or_abandon("open", [&] { open(frames); });
}

VtkhdfFile::~VtkhdfFile() = default;

// Does the work; if that fails, gives the file up as it is on the disk.
template <class Work>
void VtkhdfFile::run_or_abandon(const char* action, Work&& work) {
  try {
    work();
  } catch (const hdf5::Error& error) {
    fail(action, error);
  } catch (const SystemError&) {  // agreed on by all ranks
    abandon();
    throw;
  } catch (const std::exception& error) {
    // To give up a file that several ranks write takes all of them, and this rank may be the only one here.
    if (ranks_.size() > 1) hdf5::end_all_ranks(ranks_, fmt::format("cannot {} '{}' ({})", action, path_, error.what()));
    abandon();
    throw;
  }
}

std::string VtkhdfFile::make_message(const char* action, const hdf5::Error& error) const {
  return fmt::format("cannot {} '{}' ({}; while HDF5 was to {}){}", action, path_, error.reason, error.what(),
                     suggest_for_errno(error.error_number));
}

void VtkhdfFile::fail(const char* action, const hdf5::Error& error) {
  const std::string message = make_message(action, error);
  if (ranks_.size() > 1) hdf5::end_all_ranks(ranks_, message);
  abandon();
  throw SystemError(message);
}

void VtkhdfFile::create(const Mesh& mesh) {
  file_ = hdf5::create_durable_file(path_, ranks_);
  run_on_first_rank(ranks_, [&] {
    disk_ = DiskReservation(path_);
    disk_.reserve(0, metadata_bytes_of_file + nodes_ * mesh_bytes_per_node + elements_ * mesh_bytes_per_element);
  });
  tables_.create_groups(file_.get());
  write_mesh(mesh);
  write_scene(mesh);
  tables_.create_steps(nodes_, options_.units);
  flush();
  compare();
  trim();
}

hdf5::RowBlock VtkhdfFile::make_block(FieldPlace place, int rows) {
  hdf5::RowBlock block = (place == FieldPlace::node ? node_rows_ : element_rows_).block(rows);
  if (transfer_) block.transfer = transfer_.get();
  block.record = &record_;
  return block;
}

hdf5::RowBlock VtkhdfFile::make_block_of_first_rank(hsize_t rows) {
  const bool first = ranks_.rank() == 0;
  return {rows, first ? 0 : rows, first ? rows : 0, transfer_ ? transfer_.get() : H5P_DEFAULT, &record_};
}

hdf5::RowBlock VtkhdfFile::make_block_of_all(std::size_t count) {
  hdf5::RowBlock block = join_blocks(ranks_, count, transfer_ ? transfer_.get() : H5P_DEFAULT);
  block.record = &record_;
  return block;
}

void VtkhdfFile::write_numbers(const hdf5::Handle& group, const std::string& name, const hdf5::RowBlock& block,
                               std::span<const std::int64_t> values) {
  hdf5::write_dataset(group.get(), name, H5T_STD_I64LE, block, H5T_NATIVE_INT64, values.data());
}

// Writes whole numbers of the local nodes or elements.
void VtkhdfFile::write_items(const std::string& name, FieldPlace place, std::span<const std::int64_t> values) {
  auto& rows = place == FieldPlace::node ? node_rows_ : element_rows_;
  write_numbers(place == FieldPlace::node ? tables_.point_data : tables_.cell_data, name, make_block(place),
                rows.gather(values, 1));
}

void VtkhdfFile::write_cells(const Mesh& mesh) {
  const auto rows = list_cell_rows(mesh);
  const Cells cells = list_cells(element_rows_.gather(std::span<const std::int64_t>(rows), static_cast<int>(cell_row)));
  const hdf5::RowBlock ids = make_block_of_all(cells.corners.size());
  write_numbers(tables_.root, "NumberOfConnectivityIds", make_block_of_first_rank(1),
                std::array{static_cast<std::int64_t>(ids.all)});
  write_numbers(tables_.root, "Connectivity", ids, cells.corners);
  auto block = make_block(FieldPlace::element);
  hdf5::write_dataset(tables_.root.get(), "Types", H5T_STD_U8LE, block, H5T_NATIVE_UINT8,
                      cells.list_vtk_types().data());
  // One more than there are cells: the end of the last one.
  const bool last = block.first + block.count == block.all;
  std::vector<std::int64_t> offsets{0};
  offsets.insert(offsets.end(), cells.ends.begin(), cells.ends.end());
  offsets.resize(block.count + (last ? 1 : 0));
  for (std::int64_t& offset : offsets) offset += static_cast<std::int64_t>(ids.first);
  block.all += 1;
  block.count = offsets.size();
  write_numbers(tables_.root, "Offsets", block, offsets);
  if (!has_several_kinds(ranks_, cells)) return;  // XDMF needs no more for one
  const std::vector<std::int64_t> mixed = list_mixed_topology(cells);
  write_numbers(tables_.own, "xdmf_topology", make_block_of_all(mixed.size()), mixed);
}

void VtkhdfFile::write_mesh(const Mesh& mesh) {
  const auto write_count = [&](const char* name, hsize_t count) {
    write_numbers(tables_.root, name, make_block_of_first_rank(1), std::array{static_cast<std::int64_t>(count)});
  };
  write_count("NumberOfPoints", nodes_);
  write_count("NumberOfCells", elements_);
  write_cells(mesh);
  write_items("node_id", FieldPlace::node, mesh.node_ids);
  write_items("element_id", FieldPlace::element, mesh.element_ids);
  std::vector<std::int64_t> parts(mesh.elements.size());
  for (std::size_t e = 0; e < parts.size(); ++e) parts[e] = mesh.part_of(e);
  write_items("part", FieldPlace::element, parts);
}

// What VTK does not know.
void VtkhdfFile::write_scene(const Mesh& mesh) {
  std::vector<std::string> names;
  for (const auto& part : mesh.parts) names.push_back(part.name);
  hdf5::write_texts(tables_.own.get(), "part_names", names, make_block_of_first_rank(names.size()));
  hdf5::write_attribute(tables_.own.get(), "title", options_.title);
  hdf5::write_attribute(tables_.own.get(), "units", options_.units);
  if (options_.walls.empty()) return;
  std::vector<double> walls;  // a point and the normal of each
  for (const auto& [point, normal] : options_.walls) {
    walls.insert(walls.end(), point.begin(), point.end());
    walls.insert(walls.end(), normal.begin(), normal.end());
  }
  hdf5::write_rows_once(tables_.own.get(), "walls", make_block_of_first_rank(options_.walls.size()), 6, walls);
}

void VtkhdfFile::open(std::int64_t frames) {
  file_ = hdf5::open_durable_file(path_, ranks_);
  run_on_first_rank(ranks_, [&] { disk_ = DiskReservation(path_); });
  tables_.open(file_.get());
  frames_ = frames;
}

hsize_t VtkhdfFile::frame_bytes(std::span<const FieldData> fields) const {
  const hsize_t tables = 4 + tables_.constants.size() + 2 * fields.size();
  hsize_t bytes = metadata_bytes_per_table * tables + tables_.points->growth_bytes(nodes_);
  for (const auto& table : tables_.fields)
    bytes += table.values.growth_bytes(table.place == FieldPlace::node ? nodes_ : elements_);
  return bytes;
}

void VtkhdfFile::append_frame(double time, std::int64_t step, std::span<const double> positions,
                              std::span<const FieldData> fields) {
  if (!file_) throw SystemError(fmt::format("cannot write '{}' (it was given up after an error)", path_));
  run_or_abandon("write", [&] {
    if (frames_ == 0)
      tables_.create_fields(fields, options_, nodes_, elements_);
    else if (tables_.fields.empty())
      tables_.open_fields(fields);
    reserve(frame_bytes(fields));
    append_rows(time, step, positions, fields);
    flush();
    compare();
    // Only now does the frame exist for a reader.
    hdf5::write_attribute(tables_.steps.get(), "NSteps", std::array<std::int64_t, 1>{frames_ + 1});
    flush();
    ++frames_;
    trim();
  });
}

template <class T>
void VtkhdfFile::append_one(hdf5::Table& table, T value) {
  table.append(std::span<const T>(&value, 1), make_block_of_first_rank(1));
}

void VtkhdfFile::append_items(hdf5::Table& table, FieldPlace place, std::span<const double> values, int components,
                              FieldNumber number) {
  auto& rows = place == FieldPlace::node ? node_rows_ : element_rows_;
  const std::span<const double> block = rows.gather(values, components);
  if (number == FieldNumber::real) return table.append(block, make_block(place));
  std::vector<std::uint8_t> bytes;  // HDF5 would convert them as well, but then not write them collectively
  for (const double value : block) bytes.push_back(static_cast<std::uint8_t>(value));
  table.append(std::span<const std::uint8_t>(bytes), make_block(place));
}

void VtkhdfFile::append_rows(double time, std::int64_t step, std::span<const double> positions,
                             std::span<const FieldData> fields) {
  append_one(*tables_.point_offsets, static_cast<std::int64_t>(tables_.points->rows()));
  append_items(*tables_.points, FieldPlace::node, positions, 3);
  for (std::size_t i = 0; i < fields.size(); ++i) {
    append_one(tables_.fields[i].offsets, static_cast<std::int64_t>(tables_.fields[i].values.rows()));
    const FieldData& field = fields[i];
    append_items(tables_.fields[i].values, field.place, field.values, field.components, field.number);
  }
  for (auto& constant : tables_.constants) append_one(constant.table, constant.value);
  append_one(*tables_.step_numbers, step);
  append_one(*tables_.times, time);
}

void VtkhdfFile::flush() { check(H5Fflush(file_.get(), H5F_SCOPE_GLOBAL), "flush the file"); }

// What a reader finds must be what was written since this was called last, behind the frames of which the file tells.
void VtkhdfFile::compare() {
  ranks_.barrier();  // all have flushed it
  const auto read_back = [&] {
    try {
      const hdf5::Handle file = hdf5::open_to_compare(path_);
      record_.compare(file.get());
      const hdf5::Handle steps = hdf5::open_group(file.get(), "VTKHDF/Steps");
      if (hdf5::read_whole_number(steps.get(), "NSteps") != frames_)
        throw hdf5::Error("read back the number of frames", "it is not what was written");
    } catch (const hdf5::Error& error) {
      throw SystemError(make_message("write", error));
    }
  };
  try {
    fail_together(ranks_, read_back);
  } catch (const SystemError&) {
    // A file that was taken away meanwhile cannot be read either: that is what to tell.
    run_on_first_rank(ranks_, [&] { disk_.file().check_place(); });
    throw;
  }
  record_.clear();
}

hsize_t VtkhdfFile::file_bytes() const {
  hsize_t bytes = 0;
  check(H5Fget_filesize(file_.get(), &bytes), "ask for the size of the file");
  return bytes;
}

// HDF5 does not tell how long a file is that several ranks write, but a flush cuts it to its data if they end elsewhere
// than before, and frame_bytes() is more than a frame takes.
void VtkhdfFile::reserve(hsize_t bytes) {
  if (ranks_.size() == 1) {
    disk_.reserve(file_bytes(), bytes);
  } else {
    run_on_first_rank(ranks_, [&] { disk_.reserve(static_cast<std::uint64_t>(disk_.file().size()), bytes); });
  }
}

void VtkhdfFile::trim() {
  if (ranks_.size() == 1) {
    disk_.trim(file_bytes());
  } else {
    run_on_first_rank(ranks_, [&] { disk_.trim_if_unused(); });
  }
}

void VtkhdfFile::sync() {
  run_on_first_rank(ranks_, [&] {
    disk_.file().check_place();
    disk_.file().sync();
  });
  compare();
}

void VtkhdfFile::close() {
  if (!file_) return;
  run_or_abandon("write", [&] {
    flush();
    tables_.release();
    check(file_.reset(), "close the file");
    sync();
  });
}

bool VtkhdfFile::is_in_place() const {
  int in_place = ranks_.rank() == 0 && disk_.file().is_in_place() ? 1 : 0;
  wait_mpi([&] { return MPI_Bcast(&in_place, 1, MPI_INT, 0, ranks_.handle()); }, "MPI_Bcast");
  return in_place != 0;
}

void VtkhdfFile::abandon() {
  hdf5::turn_away(file_, ranks_);
  tables_.release();
  file_.release();
}

}  // namespace percuss
