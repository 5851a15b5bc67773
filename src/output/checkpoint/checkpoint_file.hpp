#pragma once
// checkpoint.h5: the state of a run, for a restart to the same bits on any number of ranks (docs/output.md).
//
// An HDF5 file with an array for each piece of state, chunk after chunk, and a seal at its end. It is written under a
// temporary name, read back and compared with the state in memory, and renamed when the disk has it. The previous one
// becomes checkpoint_previous.h5. A hash of all data is an attribute of the header; readers compare it with what they
// read.

#include <cstdint>
#include <map>
#include <memory>
#include <set>
#include <string>
#include <vector>

#include "src/hdf5/hdf5_handle.hpp"
#include "src/mesh/ordering.hpp"
#include "src/output/checkpoint/checkpoint_archive.hpp"
#include "src/output/checkpoint/checkpoint_place.hpp"
#include "src/output/checkpoint/chunk_blocks.hpp"
#include "src/output/files/disk_reservation.hpp"

namespace percuss {

/// Header of a checkpoint.
struct CheckpointHeader {
  std::string version;    // of percuss
  std::string precision;  // "double"
  std::string title;      // of the deck
  std::string deck;       // its values on which the motion depends, a line each
  std::string values;     // all values of the deck as JSON (Deck::resolved)
  std::string mesh;       // hash of the mesh
  std::string pieces;     // of the mesh, each with its hash, a line each (src/step/restart/mesh_pieces.hpp)
  std::string warnings;   // that the run has given (write_warnings())
  std::string earlier;    // cost of the run so far (write_earlier()); empty: not known
  std::string written;    // UTC
  std::string content;    // hash of all that was given, 16 digits; empty: of a percuss that did not write it
  std::int64_t elements = 0, nodes = 0, step = 0;
  double time = 0;

  bool operator==(const CheckpointHeader&) const = default;
};

class CheckpointWriter : public CheckpointArchive {
 public:
  /// Begins a file beside `path`. `mesh` outlives this. Collective, as is everything below. Throws SystemError.
  CheckpointWriter(const std::string& path, const CheckpointHeader& header, const ChunkedMesh& mesh,
                   const Communicator& ranks);
  /// Removes the file if finish() was not called.
  ~CheckpointWriter() override;
  CheckpointWriter(const CheckpointWriter&) = delete;
  CheckpointWriter& operator=(const CheckpointWriter&) = delete;

  /// Completes the file, reads it back and compares it with what was given, seals it, waits for the disk and puts it in
  /// its place. known_whole: as of replace_checkpoint(). Throws SystemError; what was there then stays.
  void finish(const std::string& known_whole = "");

  bool is_loading() const override { return false; }
  bool has_number(const std::string&) const override { return true; }
  using CheckpointArchive::rows;
  void words(const std::string& name, std::span<std::int64_t> values) override;
  void sum(const std::string& name, ExactSum& value) override;
  void rows(const std::string& name, const ChunkRows& rows, int components, std::span<double> values) override;
  void rows(const std::string& name, const ChunkRows& rows, int components, std::span<std::int64_t> values) override;
  void expect_rows(const std::string&, std::span<const std::int64_t>, int) override {}

 private:
  [[noreturn]] void refuse_value(const std::string& name) const override;
  template <class Work>
  void run_or_abandon(Work&& work);
  void create();
  void write_header();
  void write_numbers();
  void reserve(std::uint64_t bytes);
  void trim();
  template <class T>
  void write_rows(const std::string& name, const ChunkRows& rows, int components, std::span<const T> values);
  template <class T>
  void write_once(const std::string& name, std::span<const T> values);
  void make_groups(const std::string& path);
  hdf5::RowBlock make_block_of_first_rank(hsize_t count);
  std::string make_message(const hdf5::Error& error) const;
  void compare() const;
  void abandon();
  void remove_temporary() const;

  std::string path_, temporary_;
  CheckpointHeader header_;
  Communicator ranks_;
  ChunkBlocks blocks_;
  const ChunkedMesh& mesh_;
  hdf5::Handle transfer_, file_;
  DiskReservation disk_;  // rank 0's
  std::set<std::string> groups_;
  std::vector<std::string> number_names_, sum_names_;
  std::vector<std::int64_t> number_counts_, numbers_, sums_;  // by name; bits; limbs
  hdf5::WriteRecord record_;
};

class CheckpointReader : public CheckpointArchive {
 public:
  /// Opens a checkpoint whose seal holds. `mesh` outlives this. Collective, as is everything below. Throws InputError,
  /// SystemError, the same on all ranks.
  CheckpointReader(const std::string& path, const ChunkedMesh& mesh, const Communicator& ranks);

  const CheckpointHeader& header() const { return header_; }

  bool is_loading() const override { return true; }
  bool has_number(const std::string& name) const override { return number_places_.count(name) > 0; }
  using CheckpointArchive::rows;
  void words(const std::string& name, std::span<std::int64_t> values) override;
  void sum(const std::string& name, ExactSum& value) override;
  void rows(const std::string& name, const ChunkRows& rows, int components, std::span<double> values) override;
  void rows(const std::string& name, const ChunkRows& rows, int components, std::span<std::int64_t> values) override;
  void expect_rows(const std::string& name, std::span<const std::int64_t> counts, int components) override;

 private:
  [[noreturn]] void refuse_value(const std::string& name) const override;
  void load();
  void check_length(const std::string& name, std::int64_t rows, int components) const;
  template <class T>
  void read_rows(const std::string& name, const ChunkRows& rows, int components, std::span<T> values);
  template <class T>
  void read_runs(const std::string& name, const std::vector<std::int64_t>& first, int components,
                 std::vector<T>& into) const;

  std::string path_;
  Communicator ranks_;
  const ChunkedMesh& mesh_;
  std::uint64_t file_bytes_ = 0;
  hdf5::Handle file_;
  CheckpointHeader header_;
  /// Place of a name's numbers in numbers_.
  struct Place {
    std::size_t first = 0, count = 0;
  };
  void place_numbers(const std::vector<std::string>& names, const std::vector<std::int64_t>& counts);
  std::map<std::string, Place> number_places_;
  std::map<std::string, std::size_t> sum_places_;
  std::vector<std::int64_t> numbers_, sums_;
};

/// The header of a file that has no seal yet, by this process alone. Throws InputError, SystemError.
CheckpointHeader read_unsealed_header(const std::string& path);

/// The header of a checkpoint whose seal holds, by this process alone. Throws InputError, SystemError.
CheckpointHeader read_checkpoint_header(const std::string& path);

/// Whether an HDF5 file calls itself a checkpoint of percuss; false for what cannot be read.
bool is_checkpoint(const std::string& path);

/// Describes a checkpoint in words, for `percuss info`. Throws InputError, SystemError.
std::string describe_checkpoint(const std::string& path);

}  // namespace percuss
