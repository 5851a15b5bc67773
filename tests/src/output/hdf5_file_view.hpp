#pragma once
// Reads HDF5 files in tests with the HDF5 library alone, none of percuss' own reading.

#include <gtest/gtest.h>
#include <hdf5.h>

#include <string>
#include <vector>

namespace percuss::sample {

class Hdf5FileView {
 public:
  /// As another program sees it, also if this one has the file open: HDF5 shares what it has in memory between openings
  /// by one driver, and percuss writes by others.
  explicit Hdf5FileView(const std::string& path) : path_(path), file_(open(path, H5Pset_fapl_stdio)) {}
  ~Hdf5FileView() {
    if (file_ >= 0) H5Fclose(file_);
  }
  Hdf5FileView(const Hdf5FileView&) = delete;
  Hdf5FileView& operator=(const Hdf5FileView&) = delete;
  bool is_open() const { return file_ >= 0; }

  bool has(const std::string& name) const { return H5Lexists(file_, name.c_str(), H5P_DEFAULT) > 0; }

  /// Where the file ends by what it says itself.
  hsize_t end_of_data() const {
    const hid_t file = open(path_, H5Pset_fapl_sec2);  // others do not tell
    haddr_t end = 0;
    EXPECT_GE(H5Fget_eoa(file, &end), 0);
    H5Fclose(file);
    return end;
  }

  /// Names of all datasets, ascending.
  std::vector<std::string> datasets() const {
    std::vector<std::string> names;
    const auto add = [](hid_t, const char* name, const H5O_info_t* info, void* data) -> herr_t {
      if (info->type == H5O_TYPE_DATASET) static_cast<std::vector<std::string>*>(data)->push_back(name);
      return 0;
    };
#if H5_VERSION_GE(1, 12, 0)
    H5Ovisit3(file_, H5_INDEX_NAME, H5_ITER_INC, add, &names, H5O_INFO_BASIC);
#else
    H5Ovisit(file_, H5_INDEX_NAME, H5_ITER_INC, add, &names);
#endif
    return names;
  }

  /// A dataset as it is stored.
  std::vector<unsigned char> bytes(const std::string& name) const {
    const hid_t set = H5Dopen2(file_, name.c_str(), H5P_DEFAULT), type = H5Dget_type(set), space = H5Dget_space(set);
    std::vector<unsigned char> data(static_cast<std::size_t>(H5Sget_simple_extent_npoints(space)) * H5Tget_size(type));
    EXPECT_GE(H5Dread(set, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, data.data()), 0) << name;
    H5Sclose(space);
    H5Tclose(type);
    H5Dclose(set);
    return data;
  }

  std::vector<hsize_t> shape(const std::string& name) const {
    const hid_t set = H5Dopen2(file_, name.c_str(), H5P_DEFAULT), space = H5Dget_space(set);
    std::vector<hsize_t> dims(static_cast<std::size_t>(H5Sget_simple_extent_ndims(space)));
    H5Sget_simple_extent_dims(space, dims.data(), nullptr);
    H5Sclose(space);
    H5Dclose(set);
    return dims;
  }

  bool has_attribute(const std::string& object, const std::string& name) const {
    return H5Aexists_by_name(file_, object.c_str(), name.c_str(), H5P_DEFAULT) > 0;
  }

  std::vector<double> numbers(const std::string& name) const { return read<double>(name, H5T_NATIVE_DOUBLE); }
  std::vector<long> whole_numbers(const std::string& name) const { return read<long>(name, H5T_NATIVE_LONG); }

  /// The first rows alone: what lies behind them need not be there.
  std::vector<double> first_rows(const std::string& name, hsize_t rows) const {
    std::vector<hsize_t> count = shape(name), first(count.size(), 0);
    count[0] = rows;
    std::size_t size = 1;
    for (const hsize_t n : count) size *= n;
    std::vector<double> values(size);
    const hid_t set = H5Dopen2(file_, name.c_str(), H5P_DEFAULT), space = H5Dget_space(set);
    const hid_t memory = H5Screate_simple(static_cast<int>(count.size()), count.data(), nullptr);
    H5Sselect_hyperslab(space, H5S_SELECT_SET, first.data(), nullptr, count.data(), nullptr);
    if (H5Dread(set, H5T_NATIVE_DOUBLE, memory, space, H5P_DEFAULT, values.data()) < 0) values.clear();
    H5Sclose(memory);
    H5Sclose(space);
    H5Dclose(set);
    return values;
  }

  std::size_t bytes_of_number(const std::string& name) const {
    const hid_t set = H5Dopen2(file_, name.c_str(), H5P_DEFAULT), type = H5Dget_type(set);
    const std::size_t bytes = H5Tget_size(type);
    H5Tclose(type);
    H5Dclose(set);
    return bytes;
  }

  std::vector<long> attribute(const std::string& group, const std::string& name) const {
    const hid_t id = H5Aopen_by_name(file_, group.c_str(), name.c_str(), H5P_DEFAULT, H5P_DEFAULT);
    const hid_t space = H5Aget_space(id);
    std::vector<long> values(static_cast<std::size_t>(H5Sget_simple_extent_npoints(space)));
    EXPECT_GE(H5Aread(id, H5T_NATIVE_LONG, values.data()), 0) << name;
    H5Sclose(space);
    H5Aclose(id);
    return values;
  }

  std::string text_attribute(const std::string& group, const std::string& name) const {
    const hid_t id = H5Aopen_by_name(file_, group.c_str(), name.c_str(), H5P_DEFAULT, H5P_DEFAULT);
    const hid_t type = H5Aget_type(id);
    std::string text(H5Tget_size(type), '\0');
    EXPECT_GE(H5Aread(id, type, text.data()), 0) << name;
    H5Tclose(type);
    H5Aclose(id);
    return text;
  }

 private:
  static hid_t open(const std::string& path, herr_t (*set_driver)(hid_t)) {
    const hid_t access = H5Pcreate(H5P_FILE_ACCESS);
    set_driver(access);
    H5Pset_file_locking(access, false, true);
    const hid_t file = H5Fopen(path.c_str(), H5F_ACC_RDONLY, access);
    H5Pclose(access);
    return file;
  }

  template <class T>
  std::vector<T> read(const std::string& name, hid_t type) const {
    const hid_t set = H5Dopen2(file_, name.c_str(), H5P_DEFAULT), space = H5Dget_space(set);
    std::vector<T> values(static_cast<std::size_t>(H5Sget_simple_extent_npoints(space)));
    EXPECT_GE(H5Dread(set, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()), 0) << name;
    H5Sclose(space);
    H5Dclose(set);
    return values;
  }

  std::string path_;
  hid_t file_;
};

}  // namespace percuss::sample
