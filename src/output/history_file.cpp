#include "src/output/history_file.hpp"

#include <fcntl.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <utility>

#include "src/error.hpp"
#include "src/output/files/safe_text.hpp"

namespace percuss {
namespace {

constexpr std::size_t pending_limit = std::size_t{64} << 10;  // bytes kept back, to write rows many at a time
constexpr std::int64_t largest_read = 1 << 20;                // bytes
constexpr auto longest_wait = std::chrono::seconds(1);        // so that others can watch, and a kill loses little

// A heading with a comma, a quote or a line break is quoted as RFC 4180 says.
std::string quote_heading(const std::string& heading) {
  if (heading.find_first_of(",\"\r\n") == std::string::npos) return heading;
  std::string quoted = "\"";
  for (const char c : heading) quoted.append(c == '"' ? 2 : 1, c);
  return quoted + '"';
}

void append_number(std::string& text, double value) {
  if (std::isnan(value)) {  // to_chars would give its sign, which readers of CSV files do not know
    text += "nan";
    return;
  }
  // Below 2^53 every whole number is exact; "100000" reads better than "1e+05". -0 keeps its sign.
  constexpr double exact_limit = 9007199254740992.0;
  std::array<char, 32> digits;
  const bool whole = std::trunc(value) == value && std::fabs(value) < exact_limit;
  const auto end = whole ? std::to_chars(digits.begin(), digits.end(), value, std::chars_format::fixed)
                         : std::to_chars(digits.begin(), digits.end(), value);
  text.append(digits.begin(), end.ptr);
}

std::string make_heading(std::span<const std::string> columns) {
  std::string heading;
  for (const auto& column : columns) heading += quote_heading(make_printable(column)) + ',';
  if (!columns.empty()) heading.pop_back();
  return heading + '\n';
}

constexpr std::uint64_t empty_hash = 0xcbf29ce484222325ull;

/// FNV-1a (Fowler, Noll and Vo), which continues byte by byte.
std::uint64_t add_to_hash(std::uint64_t hash, std::string_view bytes) {
  for (const char byte : bytes) hash = (hash ^ static_cast<unsigned char>(byte)) * 0x100000001b3ull;
  return hash;
}

}  // namespace

std::string format_number(double value) {
  std::string text;
  append_number(text, value);
  return text;
}

void check_history_file(const std::string& path, std::span<const std::string> columns, std::int64_t bytes) {
  const auto refuse = [&](const char* problem) {
    throw InputError(fmt::format(
        "{}: error: {} (the restart would continue this file): choose another folder with --out", path, problem));
  };
  std::ifstream file(path, std::ios::binary);
  if (!file) refuse("it cannot be opened");
  std::string heading(static_cast<std::size_t>(make_heading(columns).size()), '\0');
  file.read(heading.data(), static_cast<std::streamsize>(heading.size()));
  if (!file || heading != make_heading(columns)) refuse("its columns are not those of this run");
  file.seekg(bytes - 1);
  if (bytes < static_cast<std::int64_t>(heading.size()) || file.get() != '\n')
    refuse("it lacks rows that the checkpoint expects");
}

LaterStates find_later_rows(const std::string& path, std::int64_t bytes) {
  LaterStates rows;
  std::ifstream file(path, std::ios::binary);
  std::string line;
  if (bytes > 0) {
    file.seekg(bytes);
  } else {
    std::getline(file, line);  // the heading
  }
  while (std::getline(file, line) && !file.eof()) {  // what does not end is no row
    SavedState row;
    const char* const end = line.data() + line.size();
    const auto time = std::from_chars(line.data(), end, row.time);
    if (time.ec != std::errc() || time.ptr == end || *time.ptr != ',') break;
    if (std::from_chars(time.ptr + 1, end, row.step).ec != std::errc()) break;
    rows.push_back(row);
  }
  return rows;
}

HistoryFile::HistoryFile(const std::string& path, std::span<const std::string> columns)
    : path_(path), columns_(columns.size()), file_(path, O_RDWR | O_CREAT | O_TRUNC | O_NOFOLLOW), hash_(empty_hash) {
  pending_ = make_heading(columns);
  flush();
}

HistoryFile::HistoryFile(const std::string& path, std::span<const std::string> columns, std::int64_t bytes)
    : path_(path), columns_(columns.size()), written_(bytes), compared_(bytes), hash_(empty_hash) {
  check_history_file(path, columns, bytes);
  file_ = PosixFile(path, O_RDWR);
  file_.truncate(bytes);
}

HistoryFile::~HistoryFile() {
  try {
    if (is_open_) flush();
  } catch (const SystemError&) {  // a destructor cannot report it
  }
}

void HistoryFile::write_row(std::span<const double> values) {
  if (values.size() != columns_)
    throw std::logic_error(
        fmt::format("a row of {} has {} values (it has {} columns)", path_, values.size(), columns_));
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (i > 0) pending_ += ',';
    append_number(pending_, values[i]);
  }
  pending_ += '\n';
  const bool late = std::chrono::steady_clock::now() - flushed_ >= longest_wait;
  if (late || pending_.size() >= pending_limit) flush();
}

void HistoryFile::flush() {
  flushed_ = std::chrono::steady_clock::now();
  if (pending_.empty()) return;
  const std::string rows = std::exchange(pending_, "");  // one message, no second try on a full disk
  try {
    file_.check_place();
    file_.write(rows.data(), written_, std::ssize(rows));
  } catch (const SystemError&) {
    cut_to_last_row(rows);
    throw;
  }
  written_ += std::ssize(rows);
  hash_ = add_to_hash(hash_, rows);
}

/// After a failed write, keeps those of its rows that are in the file as a whole.
void HistoryFile::cut_to_last_row(std::string_view rows) {
  try {
    const auto there = std::clamp<std::int64_t>(file_.size() - written_, 0, std::ssize(rows));
    const auto end = rows.substr(0, static_cast<std::size_t>(there)).rfind('\n');
    const std::string_view whole = rows.substr(0, end == std::string_view::npos ? 0 : end + 1);
    written_ += std::ssize(whole);
    hash_ = add_to_hash(hash_, whole);
    file_.truncate(written_);
  } catch (const SystemError&) {  // the first error is the one to tell
  }
}

/// Checks that a reader finds behind compared_ what was written there.
void HistoryFile::compare() const {
  std::uint64_t found = empty_hash;
  std::string part;
  for (std::int64_t at = compared_; at < written_; at += std::ssize(part)) {
    part.resize(static_cast<std::size_t>(std::min<std::int64_t>(written_ - at, largest_read)));
    file_.read(part.data(), at, std::ssize(part));
    found = add_to_hash(found, part);
  }
  if (found == hash_ && file_.size() == written_) return;
  throw SystemError(
      fmt::format("cannot write '{}' (read back, it does not hold the rows that were written): check the disk, and "
                  "that no other program writes to the file",
                  path_));
}

void HistoryFile::sync() {
  flush();
  file_.check_place();
  file_.sync();
  compare();
  compared_ = written_;
  hash_ = empty_hash;
}

void HistoryFile::close() {
  if (!is_open_) return;
  is_open_ = false;
  sync();
  file_.close();
}

}  // namespace percuss
