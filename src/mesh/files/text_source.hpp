#pragma once
// Text files of meshes, line by line, and errors that name the line.

#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace percuss {

/// A line of a file; errors name it.
struct TextPlace {
  int file = 0;  // place among TextNames
  int line = 0;  // from 1; 0: no line
};

/// Names of the files that make up a mesh: the main one, then what it includes.
class TextNames {
 public:
  int add(const std::string& path) {
    names_.push_back(path);
    return static_cast<int>(names_.size()) - 1;
  }
  std::size_t count() const { return names_.size(); }

  /// "car.k:12: "
  std::string at(TextPlace place) const;

  /// Throws InputError.
  [[noreturn]] void refuse(TextPlace place, const std::string& text) const;

 private:
  std::vector<std::string> names_;
};

/// A file in memory.
class TextSource {
 public:
  /// Throws SystemError if the file cannot be read, InputError if it is no regular file or too long.
  TextSource(const std::string& path, TextNames& names);

  /// The next line without its end; false at the end of the file.
  bool next_line(std::string_view& line);
  /// Goes back, so that the last line is read again.
  void step_back() {
    next_ = last_;
    --place_.line;
  }

  TextPlace place() const { return place_; }
  std::string_view text() const { return *text_; }

 private:
  std::shared_ptr<const std::string> text_;
  std::size_t next_ = 0, last_ = 0;
  TextPlace place_;
};

}  // namespace percuss
