#include "src/step/model/whole_mesh.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "comm/agreement.hpp"

namespace percuss {

Communicator find_ranks(const Mesh& mesh) { return mesh.ranks.value_or(Communicator(MPI_COMM_SELF)); }

bool owns_node(const ChunkedMesh& chunked, int node) {
  const std::int64_t number = chunked.mesh.node_numbers[static_cast<std::size_t>(node)];
  return chunked.numbering.find_node_owner(number) == find_ranks(chunked.mesh).rank();
}

std::int64_t find_element_number(const ChunkedMesh& chunked, int element) {
  const auto next = std::upper_bound(chunked.chunks.begin(), chunked.chunks.end(), element,
                                     [](int e, const Chunk& chunk) { return e < chunk.first_element; });
  const Chunk& chunk = *(next - 1);
  return chunked.numbering.first_element[static_cast<std::size_t>(chunk.number)] + element - chunk.first_element;
}

int find_local_node(const ChunkedMesh& chunked, std::int64_t number) {
  const auto& numbers = chunked.mesh.node_numbers;
  const auto found = std::lower_bound(numbers.begin(), numbers.end(), number);
  return found != numbers.end() && *found == number ? static_cast<int>(found - numbers.begin()) : -1;
}

int find_local_element(const ChunkedMesh& chunked, std::int64_t number) {
  const auto chunk_number = static_cast<int>(Numbering::find_chunk(chunked.numbering.first_element, number));
  const auto chunk = std::lower_bound(chunked.chunks.begin(), chunked.chunks.end(), chunk_number,
                                      [](const Chunk& c, int n) { return c.number < n; });
  if (chunk == chunked.chunks.end() || chunk->number != chunk_number) return -1;
  const std::int64_t first = chunked.numbering.first_element[static_cast<std::size_t>(chunk_number)];
  return chunk->first_element + static_cast<int>(number - first);
}

std::int64_t find_node_id(const ChunkedMesh& chunked, std::int64_t number) {
  const Communicator ranks = find_ranks(chunked.mesh);
  const int owner = chunked.numbering.find_node_owner(number);
  std::vector<std::int64_t> id{0};
  if (owner == ranks.rank())
    id.front() = chunked.mesh.node_ids[static_cast<std::size_t>(find_local_node(chunked, number))];
  broadcast_values(ranks, id, owner);
  return id.front();
}

std::string name_element(const Mesh& mesh, int element) {
  const auto e = static_cast<std::size_t>(element);
  return fmt::format("element {} of part '{}'", mesh.element_ids[e],
                     mesh.parts[static_cast<std::size_t>(mesh.part_of(e))].name);
}

}  // namespace percuss
