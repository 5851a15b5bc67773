// The line that tells what a command is doing.

#include "src/app/reports/stage_line.hpp"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <array>
#include <cstdlib>
#include <string>

namespace percuss {
namespace {

void show_two(std::FILE* stream, StageLine::Speaker speaker) {
  StageLine line(stream, speaker);
  line.show("reading");
  line.show("building");
}

/// Text that the lines leave on a terminal.
std::string show_on_terminal(StageLine::Speaker speaker) {
  const int terminal = posix_openpt(O_RDWR | O_NOCTTY);
  EXPECT_EQ(grantpt(terminal), 0);
  EXPECT_EQ(unlockpt(terminal), 0);
  std::FILE* const stream = fdopen(open(ptsname(terminal), O_RDWR | O_NOCTTY), "w");
  show_two(stream, speaker);
  std::fputs("$", stream);  // so that there is something to read
  std::fflush(stream);
  std::string text;
  std::array<char, 256> part{};
  while (text.find('$') == std::string::npos) {  // a terminal hands over what it has, in any pieces
    const ssize_t count = read(terminal, part.data(), part.size());
    if (count <= 0) break;
    text.append(part.data(), static_cast<std::size_t>(count));
  }
  std::fclose(stream);
  close(terminal);
  return text;
}

TEST(StageLine, IsOverwrittenAndGoneAtTheEnd) {
  EXPECT_EQ(show_on_terminal(StageLine::Speaker::yes), "\r\x1b[Kreading ...\r\x1b[Kbuilding ...\r\x1b[K$");
  EXPECT_EQ(show_on_terminal(StageLine::Speaker::no), "$");
}

TEST(StageLine, IsForTerminalsOnly) {
  std::FILE* const file = std::tmpfile();
  show_two(file, StageLine::Speaker::yes);
  EXPECT_EQ(std::ftell(file), 0);
  std::fclose(file);
}

}  // namespace
}  // namespace percuss
