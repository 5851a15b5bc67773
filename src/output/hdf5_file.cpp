#include "src/output/hdf5_file.hpp"

#include <sys/mman.h>
#include <unistd.h>

#include <cstdio>
#include <cstdlib>

namespace percuss::hdf5 {
namespace {

// A B-tree node of the chunk index holds 2 k entries. A node that does not split is only ever added to, which lets a
// file survive a crash between any two writes of its metadata; so only every 512th frame of a field has such a weak
// moment.
constexpr unsigned chunk_index_k = 256;

// Metadata leave the cache at a flush only, so that a crash while a frame is computed or written changes nothing.
void keep_metadata_until_flush(hid_t file, const std::string& action) {
  H5AC_cache_config_t cache{};
  cache.version = H5AC__CURR_CACHE_CONFIG_VERSION;
  check(H5Fget_mdc_config(file, &cache), action);
  cache.evictions_enabled = false;
  cache.incr_mode = H5C_incr__off;
  cache.decr_mode = H5C_decr__off;
  cache.flash_incr_mode = H5C_flash_incr__off;
  check(H5Fset_mdc_config(file, &cache), action);
}

// Ends the program, with the exit code that it has, before the functions that were registered earlier have their turn.
void end_before_hdf5(int exit_code, void*) {
  std::fflush(nullptr);
  ::_exit(exit_code);
}

}  // namespace

Handle create_durable_file(const std::string& path) {
  const std::string action = "create the file";
  const Handle access(check(H5Pcreate(H5P_FILE_ACCESS), action), H5Pclose);
  // No lock, so that ParaView can look at a run that goes on; no chunk cache: frames go to the system as they come.
  check(H5Pset_file_locking(access.get(), false, true), action);
  check(H5Pset_cache(access.get(), 0, 1, 0, 1.0), action);
  const Handle creation(check(H5Pcreate(H5P_FILE_CREATE), action), H5Pclose);
  check(H5Pset_istore_k(creation.get(), chunk_index_k), action);
  ::unlink(path.c_str());  // who still reads an older run keeps its file
  Handle file(check(H5Fcreate(path.c_str(), H5F_ACC_TRUNC, creation.get(), access.get()), action), H5Fclose);
  keep_metadata_until_flush(file.get(), action);
  return file;
}

void turn_to_memory(const Handle& file) {
  void* descriptor = nullptr;
  if (!file || H5Fget_vfd_handle(file.get(), H5P_DEFAULT, &descriptor) < 0) return;
  const int memory = ::memfd_create("abandoned", MFD_CLOEXEC);
  if (memory < 0) return;
  ::dup2(memory, *static_cast<int*>(descriptor));
  ::close(memory);
}

void close_abandoned(Handle& file, Failure failure) {
  if (failure == Failure::elsewhere) {
    file.reset();
    return;
  }
  file.release();
  ::on_exit(end_before_hdf5, nullptr);
}

}  // namespace percuss::hdf5
