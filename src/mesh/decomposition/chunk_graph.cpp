#include "src/mesh/decomposition/chunk_graph.hpp"

#include <algorithm>
#include <bit>
#include <cstddef>
#include <numeric>

#include "comm/all_reduce.hpp"
#include "comm/exchange/item_exchange.hpp"
#include "src/fail_together.hpp"
#include "src/index.hpp"
#include "src/mesh/decomposition/element_costs.hpp"
#include "src/mesh/decomposition/near_chunks.hpp"
#include "src/mesh/decomposition/node_homes.hpp"

namespace percuss {
namespace {

/// [nodes] the chunk of each.
std::vector<int> list_using_chunks(const ChunkPieces& pieces) {
  std::vector<int> chunks;
  chunks.reserve(pieces.keys.size());
  for (std::size_t c = 0; c < pieces.chunks.size(); ++c) {
    chunks.insert(chunks.end(), at(pieces.first_node[c + 1] - pieces.first_node[c]), pieces.chunks[c]);
  }
  return chunks;
}

/// [chunks of the scene + 1]: numbers of the first node of each, from the nodes that own-ed chunks count.
std::vector<std::int64_t> number_first_nodes(const Communicator& ranks, int chunk_count, const std::vector<int>& users,
                                             const std::vector<int>& owners) {
  std::vector<std::int64_t> first(at(chunk_count) + 1, 0);
  for (std::size_t n = 0; n < owners.size(); ++n) {
    if (owners[n] == users[n]) ++first[at(owners[n]) + 1];
  }
  all_reduce(ranks, Reduce::sum, first);
  std::partial_sum(first.begin(), first.end(), first.begin());
  return first;
}

/// Nodes of a chunk lie in the order of their first use already.
std::vector<std::int64_t> number_owned_nodes(const std::vector<int>& users, const std::vector<int>& owners,
                                             const std::vector<std::int64_t>& first_node) {
  std::vector<std::int64_t> numbers(users.size(), -1);
  std::int64_t next = 0;
  int chunk = -1;
  for (std::size_t n = 0; n < users.size(); ++n) {
    if (users[n] != chunk) {
      chunk = users[n];
      next = first_node[at(chunk)];
    }
    if (owners[n] == chunk) numbers[n] = next++;
  }
  return numbers;
}

/// [chunks of the scene] sums over the elements of each, on every rank.
template <class Find>
std::vector<std::int64_t> sum_over_elements(const Communicator& ranks, const SceneParts& scene,
                                            const ChunkPieces& pieces, const Find& find) {
  std::vector<std::int64_t> sums(at(scene.chunk_count()), 0);
  for (std::size_t c = 0; c < pieces.chunks.size(); ++c) {
    for (int e = pieces.first_element[c]; e < pieces.first_element[c + 1]; ++e)
      sums[at(pieces.chunks[c])] += find(at(e));
  }
  all_reduce(ranks, Reduce::sum, sums);
  return sums;
}

/// [blocks of all parts]
std::vector<int> list_element_costs(const Deck& deck, const SceneParts& scene) {
  std::vector<int> costs;
  for (const ScenePart& part : scene.parts)
    for (const ElementBlock& block : part.blocks) costs.push_back(find_element_cost(deck, block));
  return costs;
}

/// A chunk in the message to rank 0.
struct BoxNotice {
  int chunk = 0;
  ChunkBox box;
};

/// [chunks of the scene] on rank 0.
std::vector<ChunkBox> gather_boxes(const Communicator& ranks, const SceneParts& scene, const ChunkPieces& pieces,
                                   const std::vector<std::int64_t>& faces) {
  std::vector<BoxNotice> notices;
  for (std::size_t c = 0; c < pieces.chunks.size(); ++c) {
    const auto first = at(pieces.first_node[c]), last = at(pieces.first_node[c + 1]);
    ChunkBox box{pieces.places[first], pieces.places[first], faces[at(pieces.chunks[c])]};
    for (std::size_t n = first; n < last; ++n) {
      for (std::size_t k = 0; k < 3; ++k) {
        box.low[k] = std::min(box.low[k], pieces.places[n][k]);
        box.high[k] = std::max(box.high[k], pieces.places[n][k]);
      }
    }
    notices.push_back({pieces.chunks[c], box});
  }
  std::vector<ChunkBox> boxes(ranks.rank() == 0 ? at(scene.chunk_count()) : 0);
  for (const BoxNotice& notice : ItemExchange(ranks).send(std::vector<int>(notices.size(), 0), notices))
    boxes[at(notice.chunk)] = notice.box;
  return boxes;
}

std::vector<int> find_costs(const std::vector<std::int64_t>& work, const std::vector<std::int64_t>& faces,
                            int face_cost) {
  std::vector<int> costs(faces.size());
  for (std::size_t c = 0; c < costs.size(); ++c) costs[c] = static_cast<int>(work[c] + face_cost * faces[c]);
  return costs;
}

}  // namespace

NumberedChunks number_chunks(const Deck& deck, const Communicator& ranks, const SceneParts& scene,
                             const ChunkPieces& pieces) {
  const std::vector<int> users = list_using_chunks(pieces);
  NodeHomes homes(ranks, pieces.keys, users, scene.keys);
  NumberedChunks numbered;
  {
    const std::vector<int> owners = homes.find_owners();
    numbered.numbering.first_element = scene.first_element;
    numbered.numbering.first_node = number_first_nodes(ranks, scene.chunk_count(), users, owners);
    numbered.numbers = homes.share_numbers(number_owned_nodes(users, owners, numbered.numbering.first_node));
  }
  std::vector<GraphEdge> edges = homes.gather_edges();
  const bool has_contact = deck.contact.surfaces != ContactDeck::Surfaces::none;
  const std::vector<std::int64_t> faces =
      sum_over_elements(ranks, scene, pieces, [&](std::size_t e) { return std::popcount(pieces.exterior[e]); });
  const std::vector<int> element_costs = list_element_costs(deck, scene);
  numbered.work =
      sum_over_elements(ranks, scene, pieces, [&](std::size_t e) { return element_costs[at(pieces.blocks[e])]; });
  std::vector<ChunkBox> boxes;
  if (has_contact) boxes = gather_boxes(ranks, scene, pieces, faces);
  std::vector<int> costs = find_costs(numbered.work, faces, has_contact ? contact_face_cost : 0);
  fail_together(ranks, [&] {
    if (ranks.rank() != 0) return;
    if (has_contact) edges = add_near_chunks(boxes, std::move(edges));
    numbered.graph = build_graph(edges, std::move(costs));
  });
  return numbered;
}

}  // namespace percuss
