#pragma once
// An HDF5 file of a test, gone with this.

#include <gtest/gtest.h>
#include <unistd.h>

#include <array>
#include <cstdio>
#include <string>
#include <vector>

#include "src/hdf5/hdf5_handle.hpp"

namespace percuss::hdf5 {

/// A new file with a group "a" and a dataset "x" of two whole numbers; open until close().
class SampleFile {
 public:
  explicit SampleFile(const std::string& name)
      : path_(testing::TempDir() + "percuss_" + std::to_string(getpid()) + "_" + name),
        file_(check(H5Fcreate(path_.c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, H5P_DEFAULT), "create"), H5Fclose) {
    make_group("a");
    write("x", H5T_NATIVE_INT, {2}, std::array<int, 2>{1, 2}.data());
  }
  ~SampleFile() {
    file_.reset();
    std::remove(path_.c_str());
  }
  SampleFile(const SampleFile&) = delete;
  SampleFile& operator=(const SampleFile&) = delete;

  hid_t id() const { return file_.get(); }
  const std::string& path() const { return path_; }
  void close() { file_.reset(); }

  void make_group(const std::string& name) {
    const Handle group(check(H5Gcreate2(id(), name.c_str(), H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT), name), H5Gclose);
  }

  /// A dataset of that shape; without values they stay unwritten. properties: of its creation.
  void write(const std::string& name, hid_t type, std::vector<hsize_t> shape, const void* values,
             hid_t properties = H5P_DEFAULT) {
    const Handle space(check(H5Screate_simple(int(shape.size()), shape.data(), nullptr), name), H5Sclose);
    const Handle set(
        check(H5Dcreate2(id(), name.c_str(), type, space.get(), H5P_DEFAULT, properties, H5P_DEFAULT), name), H5Dclose);
    if (values != nullptr) check(H5Dwrite(set.get(), type, H5S_ALL, H5S_ALL, H5P_DEFAULT, values), name);
  }

 private:
  std::string path_;
  Handle file_;
};

}  // namespace percuss::hdf5
