#include "src/output/fields/fields_restart.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <set>

#include "src/mesh/exodus/trial_process.hpp"
#include "src/output/files/atomic_file.hpp"
#include "src/output/hdf5/hdf5_reading.hpp"
#include "src/output/hdf5/hdf5_table.hpp"

namespace percuss {
namespace {

using hdf5::check;

// What lies beside the fields of the frames, written once.
constexpr std::array<const char*, 3> written_once{"node_id", "element_id", "part"};

bool is_written_once(const std::string& name) {
  return std::find(written_once.begin(), written_once.end(), name) != written_once.end();
}

hdf5::Handle open_file(const std::string& path, unsigned mode) {
  const hdf5::Handle access(check(H5Pcreate(H5P_FILE_ACCESS), "open the file"), H5Pclose);
  check(H5Pset_file_locking(access.get(), false, true), "open the file");
  return {check(H5Fopen(path.c_str(), mode, access.get()), "open it as HDF5"), H5Fclose};
}

hsize_t read_count(hid_t root, const char* name, hsize_t bytes) {
  return static_cast<hsize_t>(hdf5::read_rows<std::int64_t>(root, name, 0, 1, bytes).front());
}

std::set<std::string> list_fields(hid_t root) {
  std::set<std::string> names;
  for (const char* group : {"PointData", "CellData"}) {
    for (const std::string& name : hdf5::list_names(root, group)) {
      if (!is_written_once(name)) names.insert(name);
    }
  }
  return names;
}

hsize_t find_file_bytes(const std::string& path) {
  const int descriptor = ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
  if (descriptor < 0) return 0;
  const off_t size = ::lseek(descriptor, 0, SEEK_END);
  ::close(descriptor);
  return static_cast<hsize_t>(std::max<off_t>(size, 0));
}

/// Why the file does not fit; empty if it does.
std::string find_problem(hid_t root, const EarlierFrames& kept, std::span<const std::string> fields, hsize_t bytes) {
  if (read_count(root, "NumberOfPoints", bytes) != kept.nodes ||
      read_count(root, "NumberOfCells", bytes) != kept.elements)
    return "it has another mesh";
  const auto frames = hdf5::read_whole_number(hdf5::open_group(root, "Steps").get(), "NSteps");
  if (frames < static_cast<std::int64_t>(kept.frames))
    return fmt::format("it has {} frames, and the checkpoint counts on {}", frames, kept.frames);
  if (kept.frames > 0 && list_fields(root) != std::set<std::string>(fields.begin(), fields.end()))
    return "its fields are not those of this deck";
  return "";
}

LaterStates read_later_frames(const std::string& path, hsize_t frames) {
  const hdf5::QuietErrors quiet;
  const hdf5::Handle file = open_file(path, H5F_ACC_RDONLY);
  const hdf5::Handle root = hdf5::open_group(file.get(), "VTKHDF");
  const hsize_t bytes = find_file_bytes(path);
  const std::int64_t all = hdf5::read_whole_number(hdf5::open_group(root.get(), "Steps").get(), "NSteps");
  if (all <= static_cast<std::int64_t>(frames)) return {};
  const hsize_t count = static_cast<hsize_t>(all) - frames;
  const std::vector<double> times = hdf5::read_rows<double>(root.get(), "Steps/Values", frames, count, bytes);
  const std::vector<std::int64_t> steps =
      hdf5::read_rows<std::int64_t>(file.get(), "percuss/step", frames, count, bytes);
  LaterStates later;
  for (std::size_t i = 0; i < times.size() && i < steps.size(); ++i) later.push_back({times[i], steps[i]});
  return later;
}

void cut_all(hid_t root, hid_t own, const EarlierFrames& kept) {
  const auto cut = [](hid_t parent, const std::string& name, hsize_t rows) { hdf5::Table(parent, name).cut(rows); };
  const hdf5::Handle steps = hdf5::open_group(root, "Steps");
  hdf5::write_attribute(steps.get(), "NSteps", std::array{static_cast<std::int64_t>(kept.frames)});
  // On its way to the disk before the tables are: a kill in between must leave no frame that a reader counts but finds
  // cut, and filled with zeros.
  check(H5Fflush(root, H5F_SCOPE_GLOBAL), "flush the file");
  for (const std::string& name : hdf5::list_names(root, "Steps")) {
    if (!name.ends_with("DataOffsets")) cut(steps.get(), name, kept.frames);
  }
  const auto cut_fields = [&](const char* group, const char* offsets, hsize_t items) {
    for (const std::string& name : hdf5::list_names(root, group)) {
      if (!is_written_once(name)) cut(hdf5::open_group(root, group).get(), name, kept.frames * items);
    }
    for (const std::string& name : hdf5::list_names(steps.get(), offsets))
      cut(hdf5::open_group(steps.get(), offsets).get(), name, kept.frames);
  };
  cut_fields("PointData", "PointDataOffsets", kept.nodes);
  cut_fields("CellData", "CellDataOffsets", kept.elements);
  cut(root, "Points", kept.frames * kept.nodes);
  cut(own, "step", kept.frames);
}

/// The times of the frames that are kept.
std::vector<double> read_times(const std::string& path, const EarlierFrames& kept,
                               std::span<const std::string> fields) {
  const hdf5::QuietErrors quiet;
  std::string problem;
  try {
    const hdf5::Handle file = open_file(path, H5F_ACC_RDONLY);
    const hdf5::Handle root = hdf5::open_group(file.get(), "VTKHDF");
    const hsize_t bytes = find_file_bytes(path);
    problem = find_problem(root.get(), kept, fields, bytes);
    if (problem.empty()) return hdf5::read_rows<double>(root.get(), "Steps/Values", 0, kept.frames, bytes);
  } catch (const hdf5::Error& error) {
    problem = fmt::format("cannot {}: {}", error.what(), error.reason);
  }
  throw InputError(fmt::format("{}: error: {} (the restart goes on with this file) choose another folder with --out",
                               path, problem));
}

}  // namespace

std::vector<double> check_fields_file(const std::string& path, const EarlierFrames& kept,
                                      std::span<const std::string> fields) {
  rehearse(path, find_file_bytes(path), [&] { read_times(path, kept, fields); });
  return read_times(path, kept, fields);
}

LaterStates find_later_frames(const std::string& path, std::int64_t frames) {
  if (find_file_bytes(path) == 0) return {};
  const auto first = static_cast<hsize_t>(std::max<std::int64_t>(frames, 0));
  LaterStates later;
  try {
    rehearse(path, find_file_bytes(path), [&] { read_later_frames(path, first); });
    later = read_later_frames(path, first);
  } catch (const hdf5::Error&) {  // no fields file of percuss
  } catch (const InputError&) {   // nor one that the library can read
  }
  return later;
}

void cut_fields_file(const std::string& path, const EarlierFrames& kept) {
  const hdf5::QuietErrors quiet;
  try {
    hdf5::Handle file = open_file(path, H5F_ACC_RDWR);
    cut_all(hdf5::open_group(file.get(), "VTKHDF").get(), hdf5::open_group(file.get(), "percuss").get(), kept);
    check(file.reset(), "close the file");
  } catch (const hdf5::Error& error) {
    throw SystemError(fmt::format("cannot cut '{}' to its first {} frames ({}; while HDF5 was to {}){}", path,
                                  kept.frames, error.reason, error.what(), suggest_for_errno(error.error_number)));
  }
}

}  // namespace percuss
