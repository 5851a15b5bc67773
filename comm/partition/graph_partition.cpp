#include "comm/partition/graph_partition.hpp"

#include <metis.h>

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <string>
#include <type_traits>
#include <utility>

#include "comm/partition/even_out.hpp"
#include "kernels/core/counting_sort.hpp"

namespace percuss {

static_assert(std::is_same_v<idx_t, int>, "the graph is given to METIS as it is");

namespace {

/// METIS' manual: recursive bisection cuts better for few parts, direct k-way for more.
constexpr int most_parts_by_bisection = 8;

/// Room that METIS has for a small cut; even_out() brings the rest.
constexpr int imbalance_per_mille = 30;

const char* explain(int status) {
  if (status == METIS_ERROR_MEMORY) return "it found no memory";
  if (status == METIS_ERROR_INPUT) return "it refused the graph";
  return "no reason given";
}

void call_metis(const Graph& graph, int part_count, std::vector<int>& parts) {
  idx_t options[METIS_NOPTIONS];
  METIS_SetDefaultOptions(options);
  options[METIS_OPTION_SEED] = 1;
  options[METIS_OPTION_NUMBERING] = 0;
  options[METIS_OPTION_NCUTS] = 4;  // the best of four
  options[METIS_OPTION_UFACTOR] = imbalance_per_mille;
  // METIS takes everything as non-const but changes nothing of the graph.
  const auto open = [](const std::vector<int>& values) { return const_cast<idx_t*>(values.data()); };
  auto vertex_count = static_cast<idx_t>(graph.vertex_weights.size());
  idx_t constraint_count = 1, parts_wanted = part_count, cut = 0;
  const auto method = part_count <= most_parts_by_bisection ? METIS_PartGraphRecursive : METIS_PartGraphKway;
  const int status =
      method(&vertex_count, &constraint_count, open(graph.first), open(graph.neighbours), open(graph.vertex_weights),
             nullptr, open(graph.edge_weights), &parts_wanted, nullptr, nullptr, options, &cut, parts.data());
  if (status != METIS_OK) {
    throw PartitionError("METIS could not divide " + std::to_string(vertex_count) + " chunks in " +
                         std::to_string(part_count) + " parts (" + explain(status) + ")");
  }
}

void measure(const Graph& graph, int part_count, Partition& partition) {
  std::vector<long long> costs(static_cast<std::size_t>(part_count), 0);
  std::vector<int> counts(costs.size(), 0);
  for (std::size_t v = 0; v < partition.parts.size(); ++v) {
    const auto part = static_cast<std::size_t>(partition.parts[v]);
    costs[part] += graph.vertex_weights[v];
    ++counts[part];
    for (int e = graph.first[v]; e < graph.first[v + 1]; ++e) {
      const auto other = static_cast<std::size_t>(graph.neighbours[static_cast<std::size_t>(e)]);
      if (v < other && partition.parts[other] != partition.parts[v]) {
        partition.cut += graph.edge_weights[static_cast<std::size_t>(e)];
      }
    }
  }
  const long long total = std::accumulate(costs.begin(), costs.end(), 0LL);
  const long long heaviest = *std::max_element(costs.begin(), costs.end());
  partition.empty_parts = static_cast<int>(std::count(counts.begin(), counts.end(), 0));
  if (total > 0) partition.imbalance = static_cast<double>(heaviest) * part_count / static_cast<double>(total);
}

}  // namespace

Graph build_graph(const std::vector<GraphEdge>& edges, std::vector<int> costs) {
  struct Neighbour {
    int vertex = 0, weight = 0;
  };
  // Lower neighbours first: both passes ascend.
  auto by_vertex = collect_buckets<Neighbour>(costs.size(), [&](auto&& put) {
    for (const GraphEdge& edge : edges) put(static_cast<std::size_t>(edge.b), Neighbour{edge.a, edge.weight});
    for (const GraphEdge& edge : edges) put(static_cast<std::size_t>(edge.a), Neighbour{edge.b, edge.weight});
  });
  Graph graph;
  graph.vertex_weights = std::move(costs);
  graph.first = std::move(by_vertex.first);
  graph.neighbours.reserve(by_vertex.items.size());
  graph.edge_weights.reserve(by_vertex.items.size());
  for (const Neighbour& neighbour : by_vertex.items) {
    graph.neighbours.push_back(neighbour.vertex);
    graph.edge_weights.push_back(neighbour.weight);
  }
  return graph;
}

Partition partition_graph(const Graph& graph, int part_count) {
  if (part_count < 1)
    throw std::invalid_argument("a graph cannot be divided in " + std::to_string(part_count) + " parts");
  Partition partition;
  const auto vertex_count = static_cast<int>(graph.vertex_weights.size());
  partition.parts.assign(graph.vertex_weights.size(), 0);
  if (vertex_count <= part_count) {
    std::iota(partition.parts.begin(), partition.parts.end(), 0);
  } else if (part_count > 1) {
    call_metis(graph, part_count, partition.parts);
    fill_empty_parts(graph, part_count, partition.parts);
    even_out(graph, part_count, partition.parts);
  }
  measure(graph, part_count, partition);
  return partition;
}

Partition partition_for_ranks(const Communicator& ranks, const Graph& graph) {
  Partition partition;
  std::string failure;
  if (ranks.rank() == 0) {
    try {
      partition = partition_graph(graph, ranks.size());
    } catch (const PartitionError& error) {
      failure = error.what();
    }
  }
  const auto share = [&](void* values, std::size_t bytes) {
    wait_mpi([&] { return MPI_Bcast(values, static_cast<int>(bytes), MPI_BYTE, 0, ranks.handle()); }, "MPI_Bcast");
  };
  std::size_t sizes[2] = {failure.size(), partition.parts.size()};
  share(sizes, sizeof(sizes));
  failure.resize(sizes[0]);
  share(failure.data(), failure.size());
  if (!failure.empty()) throw PartitionError(failure);
  partition.parts.resize(sizes[1]);
  wait_mpi([&] { return MPI_Bcast(partition.parts.data(), static_cast<int>(sizes[1]), MPI_INT, 0, ranks.handle()); },
           "MPI_Bcast");
  share(&partition.empty_parts, sizeof(partition.empty_parts));
  share(&partition.imbalance, sizeof(partition.imbalance));
  share(&partition.cut, sizeof(partition.cut));
  return partition;
}

}  // namespace percuss
