// history.csv: what was written reads back to the same bits, and a disk that is full is told.

#include "src/output/history_file.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <fstream>
#include <limits>
#include <random>
#include <sstream>

#include "src/error.hpp"
#include "tests/expect_error.hpp"
#include "tests/src/output/sample_run.hpp"

namespace percuss {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

std::vector<std::string> read_lines(const std::string& path) {
  std::ifstream file(path);
  std::vector<std::string> lines;
  for (std::string line; std::getline(file, line);) lines.push_back(line);
  return lines;
}

std::vector<double> parse_row(const std::string& line) {
  std::vector<double> values;
  std::istringstream cells(line);
  for (std::string cell; std::getline(cells, cell, ',');) values.push_back(std::strtod(cell.c_str(), nullptr));
  return values;
}

bool same_bits(double a, double b) { return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b); }

TEST(HistoryFile, ReadsBackToTheSameBits) {
  std::mt19937_64 random(42);
  std::vector<double> values{0.0,
                             -0.0,
                             0.1,
                             1.0 / 3,
                             100000,
                             1e15,
                             9007199254740993.0,
                             1e300,
                             -2.5e-308,
                             std::numeric_limits<double>::denorm_min(),
                             std::numeric_limits<double>::max()};
  while (values.size() < 4000) {  // any bits that are a finite number
    const auto value = std::bit_cast<double>(random());
    if (std::isfinite(value)) values.push_back(value);
  }
  const sample::TemporaryFolder folder;
  const std::vector<std::string> columns{"a", "b"};
  {
    HistoryFile file(folder.file("history.csv"), columns);
    for (std::size_t i = 0; i < values.size(); i += 2) file.write_row(std::span(values).subspan(i, 2));
  }
  const auto lines = read_lines(folder.file("history.csv"));
  ASSERT_EQ(lines.size(), 1 + values.size() / 2);
  for (std::size_t i = 0; i < values.size(); i += 2) {
    const auto row = parse_row(lines[1 + i / 2]);
    EXPECT_TRUE(same_bits(row.at(0), values[i]) && same_bits(row.at(1), values[i + 1])) << lines[1 + i / 2];
  }
}

TEST(HistoryFile, WritesNumbersAsShortAsTheyCanBe) {
  EXPECT_EQ(format_number(0.1), "0.1");
  EXPECT_EQ(format_number(12345), "12345");
  EXPECT_EQ(format_number(100000), "100000");
  EXPECT_EQ(format_number(-0.0), "-0");
  EXPECT_EQ(format_number(2e-6), "2e-06");
  EXPECT_EQ(format_number(-std::numeric_limits<double>::quiet_NaN()), "nan");
  EXPECT_EQ(format_number(-std::numeric_limits<double>::infinity()), "-inf");
}

TEST(HistoryFile, QuotesHeadingsThatHoldACommaOrAQuote) {
  const sample::TemporaryFolder folder;
  const std::vector<std::string> columns{"time", "tip, left_x", "6\" rod"};
  { HistoryFile file(folder.file("history.csv"), columns); }
  EXPECT_THAT(read_lines(folder.file("history.csv")), ElementsAre("time,\"tip, left_x\",\"6\"\" rod\""));
}

TEST(HistoryFile, HasEveryRowOnTheDiskAfterAFlush) {
  const sample::TemporaryFolder folder;
  const std::vector<std::string> columns{"a"};
  HistoryFile file(folder.file("history.csv"), columns);
  const std::vector<double> row{7};
  file.write_row(row);
  file.flush();
  EXPECT_THAT(read_lines(folder.file("history.csv")), ElementsAre("a", "7"));
}

TEST(HistoryFile, RefusesARowOfAnotherLengthThanItsHeading) {
  const sample::TemporaryFolder folder;
  const std::vector<std::string> columns{"a", "b"};
  HistoryFile file(folder.file("history.csv"), columns);
  const std::vector<double> row{1, 2, 3};
  EXPECT_ERROR(file.write_row(row), std::logic_error, "has 3 values");
}

TEST(HistoryFile, TellsOnceThatTheDiskIsFull) {
  const std::vector<std::string> columns{"a"};
  ::setenv("PERCUSS_WAIT_FOR_SPACE", "0", 1);
  try {
    HistoryFile file("/dev/full", columns);
    FAIL() << "a heading went to a full disk";
  } catch (const SystemError& error) {
    EXPECT_THAT(error.what(), HasSubstr("cannot write '/dev/full' (No space left on device): free some space"));
  }
}

TEST(HistoryFile, NamesTheFileAndTheReasonWhenItsFolderIsAFile) {
  const std::vector<std::string> columns{"a"};
  try {
    HistoryFile file("/dev/null/history.csv", columns);
    FAIL() << "a file was created below a file";
  } catch (const SystemError& error) {
    EXPECT_THAT(error.what(), HasSubstr("'/dev/null/history.csv' (Not a directory)"));
  }
}

}  // namespace
}  // namespace percuss
