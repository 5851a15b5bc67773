#include "src/step/springs/connection_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "src/deck/text/table_text.hpp"
#include "src/mesh/files/text_numbers.hpp"
#include "src/mesh/formats/vtu/xml_scanner.hpp"

namespace percuss {
namespace {

// How deep tags lie: xmcf is at 1, connection_group at 2, connection_list and connected_to at 3.
constexpr std::size_t depth_of_groups = 2, depth_of_connections = 4, depth_of_contents = 5;

/// Names of elements of a connection that are not its kind.
constexpr std::array<std::string_view, 8> no_kinds{"loc",
                                                   "loc_list",
                                                   "face_list",
                                                   "appdata",
                                                   "femdata",
                                                   "custom_attributes_list",
                                                   "normal_direction",
                                                   "tangential_direction"};

std::string_view skip_byte_order_mark(std::string_view text) {
  return text.starts_with(byte_order_mark) ? text.substr(byte_order_mark.size()) : text;
}

/// The text without blanks and ends of lines at both ends.
std::string_view trim_lines(std::string_view text) {
  constexpr std::string_view blanks = " \t\r\n";
  const std::size_t first = text.find_first_not_of(blanks);
  return first == std::string_view::npos ? std::string_view()
                                         : text.substr(first, text.find_last_not_of(blanks) - first + 1);
}

class ConnectionReader {
 public:
  ConnectionReader(std::string_view text, const std::string& path, std::size_t most)
      : most_(most), scanner_(skip_byte_order_mark(text), names_) {
    names_.add(path);
  }

  ConnectionFile read() {
    XmlTag tag;
    while (scanner_.next(tag)) {
      if (!tag.closes) read_tag(tag);
      // <NAME/> has no tag that closes it: a connection ends where the next one begins, or its list does.
      const std::size_t depth = scanner_.open_tags().size();
      if (depth < depth_of_connections || (depth == depth_of_connections && !tag.closes)) end_connection();
      if (!tag.closes && is_connection(tag)) begin_connection(tag);
    }
    end_connection();
    if (!has_root_) refuse(tag, "the file has no tag");
    return std::move(file_);
  }

 private:
  [[noreturn]] void refuse(const XmlTag& tag, const std::string& what) const {
    names_.refuse(tag.place, "error: " + what);
  }

  bool is_connection(const XmlTag& tag) const {
    return scanner_.open_tags().size() == depth_of_connections && tag.name.starts_with("connection_") &&
           !file_.groups.empty();
  }

  void read_tag(const XmlTag& tag) {
    const std::size_t depth = scanner_.open_tags().size();
    if (depth < depth_of_groups) read_root(tag);
    if (depth == depth_of_groups && tag.name == "units") read_units(tag);
    if (depth == depth_of_groups && tag.name == "connection_group") file_.groups.emplace_back();
    if (file_.groups.empty()) return;
    if (tag.name == "part" && depth >= depth_of_connections && scanner_.is_within("connected_to")) read_part(tag);
    if (depth == depth_of_contents && is_open_) read_content(tag);
  }

  void read_root(const XmlTag& tag) {
    if (tag.name != "xmcf")
      refuse(tag, fmt::format("the file begins with <{}> (<xmcf> of a master connection file is expected, or a table "
                              "of rows x, y, z)",
                              tag.name));
    has_root_ = true;
  }

  void read_units(const XmlTag& tag) {
    constexpr std::array<std::pair<std::string_view, double>, 4> lengths{
        {{"mm", 1e-3}, {"m", 1}, {"in", 0.0254}, {"ft", 0.3048}}};
    const std::string name = tag.attribute("length");
    if (name.empty()) return;
    const auto* found =
        std::find_if(lengths.begin(), lengths.end(), [&](const auto& one) { return one.first == name; });
    if (found == lengths.end())
      refuse(tag, fmt::format("unit {} of length is not known (it is mm, m, in or ft)", quote_field(name)));
    file_.length_in_si = found->second;
  }

  void read_part(const XmlTag& tag) {
    std::vector<std::string> names;
    for (const char* key : {"label", "pname", "pid"})
      if (const std::string name = tag.attribute(key); !name.empty()) names.push_back(name);
    file_.groups.back().parts.push_back(std::move(names));
  }

  void begin_connection(const XmlTag& tag) {
    is_open_ = true;
    spot_ = WeldPoint{};
    kind_.clear();
    begin_ = tag;
  }

  void read_content(const XmlTag& tag) {
    if (tag.name == "loc" && spot_.line == 0) read_place(tag);
    const bool is_kind = std::find(no_kinds.begin(), no_kinds.end(), tag.name) == no_kinds.end();
    if (!is_kind || !kind_.empty()) return;
    kind_ = tag.name;
    const std::string diameter = kind_ == "spotweld" ? tag.attribute("diameter") : "";
    if (diameter.empty()) return;
    const auto value = parse_real(trim_lines(diameter));
    if (!value || !(*value > 0))
      refuse(tag, fmt::format("diameter {} is not a positive number", quote_field(diameter)));
    spot_.radius = 0.5 * *value;
  }

  void read_place(const XmlTag& tag) {
    std::string_view rest = trim_lines(tag.text);
    for (std::size_t c = 0; c < 3; ++c) {
      const std::size_t end = std::min(rest.find_first_of(" \t\r\n"), rest.size());
      const auto value = parse_real(rest.substr(0, end));
      rest = trim_lines(rest.substr(end));
      if (!value || (c == 2) != rest.empty())
        refuse(tag, fmt::format("<loc> has {} (it must be three numbers with blanks between them)",
                                quote_field(trim_lines(tag.text))));
      spot_.at[c] = *value;
    }
    spot_.line = tag.place.line;
  }

  void end_connection() {
    if (!is_open_) return;
    is_open_ = false;
    ConnectionGroup& into = file_.groups.back();
    if (begin_.name != "connection_0d" || kind_ != "spotweld") {
      ++into.others[kind_.empty() ? std::string(begin_.name) : kind_];
      return;
    }
    if (spot_.line == 0) refuse(begin_, "a spot weld has no <loc>");
    into.spots.push_back(spot_);
    if (++count_ > most_) refuse(begin_, fmt::format("the file has more than {} spot welds: divide it", most_));
  }

  std::size_t most_, count_ = 0;
  TextNames names_;
  XmlScanner scanner_;
  ConnectionFile file_;
  bool has_root_ = false, is_open_ = false;
  XmlTag begin_;      // of the connection that is open
  WeldPoint spot_{};  // of it, so far
  std::string kind_;
};

}  // namespace

bool is_connection_file(std::string_view text) { return trim_lines(skip_byte_order_mark(text)).starts_with('<'); }

ConnectionFile parse_connections(std::string_view text, const std::string& path, std::size_t most) {
  return ConnectionReader(text, path, most).read();
}

}  // namespace percuss
