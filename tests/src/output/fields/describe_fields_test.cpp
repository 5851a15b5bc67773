// `percuss info fields.vtkhdf`: what it tells, and that no file makes it fail in another way than by a message.

#include "src/output/vtkhdf/describe_fields.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cmath>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <random>

#include "src/error.hpp"
#include "tests/expect_error.hpp"
#include "tests/src/output/sample_run.hpp"

// A damaged file makes HDF5 request absurd amounts of memory, which it is refused everywhere; under the address
// sanitizer that must not end the test.
extern "C" const char* __asan_default_options() { return "allocator_may_return_null=1"; }

namespace percuss {
namespace {

using sample::TemporaryFolder;
using testing::HasSubstr;

std::string write_frames(const TemporaryFolder& folder, int frames) {
  const Mesh mesh = sample::make_mesh();
  FieldsFile file = sample::create_file(folder.path(), mesh, sample::options());
  for (int frame = 0; frame < frames; ++frame) sample::write_frame(file, mesh, frame);
  file.close();
  return folder.file("fields.vtkhdf");
}

std::string read_bytes(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

void write_bytes(const std::string& path, const std::string& bytes) {
  std::ofstream(path, std::ios::binary).write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
}

TEST(DescribeFields, TellsMeshFramesAndTheRangeOfEveryField) {
  const TemporaryFolder folder;
  const std::string text = describe_fields_file(write_frames(folder, 3));
  EXPECT_THAT(text, HasSubstr("title:   A sample & its <title>\n"));
  EXPECT_THAT(text, HasSubstr("units:   m, kg, s\n"));
  EXPECT_THAT(text, HasSubstr("mesh:    16 elements, 54 nodes, 2 parts (left, right <&\"> one)\n"));
  EXPECT_THAT(text, HasSubstr("frames:  3, time 0 to 0.2, step 0 to 20\n"));
  // stress of the last frame: 200 + element + 0.1 component
  EXPECT_THAT(text, HasSubstr("  stress                       element  6  200 to 215.5 [Pa]\n"));
  EXPECT_THAT(text, HasSubstr("walls:   1\n"));
  EXPECT_THAT(text, HasSubstr("  node_id                      node     1  947 to 1000\n"));
  EXPECT_THAT(text, HasSubstr("  velocity                     node     3  magnitude "));
}

TEST(DescribeFields, SaysWhenThereIsNoFrame) {
  const TemporaryFolder folder;
  EXPECT_THAT(describe_fields_file(write_frames(folder, 0)), HasSubstr("frames:  none\n"));
}

TEST(DescribeFields, CountsWhatIsNotFinite) {
  const TemporaryFolder folder;
  const Mesh mesh = sample::make_mesh();
  sample::Frame data(mesh, 0);
  data.von_mises = std::vector<double>(mesh.elements.size(), 4.0);
  data.von_mises[3] = NAN;
  FieldsFile file = sample::create_file(folder.path(), mesh);
  const auto fields = data.fields();
  file.write_frame(0, 0, data.positions, fields);
  file.close();
  EXPECT_THAT(describe_fields_file(folder.file("fields.vtkhdf")), HasSubstr("4 to 4, 1 not finite [Pa]\n"));
}

TEST(DescribeFields, RefusesOtherFilesAsWrongInput) {
  const TemporaryFolder folder;
  write_bytes(folder.file("text"), "not HDF5");
  write_bytes(folder.file("empty"), "");
  EXPECT_ERROR(describe_fields_file(folder.file("text")), InputError, "file signature not found");
  EXPECT_ERROR(describe_fields_file(folder.file("empty")), InputError, "file signature not found");
}

TEST(DescribeFields, TellsWhyAFileCannotBeRead) {
  const TemporaryFolder folder;
  EXPECT_ERROR(describe_fields_file(folder.file("missing")), SystemError, "No such file or directory");
  EXPECT_ERROR(describe_fields_file(folder.path()), SystemError, "Is a directory");
}

TEST(DescribeFields, RefusesAFileThatIsCutShortAnywhere) {
  const TemporaryFolder folder;
  const std::string bytes = read_bytes(write_frames(folder, 2));
  for (std::size_t size = 0; size < bytes.size(); size += 1 + bytes.size() / 97) {
    write_bytes(folder.file("cut"), bytes.substr(0, size));
    EXPECT_ERROR(describe_fields_file(folder.file("cut")), InputError, "not a fields file of percuss")
        << size << " of " << bytes.size() << " bytes";
  }
}

// In a process of its own, which a crash would end, and with it what HDF5 leaks of a damaged file. 0: a text, 2:
// refused as wrong input, 4: refused as unreadable, 1: anything else; -1: a signal.
int describe_in_child(const std::string& path) {
  const pid_t child = ::fork();
  if (child == 0) {
    try {
      std::_Exit(describe_fields_file(path).empty() ? 1 : 0);
    } catch (const InputError&) {
      std::_Exit(2);
    } catch (const SystemError&) {
      std::_Exit(4);
    } catch (...) {
      std::_Exit(1);
    }
  }
  int status = 0;
  ::waitpid(child, &status, 0);
  return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

TEST(DescribeFields, AnswersADamagedFileWithTextOrWithAnError) {
  const TemporaryFolder folder;
  const std::string bytes = read_bytes(write_frames(folder, 2));
  std::mt19937 random(7);
  int refused = 0;
  for (int trial = 0; trial < 200; ++trial) {
    std::string damaged = bytes;
    // Metadata come first in the file; damage there is the more dangerous one.
    const std::size_t reach = trial % 2 == 0 ? damaged.size() : 8192;
    for (int i = 0; i < 1 + trial; ++i) damaged[random() % reach] = static_cast<char>(random());
    write_bytes(folder.file("damaged"), damaged);
    const int answer = describe_in_child(folder.file("damaged"));
    EXPECT_TRUE(answer == 0 || answer == 2 || answer == 4) << "trial " << trial << " ended with " << answer;
    refused += answer == 2 ? 1 : 0;
  }
  EXPECT_GT(refused, 50);
}

}  // namespace
}  // namespace percuss
