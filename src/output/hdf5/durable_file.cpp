#include "src/output/hdf5/durable_file.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <utility>

#include "comm/all_reduce.hpp"
#include "src/output/files/atomic_file.hpp"
#include "src/output/files/first_rank.hpp"

namespace percuss::hdf5 {

DurableFile::DurableFile(std::string path, const Communicator& ranks, FileLayout layout)
    : path_(std::move(path)), ranks_(ranks), layout_(std::move(layout)) {
  if (ranks.size() > 1) transfer_ = create_collective_transfer();
}

void DurableFile::create(std::uint64_t bytes, const std::function<void()>& write) {
  try {
    run_or_abandon("create", [&] {
      file_ = create_durable_file(path_, ranks_, layout_.links, layout_.chunk_index);
      run_on_first_rank(ranks_, [&] {
        disk_ = DiskReservation(path_);
        disk_.reserve(0, bytes);
      });
      write();
      flush();
      compare();
      trim();
    });
  } catch (...) {
    if (ranks_.rank() == 0) ::unlink(path_.c_str());
    throw;
  }
}

void DurableFile::open(std::int64_t frames, const std::function<void()>& open) {
  run_or_abandon("open", [&] {
    file_ = open_durable_file(path_, ranks_);
    run_on_first_rank(ranks_, [&] { disk_ = DiskReservation(path_, true); });
    open();
    frames_ = frames;
  });
}

// Does the work; if that fails, gives the file up as it is on the disk.
void DurableFile::run_or_abandon(const char* action, const std::function<void()>& work) {
  try {
    work();
  } catch (const Error& error) {
    fail(action, error);
  } catch (const SystemError&) {  // agreed on by all ranks
    abandon();
    throw;
  } catch (const std::exception& error) {
    // To give up a file that several ranks write takes all of them, and this rank may be the only one here.
    if (ranks_.size() > 1) end_all_ranks(ranks_, fmt::format("cannot {} '{}' ({})", action, path_, error.what()));
    abandon();
    throw;
  }
}

std::string DurableFile::make_message(const char* action, const Error& error) const {
  return fmt::format("cannot {} '{}' ({}; while HDF5 was to {}){}", action, path_, error.reason, error.what(),
                     suggest_for_errno(error.error_number));
}

void DurableFile::fail(const char* action, const Error& error) {
  const std::string message = make_message(action, error);
  if (ranks_.size() > 1) end_all_ranks(ranks_, message);
  abandon();
  throw SystemError(message);
}

RowBlock DurableFile::complete(RowBlock block) {
  if (transfer_) block.transfer = transfer_.get();
  block.record = &record_;
  return block;
}

RowBlock DurableFile::block_of_first_rank(hsize_t rows) {
  const bool first = ranks_.rank() == 0;
  return complete({rows, first ? 0 : rows, first ? rows : 0});
}

RowBlock DurableFile::block_of_all(std::size_t count) {
  std::uint64_t all = count, first = count;
  all_reduce(ranks_, Reduce::sum, all);
  wait_mpi([&] { return MPI_Scan(MPI_IN_PLACE, &first, 1, MPI_UINT64_T, MPI_SUM, ranks_.handle()); }, "MPI_Scan");
  return complete({all, first - count, count});
}

void DurableFile::append_frame(const FrameWork& work) {
  if (!file_) throw SystemError(fmt::format("cannot write '{}' (it was given up after an error)", path_));
  run_or_abandon("write", [&] {
    reserve(work.prepare());
    work.write();
    flush();
    compare();
    // Only now does the frame exist for a reader.
    work.show();
    flush();
    ++frames_;
    trim();
  });
}

void DurableFile::flush() { check(H5Fflush(file_.get(), H5F_SCOPE_GLOBAL), "flush the file"); }

// Checks that a reader finds what was written since the last call, behind the frames of which the file tells.
void DurableFile::compare() {
  ranks_.barrier();  // all have flushed it
  const auto read_back = [&] {
    try {
      const Handle file = open_to_compare(path_);
      record_.compare(file.get());
      if (layout_.count_frames(file.get()) != frames_)
        throw Error("read back the number of frames", "it is not what was written");
    } catch (const Error& error) {
      throw SystemError(make_message("write", error));
    } catch (const InputError& error) {  // it is damaged, and no input
      throw SystemError(make_message("write", Error("read it back", error.what())));
    }
  };
  try {
    fail_together(ranks_, read_back);
  } catch (const SystemError&) {
    // A file that was taken away meanwhile cannot be read either: that is what to tell.
    run_on_first_rank(ranks_, [&] { disk_.file().check_place(); });
    throw;
  }
  record_.clear();
}

std::uint64_t DurableFile::file_bytes() const {
  hsize_t bytes = 0;
  check(H5Fget_filesize(file_.get(), &bytes), "ask for the size of the file");
  return bytes;
}

// HDF5 does not tell how long a file is that several ranks write, but a flush cuts it to its data if they end elsewhere
// than before, and what is reserved is more than a frame takes.
void DurableFile::reserve(std::uint64_t bytes) {
  if (ranks_.size() == 1) {
    disk_.reserve(file_bytes(), bytes);
  } else {
    run_on_first_rank(ranks_, [&] { disk_.reserve(static_cast<std::uint64_t>(disk_.file().size()), bytes); });
  }
}

void DurableFile::trim() {
  if (ranks_.size() == 1) {
    disk_.trim(file_bytes());
  } else {
    run_on_first_rank(ranks_, [&] { disk_.trim_if_unused(); });
  }
}

void DurableFile::sync() {
  run_on_first_rank(ranks_, [&] {
    disk_.file().check_place();
    disk_.file().sync();
  });
  compare();
}

void DurableFile::close() {
  if (!file_) return;
  run_or_abandon("write", [&] {
    flush();
    layout_.release();
    check(file_.reset(), "close the file");
    sync();
  });
}

bool DurableFile::is_in_place() const {
  int in_place = ranks_.rank() == 0 && disk_.file().is_in_place() ? 1 : 0;
  wait_mpi([&] { return MPI_Bcast(&in_place, 1, MPI_INT, 0, ranks_.handle()); }, "MPI_Bcast");
  return in_place != 0;
}

void DurableFile::abandon() {
  turn_away(file_, ranks_);
  layout_.release();
  file_.release();
}

}  // namespace percuss::hdf5
