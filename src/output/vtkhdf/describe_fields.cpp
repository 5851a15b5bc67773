#include "src/output/vtkhdf/describe_fields.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cmath>
#include <span>
#include <vector>

#include "src/error.hpp"
#include "src/hdf5/hdf5_handle.hpp"
#include "src/output/files/atomic_file.hpp"
#include "src/output/hdf5/hdf5_reading.hpp"

namespace percuss {
namespace {

using hdf5::check;
using hdf5::Handle;
using hdf5::open_group;
using hdf5::read_rows;

// Describes a field: its range in a frame, the magnitude's for a vector.
std::string describe_range(std::span<const double> values, hsize_t components) {
  double low = HUGE_VAL, high = -HUGE_VAL;
  std::size_t not_finite = 0;
  const std::size_t stride = components == 3 ? 3 : 1;
  for (std::size_t i = 0; i + stride <= values.size(); i += stride) {
    const double value = stride == 3 ? std::hypot(values[i], values[i + 1], values[i + 2]) : values[i];
    if (!std::isfinite(value)) {
      ++not_finite;
      continue;
    }
    low = std::min(low, value);
    high = std::max(high, value);
  }
  std::string text = low > high ? "nothing finite" : fmt::format("{:.6g} to {:.6g}", low, high);
  if (stride == 3) text = "magnitude " + text;
  return not_finite == 0 ? text : fmt::format("{}, {} not finite", text, not_finite);
}

// The file while it is described.
struct Description {
  std::string path;
  hsize_t bytes = 0;
  Handle file, root, own;
  hsize_t nodes = 0, elements = 0, frames = 0;

  std::string describe_mesh() const;
  std::string describe_frames() const;
  std::string describe_fields(const std::string& group, const char* place, hsize_t items) const;
};

std::string format_bytes(hsize_t bytes) {
  static constexpr std::array units{"B", "kB", "MB", "GB", "TB"};
  auto size = static_cast<double>(bytes);
  std::size_t unit = 0;
  for (; size >= 1000 && unit + 1 < units.size(); ++unit) size /= 1000;
  return fmt::format("{:.4g} {}", size, units[unit]);
}

std::string Description::describe_mesh() const {
  const auto parts = hdf5::read_texts(own.get(), "part_names");
  const std::string title = hdf5::read_text(own.get(), "title"), units = hdf5::read_text(own.get(), "units");
  std::string text = fmt::format("{}: fields of a percuss run, {}\n", path, format_bytes(bytes));
  if (!title.empty()) text += fmt::format("title:   {}\n", title);
  if (!units.empty()) text += fmt::format("units:   {}\n", units);
  text += fmt::format("mesh:    {} elements, {} nodes, {} part{} ({})\n", elements, nodes, parts.size(),
                      parts.size() == 1 ? "" : "s", fmt::join(parts, ", "));
  std::uint64_t walls = 0;
  for (const char* name : {"walls", "moving_walls", "round_walls", "moving_round_walls"})
    if (check(H5Lexists(own.get(), name, H5P_DEFAULT), "look for walls") > 0)
      walls += hdf5::read_shape(own.get(), name).rows;
  if (walls > 0) text += fmt::format("walls:   {}\n", walls);
  return text;
}

std::string Description::describe_frames() const {
  if (frames == 0) return "frames:  none\n";
  const auto times = read_rows<double>(root.get(), "Steps/Values", 0, frames, bytes);
  const auto steps = read_rows<std::int64_t>(own.get(), "step", 0, frames, bytes);
  return fmt::format("frames:  {}, time {} to {}, step {} to {}\n", frames, times.front(), times.back(), steps.front(),
                     steps.back());
}

// " [m/s]", or nothing: the deck's units may have no known names, and files of older versions say none.
std::string read_unit(hid_t root, const std::string& dataset) {
  const Handle open(check(H5Dopen2(root, dataset.c_str(), H5P_DEFAULT), "open " + dataset), H5Dclose);
  const bool there = check(H5Aexists(open.get(), "unit"), "read the unit of " + dataset) > 0;
  return there ? fmt::format(" [{}]", hdf5::read_text(open.get(), "unit")) : "";
}

std::string Description::describe_fields(const std::string& group, const char* place, hsize_t items) const {
  std::string text;
  for (const auto& name : hdf5::list_names(root.get(), group)) {
    const std::string dataset = group + "/" + name;
    const std::string steps = fmt::format("Steps/{}Offsets/{}", group, name);
    const hsize_t components = hdf5::read_shape(root.get(), dataset).components;
    std::string range = "no frame";
    if (frames > 0) {
      const auto first = read_rows<std::int64_t>(root.get(), steps, frames - 1, 1, bytes).front();
      if (first < 0) throw hdf5::Error("read " + steps, "a row is negative");
      const auto values = read_rows<double>(root.get(), dataset, static_cast<hsize_t>(first), items, bytes);
      range = describe_range(values, components);
    }
    text += fmt::format("  {:<28} {:<8} {}  {}{}\n", name, place, components, range, read_unit(root.get(), dataset));
  }
  return text;
}

hsize_t read_file_size(const std::string& path) {
  const int descriptor = ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
  if (descriptor < 0) throw make_io_error("read", path, errno);
  const off_t size = ::lseek(descriptor, 0, SEEK_END);
  const int error_number = errno;
  ::close(descriptor);
  if (size < 0) throw make_io_error("read", path, error_number);
  return static_cast<hsize_t>(size);
}

void open_file(Description& d) {
  d.file = hdf5::open_unlocked(d.path, H5F_ACC_RDONLY);
  d.root = open_group(d.file.get(), "VTKHDF");
  d.own = open_group(d.file.get(), "percuss");
  const auto count = [&](const char* name) {
    const auto value = read_rows<std::int64_t>(d.root.get(), name, 0, 1, d.bytes).front();
    if (value < 0) throw hdf5::Error(fmt::format("read {}", name), "it is negative");
    return static_cast<hsize_t>(value);
  };
  d.nodes = count("NumberOfPoints");
  d.elements = count("NumberOfCells");
  const auto frames = hdf5::read_whole_number(open_group(d.root.get(), "Steps").get(), "NSteps");
  if (frames < 0) throw hdf5::Error("read NSteps", "it is negative");
  d.frames = static_cast<hsize_t>(frames);
}

}  // namespace

std::string describe_fields_file(const std::string& path) {
  const hdf5::QuietErrors quiet;
  Description d;
  d.path = path;
  d.bytes = read_file_size(path);
  try {
    open_file(d);
    return d.describe_mesh() + d.describe_frames() + "fields:  name, place, components, range in the last frame\n" +
           d.describe_fields("PointData", "node", d.nodes) + d.describe_fields("CellData", "element", d.elements);
  } catch (const hdf5::Error& error) {
    if (error.error_number != 0) throw make_io_error("read", path, error.error_number);
    throw InputError(fmt::format("{}: error: this is not a fields file of percuss (cannot {}: {}), or it is damaged",
                                 path, error.what(), error.reason));
  }
}

}  // namespace percuss
