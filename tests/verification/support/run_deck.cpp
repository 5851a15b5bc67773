#include "tests/verification/support/run_deck.hpp"

#include <fmt/format.h>
#include <stdlib.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <limits>
#include <sstream>
#include <stdexcept>

#include "comm/agreement.hpp"
#include "src/deck/reading/read_deck.hpp"
#include "src/step/run/run.hpp"

namespace percuss::test {

TemporaryFolder::TemporaryFolder() {
  path_ = (std::filesystem::temp_directory_path() / "percuss_test_XXXXXX").string();
  if (mkdtemp(path_.data()) == nullptr) throw std::runtime_error("no folder can be made at " + path_);
}

TemporaryFolder::~TemporaryFolder() {
  std::error_code ignored;
  std::filesystem::remove_all(path_, ignored);
}

SharedFolder::SharedFolder() : path_(broadcast_text(Communicator::world(), own_.path(), 0)) {}
SharedFolder::~SharedFolder() { Communicator::world().barrier(); }

TemporaryFile::~TemporaryFile() {
  std::error_code ignored;
  std::filesystem::remove(path_, ignored);
}

HistoryTable::HistoryTable(const std::string& file) {
  std::ifstream in(file);
  std::string line, cell;
  if (!std::getline(in, line)) throw std::runtime_error(file + " cannot be read");
  std::vector<std::vector<double>*> order;
  std::istringstream heading(line);
  while (std::getline(heading, cell, ',')) order.push_back(&columns_[cell]);
  while (std::getline(in, line)) {
    std::istringstream row(line);
    for (std::vector<double>* column : order) {
      if (!std::getline(row, cell, ','))
        throw std::runtime_error(fmt::format("row {} of {} is short", rows_ + 1, file));
      column->push_back(std::strtod(cell.c_str(), nullptr));  // stod refuses denormal numbers
    }
    ++rows_;
  }
}

const std::vector<double>& HistoryTable::operator[](const std::string& column) const {
  const auto found = columns_.find(column);
  if (found == columns_.end()) throw std::out_of_range("history.csv has no column " + column);
  return found->second;
}

double HistoryTable::largest(const std::string& column) const {
  const std::vector<double>& values = (*this)[column];
  return *std::max_element(values.begin(), values.end());
}

double HistoryTable::smallest(const std::string& column) const {
  const std::vector<double>& values = (*this)[column];
  return *std::min_element(values.begin(), values.end());
}

double HistoryTable::at(double time, const std::string& column) const {
  const std::vector<double>&t = (*this)["time"], &values = (*this)[column];
  const auto above = std::lower_bound(t.begin(), t.end(), time);
  if (above == t.begin()) return values.front();
  if (above == t.end()) return values.back();
  const auto i = static_cast<std::size_t>(above - t.begin());
  return values[i - 1] + (values[i] - values[i - 1]) * (time - t[i - 1]) / (t[i] - t[i - 1]);
}

double HistoryTable::mean(double start, double end, const std::string& column) const {
  const std::vector<double>&t = (*this)["time"], &values = (*this)[column];
  double sum = 0, length = 0;
  for (std::size_t i = 1; i < rows_; ++i) {
    if (t[i - 1] < start || t[i] > end) continue;
    sum += 0.5 * (values[i - 1] + values[i]) * (t[i] - t[i - 1]);
    length += t[i] - t[i - 1];
  }
  return sum / length;
}

double HistoryTable::time_of_rise(const std::string& column, double level) const {
  const std::vector<double>&t = (*this)["time"], &values = (*this)[column];
  for (std::size_t i = 1; i < rows_; ++i) {
    if (values[i - 1] < level && values[i] >= level) {
      return t[i - 1] + (t[i] - t[i - 1]) * (level - values[i - 1]) / (values[i] - values[i - 1]);
    }
  }
  return std::numeric_limits<double>::quiet_NaN();
}

Outcome run_deck(const Deck& deck) {
  const TemporaryFolder folder;
  Outcome outcome;
  outcome.summary = run_scene(deck, {folder.path(), Progress::Style::quiet}).summary;
  if (deck.output.history_every) outcome.history = HistoryTable(folder.path() + "/history.csv");
  fmt::print("{}: {} elements, {} steps, {:.2f} s, energy error {:.1e}\n", deck.title.empty() ? "run" : deck.title,
             outcome.summary.elements, outcome.summary.steps, outcome.summary.loop_s, outcome.summary.energy.error);
  return outcome;
}

Outcome run_deck(const std::string& text, const std::vector<std::string>& overrides) {
  return run_deck(parse_deck(text, "deck.yaml", overrides));
}

}  // namespace percuss::test
