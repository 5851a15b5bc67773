// Checkpoints: as they come, and with a seal that fits them, so that what stands behind the seal is tried too.

#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <iterator>

#include "src/error.hpp"
#include "src/hdf5/hdf5_handle.hpp"
#include "src/output/checkpoint/checkpoint_file.hpp"
#include "src/output/checkpoint/sealed_file.hpp"
#include "tests/fuzz/target.hpp"
#include "tests/src/output/sample_run.hpp"

namespace percuss::fuzz {
namespace {

const Communicator& alone() {
  static const Communicator ranks(MPI_COMM_SELF);
  return ranks;
}

const ChunkedMesh& scene() {
  static const ChunkedMesh mesh = sample::cut_layers(sample::make_mesh(2));
  return mesh;
}

/// Some of every kind of thing that a checkpoint holds.
void archive(CheckpointArchive& archive) {
  const ChunkRows nodes = find_owned_node_rows(scene());
  const ChunkRows elements = find_element_rows(scene());
  double time = 0.5;
  std::int64_t step = 7;
  ExactSum work;
  work.add(0.25);
  std::vector<double> x(3 * scene().mesh.nodes.size(), 1);
  std::vector<std::int64_t> faces(scene().mesh.elements.size(), 2);
  archive.number("time", time);
  archive.number("step", step);
  archive.sum("work", work);
  archive.rows("nodes/x", nodes, 3, std::span<double>(x));
  archive.rows("elements/faces", elements, 1, std::span<std::int64_t>(faces));
}

/// A file of this process, removed with what stands beside it.
class CheckpointPath {
 public:
  CheckpointPath() { std::filesystem::create_directories(folder_); }
  ~CheckpointPath() {
    std::error_code ignored;
    std::filesystem::remove_all(folder_, ignored);
  }
  std::string operator()() const { return (folder_ / "checkpoint.h5").string(); }

 private:
  std::filesystem::path folder_ =
      std::filesystem::temp_directory_path() / ("percuss_fuzz_checkpoint_" + std::to_string(getpid()));
};

const std::string& path() {
  static const CheckpointPath file;
  static const std::string text = file();
  return text;
}

void read() {
  try {
    CheckpointReader reader(path(), scene(), alone());
    archive(reader);
  } catch (const InputError&) {
  }
}

std::string take_bytes() {
  std::ifstream in(path(), std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

/// A checkpoint that HDF5 has changed behind its writer's back, without a seal.
template <class Change>
std::string change(const std::string& bytes, const Change& how) {
  std::ofstream(path(), std::ios::binary | std::ios::trunc) << bytes;
  const hdf5::Handle file(H5Fopen(path().c_str(), H5F_ACC_RDWR, H5P_DEFAULT), H5Fclose);
  how(file.get());
  H5Fflush(file.get(), H5F_SCOPE_LOCAL);
  return take_bytes();
}

/// The names of the numbers as a table instead of a list.
void make_table_of_names(hid_t file) {
  const char* const name = "percuss_checkpoint/number_names";
  const hdf5::Handle type(H5Tcopy(H5T_C_S1), H5Tclose);
  H5Tset_size(type.get(), 8);
  const hsize_t shape[2] = {2, 4};
  const hdf5::Handle space(H5Screate_simple(2, shape, nullptr), H5Sclose);
  H5Ldelete(file, name, H5P_DEFAULT);
  const hdf5::Handle set(H5Dcreate2(file, name, type.get(), space.get(), H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT),
                         H5Dclose);
  const std::string texts(64, 'n');
  H5Dwrite(set.get(), type.get(), H5S_ALL, H5S_ALL, H5P_DEFAULT, texts.data());
}

}  // namespace

void try_bytes(const std::string& bytes) {
  std::ofstream(path(), std::ios::binary | std::ios::trunc) << bytes;
  read();
  seal_file(alone(), path());
  read();
}

std::vector<std::string> make_seeds() {
  std::vector<std::string> seeds;
  for (const std::string title : {"", "A title", "Another one that is longer than the first"}) {
    CheckpointHeader header;
    header.warnings = "[]";
    header.version = "1.2.3";
    header.precision = "double";
    header.title = title;
    header.deck = "a = 1\nb = 2";
    header.mesh = "0123";
    CheckpointWriter writer(path(), header, scene(), alone());
    archive(writer);
    writer.finish();
    seeds.push_back(take_bytes());
  }
  const std::string whole = seeds.front();
  seeds.push_back(change(
      whole, [](hid_t file) { H5Lcreate_hard(file, "state", file, "state/nodes/again", H5P_DEFAULT, H5P_DEFAULT); }));
  seeds.push_back(change(whole, [](hid_t file) { H5Lcreate_soft("/", file, "state/soft", H5P_DEFAULT, H5P_DEFAULT); }));
  seeds.push_back(change(whole, make_table_of_names));
  return seeds;
}

std::vector<std::string> make_words() {
  return {"\x89HDF\r\n\x1a\n",
          "OHDR",
          "TREE",
          "SNOD",
          "HEAP",
          "GCOL",
          "FRHP",
          "BTHD",
          "percuss_checkpoint",
          "deck",
          "sums",
          "numbers",
          "sum_names",
          "state",
          "number_names",
          "number_counts",
          "time_bits",
          "format",
          "\xff\xff\xff\xff\xff\xff\xff\xff"};
}

}  // namespace percuss::fuzz
