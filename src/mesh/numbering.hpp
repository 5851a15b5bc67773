#pragma once
// The chunk and the rank of each node and element of the whole mesh: the same table on every rank.
//
// Elements are numbered chunk after chunk. A node belongs to the lowest chunk that uses it, and nodes are numbered
// chunk after chunk too, so that a node's number gives its chunk and its owner. This is the one table of the mesh that
// does not shrink with the number of ranks: five words a chunk.

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace percuss {

struct Numbering {
  std::vector<std::int64_t> first_element;  // [chunks + 1] number of the first element of each chunk
  std::vector<std::int64_t> first_node;     // [chunks + 1] number of the first node that belongs to it
  std::vector<int> ranks;                   // [chunks] who holds it

  int chunk_count() const { return static_cast<int>(ranks.size()); }
  std::int64_t element_count() const { return first_element.empty() ? 0 : first_element.back(); }
  std::int64_t node_count() const { return first_node.empty() ? 0 : first_node.back(); }

  /// The rank that owns a node (element): that of its chunk. O(log chunks).
  int find_node_owner(std::int64_t node) const { return ranks[find_chunk(first_node, node)]; }
  int find_element_owner(std::int64_t element) const { return ranks[find_chunk(first_element, element)]; }

  static std::size_t find_chunk(const std::vector<std::int64_t>& first, std::int64_t number) {
    return static_cast<std::size_t>(std::upper_bound(first.begin(), first.end(), number) - first.begin()) - 1;
  }
};

/// The owners of nodes that are requested in nearly ascending order: the next is mostly of the same chunk.
class NodeOwners {
 public:
  explicit NodeOwners(const Numbering& numbering) : numbering_(numbering) {}

  int find(std::int64_t node) {
    const std::vector<std::int64_t>& first = numbering_.first_node;
    if (node < first[chunk_] || node >= first[chunk_ + 1]) chunk_ = Numbering::find_chunk(first, node);
    return numbering_.ranks[chunk_];
  }

  std::vector<int> find(const std::vector<std::int64_t>& nodes) {
    std::vector<int> owners;
    owners.reserve(nodes.size());
    for (const std::int64_t node : nodes) owners.push_back(find(node));
    return owners;
  }

 private:
  const Numbering& numbering_;
  std::size_t chunk_ = 0;
};

}  // namespace percuss
