#pragma once
// Runs a deck given as text through run_scene and reads back what it wrote: the fixture of whole-run tests.

#include <cstddef>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "src/deck/deck.hpp"
#include "src/output/summary.hpp"

namespace percuss::test {

/// A folder of its own under the system's temporary folder, gone at the end of the scope.
class TemporaryFolder {
 public:
  TemporaryFolder();
  ~TemporaryFolder();
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;
  const std::string& path() const { return path_; }

 private:
  std::string path_;
};

/// A folder of rank 0 that all ranks know. Collective at its beginning and its end.
class SharedFolder {
 public:
  SharedFolder();
  ~SharedFolder();
  SharedFolder(const SharedFolder&) = delete;
  SharedFolder& operator=(const SharedFolder&) = delete;
  const std::string& path() const { return path_; }

 private:
  TemporaryFolder own_;
  std::string path_;
};

/// A file that is gone at the end of the scope.
class TemporaryFile {
 public:
  explicit TemporaryFile(std::string path) : path_(std::move(path)) {}
  ~TemporaryFile();
  TemporaryFile(const TemporaryFile&) = delete;
  TemporaryFile& operator=(const TemporaryFile&) = delete;
  const std::string& path() const { return path_; }

 private:
  std::string path_;
};

/// history.csv, column by column.
class HistoryTable {
 public:
  HistoryTable() = default;
  /// Reads the file. Throws std::runtime_error if it is missing or a row is short.
  explicit HistoryTable(const std::string& file);

  std::size_t rows() const { return rows_; }
  bool has(const std::string& column) const { return columns_.count(column) > 0; }
  /// Values of a column; std::out_of_range naming it if there is none.
  const std::vector<double>& operator[](const std::string& column) const;
  double last(const std::string& column) const { return (*this)[column].back(); }
  double largest(const std::string& column) const;
  double smallest(const std::string& column) const;
  /// Value at a time, linear between rows.
  double at(double time, const std::string& column) const;
  /// Time average over the rows from start to end; NaN if there are none.
  double mean(double start, double end, const std::string& column) const;
  /// First time at which the column rises through a level, linear between rows; NaN if it never does.
  double time_of_rise(const std::string& column, double level) const;

 private:
  std::map<std::string, std::vector<double>> columns_;
  std::size_t rows_ = 0;
};

struct Outcome {
  Summary summary;
  HistoryTable history;  // empty unless the deck requests one
};

/// Runs a scene in a folder of its own. Prints one line with its size and seconds. Throws what run_scene throws.
Outcome run_deck(const Deck& deck);
Outcome run_deck(const std::string& text, const std::vector<std::string>& overrides = {});

}  // namespace percuss::test
