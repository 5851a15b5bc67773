#pragma once
// history.csv: one row a due step; units and meaning of each column in docs/output.md.

#include <chrono>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "src/output/files/posix_file.hpp"
#include "src/output/later_states.hpp"

namespace percuss {

class HistoryFile {
 public:
  /// Creates the file with its heading row. Throws SystemError.
  HistoryFile(const std::string& path, std::span<const std::string> columns);
  /// Continues with a file of an earlier run behind its first `bytes`, and cuts off what lies there. Throws what
  /// check_history_file() throws, which is asked first.
  HistoryFile(const std::string& path, std::span<const std::string> columns, std::int64_t bytes);
  /// Flushes and closes; an error is lost here, so close() first.
  ~HistoryFile();
  HistoryFile(const HistoryFile&) = delete;
  HistoryFile& operator=(const HistoryFile&) = delete;

  /// Appends a row of as many values as there are columns (std::logic_error otherwise), in the shortest text that reads
  /// back to the same bits. Rows reach the file whole, some at a time, but within about a second while rows come.
  /// Throws SystemError (disk full).
  void write_row(std::span<const double> values);

  /// Hands all rows to the system, so that they survive the end of the process. Throws SystemError; the file then ends
  /// with the last row that fitted. A file that was removed or replaced meanwhile is such an error, too.
  void flush();

  /// flush(), waits until the disk has it, and reads back and compares what is new since the last time. Throws
  /// SystemError.
  void sync();

  /// sync(), and closes the file. Throws SystemError.
  void close();

  /// Length of the file, with all rows that were flushed [byte].
  std::int64_t length() const { return written_; }

  /// Whether the path still leads to this file.
  bool is_in_place() const { return file_.is_in_place(); }

 private:
  void cut_to_last_row(std::string_view rows);
  void compare() const;

  std::string path_;
  std::size_t columns_ = 0;
  PosixFile file_;
  bool is_open_ = true;
  std::string pending_;                      // whole rows that are not in the file yet
  std::int64_t written_ = 0, compared_ = 0;  // bytes; of which read back
  std::uint64_t hash_;                       // of those between the two
  std::chrono::steady_clock::time_point flushed_;
};

/// Throws InputError if the first `bytes` of a history file are not the heading of these columns with whole rows after
/// it, SystemError if it cannot be read.
void check_history_file(const std::string& path, std::span<const std::string> columns, std::int64_t bytes);

/// The rows behind the first `bytes` of a history file whose first columns are time and step; all of its rows if
/// `bytes` is not above zero. None of a file that is not there or that holds something else.
LaterStates find_later_rows(const std::string& path, std::int64_t bytes);

/// The shortest text that reads back to the same double: whole numbers without a decimal point, nan, inf, -inf.
std::string format_number(double value);

}  // namespace percuss
