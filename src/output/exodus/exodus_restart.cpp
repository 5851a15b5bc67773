#include "src/output/exodus/exodus_restart.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <set>

#include "src/mesh/exodus/trial_process.hpp"
#include "src/output/exodus/exodus_variables.hpp"
#include "src/output/exodus/netcdf_variables.hpp"
#include "src/output/files/atomic_file.hpp"
#include "src/output/hdf5/frame_table.hpp"
#include "src/output/hdf5/hdf5_reading.hpp"

namespace percuss {
namespace {

using hdf5::check;

hdf5::Handle open_file(const std::string& path, unsigned mode) {
  const hdf5::Handle access(check(H5Pcreate(H5P_FILE_ACCESS), "open the file"), H5Pclose);
  check(H5Pset_file_locking(access.get(), false, true), "open the file");
  return {check(H5Fopen(path.c_str(), mode, access.get()), "open it as HDF5"), H5Fclose};
}

hsize_t find_file_bytes(const std::string& path) {
  std::error_code ignored;
  const auto bytes = std::filesystem::file_size(path, ignored);
  return ignored ? 0 : static_cast<hsize_t>(bytes);
}

bool has(hid_t file, const char* name) { return check(H5Lexists(file, name, H5P_DEFAULT), "look for a variable") > 0; }

/// The fields whose components are the variables of nodes and elements; "?" for one that belongs to none of `fields`.
std::set<std::string> list_fields(hid_t file, std::span<const std::string> fields) {
  std::set<std::string> found;
  for (const char* names : {"name_nod_var", "name_elem_var"}) {
    if (!has(file, names)) continue;
    for (const std::string& variable : read_character_rows(file, names)) {
      const std::string field = find_field_of_variable(variable, fields);
      found.insert(field.empty() ? "?" : field);
    }
  }
  return found;
}

/// Why the file does not fit; empty if it does.
std::string find_problem(hid_t file, const EarlierFrames& kept, std::span<const std::string> fields) {
  if (hdf5::read_shape(file, "node_num_map").rows != kept.nodes ||
      hdf5::read_shape(file, "elem_num_map").rows != kept.elements)
    return "it has another mesh";
  const std::int64_t frames = count_exodus_frames(file);
  if (kept.frames == 0) return "the checkpoint counts on no frame in it";
  if (frames < static_cast<std::int64_t>(kept.frames))
    return fmt::format("it has {} frames, and the checkpoint counts on {}", frames, kept.frames);
  if (list_fields(file, fields) != std::set<std::string>(fields.begin(), fields.end()))
    return "its fields are not those of this deck";
  return "";
}

void check_file(const std::string& path, const EarlierFrames& kept, std::span<const std::string> fields) {
  const hdf5::QuietErrors quiet;
  std::string problem;
  try {
    problem = find_problem(open_file(path, H5F_ACC_RDONLY).get(), kept, fields);
    if (problem.empty()) return;
  } catch (const hdf5::Error& error) {
    problem = fmt::format("cannot {}: {}", error.what(), error.reason);
  }
  throw InputError(fmt::format("{}: error: {} (the restart goes on with this file) choose another folder with --out",
                               path, problem));
}

LaterStates read_later_frames(const std::string& path, hsize_t frames) {
  const hdf5::QuietErrors quiet;
  const hdf5::Handle file = open_file(path, H5F_ACC_RDONLY);
  const hsize_t bytes = find_file_bytes(path), all = static_cast<hsize_t>(count_exodus_frames(file.get()));
  if (all <= frames) return {};
  const auto times = hdf5::read_rows<double>(file.get(), "time_whole", frames, all - frames, bytes);
  const auto steps = hdf5::read_rows<double>(file.get(), "vals_glo_var", frames, all - frames, bytes);
  LaterStates later;
  for (std::size_t i = 0; i < times.size(); ++i) {
    if (!(steps[i] >= 0 && steps[i] < 9e15)) throw hdf5::Error("read vals_glo_var", "a step number is not a count");
    later.push_back({times[i], static_cast<std::int64_t>(steps[i])});
  }
  return later;
}

void cut_all(hid_t file, const EarlierFrames& kept) {
  hdf5::FrameTable(file, "time_whole").cut(kept.frames);
  // On its way to the disk before the others are: a kill in between must leave no frame that a reader counts but finds
  // cut.
  check(H5Fflush(file, H5F_SCOPE_GLOBAL), "flush the file");
  for (const std::string& name : hdf5::list_names(file, ".")) {
    if (name.starts_with("vals_")) hdf5::FrameTable(file, name).cut(kept.frames);
  }
}

}  // namespace

std::int64_t count_exodus_frames(hid_t file) {
  return static_cast<std::int64_t>(hdf5::read_shape(file, "time_whole").rows);
}

void check_exodus_results(const std::string& path, const EarlierFrames& kept, std::span<const std::string> fields) {
  rehearse(path, find_file_bytes(path), [&] { check_file(path, kept, fields); });
  check_file(path, kept, fields);
}

LaterStates find_later_exodus_frames(const std::string& path, std::int64_t frames) {
  if (find_file_bytes(path) == 0) return {};
  const auto first = static_cast<hsize_t>(std::max<std::int64_t>(frames, 0));
  LaterStates later;
  try {
    rehearse(path, find_file_bytes(path), [&] { read_later_frames(path, first); });
    later = read_later_frames(path, first);
  } catch (const hdf5::Error&) {  // no fields.exo of percuss
  } catch (const InputError&) {   // nor one that the library can read
  }
  return later;
}

void cut_exodus_results(const std::string& path, const EarlierFrames& kept) {
  const hdf5::QuietErrors quiet;
  try {
    hdf5::Handle file = open_file(path, H5F_ACC_RDWR);
    cut_all(file.get(), kept);
    check(file.reset(), "close the file");
  } catch (const hdf5::Error& error) {
    throw SystemError(fmt::format("cannot cut '{}' to its first {} frames ({}; while HDF5 was to {}){}", path,
                                  kept.frames, error.reason, error.what(), suggest_for_errno(error.error_number)));
  }
}

}  // namespace percuss
