// Links of HDF5 files: loops are found, and what leads to other files.

#include "src/hdf5/hdf5_structure.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdio>
#include <fstream>

#include "src/error.hpp"
#include "tests/src/output/hdf5_sample.hpp"

namespace percuss::hdf5 {
namespace {

using testing::HasSubstr;

std::string find_fault(const std::string& path, ExternalFiles external) {
  try {
    check_structure(path, external);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

/// Closes the file and gives its fault with other files refused and allowed.
std::pair<std::string, std::string> find_faults(SampleFile& file) {
  file.close();
  return {find_fault(file.path(), ExternalFiles::refuse), find_fault(file.path(), ExternalFiles::allow)};
}

void expect_external(SampleFile& file, const std::string& says) {
  const auto [refused, allowed] = find_faults(file);
  EXPECT_THAT(refused, HasSubstr(says));
  EXPECT_THAT(refused, HasSubstr("--allow-external"));
  EXPECT_EQ(allowed, "");
}

Handle make_properties() { return {check(H5Pcreate(H5P_DATASET_CREATE), "properties"), H5Pclose}; }

TEST(Hdf5Structure, OfAnOrdinaryFileIsRight) {
  SampleFile file("ordinary.h5");
  check(H5Lcreate_hard(file.id(), "x", file.id(), "a/same", H5P_DEFAULT, H5P_DEFAULT), "link");
  check(H5Lcreate_soft("/x", file.id(), "soft", H5P_DEFAULT, H5P_DEFAULT), "link");
  check(H5Lcreate_soft("/nowhere", file.id(), "dangling", H5P_DEFAULT, H5P_DEFAULT), "link");
  check(H5Lcreate_soft("/itself", file.id(), "itself", H5P_DEFAULT, H5P_DEFAULT), "link");
  EXPECT_EQ(find_faults(file), std::pair(std::string(), std::string()));
}

TEST(Hdf5Structure, HasNoLoopOfHardLinks) {
  SampleFile file("hard.h5");
  check(H5Lcreate_hard(file.id(), "/", file.id(), "a/up", H5P_DEFAULT, H5P_DEFAULT), "link");
  const auto [refused, allowed] = find_faults(file);
  EXPECT_THAT(refused, HasSubstr("group '/a/up' can be reached in more than one way"));
  EXPECT_EQ(allowed, refused);
}

TEST(Hdf5Structure, HasNoLoopOfSoftLinks) {
  SampleFile file("soft.h5");
  check(H5Lcreate_soft("/", file.id(), "a/up", H5P_DEFAULT, H5P_DEFAULT), "link");
  EXPECT_THAT(find_faults(file).second, HasSubstr("group '/a/up' can be reached in more than one way"));
}

TEST(Hdf5Structure, HasNoGroupTwice) {  // 2^n ways through n such pairs
  SampleFile file("twice.h5");
  check(H5Lcreate_hard(file.id(), "a", file.id(), "b", H5P_DEFAULT, H5P_DEFAULT), "link");
  EXPECT_THAT(find_faults(file).second, HasSubstr("can be reached in more than one way"));
}

TEST(Hdf5Structure, IsNotNestedWithoutEnd) {
  SampleFile file("deep.h5");
  std::string path = "a";
  for (int i = 0; i < 150; ++i) file.make_group(path += "/g");
  EXPECT_THAT(find_faults(file).second, HasSubstr("nested more than 100 deep"));
}

TEST(Hdf5Structure, TellsOfLinksToOtherFiles) {
  SampleFile file("external.h5");
  check(H5Lcreate_external("other.h5", "/x", file.id(), "a/out", H5P_DEFAULT, H5P_DEFAULT), "link");
  check(H5Lcreate_soft("/a/out/deeper", file.id(), "a/soft", H5P_DEFAULT, H5P_DEFAULT), "link");
  expect_external(file, "link '/a/out' leads to another file");
}

TEST(Hdf5Structure, TellsOfValuesInOtherFiles) {
  SampleFile file("storage.h5");
  const Handle properties = make_properties();
  check(H5Pset_external(properties.get(), "/etc/passwd", 0, 8), "properties");
  file.write("y", H5T_NATIVE_DOUBLE, {1}, nullptr, properties.get());
  expect_external(file, "dataset '/y' has its values in another file, '/etc/passwd'");
}

TEST(Hdf5Structure, TellsOfVirtualDatasetsOfOtherFiles) {
  for (const bool is_own : {true, false}) {
    SampleFile file("virtual.h5");
    const Handle properties = make_properties();
    const hsize_t count = 2;
    const Handle space(check(H5Screate_simple(1, &count, nullptr), "space"), H5Sclose);
    check(H5Pset_virtual(properties.get(), space.get(), is_own ? "." : "other.h5", "/x", space.get()), "properties");
    file.write("y", H5T_NATIVE_INT, {2}, nullptr, properties.get());
    if (is_own)
      EXPECT_EQ(find_faults(file).first, "");
    else
      expect_external(file, "virtual dataset '/y' has its values in another file, 'other.h5'");
  }
}

TEST(Hdf5Structure, BehindAUserBlockIsOneToo) {
  const std::string path = "user_block.h5";
  for (const hsize_t bytes : {512, 1024, 4096}) {
    const Handle properties(check(H5Pcreate(H5P_FILE_CREATE), "properties"), H5Pclose);
    check(H5Pset_userblock(properties.get(), bytes), "properties");
    Handle file(check(H5Fcreate(path.c_str(), H5F_ACC_TRUNC, properties.get(), H5P_DEFAULT), "create"), H5Fclose);
    check(H5Lcreate_external("other.h5", "/x", file.get(), "out", H5P_DEFAULT, H5P_DEFAULT), "link");
    check(file.reset(), "close");
    EXPECT_TRUE(has_hdf5_signature(path)) << bytes;
    EXPECT_THAT(find_fault(path, ExternalFiles::refuse), HasSubstr("link '/out' leads to another file"));
  }
  std::remove(path.c_str());
}

TEST(Hdf5Structure, OfWhatIsNoHdf5FileIsRefused) {
  SampleFile file("none.h5");
  file.close();
  EXPECT_TRUE(has_hdf5_signature(file.path()));
  std::ofstream(file.path()) << "title: no HDF5";
  EXPECT_FALSE(has_hdf5_signature(file.path()));
  EXPECT_THAT(find_fault(file.path(), ExternalFiles::allow), HasSubstr("the file is damaged"));
}

}  // namespace
}  // namespace percuss::hdf5
