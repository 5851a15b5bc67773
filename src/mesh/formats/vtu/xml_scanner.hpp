#pragma once
// Tags of an XML file, one after the other, as VTK and master connection files have them. What such files do not have
// is an error: document types, CDATA, tags that do not match.

#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "src/mesh/files/text_source.hpp"

namespace percuss {

struct XmlTag {
  std::string_view name;
  std::map<std::string, std::string> attributes;
  bool closes = false;    // </NAME>; a tag <NAME/> opens and closes
  std::string_view text;  // between this tag and the next; of AppendedData all that follows
  TextPlace place;

  /// Empty: it is not given.
  std::string attribute(const std::string& key) const {
    const auto found = attributes.find(key);
    return found == attributes.end() ? std::string() : found->second;
  }
};

class XmlScanner {
 public:
  XmlScanner(std::string_view text, const TextNames& names) : text_(text), names_(names) {}

  /// False at the end of the file, or behind AppendedData. Throws InputError.
  bool next(XmlTag& tag);

  /// Names of the tags that are open, the outermost first.
  const std::vector<std::string_view>& open_tags() const { return open_; }
  bool is_within(std::string_view name) const;

 private:
  [[noreturn]] void refuse(const std::string& what) const { names_.refuse(place_, what); }
  void skip_to(std::size_t at);
  bool skip_remarks();
  void read_tag(XmlTag& tag);
  void read_attributes(XmlTag& tag);
  std::string_view take_name();
  void skip_blanks();
  void keep_open(XmlTag& tag);

  std::string_view text_;
  const TextNames& names_;
  std::size_t at_ = 0;
  TextPlace place_{0, 1};
  std::vector<std::string_view> open_;
  bool has_closed_itself_ = false;  // the last tag was <NAME/>
  bool is_done_ = false;
};

}  // namespace percuss
