// Regions of a mesh on several ranks: their files are those of one rank, number by number, and hold the rows of the
// whole mesh that they choose.

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <optional>
#include <utility>

#include "comm/agreement.hpp"
#include "comm/all_reduce.hpp"
#include "src/output/exodus/exodus_results.hpp"
#include "src/output/frame/field_region.hpp"
#include "src/output/vtkhdf/fields_file.hpp"
#include "tests/src/output/hdf5_file_view.hpp"
#include "tests/src/output/sample_run.hpp"

namespace percuss {
namespace {

using sample::Hdf5FileView;
using sample::TemporaryFolder;

constexpr int cells = 6;

/// Chooses cells of a share by what is the same on any number of ranks: the ids of its elements.
using Choose = std::function<std::vector<RegionCell>(const Mesh&)>;

std::vector<RegionCell> choose_by_ids(const Mesh& mesh, const std::function<bool(std::int64_t)>& is_chosen) {
  std::vector<char> marks;
  for (const std::int64_t id : mesh.element_ids) marks.push_back(is_chosen((id - 500) / 3) ? 1 : 0);
  return list_marked_cells(mesh, marks);
}

std::vector<RegionCell> choose_column(const Mesh& mesh) {
  return choose_by_ids(mesh, [](std::int64_t e) { return e < cells * cells * cells && e % (cells * cells) == 7; });
}
std::vector<RegionCell> choose_every_fifth(const Mesh& mesh) {
  return choose_by_ids(mesh, [](std::int64_t e) { return e % 5 == 0; });
}
/// An element of the upper cube whose lower nodes belong to the chunk below.
std::vector<RegionCell> choose_one(const Mesh& mesh) {
  return choose_by_ids(mesh, [](std::int64_t e) { return e == cells * cells * cells + cells * cells + 3; });
}
std::vector<RegionCell> choose_floor(const Mesh& mesh) {
  return list_face_cells(mesh, mesh.side_sets.at("left/floor"));
}

struct Shown {
  FieldRegion region;
  ChunkedMesh share;
};

Shown show(const Choose& choose, const Communicator& ranks) {
  ChunkedMesh share = sample::take_share(sample::cut_layers(sample::make_mesh(cells)), ranks);
  return {std::move(*make_field_region(share, choose(share.mesh), ranks)), std::move(share)};
}

std::vector<double> pick(const std::vector<double>& values, const std::vector<int>& items) {
  std::vector<double> picked;
  for (const int item : items) picked.push_back(values[static_cast<std::size_t>(item)]);
  return picked;
}

template <class File>
void write_frames(const std::string& folder, const Shown& shown, const Communicator& ranks) {
  FieldsOptions options = sample::options();
  options.name = "some";
  options.are_faces = shown.region.are_faces;
  File file(folder, shown.region.chunked, options, ranks);
  for (int frame = 0; frame < 2; ++frame) {
    const sample::Frame whole(shown.share.mesh, frame);
    std::vector<double> positions;
    for (const int node : shown.region.nodes)
      positions.insert(positions.end(), whole.positions.begin() + 3 * node, whole.positions.begin() + 3 * node + 3);
    const std::vector<double> mises = pick(whole.von_mises, shown.region.elements);
    const std::vector<FieldData> fields{{"von_mises", FieldPlace::element, 1, mises}};
    file.write_frame(sample::time_of(frame), sample::step_of(frame), positions, fields);
  }
  file.close();
}

void write_both(const std::string& folder, const Choose& choose, const Communicator& ranks) {
  const Shown shown = show(choose, ranks);
  write_frames<FieldsFile>(folder, shown, ranks);
  write_frames<ExodusResults>(folder, shown, ranks);
}

void expect_equal(const std::string& path, const std::string& reference) {
  const Hdf5FileView file(path), expected(reference);
  ASSERT_TRUE(file.is_open() && expected.is_open());
  ASSERT_EQ(file.datasets(), expected.datasets());
  for (const std::string& name : expected.datasets()) {
    EXPECT_EQ(file.shape(name), expected.shape(name)) << name;
    EXPECT_EQ(file.bytes(name), expected.bytes(name)) << name;
  }
}

class FieldRegions : public testing::TestWithParam<const char*> {
 protected:
  static Choose find_choice(const std::string& name) {
    if (name == "column") return choose_column;
    if (name == "every_fifth") return choose_every_fifth;
    return name == "one" ? choose_one : choose_floor;
  }
};

TEST_P(FieldRegions, HaveTheFilesOfOneRankOnAnyNumber) {
  const Communicator ranks = Communicator::world();
  std::optional<TemporaryFolder> own;
  if (ranks.rank() == 0) own.emplace();
  const std::string together = broadcast_text(ranks, own ? own->path() : "", 0);
  write_both(together, find_choice(GetParam()), ranks);
  if (ranks.rank() == 0) {
    const TemporaryFolder alone;
    write_both(alone.path(), find_choice(GetParam()), Communicator(MPI_COMM_SELF));
    for (const char* file : {"/fields_some.vtkhdf", "/fields_some.exo"})
      expect_equal(together + file, alone.path() + file);
  }
  ranks.barrier();
}

TEST_P(FieldRegions, HoldEachNodeOnceWithTheRankThatOwnsIt) {
  const Communicator ranks = Communicator::world();
  const Shown shown = show(find_choice(GetParam()), ranks);
  const ChunkedMesh& of = shown.region.chunked;
  std::vector<std::int64_t> ids(static_cast<std::size_t>(of.numbering.node_count()), 0), counts(ids);
  for (std::size_t n = 0; n < of.mesh.nodes.size(); ++n) {
    const auto whole = static_cast<std::size_t>(shown.region.nodes[n]);
    EXPECT_EQ(of.mesh.node_ids[n], shown.share.mesh.node_ids[whole]);
    const std::int64_t number = of.mesh.node_numbers[n];
    const int owner = of.numbering.find_node_owner(number);
    EXPECT_EQ(owner, shown.share.numbering.find_node_owner(shown.share.mesh.node_numbers[whole]));
    if (owner != ranks.rank()) continue;
    ++counts[static_cast<std::size_t>(number)];
    ids[static_cast<std::size_t>(number)] = of.mesh.node_ids[n];
  }
  all_reduce(ranks, Reduce::sum, counts);
  all_reduce(ranks, Reduce::sum, ids);
  EXPECT_TRUE(std::all_of(counts.begin(), counts.end(), [](std::int64_t count) { return count == 1; }));
  EXPECT_TRUE(std::is_sorted(ids.rbegin(), ids.rend()));  // ids of the sample fall
}

TEST(FieldRegion, HasTheNodesOfItsElementsAndTheirParts) {
  const Communicator ranks = Communicator::world();
  const auto count = [&](const Choose& choose) {
    const Numbering numbering = show(choose, ranks).region.chunked.numbering;
    return std::pair(numbering.element_count(), numbering.node_count());
  };
  EXPECT_EQ(count(choose_column), std::pair(std::int64_t{cells}, std::int64_t{4 * (cells + 1)}));
  EXPECT_EQ(count(choose_one), std::pair(std::int64_t{1}, std::int64_t{8}));
  EXPECT_EQ(count(choose_floor), std::pair(std::int64_t{cells * cells}, std::int64_t{(cells + 1) * (cells + 1)}));
  EXPECT_EQ(show(choose_one, ranks).region.chunked.mesh.parts.size(), 1u);
  EXPECT_EQ(show(choose_every_fifth, ranks).region.chunked.mesh.parts.size(), 2u);
}

INSTANTIATE_TEST_SUITE_P(Of, FieldRegions, testing::Values("column", "every_fifth", "one", "floor"));

}  // namespace
}  // namespace percuss
