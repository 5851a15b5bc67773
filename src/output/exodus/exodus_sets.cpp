#include "src/output/exodus/exodus_sets.hpp"

#include <algorithm>
#include <utility>

#include "comm/gather_items.hpp"
#include "src/index.hpp"

namespace percuss {
namespace {

/// A member of a set; of node sets without a side.
struct SetMemberInFile {
  std::int64_t number = 0, side = 0;
  friend auto operator<=>(const SetMemberInFile&, const SetMemberInFile&) = default;
};

/// Takes the members of all ranks into a set, if there are any.
void add_set(const std::string& name, const std::vector<SetMemberInFile>& own, const Communicator& ranks,
             std::vector<ExodusSet>& sets) {
  std::vector<SetMemberInFile> all = gather_items(ranks, own);
  if (all.empty()) return;
  std::sort(all.begin(), all.end());
  all.erase(std::unique(all.begin(), all.end()), all.end());  // nodes that several ranks hold
  ExodusSet set{name, {}, {}};
  for (const SetMemberInFile& member : all) {
    set.members.push_back(member.number);
    set.sides.push_back(member.side);
  }
  sets.push_back(std::move(set));
}

/// [local elements] numbers in the file, block after block, from 1.
std::vector<std::int64_t> number_elements(const Mesh& mesh, const std::vector<ExodusBlock>& blocks) {
  std::vector<std::int64_t> numbers(mesh.elements.size());
  std::int64_t first = 1;
  for (const ExodusBlock& block : blocks) {
    for (std::size_t i = 0; i < block.local.size(); ++i) numbers[at(block.local[i])] = first + block.places[i];
    first += block.elements;
  }
  return numbers;
}

std::int64_t find_side(const Topology& topology, int face) {
  const auto sides = topology.exodus_sides.begin();
  return 1 + (std::find(sides, sides + static_cast<std::ptrdiff_t>(topology.faces().size()), face) - sides);
}

}  // namespace

ExodusSets list_exodus_sets(const Mesh& mesh, const std::vector<ExodusBlock>& blocks, const FieldsOptions& options,
                            const Communicator& ranks) {
  ExodusSets sets;
  for (const std::string& name : options.node_sets) {
    std::vector<SetMemberInFile> own;
    for (const int node : mesh.node_sets.at(name)) own.push_back({mesh.node_numbers[at(node)] + 1, 0});
    add_set(name, own, ranks, sets.of_nodes);
  }
  if (options.side_sets.empty()) return sets;
  const std::vector<std::int64_t> numbers = number_elements(mesh, blocks);
  for (const std::string& name : options.side_sets) {
    std::vector<SetMemberInFile> own;
    for (const ElementFace& face : mesh.side_sets.at(name))
      own.push_back({numbers[at(face.element)], find_side(mesh.elements.topology_of(at(face.element)), face.face)});
    add_set(name, own, ranks, sets.of_sides);
  }
  return sets;
}

}  // namespace percuss
