// The lock of a folder of results: who gets it, who is told what, and what becomes of one that was left.

#include "src/app/folder/folder_lock.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <optional>
#include <vector>

#include "src/app/folder/lock_holder.hpp"
#include "src/error.hpp"
#include "tests/src/app/percuss_process.hpp"

namespace percuss {
namespace {

namespace fs = std::filesystem;
using testing::AllOf;
using testing::HasSubstr;

class FolderLockTest : public testing::Test {
 protected:
  std::string lock_path() const { return folder_.path() + "/run.lock"; }
  std::string read_lock() const {
    std::ifstream file(lock_path());
    return {std::istreambuf_iterator<char>(file), {}};
  }
  std::string refuse() const {
    try {
      const FolderLock lock(folder_.path());
    } catch (const InputError& error) {
      return error.what();
    }
    return "no refusal";
  }
  void leave_lock_of(const LockHolder& holder) const { folder_.write("run.lock", format_holder(holder)); }

  TemporaryFolder folder_;
};

/// A process that has ended.
LockHolder describe_ended_process() {
  LockHolder holder = describe_this_process();
  const pid_t child = fork();
  if (child == 0) _exit(0);
  waitpid(child, nullptr, 0);
  holder.process = child;
  return holder;
}

/// Until the last writer of a pipe has closed it.
void wait_for_end_of(int pipe) {
  char byte = 0;
  while (read(pipe, &byte, 1) > 0) {
  }
}

TEST_F(FolderLockTest, NamesItsHolderAndGoesWithIt) {
  {
    const FolderLock lock(folder_.path());
    EXPECT_EQ(lock.note(), "");
    const LockHolder holder = parse_holder(read_lock());
    EXPECT_EQ(holder.process, getpid());
    EXPECT_EQ(holder.host, describe_this_process().host);
    EXPECT_THAT(holder.command, HasSubstr("app_test"));
    EXPECT_EQ(format_holder(holder), lock.text());
    EXPECT_EQ(std::distance(fs::directory_iterator(folder_.path()), {}), 1);
  }
  EXPECT_TRUE(fs::is_empty(folder_.path()));
}

// Processes of two containers may have one id.
TEST_F(FolderLockTest, LeavesAloneWhatAnotherProcessWithTheSameIdHasThere) {
  const std::string other = folder_.write("run.lock." + std::to_string(getpid()) + ".tmp", "of another");
  const std::string first = FolderLock(folder_.path()).text(), second = FolderLock(folder_.path()).text();
  EXPECT_NE(first, second);
  std::ifstream file(other);
  EXPECT_EQ(std::string(std::istreambuf_iterator<char>(file), {}), "of another");
}

TEST_F(FolderLockTest, IsRefusedWhileAnotherHoldsIt) {
  const FolderLock lock(folder_.path());
  EXPECT_THAT(refuse(), AllOf(HasSubstr("run.lock: error: another run writes into this folder (process " +
                                        std::to_string(getpid()) + " on host "),
                              HasSubstr("--out")));
  EXPECT_EQ(read_lock(), lock.text());
  EXPECT_THAT(describe_lock(folder_.path()), HasSubstr("a run is under way"));
}

TEST_F(FolderLockTest, OfAProcessThatHasEndedIsTakenOverAndTold) {
  const LockHolder ended = describe_ended_process();
  leave_lock_of(ended);
  EXPECT_THAT(describe_lock(folder_.path()), HasSubstr("the last run was killed (process "));
  const FolderLock lock(folder_.path());
  EXPECT_THAT(lock.note(), HasSubstr("was killed (process " + std::to_string(ended.process)));
  EXPECT_EQ(read_lock(), lock.text());
}

// The id of a process that has ended is given to another one.
TEST_F(FolderLockTest, OfAnotherProcessWithTheSameIdIsTakenOver) {
  LockHolder holder = describe_this_process();
  --holder.process_start;
  leave_lock_of(holder);
  EXPECT_NE(FolderLock(folder_.path()).note(), "");
}

TEST_F(FolderLockTest, OfAnotherMachineIsNotJudged) {
  LockHolder far = describe_ended_process();
  far.host = "elsewhere";
  far.boot = "another";
  leave_lock_of(far);
  fs::last_write_time(lock_path(), fs::file_time_type::clock::now() - std::chrono::hours(5));
  EXPECT_THAT(refuse(),
              AllOf(HasSubstr("another run may write into this folder (process "), HasSubstr("on host elsewhere"),
                    HasSubstr("last 5 h ago"), HasSubstr("remove " + lock_path())));
  EXPECT_EQ(read_lock(), format_holder(far));
  EXPECT_THAT(describe_lock(folder_.path()), HasSubstr("a run may be under way"));
}

TEST_F(FolderLockTest, OfAnotherContainerIsNotJudged) {
  LockHolder contained = describe_ended_process();
  contained.pid_namespace = "pid:[1]";
  leave_lock_of(contained);
  EXPECT_THAT(refuse(), HasSubstr("another run may write"));
}

TEST_F(FolderLockTest, FromBeforeThisMachineWasStartedIsTakenOver) {
  LockHolder before = describe_this_process();
  before.boot = "the one before";
  EXPECT_EQ(find_state(before, 1e12), HolderState::ended);
  EXPECT_EQ(find_state(before, 0), HolderState::unknown);  // another machine with the same name
  before.host = "elsewhere";
  EXPECT_EQ(find_state(before, 1e12), HolderState::unknown);
}

TEST_F(FolderLockTest, ThatCannotBeReadIsNotJudged) {
  for (const char* text : {"", "process: x\n", "nonsense"}) {
    folder_.write("run.lock", text);
    EXPECT_THAT(refuse(), HasSubstr("a process that its lock does not name")) << text;
  }
}

TEST_F(FolderLockTest, OfAnotherStaysWhereItIsTakenAwayAndMadeAnew) {
  std::optional<FolderLock> lock(std::in_place, folder_.path());
  folder_.write("run.lock", "of another run");
  lock.reset();
  EXPECT_EQ(read_lock(), "of another run");
}

TEST_F(FolderLockTest, IsGivenUpWhereTheRemovalOfAnEndedOneIsStuck) {
  leave_lock_of(describe_ended_process());
  folder_.write("run.lock.removal", "");
  EXPECT_THAT(refuse(), HasSubstr("remove " + lock_path() + " and " + lock_path() + ".removal"));
}

TEST_F(FolderLockTest, OfSymbolicLinkIsNotFollowed) {
  const std::string other = folder_.write("other", "mine");
  fs::create_symlink(other, lock_path());
  EXPECT_THAT(refuse(), HasSubstr("another run may write"));
  std::ifstream file(other);
  EXPECT_EQ(std::string(std::istreambuf_iterator<char>(file), {}), "mine");
}

// All find a lock whose holder has ended, and start at once; those that lose must not take the winner's away.
TEST_F(FolderLockTest, IsTakenByOneOfManyProcesses) {
  leave_lock_of(describe_ended_process());
  int start[2], end[2];
  ASSERT_EQ(pipe(start) | pipe(end), 0);
  std::vector<pid_t> children;
  constexpr int count = 12;
  for (int i = 0; i < count; ++i) {
    const pid_t child = fork();
    if (child != 0) {
      children.push_back(child);
      continue;
    }
    alarm(60);  // of two winners each waits for the end of the other
    close(start[1]);
    close(end[1]);
    wait_for_end_of(start[0]);
    int code = 0;
    try {
      const FolderLock lock(folder_.path());
      code = 1;
      wait_for_end_of(end[0]);  // the winner stays until all have tried
    } catch (const std::exception&) {
    }
    _exit(code);
  }
  close(start[0]);
  close(start[1]);
  close(end[0]);
  int taken = 0;
  for (int ended = 0; ended < count; ++ended) {
    if (ended == count - 1) close(end[1]);
    int status = 0;
    wait(&status);
    taken += WIFEXITED(status) ? WEXITSTATUS(status) : count;
  }
  EXPECT_EQ(taken, 1);
}

}  // namespace
}  // namespace percuss
