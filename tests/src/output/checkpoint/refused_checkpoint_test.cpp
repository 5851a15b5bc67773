// Checkpoints that are not whole, or not of the scene, are refused.

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <hdf5.h>
#include <sys/stat.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <functional>

#include "tests/expect_error.hpp"
#include "tests/src/output/checkpoint/checkpoint_fixture.hpp"

namespace percuss {

using testing::HasSubstr;

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
    EXPECT_THAT(take_refusal(path(), share_), HasSubstr("): there is no older one in its folder; start the run again"));
    world().barrier();
    write(path(), share_, Contents(share_));
    write(path(), share_, Contents(share_));
    change(damage);
    EXPECT_THAT(take_refusal(path(), share_), HasSubstr("): use the older one: " + older));
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
  EXPECT_ERROR(reader.number("pressure", value), InputError, "has no pressure");
  Contents other(share_);
  const auto read_list = [&] {
    reader.each("list", other.list, [](Contents::Row& row, const auto& take) { take(row.length, row.count); });
  };
  other.list.pop_back();
  EXPECT_THAT(read_list,
              testing::ThrowsMessage<InputError>(HasSubstr("list has 6 values in the checkpoint (this scene has 4): "
                                                           "continue with the deck that wrote it")));
  for (std::int64_t& count : other.some.counts) count += 1;
  other.numbers.resize(other.numbers.size() + 2 * other.some.counts.size());
  EXPECT_ERROR(reader.rows("chunks/some", other.some, 2, other.numbers), InputError,
               "has 12 values in the checkpoint (this scene has 24)");
  EXPECT_ERROR(reader.rows("chunks/none", other.some, 2, other.numbers), InputError, "cannot open dataset chunks/none");
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
    EXPECT_THAT(take_refusal_of(path(), share_, [&](Contents& c) { c.list[1].length = value; }),
                HasSubstr("a value of list"));
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
  EXPECT_ERROR(take({std::nan("")}), InputError, "a value of bound");
  EXPECT_FALSE(take({1, true, 0}).flag);
  EXPECT_ERROR(take({1, true, 2}), InputError, "a value of flag");
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
    EXPECT_ERROR(reader.expect_rows("chunks/some", changed, 2), InputError, "chunks/some") << wrong;
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
  EXPECT_ERROR(write(folder_ + "/none/checkpoint.h5", share_, Contents(share_)), SystemError, "cannot create");
}

}  // namespace percuss
