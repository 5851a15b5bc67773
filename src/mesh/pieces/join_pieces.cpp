#include "src/mesh/pieces/join_pieces.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <numeric>
#include <tuple>

#include "comm/agreement.hpp"
#include "comm/exchange/item_exchange.hpp"
#include "src/index.hpp"

namespace percuss {
namespace {

/// A use of a joined node by a chunk of this rank.
struct Use {
  int node = 0;  // of the pieces
  std::size_t chunk = 0;
  int part = 0;
};

/// Nodes of the pieces that several parts have; they get what they have in common.
std::vector<Use> join_nodes(const SceneParts& scene, ChunkPieces& pieces) {
  std::vector<Use> uses;
  for (std::size_t c = 0; c < pieces.chunks.size(); ++c) {
    for (int n = pieces.first_node[c]; n < pieces.first_node[c + 1]; ++n) {
      std::int64_t& key = pieces.keys[at(n)];
      const auto found = std::lower_bound(scene.joined.begin(), scene.joined.end(), key,
                                          [](const JoinedNode& joined, std::int64_t k) { return joined.key < k; });
      if (found == scene.joined.end() || found->key != key) continue;
      key = found->root;
      pieces.node_ids[at(n)] = found->id;
      pieces.places[at(n)] = found->place;
      uses.push_back({n, c, pieces.parts[c]});
    }
  }
  return uses;
}

/// A face all of whose corners are joined.
struct FaceNotice {
  std::array<std::int64_t, 4> keys{};  // ascending, beyond the last the largest
  int rank = 0, element = 0, face = 0;
};

struct FaceAnswer {
  int element = 0, face = 0;
};

/// Joins the pieces of one rank to those of the others.
class PieceJoiner {
 public:
  PieceJoiner(const Communicator& ranks, const SceneParts& scene, ChunkPieces& pieces)
      : ranks_(ranks), scene_(scene), pieces_(pieces), exchange_(ranks), uses_(join_nodes(scene, pieces)) {
    is_joined_.assign(pieces.keys.size(), 0);
    for (const Use& use : uses_) is_joined_[at(use.node)] = 1;
    for (const ScenePart& part : scene.parts) {
      for (const ElementBlock& block : part.blocks) topologies_.push_back(block.topology);
    }
  }

  void join() {
    close_faces();
    join_bodies();
    share_sets();
  }

 private:
  int find_home(std::int64_t key) const { return static_cast<int>(key % ranks_.size()); }

  /// Faces of two solids are exterior to each part alone.
  void close_faces() {
    std::vector<int> homes;
    std::vector<FaceNotice> notices;
    for (std::size_t c = 0; c < pieces_.chunks.size(); ++c) {
      for (int e = pieces_.first_element[c]; e < pieces_.first_element[c + 1]; ++e) add_faces(c, e, homes, notices);
    }
    std::vector<FaceNotice> received = exchange_.send(homes, notices);
    std::sort(received.begin(), received.end(), [](const FaceNotice& a, const FaceNotice& b) {
      return std::tie(a.keys, a.rank, a.element, a.face) < std::tie(b.keys, b.rank, b.element, b.face);
    });
    homes.clear();
    std::vector<FaceAnswer> answers;
    for (std::size_t first = 0, last = 0; first < received.size(); first = last) {
      while (last < received.size() && received[last].keys == received[first].keys) ++last;
      for (std::size_t i = first; last - first > 1 && i < last; ++i) {
        homes.push_back(received[i].rank);
        answers.push_back({received[i].element, received[i].face});
      }
    }
    for (const FaceAnswer& inner : exchange_.send(homes, answers)) {
      std::uint8_t& mask = pieces_.exterior[at(inner.element)];
      mask = static_cast<std::uint8_t>(mask & ~(1U << inner.face));
    }
  }

  void add_faces(std::size_t chunk, int element, std::vector<int>& homes, std::vector<FaceNotice>& notices) const {
    const Topology& topology = find_topology(topologies_[at(pieces_.blocks[at(element)])]);
    const unsigned mask = pieces_.exterior[at(element)];
    if (!topology.is_solid() || mask == 0) return;
    for (int f = 0; f < topology.face_count; ++f) {
      if ((mask >> f & 1) == 0) continue;
      FaceNotice notice{{}, ranks_.rank(), element, f};
      notice.keys.fill(std::numeric_limits<std::int64_t>::max());
      std::size_t count = 0;
      bool are_joined = true;
      for (const int corner : topology.face_table[at(f)].corners()) {
        const std::size_t node = pieces_.find_node(chunk, at(element), at(corner));
        are_joined = are_joined && is_joined_[node] != 0;
        notice.keys[count++] = pieces_.keys[node];
      }
      if (!are_joined) continue;
      std::sort(notice.keys.begin(), notice.keys.end());
      homes.push_back(find_home(notice.keys[0]));
      notices.push_back(notice);
    }
  }

  struct BodyNotice {
    std::int64_t key = 0;
    int body = 0;
    friend auto operator<=>(const BodyNotice&, const BodyNotice&) = default;
  };

  void join_bodies() {
    std::vector<BodyNotice> notices;
    for (std::size_t c = 0; c < pieces_.chunks.size(); ++c) {
      for (int e = pieces_.first_element[c]; e < pieces_.first_element[c + 1]; ++e) {
        for (std::size_t i = 0; i < pieces_.count_corners(at(e)); ++i) {
          const std::size_t node = pieces_.find_node(c, at(e), i);
          if (is_joined_[node] != 0) notices.push_back({pieces_.keys[node], pieces_.bodies[at(e)]});
        }
      }
    }
    std::sort(notices.begin(), notices.end());
    notices.erase(std::unique(notices.begin(), notices.end()), notices.end());
    notices = exchange_.send(std::vector<int>(notices.size(), 0), notices);
    std::vector<int> numbers;
    if (ranks_.rank() == 0) numbers = number_bodies(std::move(notices));
    broadcast_values(ranks_, numbers, 0);
    for (int& body : pieces_.bodies) body = numbers[at(body)];
  }

  /// [bodies of the parts] number of the body that each is in, counted on in their order.
  std::vector<int> number_bodies(std::vector<BodyNotice> notices) const {
    const ScenePart& last = scene_.parts.back();
    std::vector<int> parent(at(last.first_body + last.bodies));
    std::iota(parent.begin(), parent.end(), 0);
    const auto find_root = [&](int body) {
      while (parent[at(body)] != body) body = parent[at(body)] = parent[at(parent[at(body)])];
      return body;
    };
    std::sort(notices.begin(), notices.end());
    for (std::size_t i = 1; i < notices.size(); ++i) {
      if (notices[i].key != notices[i - 1].key) continue;
      const int a = find_root(notices[i - 1].body), b = find_root(notices[i].body);
      parent[at(std::max(a, b))] = std::min(a, b);
    }
    std::vector<int> numbers(parent.size());
    int count = 0;
    for (std::size_t body = 0; body < parent.size(); ++body) {
      const int root = find_root(static_cast<int>(body));
      numbers[body] = root == static_cast<int>(body) ? count++ : numbers[at(root)];
    }
    return numbers;
  }

  /// A use of a node without a set, or a set that the node is in.
  struct SetNotice {
    std::int64_t key = 0;
    int set = -1, rank = 0, node = 0;
  };

  struct SetAnswer {
    int node = 0, set = 0;
  };

  /// A rank that holds a node of a set must know, whichever part has the set: conditions act on every copy of a node.
  void share_sets() {
    const ScenePart& last = scene_.parts.back();
    const int sets = last.first_node_set + static_cast<int>(last.node_sets.size());
    std::vector<int> homes;
    std::vector<SetNotice> notices;
    const auto add = [&](int node, int set) {
      const std::int64_t key = pieces_.keys[at(node)];
      homes.push_back(find_home(key));
      notices.push_back({key, set, ranks_.rank(), node});
    };
    for (const Use& use : uses_) {
      add(use.node, -1);
      add(use.node, sets + use.part);
    }
    for (const SetMember& member : pieces_.node_members) {
      if (is_joined_[at(member.item)] != 0) add(member.item, member.set);
    }
    std::vector<SetNotice> received = exchange_.send(homes, notices);
    std::sort(received.begin(), received.end(), [](const SetNotice& a, const SetNotice& b) {
      return std::tie(a.key, a.set, a.rank, a.node) < std::tie(b.key, b.set, b.rank, b.node);
    });
    homes.clear();
    std::vector<SetAnswer> answers;
    for (std::size_t first = 0, end = 0; first < received.size(); first = end) {
      while (end < received.size() && received[end].key == received[first].key) ++end;
      std::size_t first_set = first;
      while (first_set < end && received[first_set].set < 0) ++first_set;
      for (std::size_t s = first_set; s < end; ++s) {
        if (s > first_set && received[s].set == received[s - 1].set) continue;
        for (std::size_t use = first; use < first_set; ++use) {
          homes.push_back(received[use].rank);
          answers.push_back({received[use].node, received[s].set});
        }
      }
    }
    for (const SetAnswer& answer : exchange_.send(homes, answers))
      pieces_.node_members.push_back({answer.node, answer.set, 0});
  }

  const Communicator& ranks_;
  const SceneParts& scene_;
  ChunkPieces& pieces_;
  ItemExchange exchange_;
  std::vector<Use> uses_;
  std::vector<char> is_joined_;  // [nodes of the pieces]
  std::vector<TopologyKind> topologies_;
};

}  // namespace

void join_pieces(const Communicator& ranks, const SceneParts& scene, ChunkPieces& pieces) {
  if (!scene.joined.empty()) PieceJoiner(ranks, scene, pieces).join();
}

}  // namespace percuss
