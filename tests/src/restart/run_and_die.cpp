// Runs a deck until a write that the arguments choose kills the process; compares what two runs have left.
//
// run_and_die run DECK OUT KILL_RANK KILL_WRITE [CHECKPOINT]: runs the deck, from a checkpoint if there is one; the
// KILL_WRITE-th write to a file of results on rank KILL_RANK is the end of it (0: none; +N: the N-th that begins when
// there is a checkpoint). run_and_die fill DECK OUT N:
// the disk is full when the checkpoints after the first request room for the N-th time. run_and_die compare A B: 0 if
// state, history and fields are the same bits.

#include <dlfcn.h>
#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <sys/uio.h>
#include <unistd.h>

#include <Kokkos_Core.hpp>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <exception>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include "comm/communicator.hpp"
#include "src/deck/reading/read_deck.hpp"
#include "src/output/formats/result_names.hpp"
#include "src/step/run/run.hpp"
#include "tests/src/output/hdf5_file_view.hpp"

namespace {

long writes_left = 0;            // 0: nobody dies
long demands_left = 0;           // for room in a checkpoint; 0: the disk has room for all
std::string earlier_checkpoint;  // counted is what comes after there is one; empty: everything
bool is_disk_full = false;

void meet_fate() {
  if (writes_left == 0) return;
  if (!earlier_checkpoint.empty() && ::access(earlier_checkpoint.c_str(), F_OK) != 0) return;
  if (--writes_left == 0) ::kill(::getpid(), SIGKILL);
}

bool is_new_checkpoint(int file) {
  char name[4096];
  const ssize_t length = ::readlink(fmt::format("/proc/self/fd/{}", file).c_str(), name, sizeof name);
  return length > 0 && std::string(name, static_cast<std::size_t>(length)).ends_with("/checkpoint.h5.tmp");
}

// Whether there is no room for what is requested behind the end of the file.
bool lacks_room(int file, off_t end) {
  struct stat status {};
  if ((demands_left == 0 && !is_disk_full) || !is_new_checkpoint(file) || ::fstat(file, &status) != 0 ||
      end <= status.st_size)
    return false;
  if (::access(earlier_checkpoint.c_str(), F_OK) != 0) return false;
  if (!is_disk_full && --demands_left == 0) is_disk_full = true;
  return is_disk_full;
}

template <class Function>
Function find_next(const char* symbol) {
  return reinterpret_cast<Function>(::dlsym(RTLD_NEXT, symbol));
}

}  // namespace

// These stand before those of the C library: HDF5, MPI-IO and the seal write by them.
extern "C" ssize_t pwrite(int file, const void* data, std::size_t size, off_t offset) {
  static const auto real = find_next<ssize_t (*)(int, const void*, std::size_t, off_t)>("pwrite");
  meet_fate();
  if (lacks_room(file, offset + static_cast<off_t>(size))) {
    errno = ENOSPC;
    return -1;
  }
  return real(file, data, size, offset);
}
extern "C" ssize_t pwritev(int file, const iovec* pieces, int count, off_t offset) {
  static const auto real = find_next<ssize_t (*)(int, const iovec*, int, off_t)>("pwritev");
  meet_fate();
  return real(file, pieces, count, offset);
}
extern "C" int posix_fallocate(int file, off_t offset, off_t size) {
  static const auto real = find_next<int (*)(int, off_t, off_t)>("posix_fallocate");
  return lacks_room(file, offset + size) ? ENOSPC : real(file, offset, size);
}

namespace percuss {
namespace {

std::string read_file(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

bool is_same(const std::string& what, bool same) {
  if (!same) fmt::print("{} differ\n", what);
  return same;
}

bool compare_frames(const std::string& a, const std::string& b) {
  const sample::Hdf5FileView one(a), other(b);
  if (!is_same("fields files", one.is_open() && other.is_open())) return false;
  if (!is_same("names of fields", one.datasets() == other.datasets())) return false;
  bool same = true;
  for (const std::string& name : one.datasets()) {
    same = is_same(name, one.shape(name) == other.shape(name) && one.bytes(name) == other.bytes(name)) && same;
  }
  return same;
}

/// Whether the files of every output of fields are the same.
bool compare_fields(const std::string& a, const std::string& b) {
  const std::vector<std::string> files = list_fields_files(a);
  if (!is_same("names of files", !files.empty() && files == list_fields_files(b))) return false;
  bool same = true;
  for (const std::string& file : files) {
    const std::string one = a + "/" + file, other = b + "/" + file;
    if (holds_frames(file))
      same = is_same(file, compare_frames(one, other)) && same;
    else if (file.ends_with(".xdmf"))
      same = is_same(file, read_file(one) == read_file(other)) && same;
  }
  return same;
}

int compare(const std::string& a, const std::string& b) {
  const Summary one = read_summary(a + "/summary.json"), other = read_summary(b + "/summary.json");
  bool same = is_same("states", one.state_hash == other.state_hash && one.steps == other.steps);
  same = is_same("energies",
                 one.energy.error == other.energy.error && one.momentum.linear_error == other.momentum.linear_error) &&
         same;
  same = is_same("time steps", one.dt.min == other.dt.min && one.dt.max == other.dt.max) && same;
  const std::string rows = read_file(a + "/history.csv");
  same = is_same("histories", !rows.empty() && rows == read_file(b + "/history.csv")) && same;
  return compare_fields(a, b) && same ? 0 : 1;
}

/// `arrange` sees the number of the rank, and sets what is to happen there.
template <class Arrange>
int run(int argc, char** argv, RunOptions options, const Arrange& arrange) {
  const MpiSession mpi(argc, argv);
  const Kokkos::ScopeGuard kokkos;
  const int rank = Communicator::world().rank();
  options.out_dir = argv[3];
  arrange(rank);
  try {
    run_scene(read_deck(argv[2]), options);
  } catch (const std::exception& error) {
    if (rank == 0) fmt::print(stderr, "{}\n", error.what());
    return 4;
  }
  return 0;
}

int run_and_die(int argc, char** argv) {
  RunOptions options;
  if (argc > 6) options.restart = argv[6];
  options.goes_on_in_place = argc > 6;
  if (argv[5][0] == '+') earlier_checkpoint = std::string(argv[3]) + "/checkpoint.h5";
  return run(argc, argv, options, [&](int rank) {
    if (std::stoi(argv[4]) == rank) writes_left = std::stol(argv[5]);
  });
}

int fill(int argc, char** argv) {
  RunOptions options;
  options.progress = Progress::Style::plain;
  earlier_checkpoint = std::string(argv[3]) + "/checkpoint.h5";
  return run(argc, argv, options, [&](int rank) {
    if (rank == 0) demands_left = std::stol(argv[4]);  // rank 0 requests the room of all, and seals
  });
}

}  // namespace
}  // namespace percuss

int main(int argc, char** argv) {
  const std::string mode = argc > 1 ? argv[1] : "";
  if (mode == "compare" && argc == 4) return percuss::compare(argv[2], argv[3]);
  if (mode == "run" && argc >= 6) return percuss::run_and_die(argc, argv);
  if (mode == "fill" && argc == 5) return percuss::fill(argc, argv);
  return 2;
}
