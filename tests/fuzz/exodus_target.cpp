// Exodus II files: from bytes to the chunks of a mesh that can be run.

#include <exodusII.h>
#include <hdf5.h>
#include <unistd.h>

#include <cstdio>
#include <filesystem>
#include <fstream>

#include "src/error.hpp"
#include "src/mesh/reading/results_reader.hpp"
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

/// Adds a time step with a variable of elements and one of nodes.
std::string add_results(const std::string& path) {
  int word = sizeof(double), in_file = 0;
  float version = 0;
  const int file = ex_open(path.c_str(), EX_WRITE | EX_ALL_INT64_API, &word, &in_file, &version);
  std::string element = "stress_xx", node = "velocity_x";
  char *of_elements[] = {element.data()}, *of_nodes[] = {node.data()};
  const double time = 1, values[12] = {1, 2, 3};
  ex_put_variable_param(file, EX_ELEM_BLOCK, 1);
  ex_put_variable_names(file, EX_ELEM_BLOCK, 1, of_elements);
  ex_put_variable_param(file, EX_NODAL, 1);
  ex_put_variable_names(file, EX_NODAL, 1, of_nodes);
  ex_put_time(file, 1, &time);
  ex_put_var(file, 1, EX_NODAL, 1, 1, 12, values);
  for (const int block : {10, 20}) ex_put_var(file, 1, EX_ELEM_BLOCK, 1, block, 1, values);
  ex_close(file);
  return path;
}

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
  try {
    read_file_results(source.file, {{"stress_xx", "lacking"}, {"velocity_x"}, {}});
  } catch (const InputError&) {
  }
}

std::vector<std::string> make_seeds() {
  std::vector<std::string> seeds;
  for (const Container container :
       {Container::classic, Container::offset64, Container::netcdf4, Container::netcdf4_int64}) {
    seeds.push_back(take_bytes(write_exodus(make_two_cubes(), "seed.exo", container)));
    seeds.push_back(take_bytes(add_results(write_exodus(make_two_cubes(), "results.exo", container))));
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
