#include "src/output/vtkhdf/vtkhdf_file.hpp"

#include <algorithm>
#include <array>

#include "comm/all_reduce.hpp"
#include "src/output/frame/frame_layout.hpp"
#include "src/output/hdf5/hdf5_reading.hpp"
#include "src/output/vtkhdf/mesh_extents.hpp"

namespace percuss {
namespace {

// Most bytes of metadata beside the index of a table that a frame adds, and that a file starts with.
constexpr hsize_t metadata_bytes_of_frame = hsize_t{64} << 10;
constexpr hsize_t metadata_bytes_of_file = hsize_t{256} << 10;
constexpr hsize_t vtkhdf_bytes_per_node = 8;                      // its id
constexpr hsize_t vtkhdf_bytes_per_element = 8 * 8 + 8 + 1 + 16;  // corners, offset, type, id and part

// Whether the cells of all ranks are of more than one kind.
bool has_several_kinds(const Communicator& ranks, const Cells& cells) {
  std::array<int, topology_count> kinds{};  // whether there are any of each
  for (const TopologyKind kind : cells.kinds) kinds[static_cast<std::size_t>(kind)] = 1;
  all_reduce(ranks, Reduce::largest, kinds);
  return std::count(kinds.begin(), kinds.end(), 1) > 1;
}

}  // namespace

VtkhdfFile::VtkhdfFile(Unopened, const std::string& path, const ChunkedMesh& chunked, const FieldsOptions& options,
                       const Communicator& ranks)
    : ranks_(ranks),
      options_(options),
      nodes_(static_cast<hsize_t>(chunked.numbering.node_count())),
      elements_(static_cast<hsize_t>(chunked.numbering.element_count())),
      node_rows_(ranks, find_owned_nodes(chunked, ranks), chunked.mesh.node_numbers, chunked.numbering.node_count()),
      element_rows_(ranks, count_up(chunked.mesh.elements.size()), list_element_numbers(chunked),
                    chunked.numbering.element_count()),
      file_(path, ranks,
            {hdf5::LinkOrder::by_name, hdf5::most_chunk_index, [this] { tables_.release(); },
             vtkhdf_frames.count_frames}) {}

VtkhdfFile::VtkhdfFile(const std::string& path, const ChunkedMesh& chunked, const FieldsOptions& options,
                       const Communicator& ranks)
    : VtkhdfFile(Unopened{}, path, chunked, options, ranks) {
  file_.create(metadata_bytes_of_file + nodes_ * vtkhdf_bytes_per_node + elements_ * vtkhdf_bytes_per_element, [&] {
    tables_.create_groups(file_.id());
    write_mesh(chunked.mesh);
    write_scene(chunked.mesh);
    tables_.create_steps(nodes_, options_);
  });
}

VtkhdfFile::VtkhdfFile(const std::string& path, const ChunkedMesh& chunked, const FieldsOptions& options,
                       const Communicator& ranks, std::int64_t frames)
    : VtkhdfFile(Unopened{}, path, chunked, options, ranks) {
  file_.open(frames, [&] { tables_.open(file_.id()); });
}

hdf5::RowBlock VtkhdfFile::make_block(FieldPlace place, int rows) {
  return file_.complete((place == FieldPlace::node ? node_rows_ : element_rows_).block(rows));
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
  const hdf5::RowBlock ids = file_.block_of_all(cells.corners.size());
  write_numbers(tables_.root, "NumberOfConnectivityIds", file_.block_of_first_rank(1),
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
  write_numbers(tables_.own, "xdmf_topology", file_.block_of_all(mixed.size()), mixed);
}

void VtkhdfFile::write_mesh(const Mesh& mesh) {
  const auto write_count = [&](const char* name, hsize_t count) {
    write_numbers(tables_.root, name, file_.block_of_first_rank(1), std::array{static_cast<std::int64_t>(count)});
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

// Writes what VTK does not know.
void VtkhdfFile::write_scene(const Mesh& mesh) {
  std::vector<std::string> names;
  for (const auto& part : mesh.parts) names.push_back(part.name);
  hdf5::write_texts(tables_.own.get(), "part_names", names, file_.block_of_first_rank(names.size()));
  hdf5::write_attribute(tables_.own.get(), "title", options_.title);
  hdf5::write_attribute(tables_.own.get(), "units", options_.units);
  write_walls();
}

void VtkhdfFile::write_walls() {
  const auto write = [&](const char* name, const std::vector<double>& rows, int width = 6) {
    if (!rows.empty())
      hdf5::write_rows_once(tables_.own.get(), name,
                            file_.block_of_first_rank(rows.size() / static_cast<std::size_t>(width)), width, rows);
  };
  const auto list_planes = [](const std::vector<WallPlane>& walls) {
    std::vector<double> rows;
    for (const WallPlane& wall : walls) {
      for (const Vec3& vector : {wall.point, wall.normal}) rows.insert(rows.end(), vector.begin(), vector.end());
    }
    return rows;
  };
  const auto list_edges = [](const std::vector<WallPlane>& walls) {
    std::vector<double> rows;
    for (const WallPlane& wall : walls) {
      for (const Vec3& vector : wall.edges) rows.insert(rows.end(), vector.begin(), vector.end());
    }
    const bool all_endless = std::all_of(rows.begin(), rows.end(), [](double x) { return x == 0; });
    return all_endless ? std::vector<double>() : rows;
  };
  write("walls", list_planes(options_.walls));
  write("wall_edges", list_edges(options_.walls));
  write("moving_walls", list_planes(options_.moving_walls));
  write("moving_wall_edges", list_edges(options_.moving_walls));
  constexpr int round_width = 11;
  const auto list_round = [](const std::vector<RoundWall>& walls) {
    std::vector<double> rows;
    for (const RoundWall& wall : walls) {
      for (const Vec3& vector : {wall.point, wall.axis}) rows.insert(rows.end(), vector.begin(), vector.end());
      rows.insert(rows.end(), {wall.radius, wall.length});
      rows.insert(rows.end(), wall.direction.begin(), wall.direction.end());
    }
    return rows;
  };
  write("round_walls", list_round(options_.round_walls), round_width);
  write("moving_round_walls", list_round(options_.moving_round_walls), round_width);
}

hsize_t VtkhdfFile::frame_bytes() const {
  hsize_t bytes = metadata_bytes_of_frame + tables_.points->growth_bytes(nodes_);
  for (const auto& table : tables_.fields) {
    bytes += table.values.growth_bytes(table.place == FieldPlace::node ? nodes_ : elements_);
    bytes += table.offsets.growth_bytes(1);
  }
  for (const auto& constant : tables_.constants) bytes += constant.table.growth_bytes(1);
  for (const auto* table : {&tables_.times, &tables_.point_offsets, &tables_.step_numbers})
    bytes += (*table)->growth_bytes(1);
  if (tables_.wall_displacements) bytes += tables_.wall_displacements->growth_bytes();
  return bytes;
}

void VtkhdfFile::append_frame(double time, std::int64_t step, std::span<const double> positions,
                              std::span<const FieldData> fields, std::span<const double> wall_displacements) {
  const auto prepare = [&] {
    if (tables_.fields.empty() && tables_.has_fields())
      tables_.open_fields(fields);
    else if (tables_.fields.empty())
      tables_.create_fields(fields, options_, nodes_, elements_);
    return frame_bytes();
  };
  const auto show = [&] {
    hdf5::write_attribute(tables_.steps.get(), "NSteps", std::array<std::int64_t, 1>{file_.frames() + 1});
  };
  const auto write = [&] {
    append_rows(time, step, positions, fields);
    if (tables_.wall_displacements)
      tables_.wall_displacements->append(wall_displacements, file_.block_of_first_rank(wall_displacements.size()));
  };
  file_.append_frame({prepare, write, show});
}

template <class T>
void VtkhdfFile::append_one(hdf5::Table& table, T value) {
  table.append(std::span<const T>(&value, 1), file_.block_of_first_rank(1));
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

}  // namespace percuss
