#include "src/output/frame/component_names.hpp"
#include "src/output/frame/frame_layout.hpp"
#include "src/output/hdf5/growing_dataset.hpp"
#include "src/output/hdf5/hdf5_reading.hpp"

namespace percuss {
namespace {

constexpr const char* times = "time_whole";
constexpr const char* step_numbers = "vals_glo_var";  // the only global variable

std::int64_t count_exodus_frames(hid_t file) { return static_cast<std::int64_t>(hdf5::read_shape(file, times).rows); }

FramesInFile find_exodus_mesh(hid_t file) {
  return {0, hdf5::read_shape(file, "node_num_map").rows, hdf5::read_shape(file, "elem_num_map").rows};
}

/// The fields whose components are the variables of nodes and elements.
std::set<std::string> list_exodus_fields(hid_t file, std::span<const std::string> fields) {
  std::set<std::string> found;
  for (const char* names : {"name_nod_var", "name_elem_var"}) {
    if (hdf5::check(H5Lexists(file, names, H5P_DEFAULT), "look for variables") == 0) continue;
    for (const std::string& variable : hdf5::read_character_rows(file, names)) {
      const std::string field = find_field_of_component(variable, fields);
      found.insert(field.empty() ? "?" : field);
    }
  }
  return found;
}

void cut_exodus(hid_t file, const FramesInFile& kept) {
  hdf5::GrowingDataset(file, times).cut(kept.frames);
  hdf5::check(H5Fflush(file, H5F_SCOPE_GLOBAL), "flush the file");
  for (const std::string& name : hdf5::list_names(file, ".")) {
    if (name.starts_with("vals_")) hdf5::GrowingDataset(file, name).cut(kept.frames);
  }
}

}  // namespace

const FrameLayout exodus_frames{
    ".exo", times, step_numbers, count_exodus_frames, find_exodus_mesh, list_exodus_fields, cut_exodus};

}  // namespace percuss
