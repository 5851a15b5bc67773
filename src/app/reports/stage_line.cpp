#include "src/app/reports/stage_line.hpp"

#include <fmt/format.h>
#include <unistd.h>

namespace percuss {
namespace {

constexpr const char* erase_line = "\r\x1b[K";

void print(std::FILE* stream, const std::string& text) {
  std::fputs(text.c_str(), stream);  // a closed reader ends no command
  std::fflush(stream);
}

}  // namespace

StageLine::StageLine(std::FILE* stream, Speaker speaker)
    : stream_(stream), is_shown_(speaker == Speaker::yes && ::isatty(::fileno(stream)) == 1) {}

StageLine::~StageLine() { clear(); }

void StageLine::show(std::string_view what) {
  if (!is_shown_) return;
  print(stream_, fmt::format("{}{} ...", erase_line, what));
  is_dirty_ = true;
}

void StageLine::clear() {
  if (is_dirty_) print(stream_, erase_line);
  is_dirty_ = false;
}

}  // namespace percuss
