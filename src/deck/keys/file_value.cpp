#include "src/deck/keys/file_value.hpp"

#include <filesystem>
#include <system_error>

namespace percuss {

bool FileValue::read(const Reader& reader, const std::string& name, const Node& node, std::string& out) const {
  if (!reader.expect(node, Node::Kind::scalar, name, takes())) return false;
  const std::filesystem::path path = std::filesystem::path(reader.reading().folder) / node.text;
  std::error_code unreadable;
  const bool is_folder = !node.text.empty() && std::filesystem::is_directory(path, unreadable);
  if (is_folder || node.text.empty() || !std::filesystem::exists(path, unreadable)) {
    const std::string why = is_folder ? path.string() + " is a folder" : "there is no file " + path.string();
    reader.error(node.spot, fmt::format("{} is {}{} ({})", name, describe(node), reader.in(), why));
    return false;
  }
  out = path.string();
  return true;
}

}  // namespace percuss
