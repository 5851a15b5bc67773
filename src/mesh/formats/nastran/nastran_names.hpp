#pragma once
// Names of properties and sets in comments of Nastran files, as preprocessors write them (HyperMesh, ANSA, Femap,
// Patran, Simcenter); docs/mesh.md lists them.

#include <cstdint>
#include <map>
#include <string>
#include <string_view>

namespace percuss {

enum class NastranSetKind : std::uint8_t { unknown, nodes, elements, properties };

class NastranNames {
 public:
  void take_comment(std::string_view comment);
  /// An entry follows the comments taken last; property: its id, 0: it is no property. Some names stand before their
  /// property without its id.
  void take_entry(std::int64_t property);

  /// Names by the ids of properties.
  std::map<std::int64_t, std::string> list_properties() const;
  /// Empty: none.
  std::string find_set(std::int64_t id) const;
  NastranSetKind find_kind(std::int64_t set) const;

 private:
  void take_hypermesh(std::string_view text);
  void take_ansa(std::string_view text);
  void take_femap(std::string_view text);

  std::map<std::int64_t, std::string> properties_, components_, sets_;
  std::map<std::int64_t, NastranSetKind> kinds_;
  std::string next_;                // of the property that follows
  std::int64_t ansa_property_ = 0;  // whose name is the next comment
};

}  // namespace percuss
