#include "src/output/history_file.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <charconv>
#include <cmath>
#include <fstream>
#include <stdexcept>

#include "src/output/atomic_file.hpp"
#include "src/output/safe_text.hpp"

namespace percuss {
namespace {

constexpr std::size_t pending_limit = std::size_t{64} << 10;  // bytes kept back, to write rows many at a time
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

}  // namespace

std::string format_number(double value) {
  std::string text;
  append_number(text, value);
  return text;
}

void check_history_file(const std::string& path, std::span<const std::string> columns, std::int64_t bytes) {
  const auto refuse = [&](const char* problem) {
    throw InputError(fmt::format("{}: error: {} (the restart goes on with this file) choose another folder with --out",
                                 path, problem));
  };
  std::ifstream file(path, std::ios::binary);
  if (!file) refuse("it cannot be opened");
  std::string heading(static_cast<std::size_t>(make_heading(columns).size()), '\0');
  file.read(heading.data(), static_cast<std::streamsize>(heading.size()));
  if (!file || heading != make_heading(columns)) refuse("its columns are not those of this run");
  file.seekg(bytes - 1);
  if (bytes < static_cast<std::int64_t>(heading.size()) || file.get() != '\n')
    refuse("it has not the rows that the checkpoint counts on");
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
    : path_(path), columns_(columns.size()), file_(std::fopen(path.c_str(), "wbe")) {
  if (file_ == nullptr) throw make_io_error("write", path_, errno);
  std::setvbuf(file_, nullptr, _IONBF, 0);  // pending_ is the buffer: it knows where rows end
  pending_ = make_heading(columns);
  try {
    flush();
  } catch (...) {
    std::fclose(file_);
    throw;
  }
}

HistoryFile::HistoryFile(const std::string& path, std::span<const std::string> columns, std::int64_t bytes)
    : path_(path), columns_(columns.size()), written_(bytes) {
  check_history_file(path, columns, bytes);
  file_ = std::fopen(path.c_str(), "r+be");
  if (file_ == nullptr) throw make_io_error("write", path_, errno);
  std::setvbuf(file_, nullptr, _IONBF, 0);
  if (::ftruncate(::fileno(file_), bytes) == 0 && std::fseek(file_, 0, SEEK_END) == 0) return;
  const int error_number = errno;
  std::fclose(file_);
  throw make_io_error("write", path_, error_number);
}

HistoryFile::~HistoryFile() {
  try {
    flush();
  } catch (...) {  // a destructor has nobody to tell
  }
  std::fclose(file_);
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
  const std::size_t written = std::fwrite(pending_.data(), 1, pending_.size(), file_);
  if (written == pending_.size()) {
    written_ += static_cast<long long>(written);
    pending_.clear();
    return;
  }
  const int error_number = errno;
  // Cut off the row that fitted in part only, and forget the rest: one message, no second try on a full disk.
  const auto last_row_end = std::string_view(pending_).substr(0, written).rfind('\n');
  written_ += last_row_end == std::string::npos ? 0 : static_cast<long long>(last_row_end + 1);
  [[maybe_unused]] const int cut = ::ftruncate(::fileno(file_), written_);
  pending_.clear();
  throw make_io_error("write", path_, error_number);
}

std::int64_t HistoryFile::sync() {
  flush();
  if (::fsync(::fileno(file_)) != 0) throw make_io_error("write", path_, errno);
  return written_;
}

}  // namespace percuss
