#pragma once
// What a command that takes a while is doing, on a terminal.

#include <cstdio>
#include <string_view>

namespace percuss {

/// One line that is overwritten by the next and gone at the end. Prints nothing on what is no terminal.
class StageLine {
 public:
  enum class Speaker { no, yes };  // one rank speaks

  StageLine(std::FILE* stream, Speaker speaker);
  ~StageLine();
  StageLine(const StageLine&) = delete;
  StageLine& operator=(const StageLine&) = delete;

  void show(std::string_view what);

  /// Removes the line, before other text follows.
  void clear();

 private:
  std::FILE* stream_;
  bool is_shown_, is_dirty_ = false;
};

}  // namespace percuss
