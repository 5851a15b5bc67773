#include "src/mesh/decomposition/node_homes.hpp"

#include <algorithm>
#include <cstddef>

namespace percuss {
namespace {

/// Calls visit(first, last) for every run of uses of one node.
template <class Uses, class Visit>
void for_each_node(const Uses& uses, const Visit& visit) {
  for (std::size_t first = 0; first < uses.size();) {
    std::size_t last = first + 1;
    while (last < uses.size() && uses[last].key == uses[first].key) ++last;
    visit(first, last);
    first = last;
  }
}

bool is_before(const GraphEdge& a, const GraphEdge& b) { return a.a != b.a ? a.a < b.a : a.b < b.b; }

/// Ascending, each pair once.
void merge_edges(std::vector<GraphEdge>& edges) {
  std::sort(edges.begin(), edges.end(), is_before);
  std::size_t count = 0;
  for (const GraphEdge& edge : edges) {
    if (count > 0 && edges[count - 1].a == edge.a && edges[count - 1].b == edge.b) {
      edges[count - 1].weight += edge.weight;
    } else {
      edges[count++] = edge;
    }
  }
  edges.resize(count);
}

}  // namespace

NodeHomes::NodeHomes(const Communicator& ranks, const std::vector<std::int64_t>& keys, const std::vector<int>& chunks,
                     std::int64_t key_count)
    : exchange_(ranks), data_(ranks) {
  const std::int64_t range = std::max<std::int64_t>(1, (key_count + ranks.size() - 1) / ranks.size());
  std::vector<int> homes(keys.size());
  std::transform(keys.begin(), keys.end(), homes.begin(), [&](auto key) { return static_cast<int>(key / range); });
  order_ = order_by_destination(homes);
  plan_ = exchange_.plan(order_.to);
  std::vector<Use> sent(keys.size());
  for (std::size_t i = 0; i < sent.size(); ++i) {
    const auto use = static_cast<std::size_t>(order_.items[i]);
    sent[i] = {keys[use], chunks[use], 0};
  }
  uses_ = data_.exchange(plan_, sent);
  for (std::size_t i = 0; i < uses_.size(); ++i) uses_[i].place = static_cast<int>(i);
  std::sort(uses_.begin(), uses_.end(),
            [](const Use& a, const Use& b) { return a.key != b.key ? a.key < b.key : a.chunk < b.chunk; });
}

template <class T>
std::vector<T> NodeHomes::send_back(const std::vector<T>& answers) {
  const std::vector<T> ordered = data_.exchange(reverse(plan_), answers);
  std::vector<T> result(ordered.size());
  for (std::size_t i = 0; i < ordered.size(); ++i) result[static_cast<std::size_t>(order_.items[i])] = ordered[i];
  return result;
}

std::vector<int> NodeHomes::find_owners() {
  std::vector<int> owners(uses_.size());
  for_each_node(uses_, [&](std::size_t first, std::size_t last) {
    for (std::size_t i = first; i < last; ++i) owners[static_cast<std::size_t>(uses_[i].place)] = uses_[first].chunk;
  });
  return send_back(owners);
}

std::vector<std::int64_t> NodeHomes::share_numbers(const std::vector<std::int64_t>& numbers) {
  const std::vector<std::int64_t> received = data_.exchange(plan_, ItemExchange::arrange(order_, numbers));
  std::vector<std::int64_t> answers(received.size());
  for_each_node(uses_, [&](std::size_t first, std::size_t last) {
    const std::int64_t number = received[static_cast<std::size_t>(uses_[first].place)];
    for (std::size_t i = first; i < last; ++i) answers[static_cast<std::size_t>(uses_[i].place)] = number;
  });
  return send_back(answers);
}

std::vector<GraphEdge> NodeHomes::count_shared() const {
  std::vector<GraphEdge> edges;
  for_each_node(uses_, [&](std::size_t first, std::size_t last) {
    for (std::size_t i = first; i < last; ++i) {
      for (std::size_t j = i + 1; j < last; ++j) edges.push_back({uses_[i].chunk, uses_[j].chunk, 1});
    }
  });
  merge_edges(edges);
  return edges;
}

std::vector<GraphEdge> NodeHomes::gather_edges() {
  const std::vector<GraphEdge> own = count_shared();
  const ExchangePlan to_first = exchange_.plan({{0, 0, static_cast<std::int64_t>(own.size())}});
  std::vector<GraphEdge> edges = data_.exchange(to_first, own);
  merge_edges(edges);
  return edges;
}

}  // namespace percuss
