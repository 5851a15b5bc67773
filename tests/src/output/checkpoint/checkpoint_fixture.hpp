#pragma once
// A checkpoint of a small mesh on all ranks, for the tests of checkpoints.

#include <gtest/gtest.h>
#include <hdf5.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "src/error.hpp"
#include "src/output/checkpoint/checkpoint_file.hpp"
#include "src/output/checkpoint/sealed_file.hpp"
#include "tests/src/output/sample_run.hpp"

namespace percuss {

inline const Communicator& world() {
  static const Communicator ranks = Communicator::world();
  return ranks;
}

/// One folder for all ranks, made and removed by rank 0.
class CheckpointFile : public testing::Test {
 protected:
  void SetUp() override {
    folder_ = (std::filesystem::temp_directory_path() / ("percuss_checkpoint_" + std::to_string(::getppid()))).string();
    if (world().rank() == 0) {
      std::filesystem::remove_all(folder_);
      std::filesystem::create_directories(folder_);
    }
    world().barrier();
  }
  void TearDown() override {
    world().barrier();
    if (world().rank() == 0) std::filesystem::remove_all(folder_);
  }

  std::string path() const { return folder_ + "/checkpoint.h5"; }

  /// Changes the bytes of the sealed file, on rank 0.
  void change(const std::function<void(std::string&)>& how) const {
    world().barrier();
    if (world().rank() == 0) {
      std::ifstream in(path(), std::ios::binary);
      std::string bytes((std::istreambuf_iterator<char>(in)), std::istreambuf_iterator<char>());
      how(bytes);
      std::ofstream(path(), std::ios::binary) << bytes;
    }
    world().barrier();
  }

  std::string folder_;
  Mesh mesh_ = sample::make_mesh(3);
  ChunkedMesh share_ = sample::take_share(sample::cut_layers(mesh_), world());
};

/// Values that follow from global numbers, so that every rank knows what it must get back.
struct Contents {
  explicit Contents(const ChunkedMesh& mesh)
      : nodes(find_owned_node_rows(mesh)), x("x", mesh.mesh.nodes.size()), v("v", mesh.mesh.nodes.size()) {
    for (std::size_t n = 0; n < mesh.mesh.nodes.size(); ++n) {
      for (std::size_t k = 0; k < 3; ++k)
        x(n, k) = 10.0 * static_cast<double>(mesh.mesh.node_numbers[n]) + static_cast<double>(k);
    }
    for (const Chunk& chunk : mesh.chunks) {  // chunk c has c + 1 rows of two
      some.counts.push_back(chunk.number % 3);
      for (int i = 0; i < 2 * (chunk.number % 3); ++i) numbers.push_back(1000 * chunk.number + i);
    }
  }

  void archive(CheckpointArchive& archive) {
    archive.number("time", time);
    archive.number("step", step);
    archive.each("list", list, [](Row& row, const auto& take) { take(row.length, row.count); });
    archive.sum("work", work);
    archive.rows("nodes/x", nodes, 3, x);
    archive.rows("nodes/deeper/v", nodes, 3, v);
    archive.rows("chunks/some", some, 2, numbers);
  }

  struct Row {
    double length = 0;
    std::int64_t count = 0;
    bool operator==(const Row&) const = default;
  };
  std::vector<Row> list{{0.5, 3}, {-1e300, -9}, {1e-300, INT64_MAX}};
  ChunkRows nodes, some;
  Rows3<double> x, v;
  std::vector<std::int64_t> numbers;
  double time = 0.1;
  std::int64_t step = -7;
  ExactSum work;
};

inline void write(const std::string& path, const ChunkedMesh& mesh, Contents contents, const std::string& title = "") {
  CheckpointHeader header;
  header.version = "1.2.3";
  header.precision = "double";
  header.title = title;
  header.deck = "a = 1\nb = 2";
  header.mesh = "0123";
  header.warnings = R"([{"rule": "a"}])";
  header.step = 42;
  header.time = 1.0 / 3;
  CheckpointWriter writer(path, header, mesh, world());
  contents.archive(writer);
  writer.finish();
}

inline std::string take_refusal(const std::string& path, const ChunkedMesh& mesh) {
  try {
    const CheckpointReader reader(path, mesh, world());
  } catch (const InputError& error) {
    return error.what();
  }
  return "no refusal";
}

}  // namespace percuss
