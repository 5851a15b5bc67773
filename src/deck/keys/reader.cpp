#include "src/deck/keys/reader.hpp"

#include <fmt/format.h>

namespace percuss {

Reader Reader::inside(const std::string& name) const {
  Reader inner = *this;
  inner.prefix_ = name + ".";
  return inner;
}

Reader Reader::inside_named(const std::string& kind, const std::string& name) const {
  Reader inner(*reading_);
  inner.in_ = fmt::format(" in {} '{}'", kind, name);
  return inner;
}

std::string Reader::self() const {
  if (prefix_.empty()) return in_.empty() ? "the deck" : in_.substr(std::string(" in ").size());
  return fmt::format("'{}'{}", prefix_.substr(0, prefix_.size() - 1), in_);
}

void Reader::refuse(const Node& node, const std::string& name, const std::string& rule) const {
  if (node.broken) return;
  error(node.spot, fmt::format("{} is {}{} (must be {})", name, describe(node), in_, rule));
}

bool Reader::expect(const Node& node, Node::Kind kind, const std::string& name, const std::string& rule) const {
  if (node.kind == kind) return true;
  refuse(node, name, rule);
  return false;
}

}  // namespace percuss
