#include "src/mesh/decomposition/near_chunks.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <limits>
#include <numeric>
#include <tuple>

namespace percuss {
namespace {

/// Pairs of boxes a chunk, on the mean, above which chunks are not compact enough for a comparison of boxes.
constexpr std::size_t most_pairs = 64;

Vec3 find_extents(const ChunkBox& chunk) {
  return {chunk.high[0] - chunk.low[0], chunk.high[1] - chunk.low[1], chunk.high[2] - chunk.low[2]};
}

double find_surface(const ChunkBox& chunk) {
  const Vec3 e = find_extents(chunk);
  return 2 * (e[0] * e[1] + e[1] * e[2] + e[2] * e[0]);
}

/// Edge of a face, as if the box were the chunk.
double find_face_edge(const ChunkBox& chunk) {
  return chunk.faces > 0 ? std::sqrt(find_surface(chunk) / static_cast<double>(chunk.faces)) : 0;
}

/// How many faces of each of two chunks may lie against the other; 0 if they are apart. edge: of a face of either.
int count_facing(const ChunkBox& a, const ChunkBox& b, double edge) {
  Vec3 overlap{};
  for (std::size_t k = 0; k < 3; ++k) {
    overlap[k] = std::min(a.high[k], b.high[k]) - std::max(a.low[k], b.low[k]) + edge;
    if (overlap[k] < 0) return 0;
  }
  std::sort(overlap.begin(), overlap.end());  // across the thinnest of what they share
  const double area = overlap[1] * overlap[2];
  const auto share = [&](const ChunkBox& chunk) {
    const double surface = find_surface(chunk);
    return surface > 0 ? static_cast<double>(chunk.faces) * std::min(1.0, area / surface) : 0;
  };
  return static_cast<int>(std::ceil(std::min(share(a), share(b))));
}

/// [chunks] the body of each: chunks that share nodes with one another, directly or through others.
std::vector<int> find_bodies(std::size_t chunks, const std::vector<GraphEdge>& shared) {
  std::vector<int> body(chunks);
  std::iota(body.begin(), body.end(), 0);
  const auto find = [&](int c) {
    while (body[static_cast<std::size_t>(c)] != c) {
      int& above = body[static_cast<std::size_t>(c)];
      above = body[static_cast<std::size_t>(above)];
      c = above;
    }
    return c;
  };
  for (const GraphEdge& edge : shared) {
    const int a = find(edge.a), b = find(edge.b);
    body[static_cast<std::size_t>(std::max(a, b))] = std::min(a, b);
  }
  for (int& b : body) b = find(b);
  return body;
}

/// Whether METIS can add up the weights, each counted from both sides, in an int.
bool is_countable(const std::vector<GraphEdge>& edges) {
  std::int64_t sum = 0;
  for (const GraphEdge& edge : edges) sum += 2 * static_cast<std::int64_t>(edge.weight);
  return sum <= std::numeric_limits<int>::max();
}

}  // namespace

std::vector<GraphEdge> add_near_chunks(const std::vector<ChunkBox>& chunks, std::vector<GraphEdge> shared) {
  const auto comes_before = [](const GraphEdge& x, const GraphEdge& y) {
    return std::tie(x.a, x.b) < std::tie(y.a, y.b);
  };
  std::vector<double> edges;
  edges.reserve(chunks.size());
  for (const ChunkBox& chunk : chunks) edges.push_back(find_face_edge(chunk));
  std::vector<int> order(chunks.size());
  std::iota(order.begin(), order.end(), 0);
  const auto low = [&](int c) {
    const auto i = static_cast<std::size_t>(c);
    return chunks[i].low[0] - 0.5 * edges[i];
  };
  std::sort(order.begin(), order.end(), [&](int a, int b) { return std::tuple(low(a), a) < std::tuple(low(b), b); });
  const std::vector<int> bodies = find_bodies(chunks.size(), shared);
  std::vector<GraphEdge> near;
  std::vector<int> open;  // chunks whose boxes may reach the next along x
  std::size_t looked_at = 0;
  for (const int c : order) {
    const auto i = static_cast<std::size_t>(c);
    std::erase_if(open, [&](int other) {
      const auto j = static_cast<std::size_t>(other);
      return chunks[j].high[0] + 0.5 * edges[j] < low(c);
    });
    looked_at += open.size();
    if (looked_at > most_pairs * most_pairs * chunks.size()) return shared;
    for (const int other : open) {
      const auto j = static_cast<std::size_t>(other);
      if (bodies[i] == bodies[j]) continue;
      const int facing = count_facing(chunks[i], chunks[j], 0.5 * (edges[i] + edges[j]));
      if (facing == 0) continue;
      near.push_back({std::min(c, other), std::max(c, other), near_face_weight * facing});
    }
    if (near.size() > most_pairs * chunks.size()) return shared;
    if (chunks[i].faces > 0) open.push_back(c);
  }
  std::sort(near.begin(), near.end(), comes_before);
  std::vector<GraphEdge> all;
  all.reserve(shared.size() + near.size());
  std::merge(shared.begin(), shared.end(), near.begin(), near.end(), std::back_inserter(all), comes_before);
  return is_countable(all) ? all : shared;
}

}  // namespace percuss
