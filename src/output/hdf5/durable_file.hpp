#pragma once
// A file of results in HDF5 that grows by frames: room is reserved before a frame is written, what was written is read
// back and compared, and only then do readers see the frame. What files of different layouts have in common.
//
// Several ranks write the file together, each a block of every dataset (row_blocks.hpp). Predictable failures (the
// folder, the space on the disk) occur on rank 0 first and then on all. Other failures end the program at once, because
// within HDF5 the other ranks wait for the one that failed.

#include <cstdint>
#include <functional>
#include <string>

#include "comm/communicator.hpp"
#include "src/output/files/disk_reservation.hpp"
#include "src/output/hdf5/hdf5_file.hpp"
#include "src/output/hdf5/row_blocks.hpp"

namespace percuss::hdf5 {

/// Properties of a file by its layout.
struct FileLayout {
  LinkOrder links = LinkOrder::by_name;
  unsigned chunk_index = most_chunk_index;          // of create_durable_file()
  std::function<void()> release;                    // closes all that is open within the file
  std::function<std::int64_t(hid_t)> count_frames;  // that a reader finds; throws Error
};

class DurableFile {
 public:
  /// Opens nothing. All calls are collective over `ranks`, and throw SystemError or, within run_or_abandon(), Error.
  DurableFile(std::string path, const Communicator& ranks, FileLayout layout);
  DurableFile(const DurableFile&) = delete;
  DurableFile& operator=(const DurableFile&) = delete;

  /// Creates the file, with room for so many bytes; write() fills it with what comes before the first frame. No file is
  /// left if that fails.
  void create(std::uint64_t bytes, const std::function<void()>& write);

  /// Opens a file that has so many frames and nothing behind them; open() opens what is in it.
  void open(std::int64_t frames, const std::function<void()>& open);

  /// Room is reserved for so many bytes, write() writes the rows of a frame, which are flushed, read back and compared,
  /// and show() is what shows the frame to readers. prepare() comes before that and tells the bytes. Throws
  /// SystemError; the file then keeps the frames before and takes no more.
  struct FrameWork {
    std::function<std::uint64_t()> prepare;
    std::function<void()> write, show;
  };
  void append_frame(const FrameWork& work);

  /// Waits until the disk has the frames written so far, and looks whether all are there.
  void sync();

  /// Makes the file durable as above, and closes it.
  void close();

  /// Whether the path still leads to this file, as rank 0 sees it.
  bool is_in_place() const;

  hid_t id() const { return file_.get(); }
  std::int64_t frames() const { return frames_; }

  /// A block as it is written: by all ranks together, and noted, to be compared with what is read back.
  RowBlock complete(RowBlock block);
  RowBlock block_of_first_rank(hsize_t rows);
  /// Block to which each rank contributes some rows, rank after rank.
  RowBlock block_of_all(std::size_t count);

 private:
  void run_or_abandon(const char* action, const std::function<void()>& work);
  [[noreturn]] void fail(const char* action, const Error& error);
  std::string make_message(const char* action, const Error& error) const;
  std::uint64_t file_bytes() const;
  void reserve(std::uint64_t bytes);
  void trim();
  void flush();
  void compare();
  void abandon();

  std::string path_;
  Communicator ranks_;
  FileLayout layout_;
  Handle transfer_;  // collective; none: one rank
  std::int64_t frames_ = 0;
  WriteRecord record_;    // of what was written since compare()
  DiskReservation disk_;  // rank 0's
  Handle file_;
};

}  // namespace percuss::hdf5
