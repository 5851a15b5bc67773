#include "src/output/hdf5/hdf5_file.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/mman.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <cstdio>
#include <cstring>
#include <optional>
#include <thread>

#include "src/output/files/atomic_file.hpp"
#include "src/output/files/first_rank.hpp"
#include "src/output/files/safe_text.hpp"

namespace percuss::hdf5 {
namespace {

// HDF5 closes what is open when the program ends, and when MPI ends if MPI ran when HDF5 started. It crashes there
// where it meets a file that it could not write (HDF5 1.10); every other file is closed by who opened it. So both are
// kept from it, before anybody can start HDF5 or MPI, in every program that writes such files.
bool leave_open_at_exit() noexcept { return H5dont_atexit() >= 0 && H5open() >= 0; }
[[maybe_unused]] const bool leaves_open_at_exit = leave_open_at_exit();

// Metadata leave the cache at a flush only, so that a crash while a frame is computed or written changes nothing.
void keep_metadata_until_flush(hid_t file, const std::string& action) {
  H5AC_cache_config_t cache{};
  cache.version = H5AC__CURR_CACHE_CONFIG_VERSION;
  check(H5Fget_mdc_config(file, &cache), action);
  cache.evictions_enabled = false;
  cache.metadata_write_strategy = H5AC_METADATA_WRITE_STRATEGY__PROCESS_0_ONLY;
  cache.incr_mode = H5C_incr__off;
  cache.decr_mode = H5C_decr__off;
  cache.flash_incr_mode = H5C_flash_incr__off;
  check(H5Fset_mdc_config(file, &cache), action);
}

Handle create_access(const Communicator& ranks, const std::string& action) {
  Handle access(check(H5Pcreate(H5P_FILE_ACCESS), action), H5Pclose);
  // No lock, so that ParaView can look at a run that continues. No chunk cache and no sieve buffer: data go to the
  // system as they come, and the call that brings them reports a failure; what a buffer held back could only fail
  // later.
  check(H5Pset_file_locking(access.get(), false, true), action);
  check(H5Pset_cache(access.get(), 0, 1, 0, 1.0), action);
  check(H5Pset_sieve_buf_size(access.get(), 0), action);
  if (ranks.size() > 1) check(H5Pset_fapl_mpio(access.get(), ranks.handle(), MPI_INFO_NULL), action);
  return access;
}

/// An empty file that nobody else has made, by one rank. The reason of a failure is the system's own.
class NewFile {
 public:
  explicit NewFile(const std::string& path) {
    ::unlink(path.c_str());  // who still reads an older run keeps its file
    descriptor_ = ::open(path.c_str(), O_RDWR | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC, 0666);
    if (descriptor_ < 0) throw make_io_error("create", path, errno);
  }
  ~NewFile() { ::close(descriptor_); }
  NewFile(const NewFile&) = delete;
  NewFile& operator=(const NewFile&) = delete;

  /// A path that leads to this file whatever stands at its name by now; empty where the system has none.
  std::string own_path() const {
    std::string path = fmt::format("/proc/self/fd/{}", descriptor_);
    return ::access(path.c_str(), W_OK) == 0 ? path : "";
  }

 private:
  int descriptor_ = -1;
};

enum class Links { refuse, follow };

// Open MPI 4.1 waits for ever where one rank cannot open what others can: a folder that only one machine has, say.
void agree_that_all_reach(const std::string& path, const Communicator& ranks, Links links) {
  if (ranks.size() == 1) return;
  fail_together(ranks, [&] {
    const int descriptor = ::open(path.c_str(), O_RDWR | O_CLOEXEC | (links == Links::refuse ? O_NOFOLLOW : 0));
    if (descriptor < 0)
      throw SystemError(fmt::format("rank {} of {} cannot open '{}' ({}); results need a folder that all ranks share",
                                    ranks.rank(), ranks.size(), path, std::strerror(errno)));
    ::close(descriptor);
  });
}

// Each rank continues with a file of its own. One that cannot would leave the others waiting when the file is closed.
void turn_to_memory(MPI_File& file, const Communicator& ranks) {
  const int memory = ::memfd_create("abandoned", MFD_CLOEXEC);
  const std::string path = fmt::format("/proc/self/fd/{}", memory);
  MPI_File_close(&file);
  if (MPI_File_open(MPI_COMM_SELF, path.c_str(), MPI_MODE_RDWR, MPI_INFO_NULL, &file) != MPI_SUCCESS)
    ranks.abort(static_cast<int>(ExitCode::system_failed));
  ::close(memory);
}

// The duplicate stays open: the system must not give the file's number to another one, which HDF5 would then take for
// this one.
void turn_to_null(int descriptor) {
  const int null = ::open("/dev/null", O_WRONLY | O_CLOEXEC);
  if (null < 0 || ::fcntl(descriptor, F_DUPFD_CLOEXEC, 0) < 0) return;
  ::dup2(null, descriptor);
  ::close(null);
}

}  // namespace

Handle create_durable_file(const std::string& path, const Communicator& ranks, LinkOrder links, unsigned chunk_index) {
  const std::string action = "create the file";
  const bool together = ranks.size() > 1;
  const Handle access = create_access(ranks, action);
  const Handle creation(check(H5Pcreate(H5P_FILE_CREATE), action), H5Pclose);
  // A B-tree node of the chunk index holds 2 k entries. A node that does not split is only ever added to, which lets a
  // file survive a crash between any two writes of its metadata.
  check(H5Pset_istore_k(creation.get(), chunk_index), action);
  if (links == LinkOrder::by_creation)
    check(H5Pset_link_creation_order(creation.get(), H5P_CRT_ORDER_TRACKED | H5P_CRT_ORDER_INDEXED), action);
  // HDF5 opens by name: through the file that was just made, never through a link that has taken its place. Several
  // ranks, on machines of their own, have the name alone.
  std::optional<NewFile> made;
  run_on_first_rank(ranks, [&] { made.emplace(path); });
  agree_that_all_reach(path, ranks, Links::refuse);
  const std::string own = together ? "" : made->own_path();
  const std::string& name = own.empty() ? path : own;
  Handle file(check(H5Fcreate(name.c_str(), H5F_ACC_TRUNC, creation.get(), access.get()), action), H5Fclose);
  keep_metadata_until_flush(file.get(), action);
  return file;
}

Handle open_durable_file(const std::string& path, const Communicator& ranks) {
  const std::string action = "open the file";
  const Handle access = create_access(ranks, action);
  agree_that_all_reach(path, ranks, Links::follow);
  Handle file(check(H5Fopen(path.c_str(), H5F_ACC_RDWR, access.get()), action), H5Fclose);
  keep_metadata_until_flush(file.get(), action);
  return file;
}

void end_all_ranks(const Communicator& ranks, const std::string& message) {
  std::this_thread::sleep_for(std::chrono::milliseconds(250) * std::min(ranks.rank(), 20));
  std::fprintf(stderr, "percuss: error: %s\n", make_printable(message).c_str());
  std::fflush(nullptr);
  ranks.abort(static_cast<int>(ExitCode::system_failed));
}

Handle create_collective_transfer() {
  Handle transfer(check(H5Pcreate(H5P_DATASET_XFER), "describe a transfer"), H5Pclose);
  check(H5Pset_dxpl_mpio(transfer.get(), H5FD_MPIO_COLLECTIVE), "describe a transfer");
  // Each rank writes its block itself: blocks have no gaps, so there is nothing to put together on some of the ranks
  // first, and a rank whose write fails gets the error. Open MPI 4.1 loses that error where ranks write for each other.
  check(H5Pset_dxpl_mpio_collective_opt(transfer.get(), H5FD_MPIO_INDIVIDUAL_IO), "describe a transfer");
  return transfer;
}

void turn_away(const Handle& file, const Communicator& ranks) {
  void* handle = nullptr;
  if (!file || H5Fget_vfd_handle(file.get(), H5P_DEFAULT, &handle) < 0) return;
  if (ranks.size() > 1) {
    turn_to_memory(*static_cast<MPI_File*>(handle), ranks);
  } else {
    turn_to_null(*static_cast<int*>(handle));
  }
}

}  // namespace percuss::hdf5

namespace {

/// A write that came short is made again as a whole: the library does not tell where the gap is.
constexpr int most_tries = 8;

struct Written {
  int code = MPI_SUCCESS;
  MPI_Count bytes = 0;
  MPI_Status status;
};

Written write_once(MPI_File file, MPI_Offset offset, const void* data, int count, MPI_Datatype type) {
  Written written;
  written.code = PMPI_File_write_at(file, offset, data, count, type, &written.status);
  MPI_Get_elements_x(&written.status, MPI_BYTE, &written.bytes);
  return written;
}

}  // namespace

// Stands before the MPI library's function of this name, as MPI's profiling interface provides for. With several ranks
// all that HDF5 writes passes here. HDF5 1.10 continues in a flush after a failed write, past what the other ranks wait
// for, and Open MPI 4.1 reports one by the count alone: both would be a hang. So a failed write ends all ranks.
extern "C" int MPI_File_write_at(MPI_File file, MPI_Offset offset, const void* data, int count, MPI_Datatype type,
                                 MPI_Status* status) {
  MPI_Count item = 0;
  MPI_Type_size_x(type, &item);
  Written last = write_once(file, offset, data, count, type);
  for (int tries = 1; tries < most_tries && last.code == MPI_SUCCESS && last.bytes > 0 && last.bytes < item * count;
       ++tries)
    last = write_once(file, offset, data, count, type);
  if (last.code != MPI_SUCCESS || last.bytes != item * count) {
    percuss::hdf5::end_all_ranks(
        percuss::Communicator::world(),
        fmt::format("cannot write a file of results ({} of {} bytes written; is the disk sound?)", last.bytes,
                    item * count));
  }
  if (status != MPI_STATUS_IGNORE) *status = last.status;
  return last.code;
}
