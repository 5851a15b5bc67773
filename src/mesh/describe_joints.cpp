#include "src/mesh/describe_joints.hpp"

#include <fmt/format.h>

#include "src/index.hpp"

namespace percuss {

std::vector<std::string> describe_joints(const Mesh& mesh) {
  constexpr std::size_t most = 20;
  std::vector<std::string> texts;
  for (const PartJoint& joint : mesh.joints) {
    if (texts.size() == most) {
      texts.push_back(fmt::format("and {} more", mesh.joints.size() - most));
      break;
    }
    const std::string apart =
        joint.farthest > 0 ? fmt::format(" (merged from up to {:.2g} apart)", joint.farthest) : "";
    texts.push_back(fmt::format("'{}' and '{}' share {} node{}{}", mesh.parts[at(joint.part)].name,
                                mesh.parts[at(joint.other)].name, joint.nodes, joint.nodes == 1 ? "" : "s", apart));
  }
  return texts;
}

}  // namespace percuss
