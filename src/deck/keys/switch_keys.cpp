#include "src/deck/keys/switch_keys.hpp"

namespace percuss {

bool SensorNameValue::read(const Reader& reader, const std::string& name, const Node& node, std::string& out) const {
  if (!NameValue{}.read(reader, name, node, out)) return false;
  reader.reading().sensors.push_back({node.spot, out, fmt::format(" in {}", name)});
  return true;
}

}  // namespace percuss
