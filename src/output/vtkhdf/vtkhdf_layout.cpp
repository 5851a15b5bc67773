#include <algorithm>
#include <array>

#include "src/output/frame/frame_layout.hpp"
#include "src/output/hdf5/hdf5_reading.hpp"
#include "src/output/hdf5/hdf5_table.hpp"

namespace percuss {
namespace {

// Datasets beside the fields of the frames, written once.
constexpr std::array<const char*, 3> written_once{"node_id", "element_id", "part"};

bool is_written_once(const std::string& name) {
  return std::find(written_once.begin(), written_once.end(), name) != written_once.end();
}

constexpr const char* point_data = "VTKHDF/PointData";
constexpr const char* cell_data = "VTKHDF/CellData";
constexpr const char* steps = "VTKHDF/Steps";

std::int64_t count_vtkhdf_frames(hid_t file) {
  return hdf5::read_whole_number(hdf5::open_group(file, steps).get(), "NSteps");
}

FramesInFile find_vtkhdf_mesh(hid_t file) {
  const auto count = [&](const char* name) {
    return static_cast<hsize_t>(hdf5::read_rows<std::int64_t>(file, name, 0, 1, sizeof(std::int64_t)).front());
  };
  return {0, count("VTKHDF/NumberOfPoints"), count("VTKHDF/NumberOfCells")};
}

std::set<std::string> list_vtkhdf_fields(hid_t file, std::span<const std::string>) {
  std::set<std::string> names;
  for (const char* group : {point_data, cell_data}) {
    for (const std::string& name : hdf5::list_names(file, group)) {
      if (!is_written_once(name)) names.insert(name);
    }
  }
  return names;
}

/// Tables of a group that have `rows` rows in the frames that are kept.
template <class IsOther>
void cut_group(hid_t file, const std::string& group, hsize_t rows, const IsOther& is_other) {
  const hdf5::Handle parent = hdf5::open_group(file, group);
  for (const std::string& name : hdf5::list_names(file, group)) {
    if (!is_other(name)) hdf5::GrowingDataset(parent.get(), name).cut(rows);
  }
}

void cut_vtkhdf(hid_t file, const FramesInFile& kept) {
  hdf5::write_attribute(hdf5::open_group(file, steps).get(), "NSteps",
                        std::array{static_cast<std::int64_t>(kept.frames)});
  hdf5::check(H5Fflush(file, H5F_SCOPE_GLOBAL), "flush the file");
  const auto none = [](const std::string&) { return false; };
  cut_group(file, steps, kept.frames, [](const std::string& name) { return name.ends_with("DataOffsets"); });
  cut_group(file, std::string(steps) + "/PointDataOffsets", kept.frames, none);
  cut_group(file, std::string(steps) + "/CellDataOffsets", kept.frames, none);
  cut_group(file, point_data, kept.frames * kept.nodes, is_written_once);
  cut_group(file, cell_data, kept.frames * kept.elements, is_written_once);
  hdf5::GrowingDataset(file, "VTKHDF/Points").cut(kept.frames * kept.nodes);
  for (const char* name : {"percuss/step", "percuss/wall_displacements"}) {
    if (hdf5::check(H5Lexists(file, name, H5P_DEFAULT), "look for a table") > 0)
      hdf5::GrowingDataset(file, name).cut(kept.frames);
  }
}

}  // namespace

const FrameLayout vtkhdf_frames{".vtkhdf",        "VTKHDF/Steps/Values", "percuss/step", count_vtkhdf_frames,
                                find_vtkhdf_mesh, list_vtkhdf_fields,    cut_vtkhdf};

}  // namespace percuss
