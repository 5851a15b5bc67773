// Checkpoints: what is put in comes out on any ranks, and what is not whole is refused.

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <hdf5.h>
#include <sys/stat.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <functional>

#include "src/error.hpp"
#include "src/output/checkpoint/checkpoint_file.hpp"
#include "src/output/checkpoint/sealed_file.hpp"
#include "tests/src/output/sample_run.hpp"

namespace percuss {
namespace {

using testing::HasSubstr;

const Communicator& world() {
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

  /// The same for the sealed file, changed by rank 0.
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
    archive.sum("work", work);
    archive.rows("nodes/x", nodes, 3, x);
    archive.rows("nodes/deeper/v", nodes, 3, v);
    archive.rows("chunks/some", some, 2, numbers);
  }

  ChunkRows nodes, some;
  Rows3<double> x, v;
  std::vector<std::int64_t> numbers;
  double time = 0.1;
  std::int64_t step = -7;
  ExactSum work;
};

void write(const std::string& path, const ChunkedMesh& mesh, Contents contents, const std::string& title = "") {
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

std::string take_refusal(const std::string& path, const ChunkedMesh& mesh) {
  try {
    const CheckpointReader reader(path, mesh, world());
  } catch (const InputError& error) {
    return error.what();
  }
  return "no refusal";
}

}  // namespace

TEST_F(CheckpointFile, GivesBackWhatWasPutIn) {
  Contents given(share_);
  given.work.add(0.25 * (world().rank() + 1));
  write(path(), share_, given, "A title");

  Contents taken(share_);
  Kokkos::deep_copy(taken.x, -1);
  std::fill(taken.numbers.begin(), taken.numbers.end(), -1);
  taken.time = 0;
  taken.step = 0;
  CheckpointReader reader(path(), share_, world());
  taken.archive(reader);
  EXPECT_EQ(taken.time, 0.1);
  EXPECT_EQ(taken.step, -7);
  EXPECT_EQ(taken.numbers, given.numbers);
  for (const int n : given.nodes.places)
    EXPECT_EQ(taken.x(static_cast<std::size_t>(n), 2), given.x(static_cast<std::size_t>(n), 2));
  const int ranks = world().size();
  EXPECT_EQ(taken.work.round(), world().rank() == 0 ? 0.125 * ranks * (ranks + 1) : 0);
  EXPECT_EQ(reader.header().title, "A title");
  EXPECT_EQ(reader.header().deck, "a = 1\nb = 2");
  EXPECT_EQ(reader.header().time, 1.0 / 3);
  EXPECT_EQ(reader.header().step, 42);
  EXPECT_FALSE(std::filesystem::exists(path() + ".tmp"));
}

TEST_F(CheckpointFile, IsTheSameOnAnyRanks) {
  write(path(), share_, Contents(share_));
  const ChunkedMesh whole = sample::cut_layers(mesh_);
  if (world().rank() == 0) {
    Contents expected(whole), taken(whole);
    Kokkos::deep_copy(taken.x, -1);
    CheckpointReader reader(path(), whole, Communicator(MPI_COMM_SELF));
    taken.archive(reader);
    for (std::size_t n = 0; n < expected.x.extent(0); ++n) EXPECT_EQ(taken.x(n, 1), expected.x(n, 1));
    EXPECT_EQ(taken.numbers, expected.numbers);
  }
}

TEST_F(CheckpointFile, KeepsTheOneBefore) {
  write(path(), share_, Contents(share_), "first");
  write(path(), share_, Contents(share_), "second");
  EXPECT_EQ(read_checkpoint_header(path()).title, "second");
  EXPECT_EQ(read_checkpoint_header(find_previous_checkpoint(path())).title, "first");
  EXPECT_THAT(describe_checkpoint(path()), HasSubstr("t = 0.333333, step 42"));
}

// As where a run goes on from the one before, since the newest is damaged, or from one with another name.
TEST_F(CheckpointFile, ThatIsDamagedDoesNotTakeThePlaceOfAWholeOne) {
  const auto write_next = [&](const std::string& known_whole) {
    CheckpointWriter writer(path(), {}, share_, world());
    Contents(share_).archive(writer);
    writer.finish(known_whole);
  };
  const std::string previous = find_previous_checkpoint(path());
  for (const std::string& known_whole : {previous, folder_ + "/another.h5"}) {
    write(path(), share_, Contents(share_), "first");
    write(path(), share_, Contents(share_), "second");
    change([](std::string& bytes) { bytes[bytes.size() / 2] ^= 1; });
    write_next(known_whole);
    EXPECT_EQ(read_checkpoint_header(previous).title, "first");
  }
  write(path(), share_, Contents(share_), "third");
  write_next(folder_ + "/another.h5");
  EXPECT_EQ(read_checkpoint_header(previous).title, "third");
}

TEST_F(CheckpointFile, WithoutFinishLeavesTheOneBefore) {
  write(path(), share_, Contents(share_), "first");
  {
    CheckpointWriter writer(path(), {}, share_, world());
    Contents(share_).archive(writer);
  }
  world().barrier();
  EXPECT_EQ(read_checkpoint_header(path()).title, "first");
  EXPECT_FALSE(std::filesystem::exists(path() + ".tmp"));
}

// As where ranks on several machines have folders of the same name.
TEST_F(CheckpointFile, InAFolderThatOneRankLacksFailsOnAll) {
  const int last = world().size() - 1;
  std::string message;
  try {
    CheckpointWriter(world().rank() == last ? folder_ + "/none/checkpoint.h5" : path(), {}, share_, world());
  } catch (const SystemError& error) {
    message = error.what();
  }
  EXPECT_THAT(message, HasSubstr("/none/checkpoint.h5"));
  EXPECT_THAT(message, HasSubstr("No such file or directory"));
  if (last > 0) {
    EXPECT_THAT(message,
                HasSubstr("rank " + std::to_string(last) + " of " + std::to_string(last + 1) + " cannot open"));
  }
  world().barrier();
  EXPECT_FALSE(std::filesystem::exists(path() + ".tmp"));
}

// A seal is no proof: it is found from the file, and fits one that holds another state, too.
TEST_F(CheckpointFile, WithOtherNumbersThanThoseOfTheStateIsRefusedThoughItsSealFits) {
  write(path(), share_, Contents(share_));
  world().barrier();
  if (world().rank() == 0) {
    const hid_t file = H5Fopen(path().c_str(), H5F_ACC_RDWR, H5P_DEFAULT);
    const hid_t dataset = H5Dopen2(file, "state/nodes/x", H5P_DEFAULT);
    std::vector<double> x(3 * mesh_.nodes.size());
    H5Dread(dataset, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, x.data());
    std::swap(x[4], x[7]);  // a sum alone would not see it
    EXPECT_GE(H5Dwrite(dataset, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, x.data()), 0);
    H5Dclose(dataset);
    EXPECT_GE(H5Fclose(file), 0);
  }
  world().barrier();
  seal_file(world(), path());
  EXPECT_THAT(take_refusal(path(), share_), HasSubstr("its content is not the state that was saved"));
  EXPECT_THROW(describe_checkpoint(path()), InputError);
}

// Whoever follows its groups would go round until the stack is full.
TEST_F(CheckpointFile, WithALoopOfGroupsIsRefusedThoughItsSealFits) {
  write(path(), share_, Contents(share_));
  world().barrier();
  if (world().rank() == 0) {
    const hid_t file = H5Fopen(path().c_str(), H5F_ACC_RDWR, H5P_DEFAULT);
    EXPECT_GE(H5Lcreate_hard(file, "/", file, "state/up", H5P_DEFAULT, H5P_DEFAULT), 0);
    EXPECT_GE(H5Fclose(file), 0);
  }
  world().barrier();
  seal_file(world(), path());
  EXPECT_THAT(take_refusal(path(), share_), HasSubstr("can be reached in more than one way"));
  EXPECT_THROW(read_checkpoint_header(path()), InputError);
}

TEST_F(CheckpointFile, HasAHashOfItsContentThatDoesNotDependOnRanks) {
  write(path(), share_, Contents(share_));
  const std::string content = read_checkpoint_header(path()).content;
  EXPECT_EQ(content.size(), 16);
  if (world().rank() != 0) return;
  const ChunkedMesh whole = sample::cut_layers(mesh_);
  CheckpointHeader header = read_checkpoint_header(path());
  CheckpointWriter alone(folder_ + "/alone.h5", header, whole, Communicator(MPI_COMM_SELF));
  Contents(whole).archive(alone);
  alone.finish();
  EXPECT_EQ(read_checkpoint_header(folder_ + "/alone.h5").content, content);
}

TEST_F(CheckpointFile, CutOffAnywhereIsRefused) {
  write(path(), share_, Contents(share_));
  const auto size = std::filesystem::file_size(path());
  for (const double share : {0.0, 0.01, 0.5, 0.99}) {
    change([&](std::string& bytes) { bytes.resize(static_cast<std::size_t>(share * static_cast<double>(size))); });
    EXPECT_THAT(take_refusal(path(), share_), HasSubstr("not a whole one"));
    world().barrier();
    write(path(), share_, Contents(share_));
  }
  change([&](std::string& bytes) { bytes.pop_back(); });
  EXPECT_THAT(take_refusal(path(), share_), HasSubstr("not a whole one"));
  change([&](std::string& bytes) { bytes += "more"; });
  EXPECT_THAT(take_refusal(path(), share_), HasSubstr("not a whole one"));
}

TEST_F(CheckpointFile, DamagedNamesAnOlderOneOnlyIfThereIsOne) {
  const std::string older = find_previous_checkpoint(path());
  const auto cut = [](std::string& bytes) { bytes.pop_back(); };
  const auto flip = [](std::string& bytes) {
    bytes[bytes.size() / 2] = static_cast<char>(bytes[bytes.size() / 2] ^ 1);
  };
  for (const std::function<void(std::string&)>& damage : {std::function<void(std::string&)>(cut), {flip}}) {
    write(path(), share_, Contents(share_));
    change(damage);
    EXPECT_THAT(take_refusal(path(), share_), HasSubstr(") there is no older one beside it: begin the run again"));
    world().barrier();
    write(path(), share_, Contents(share_));
    write(path(), share_, Contents(share_));
    change(damage);
    EXPECT_THAT(take_refusal(path(), share_), HasSubstr(") use the older one: " + older));
    world().barrier();
    if (world().rank() == 0) std::filesystem::remove(older);
    world().barrier();
    if (world().rank() == 0) std::filesystem::remove(path());
    world().barrier();
  }
}

TEST_F(CheckpointFile, AnyChangedBitIsRefused) {
  write(path(), share_, Contents(share_));
  const auto size = std::filesystem::file_size(path());
  for (std::size_t i = 0; i < 64; ++i) {
    const std::size_t byte = (i * 2654435761U) % size;
    const auto flip = [&](std::string& bytes) { bytes[byte] = static_cast<char>(bytes[byte] ^ (1 << i % 8)); };
    change(flip);
    EXPECT_THAT(take_refusal(path(), share_), HasSubstr("checkpoint")) << byte;
    change(flip);
  }
  EXPECT_EQ(take_refusal(path(), share_), "no refusal");
}

TEST_F(CheckpointFile, OfAnotherSceneIsRefused) {
  write(path(), share_, Contents(share_));
  CheckpointReader reader(path(), share_, world());
  double value = 0;
  EXPECT_THROW(reader.number("pressure", value), InputError);
  Contents other(share_);
  for (std::int64_t& count : other.some.counts) count += 1;
  other.numbers.resize(other.numbers.size() + 2 * other.some.counts.size());
  EXPECT_THROW(reader.rows("chunks/some", other.some, 2, other.numbers), InputError);
  EXPECT_THROW(reader.rows("chunks/none", other.some, 2, other.numbers), InputError);
}

/// What loading says of contents that were changed before they were saved.
template <class Spoil>
std::string take_refusal_of(const std::string& path, const ChunkedMesh& mesh, const Spoil& spoil) {
  Contents contents(mesh);
  spoil(contents);
  write(path, mesh, contents);
  try {
    CheckpointReader reader(path, mesh, world());
    Contents(mesh).archive(reader);
  } catch (const InputError& error) {
    return error.what();
  }
  return "no refusal";
}

TEST_F(CheckpointFile, WithAValueThatIsNotFiniteIsRefused) {
  const double nan = std::nan(""), infinity = INFINITY;
  EXPECT_EQ(take_refusal_of(path(), share_, [](Contents&) {}), "no refusal");
  for (const double value : {nan, infinity, -infinity}) {
    EXPECT_THAT(take_refusal_of(path(), share_, [&](Contents& c) { c.time = value; }), HasSubstr("a value of time"));
    EXPECT_THAT(take_refusal_of(path(), share_, [&](Contents& c) { c.work.add(value); }), HasSubstr("a value of work"));
    EXPECT_THAT(take_refusal_of(path(), share_,
                                [&](Contents& c) {
                                  if (!c.nodes.places.empty())
                                    c.v(static_cast<std::size_t>(c.nodes.places.back()), 2) = value;
                                }),
                HasSubstr("a value of nodes/deeper/v"));
  }
  const auto overflow = [](Contents& c) { c.work.limb[ExactSum::limb_count - 1] = std::int64_t{1} << 40; };
  EXPECT_THAT(take_refusal_of(path(), share_, overflow), HasSubstr("a value of work"));
}

/// Numbers of which not every value can be.
struct Limited {
  double bound = INFINITY;
  bool flag = true;
  std::int64_t raw = 1;

  void archive(CheckpointArchive& archive) {
    archive.number_or_infinity("bound", bound);
    if (archive.is_loading())
      archive.integer("flag", flag);
    else
      archive.number("flag", raw);
  }
};

TEST_F(CheckpointFile, WithANumberThatCannotBeIsRefused) {
  const auto take = [&](Limited given) {
    CheckpointWriter writer(path(), {}, share_, world());
    given.archive(writer);
    writer.finish();
    CheckpointReader reader(path(), share_, world());
    Limited taken;
    taken.bound = 0;
    taken.archive(reader);
    return taken;
  };
  EXPECT_EQ(take({}).bound, INFINITY);
  EXPECT_THROW(take({std::nan("")}), InputError);
  EXPECT_FALSE(take({1, true, 0}).flag);
  EXPECT_THROW(take({1, true, 2}), InputError);
}

TEST_F(CheckpointFile, CountsAreHeldAgainstTheFileBeforeMemoryIsTaken) {
  write(path(), share_, Contents(share_));
  CheckpointReader reader(path(), share_, world());
  std::vector<std::int64_t> counts = Contents(share_).some.counts;
  reader.expect_rows("chunks/some", counts, 2);
  for (const std::int64_t wrong :
       {std::int64_t{1}, std::int64_t{-5}, std::int64_t{300'000'000}, std::int64_t{1} << 62}) {
    std::vector<std::int64_t> changed = counts;
    if (world().rank() == 0) changed[0] += wrong;
    EXPECT_THROW(reader.expect_rows("chunks/some", changed, 2), InputError) << wrong;
  }
}

TEST_F(CheckpointFile, WhoseGroupsLoopIsRefused) {
  write(path(), share_, Contents(share_));
  if (world().rank() == 0) {
    const hid_t file = H5Fopen(path().c_str(), H5F_ACC_RDWR, H5P_DEFAULT);
    H5Lcreate_hard(file, "state", file, "state/nodes/again", H5P_DEFAULT, H5P_DEFAULT);
    H5Fclose(file);
  }
  world().barrier();
  seal_file(world(), path());
  EXPECT_THAT(take_refusal(path(), share_), HasSubstr("can be reached in more than one way"));
}

TEST_F(CheckpointFile, ThatIsNoFileIsRefusedAtOnce) {
  if (world().rank() == 0) {
    ASSERT_EQ(::mkfifo(path().c_str(), 0600), 0);
  }
  world().barrier();
  EXPECT_THAT(take_refusal(path(), share_), HasSubstr("the checkpoint is a pipe (a regular file is needed)"));
  EXPECT_THAT(take_refusal("/dev/zero", share_), HasSubstr("a device"));
  EXPECT_THAT(take_refusal(folder_, share_), HasSubstr("a folder"));
}

TEST_F(CheckpointFile, InAFolderThatIsNotThereIsAnErrorOfTheSystem) {
  EXPECT_THROW(write(folder_ + "/none/checkpoint.h5", share_, Contents(share_)), SystemError);
}

}  // namespace percuss
