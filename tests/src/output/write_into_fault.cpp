// Writes the sample run on several ranks until a write of the last frame ends one of them or fails there.
//
// write_into_fault FOLDER kill|fail RANK N: the N-th write of the last frame, counted on that rank, is the one; ends
// with 0 if there are fewer. write_into_fault FOLDER check: tells whether the frames before are in the file.

#include <dlfcn.h>
#include <sys/uio.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstdio>
#include <exception>
#include <string>

#include "tests/src/output/hdf5_file_view.hpp"
#include "tests/src/output/sample_run.hpp"

namespace {

enum class Fault { none, kill, fail };
Fault fault = Fault::none;
int writes_left = 0;

// Whether the write that is about to happen must fail.
bool meet_fault() {
  if (fault == Fault::none || writes_left-- > 0) return false;
  if (fault == Fault::kill) ::kill(::getpid(), SIGKILL);
  errno = EIO;
  return true;
}

template <class Function>
Function find_next(const char* symbol) {
  return reinterpret_cast<Function>(::dlsym(RTLD_NEXT, symbol));
}

constexpr int good_frames = 2;

bool has_good_frames(const std::string& path, const percuss::Mesh& mesh) {
  const percuss::sample::Hdf5FileView file(path);
  if (!file.is_open()) return false;
  const long found = file.attribute("VTKHDF/Steps", "NSteps").front();
  if (found < good_frames || found > good_frames + 1) return false;
  const auto rows = [&](std::size_t items) { return static_cast<hsize_t>(found) * items; };
  const auto points = file.first_rows("VTKHDF/Points", rows(mesh.nodes.size()));
  const auto stress = file.first_rows("VTKHDF/CellData/stress", rows(mesh.elements.size()));
  std::vector<double> expected_points, expected_stress;
  for (int frame = 0; frame < found; ++frame) {
    const percuss::sample::Frame data(mesh, frame);
    expected_points.insert(expected_points.end(), data.positions.begin(), data.positions.end());
    expected_stress.insert(expected_stress.end(), data.stress.begin(), data.stress.end());
  }
  if (points != expected_points || stress != expected_stress) return false;
  return true;
}

}  // namespace

// These stand before those of the C library, through which MPI-IO writes.
extern "C" ssize_t pwrite(int file, const void* data, std::size_t size, off_t offset) {
  static const auto real = find_next<ssize_t (*)(int, const void*, std::size_t, off_t)>("pwrite");
  return meet_fault() ? -1 : real(file, data, size, offset);
}
extern "C" ssize_t pwritev(int file, const iovec* pieces, int count, off_t offset) {
  static const auto real = find_next<ssize_t (*)(int, const iovec*, int, off_t)>("pwritev");
  return meet_fault() ? -1 : real(file, pieces, count, offset);
}

int main(int count, char** arguments) {
  using namespace percuss;
  const MpiSession mpi(count, arguments);
  const Communicator ranks = Communicator::world();
  const Mesh mesh = sample::make_mesh(4);
  if (count == 3) return has_good_frames(std::string(arguments[1]) + "/fields.vtkhdf", mesh) ? 0 : 1;
  if (count != 5) return 2;
  try {
    const ChunkedMesh share = sample::take_share(sample::cut_layers(mesh), ranks);
    FieldsFile file(arguments[1], share, sample::options(), ranks);
    for (int frame = 0; frame < good_frames; ++frame) sample::write_frame(file, share.mesh, frame);
    writes_left = std::stoi(arguments[4]);
    if (std::stoi(arguments[3]) == ranks.rank())
      fault = arguments[2] == std::string("kill") ? Fault::kill : Fault::fail;
    sample::write_frame(file, share.mesh, good_frames);
    fault = Fault::none;
    file.close();
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 4;
  }
  return 0;
}
