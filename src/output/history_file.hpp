#pragma once
// history.csv: one row a due step; units and meaning of each column in docs/output.md.

#include <cstdio>
#include <span>
#include <string>
#include <vector>

namespace percuss {

class HistoryFile {
 public:
  /// Creates the file with its heading row. Throws SystemError.
  HistoryFile(const std::string& path, std::span<const std::string> columns);
  ~HistoryFile();
  HistoryFile(const HistoryFile&) = delete;
  HistoryFile& operator=(const HistoryFile&) = delete;

  /// Appends a row; doubles are written so that they read back to the same bits. Throws SystemError (disk full).
  void write_row(std::span<const double> values);

  /// Flushes what was written to the disk.
  void flush();

 private:
  std::string path_;
  std::size_t columns_ = 0;
  std::FILE* file_ = nullptr;
};

}  // namespace percuss
