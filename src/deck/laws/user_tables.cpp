#include "src/deck/laws/user_tables.hpp"

#include <fmt/format.h>

#include <cstddef>
#include <cstdlib>
#include <fstream>
#include <map>
#include <vector>

#include "src/deck/laws/user_routines.hpp"
#include "src/error.hpp"

namespace percuss {
namespace {

/// Kinds of columns, by the numbers that the code gets.
enum class TableKind { integer = 1, number = 2, word = 3 };

struct Cell {
  int integer = 0;
  double number = 0;
  std::string word;
};
struct UserTable {
  std::vector<TableKind> kinds;
  std::vector<Cell> cells;  // row after row
  std::size_t rows() const { return kinds.empty() ? 0 : cells.size() / kinds.size(); }
};
using Collection = std::map<std::string, UserTable>;

struct AllTables {
  std::map<std::string, Collection> collections;
};
AllTables& all_tables() {
  static AllTables all;
  return all;
}

/// The collection that this thread has chosen; null: none.
const Collection*& chosen() {
  thread_local const Collection* one = nullptr;
  return one;
}

std::vector<std::string> split(const std::string& line) {
  std::vector<std::string> words(1);
  for (const char c : line) {
    if (c == ',')
      words.emplace_back();
    else if (c != '\r')
      words.back() += c;
  }
  return words;
}

/// A file that is being read.
class TableReader {
 public:
  explicit TableReader(const std::string& file) : file_(file) {}

  void read() {
    std::ifstream in(file_);
    if (!in)
      throw InputError(fmt::format("{}: error: this file of parameter_tables cannot be read: correct it", file_));
    for (std::string line; std::getline(in, line);) {
      ++number_;
      if (!line.empty()) take(split(line));
    }
  }

 private:
  [[noreturn]] void refuse(const std::string& what, const char* why, const char* remedy) const {
    throw InputError(fmt::format("{}:{}: error: {} ({}): {}", file_, number_, what, why, remedy));
  }

  void take(const std::vector<std::string>& words) {
    if (words[0] == "collection" && words.size() == 2) {
      collection_ = &all_tables().collections[words[1]];
      table_ = nullptr;
    } else if (words[0] == "table" && words.size() > 2 && collection_ != nullptr) {
      table_ = &(*collection_)[words[1]];
      *table_ = {};
      for (std::size_t i = 2; i < words.size(); ++i) table_->kinds.push_back(read_kind(words[i]));
    } else if (words[0] == "row" && table_ != nullptr) {
      add_row(words);
    } else {
      refuse("this line is none of a table", "a collection comes first, then a table, then its rows",
             "write collection,NAME or table,LABEL,KIND,... or row,VALUE,...");
    }
  }

  TableKind read_kind(const std::string& word) const {
    if (word == "integer") return TableKind::integer;
    if (word == "float") return TableKind::number;
    if (word == "string") return TableKind::word;
    refuse(fmt::format("a column of the kind '{}'", word), "there are integer, float and string", "write one of them");
  }

  void add_row(const std::vector<std::string>& words) {
    if (words.size() != table_->kinds.size() + 1)
      refuse(fmt::format("a row of {} values", words.size() - 1), "its table has another number of columns",
             "correct the row or the table");
    for (std::size_t i = 0; i < table_->kinds.size(); ++i)
      table_->cells.push_back(read_cell(table_->kinds[i], words[i + 1]));
  }

  Cell read_cell(TableKind kind, const std::string& word) const {
    Cell cell;
    char* end = nullptr;
    if (kind == TableKind::word) cell.word = word;
    if (kind == TableKind::integer) cell.integer = static_cast<int>(std::strtol(word.c_str(), &end, 10));
    if (kind == TableKind::number) cell.number = std::strtod(word.c_str(), &end);
    if (end != nullptr && (end == word.c_str() || *end != '\0'))
      refuse(fmt::format("the value '{}'", word), "its column has numbers", "correct it");
    return cell;
  }

  std::string file_;
  int number_ = 0;
  Collection* collection_ = nullptr;
  UserTable* table_ = nullptr;
};

/// A table of the chosen collection; null: it has none of this label.
const UserTable* find_table(const char* label, std::size_t length) {
  if (chosen() == nullptr) return nullptr;
  const auto found = chosen()->find(read_fortran(label, length));
  return found == chosen()->end() ? nullptr : &found->second;
}

/// Where the code wants values of cells.
struct CellArrays {
  int* integers;
  double* numbers;
  char* words;
  std::size_t length;  // of a word
};
void write_cells(const UserTable& table, std::size_t first, std::size_t count, const CellArrays& to) {
  for (std::size_t i = 0; i < count; ++i) {
    const Cell& cell = table.cells[first + i];
    to.integers[i] = cell.integer;
    to.numbers[i] = cell.number;
    write_fortran(cell.word, to.words + i * to.length, to.length);
  }
}
void write_kinds(const UserTable& table, int* to) {
  for (const TableKind kind : table.kinds) *to++ = static_cast<int>(kind);
}

}  // namespace

void forget_user_tables() {
  chosen() = nullptr;
  all_tables().collections.clear();
}

void read_user_tables(const std::string& file) { TableReader(file).read(); }

}  // namespace percuss

using percuss::all_tables;

/// sizes: collections, then zeros.
PERCUSS_USER_ROUTINE void querytablecollectionsize_(int* sizes, int* error) {
  sizes[0] = static_cast<int>(all_tables().collections.size());
  *error = 0;
}
PERCUSS_USER_ROUTINE void querytablecollectionnames_(char* names, const int* count, std::size_t length) {
  auto next = all_tables().collections.begin();
  for (int i = 0; i < *count && next != all_tables().collections.end(); ++i, ++next)
    percuss::write_fortran(next->first, names + static_cast<std::size_t>(i) * length, length);
}
PERCUSS_USER_ROUTINE void settablecollection_(const char* name, int* error, std::size_t length) {
  const auto found = all_tables().collections.find(percuss::read_fortran(name, length));
  const bool is_known = found != all_tables().collections.end();
  percuss::chosen() = is_known ? &found->second : nullptr;
  *error = is_known ? 0 : 1;
}
PERCUSS_USER_ROUTINE void queryparametertable_(const char* label, int* columns, int* rows, int* error,
                                               std::size_t length) {
  const percuss::UserTable* const table = percuss::find_table(label, length);
  *columns = table == nullptr ? 0 : static_cast<int>(table->kinds.size());
  *rows = table == nullptr ? 0 : static_cast<int>(table->rows());
  *error = table == nullptr ? 1 : 0;
}
PERCUSS_USER_ROUTINE void getparametertable_(const char* label, const int*, int* kinds, int* integers, double* numbers,
                                             char* words, int* error, std::size_t length, std::size_t word) {
  const percuss::UserTable* const table = percuss::find_table(label, length);
  *error = table == nullptr ? 1 : 0;
  if (table == nullptr) return;
  percuss::write_kinds(*table, kinds);
  percuss::write_cells(*table, 0, table->cells.size(), {integers, numbers, words, word});
}
PERCUSS_USER_ROUTINE void getparametertablerow_(const char* label, const int* row, const int*, int* kinds,
                                                int* integers, double* numbers, char* words, int* error,
                                                std::size_t length, std::size_t word) {
  const percuss::UserTable* const table = percuss::find_table(label, length);
  const bool is_there = table != nullptr && *row >= 1 && static_cast<std::size_t>(*row) <= table->rows();
  *error = is_there ? 0 : 1;
  if (!is_there) return;
  const std::size_t columns = table->kinds.size();
  percuss::write_kinds(*table, kinds);
  percuss::write_cells(*table, static_cast<std::size_t>(*row - 1) * columns, columns, {integers, numbers, words, word});
}
