#include "src/mesh/named_sets.hpp"

#include <algorithm>
#include <set>
#include <variant>

namespace percuss {
namespace {

using Names = std::set<std::string>;

/// Parts whose mesh is that of a file.
Names list_parts_of_files(const Deck& deck) {
  Names parts;
  for (const PartDeck& part : deck.parts) {
    if (std::holds_alternative<FileMesh>(part.shape)) parts.insert(part.name);
  }
  return parts;
}

/// named: by the deck, with the part's name or without.
template <class Sets>
std::vector<std::string> choose(const Sets& sets, const Names& named, const Names& parts_of_files) {
  std::vector<std::string> chosen;
  for (const auto& [name, members] : sets) {
    const std::size_t slash = name.find('/');
    if (slash == std::string::npos) continue;
    if (parts_of_files.contains(name.substr(0, slash)) || named.contains(name) ||
        named.contains(name.substr(slash + 1)))
      chosen.push_back(name);
  }
  return chosen;
}

}  // namespace

NamedSets find_named_sets(const Deck& deck, const Mesh& mesh) {
  Names named;
  for (const UsedSelector& used : deck.selectors) named.insert(used.where.name);
  const Names parts_of_files = list_parts_of_files(deck);
  return {choose(mesh.node_sets, named, parts_of_files), choose(mesh.side_sets, named, parts_of_files)};
}

}  // namespace percuss
