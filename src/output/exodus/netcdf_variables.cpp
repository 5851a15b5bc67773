#include "src/output/exodus/netcdf_variables.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <memory>

#include "src/output/hdf5/hdf5_reading.hpp"

namespace percuss {
namespace {

using hdf5::check;
using hdf5::Handle;

constexpr hsize_t scale_chunk = 512;

/// HDF5 takes a dataset for a scale only with texts that end with a zero.
void write_ended_text(hid_t object, const char* name, const std::string& text) {
  const std::string action = fmt::format("write attribute {}", name);
  const Handle type(check(H5Tcopy(H5T_C_S1), action), H5Tclose);
  check(H5Tset_size(type.get(), text.size() + 1), action);
  const Handle space(check(H5Screate(H5S_SCALAR), action), H5Sclose);
  const Handle attribute(check(H5Acreate2(object, name, type.get(), space.get(), H5P_DEFAULT, H5P_DEFAULT), action),
                         H5Aclose);
  check(H5Awrite(attribute.get(), type.get(), text.c_str()), action);
}

void write_number_attribute(hid_t object, const std::string& name, hid_t file_type, hid_t memory_type,
                            const void* value) {
  const std::string action = fmt::format("write attribute {}", name);
  const Handle space(check(H5Screate(H5S_SCALAR), action), H5Sclose);
  const Handle attribute(
      check(H5Acreate2(object, name.c_str(), file_type, space.get(), H5P_DEFAULT, H5P_DEFAULT), action), H5Aclose);
  check(H5Awrite(attribute.get(), memory_type, value), action);
}

Handle create_dataset(hid_t file, const std::string& name, hid_t type, std::span<const hsize_t> extent) {
  const std::string action = "create dataset " + name;
  const Handle space(check(H5Screate_simple(static_cast<int>(extent.size()), extent.data(), nullptr), action),
                     H5Sclose);
  const Handle properties = hdf5::create_early_properties(action);
  return {check(H5Dcreate2(file, name.c_str(), type, space.get(), H5P_DEFAULT, properties.get(), H5P_DEFAULT), action),
          H5Dclose};
}

std::string make_scale_name(std::size_t length) {
  return fmt::format("This is a netCDF dimension but not a netCDF variable.{:10}", length);
}

}  // namespace

void NetcdfDimensions::create(hid_t file, const std::string& name, std::size_t length) {
  const std::string action = "create dimension " + name;
  const hsize_t extent = length, most = length == 0 ? H5S_UNLIMITED : extent;
  const Handle space(check(H5Screate_simple(1, &extent, &most), action), H5Sclose);
  const Handle properties = hdf5::create_dataset_properties(action);
  if (length == 0) check(H5Pset_chunk(properties.get(), 1, &scale_chunk), action);
  const Handle scale(
      check(H5Dcreate2(file, name.c_str(), H5T_IEEE_F32BE, space.get(), H5P_DEFAULT, properties.get(), H5P_DEFAULT),
            action),
      H5Dclose);
  write_ended_text(scale.get(), "CLASS", "DIMENSION_SCALE");
  write_ended_text(scale.get(), "NAME", make_scale_name(length));
  write_int_attribute(scale.get(), "_Netcdf4Dimid", static_cast<int>(scales_.size()));
  open(file, name);
  lengths_[name] = length;
}

void NetcdfDimensions::open(hid_t file, const std::string& name) {
  hobj_ref_t reference{};
  check(H5Rcreate(&reference, file, name.c_str(), H5R_OBJECT, -1), "refer to dimension " + name);
  scales_[name] = reference;
}

void NetcdfDimensions::attach(hid_t dataset, std::span<const std::string> names) const {
  const std::string action = "note the dimensions of a dataset";
  const Handle type(check(H5Tvlen_create(H5T_STD_REF_OBJ), action), H5Tclose);
  const hsize_t count = names.size();
  const Handle space(check(H5Screate_simple(1, &count, nullptr), action), H5Sclose);
  std::vector<hobj_ref_t> references;
  for (const std::string& name : names) references.push_back(scales_.at(name));
  // Not a vector: hvl_t has no name of its own, which nvcc 13.0 does not bear.
  const auto lists = std::make_unique<hvl_t[]>(references.size());
  for (std::size_t i = 0; i < references.size(); ++i) lists[i] = {1, &references[i]};
  const Handle attribute(
      check(H5Acreate2(dataset, "DIMENSION_LIST", type.get(), space.get(), H5P_DEFAULT, H5P_DEFAULT), action),
      H5Aclose);
  check(H5Awrite(attribute.get(), type.get(), lists.get()), action);
}

void NetcdfDimensions::attach(hid_t file, const std::string& dataset, std::span<const std::string> names) const {
  const Handle open(check(H5Dopen2(file, dataset.c_str(), H5P_DEFAULT), "open dataset " + dataset), H5Dclose);
  attach(open.get(), names);
}

void NetcdfFile::write_integers(const std::string& name, const std::string& dimension, const hdf5::RowBlock& block,
                                std::span<const std::int64_t> values) const {
  hdf5::write_dataset(file, name, H5T_STD_I64LE, block, H5T_NATIVE_INT64, values.data());
  dimensions.attach(file, name, std::array{dimension});
}

void NetcdfFile::write_integer_rows(const std::string& name, std::span<const std::string> names,
                                    const hdf5::RowBlock& block, std::span<const std::int64_t> values) const {
  hdf5::write_rows_once(file, name, block, static_cast<int>(dimensions.length(names[1])), values);
  dimensions.attach(file, name, names);
}

void NetcdfFile::write_numbers(const std::string& name, const std::string& dimension, const hdf5::RowBlock& block,
                               std::span<const double> values) const {
  hdf5::write_dataset(file, name, H5T_IEEE_F64LE, block, H5T_NATIVE_DOUBLE, values.data());
  dimensions.attach(file, name, std::array{dimension});
}

void NetcdfFile::write_texts(const std::string& name, std::span<const std::string> names, hid_t transfer,
                             bool is_writer, std::span<const std::string> texts) const {
  std::vector<hsize_t> extent;
  for (const std::string& dimension : names) extent.push_back(dimensions.length(dimension));
  const Handle dataset = create_dataset(file, name, H5T_C_S1, extent);
  const std::size_t length = extent.back();
  std::vector<char> padded(texts.size() * length, '\0');
  for (std::size_t i = 0; i < texts.size(); ++i)
    std::copy_n(texts[i].begin(), std::min(texts[i].size(), length - 1),
                padded.begin() + static_cast<std::ptrdiff_t>(i * length));
  const Handle space(check(H5Dget_space(dataset.get()), "write dataset " + name), H5Sclose);
  if (!is_writer) check(H5Sselect_none(space.get()), "write dataset " + name);
  check(H5Dwrite(dataset.get(), H5T_C_S1, space.get(), space.get(), transfer, padded.data()), "write dataset " + name);
  dimensions.attach(dataset.get(), names);
}

void write_int_attribute(hid_t object, const std::string& name, int value) {
  write_number_attribute(object, name, H5T_STD_I32LE, H5T_NATIVE_INT, &value);
}

void write_float_attribute(hid_t object, const std::string& name, float value) {
  write_number_attribute(object, name, H5T_IEEE_F32LE, H5T_NATIVE_FLOAT, &value);
}

}  // namespace percuss
