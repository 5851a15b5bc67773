#pragma once
// history.csv: one row a due step; units and meaning of each column in docs/output.md.

#include <chrono>
#include <cstdint>
#include <cstdio>
#include <span>
#include <string>
#include <vector>

#include "src/output/later_states.hpp"

namespace percuss {

class HistoryFile {
 public:
  /// Creates the file with its heading row. Throws SystemError.
  HistoryFile(const std::string& path, std::span<const std::string> columns);
  /// Goes on with a file of an earlier run behind its first `bytes`, and cuts off what lies there. Throws what
  /// check_history_file() throws, which is asked first.
  HistoryFile(const std::string& path, std::span<const std::string> columns, std::int64_t bytes);
  /// Flushes and closes; an error is lost here, so flush() first.
  ~HistoryFile();
  HistoryFile(const HistoryFile&) = delete;
  HistoryFile& operator=(const HistoryFile&) = delete;

  /// Appends a row of as many values as there are columns (std::logic_error otherwise), in the shortest text that reads
  /// back to the same bits. Rows reach the file whole, some at a time, but within about a second while rows come.
  /// Throws SystemError (disk full).
  void write_row(std::span<const double> values);

  /// Hands all rows to the system, so that they survive the end of the process. Throws SystemError; the file then ends
  /// with the last row that fitted.
  void flush();

  /// Of the file, with all rows that were flushed [byte].
  std::int64_t length() const { return written_; }

  /// flush(), and waits until the disk has it. Returns the length of the file [byte]. Throws SystemError.
  std::int64_t sync();

 private:
  std::string path_;
  std::size_t columns_ = 0;
  std::FILE* file_ = nullptr;
  std::string pending_;    // whole rows that are not in the file yet
  long long written_ = 0;  // bytes
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
