// Exodus II files: from bytes to the chunks of a mesh that can be run.

#include <hdf5.h>
#include <unistd.h>

#include <cstdio>
#include <filesystem>
#include <fstream>

#include "src/error.hpp"
#include "tests/fuzz/target.hpp"
#include "tests/src/mesh/exodus_writer.hpp"
#include "tests/src/mesh/mesh_measures.hpp"
#include "tests/src/mesh/variable_order.hpp"

namespace percuss::fuzz {
namespace {

using namespace testing_mesh;

/// One file for all inputs of a process; gone at its end.
class InputFile {
 public:
  const std::string& write(const std::string& bytes) {
    std::ofstream(path_, std::ios::binary | std::ios::trunc) << bytes;
    return path_;
  }
  ~InputFile() { std::remove(path_.c_str()); }

 private:
  std::string path_ =
      (std::filesystem::temp_directory_path() / ("percuss_fuzz_" + std::to_string(getpid()) + ".exo")).string();
};

std::string take_bytes(const std::string& path) {
  std::string bytes = read_bytes(path);
  std::remove(path.c_str());
  return bytes;
}

}  // namespace

void try_bytes(const std::string& bytes) {
  static InputFile file;
  FileMesh source;
  source.file = file.write(bytes);
  try {
    build_mesh(make_deck({make_part_deck("p", source)}));
  } catch (const InputError&) {
  }
}

std::vector<std::string> make_seeds() {
  std::vector<std::string> seeds;
  for (const Container container :
       {Container::classic, Container::offset64, Container::netcdf4, Container::netcdf4_int64}) {
    seeds.push_back(take_bytes(write_exodus(make_two_cubes(), "seed.exo", container)));
  }
  const std::string looped = write_exodus(make_two_cubes(), "loop.exo", Container::netcdf4);
  const hid_t file = H5Fopen(looped.c_str(), H5F_ACC_RDWR, H5P_DEFAULT);
  H5Gclose(H5Gcreate2(file, "group", H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT));
  H5Lcreate_hard(file, "/", file, "group/up", H5P_DEFAULT, H5P_DEFAULT);
  H5Lcreate_soft("/group", file, "soft", H5P_DEFAULT, H5P_DEFAULT);
  H5Fclose(file);
  seeds.push_back(take_bytes(looped));
  const std::string ordered = write_exodus(make_two_cubes(), "ordered.exo", Container::offset64);
  seeds.push_back(take_bytes(copy_with_first(ordered, "coordx", ordered + ".first")));
  std::remove(ordered.c_str());
  WrittenMesh plain = make_two_cubes();
  plain.node_ids.clear();
  plain.element_ids.clear();
  plain.single_precision = true;
  seeds.push_back(take_bytes(write_exodus(plain, "plain.exo")));
  seeds.push_back(lengthen_status(take_bytes(write_exodus(make_two_cubes(), "status.exo"))));
  return seeds;
}

std::vector<std::string> make_words() {
  return {"CDF\x01",
          "CDF\x02",
          "CDF\x05",
          "\x89HDF\r\n\x1a\n",
          "num_nodes",
          "num_elem",
          "num_el_blk",
          "connect1",
          "elem_type",
          "node_ns1",
          "elem_ss1",
          "side_ss1",
          "eb_prop1",
          "ns_prop1",
          "num_dim",
          "coordx",
          "HEX8",
          "time_whole",
          "len_string",
          "four",
          "eb_status",
          "HEX20",
          "SHELL4",
          "OHDR",
          "TREE",
          "SNOD",
          "HEAP",
          "FRHP",
          "\xff\xff\xff\xff"};
}

}  // namespace percuss::fuzz
