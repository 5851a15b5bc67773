// Claims of a damaged HDF5 file are not believed.

#include "src/output/hdf5/hdf5_reading.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/src/output/hdf5_sample.hpp"

namespace percuss::hdf5 {
namespace {

using testing::ElementsAre;

Handle make_text_type(std::size_t length) {
  Handle type(check(H5Tcopy(H5T_C_S1), "type"), H5Tclose);
  check(H5Tset_size(type.get(), length), "type");
  return type;
}

template <class Work>
std::string find_reason(const Work& work) {
  const QuietErrors quiet;
  try {
    work();
  } catch (const Error& error) {
    return error.reason;
  }
  return "";
}

TEST(ReadTexts, TakesAListOnly) {
  SampleFile file("texts.h5");
  const Handle type = make_text_type(4);
  file.write("list", type.get(), {2}, "abc\0de\0\0");
  file.write("table", type.get(), {1, 2}, "abc\0de\0\0");
  EXPECT_THAT(read_texts(file.id(), "list"), ElementsAre("abc", "de"));
  EXPECT_EQ(find_reason([&] { read_texts(file.id(), "table"); }), "its texts are not a list of one dimension");
}

TEST(ReadTexts, AsksForNoMoreMemoryThanTheFileHasBytes) {
  SampleFile file("many_texts.h5");
  const Handle type = make_text_type(60000);
  const Handle chunked(check(H5Pcreate(H5P_DATASET_CREATE), "properties"), H5Pclose);  // nothing is allocated
  const hsize_t chunk = 1;
  check(H5Pset_chunk(chunked.get(), 1, &chunk), "properties");
  file.write("list", type.get(), {60000}, nullptr, chunked.get());
  EXPECT_EQ(find_reason([&] { read_texts(file.id(), "list"); }), "the file is too short for so many texts");
}

TEST(ReadRows, AsksForNoMoreMemoryThanTheFileHasBytes) {
  SampleFile file("many_rows.h5");
  const Handle chunked(check(H5Pcreate(H5P_DATASET_CREATE), "properties"), H5Pclose);
  const hsize_t chunk = 1;
  check(H5Pset_chunk(chunked.get(), 1, &chunk), "properties");
  file.write("v", H5T_NATIVE_DOUBLE, {1000}, nullptr, chunked.get());
  EXPECT_NE(find_reason([&] { read_rows<double>(file.id(), "v", 0, 1000, 7999); }), "");
  EXPECT_EQ(read_rows<double>(file.id(), "v", 0, 1000, 8000).size(), 1000U);
}

}  // namespace
}  // namespace percuss::hdf5
