#pragma once
// Lines of reports on a terminal.

#include <fmt/format.h>

#include <string>

namespace percuss {

/// A label, in so many columns, and its text.
inline std::string format_line(const std::string& label, const std::string& text, int label_width = 10) {
  return fmt::format("{:<{}}{}\n", label, label_width, text);
}

/// "1 node", "2 nodes"
template <class Count>
std::string format_count(Count n, const std::string& what, const std::string& plural) {
  return fmt::format("{} {}", n, n == 1 ? what : plural);
}

}  // namespace percuss
