#include "src/step/restart/mesh_pieces.hpp"

#include <fcntl.h>
#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <filesystem>
#include <map>
#include <string_view>

#include "comm/all_reduce.hpp"
#include "kernels/core/same_bits.hpp"
#include "src/fail_together.hpp"
#include "src/output/files/posix_file.hpp"
#include "src/step/model/whole_mesh.hpp"

namespace percuss {
namespace {

std::uint64_t to_bits(double value) { return std::bit_cast<std::uint64_t>(value); }

/// Hashes and counts of the pieces: of this rank's share, then of all. Shares of a hash add up.
class Pieces {
 public:
  /// Begins a piece; what is added goes to it.
  void begin(std::string what) {
    std::replace(what.begin(), what.end(), '\n', ' ');
    names_.push_back(std::move(what));
    hashes_.push_back(0);
    counts_.push_back(0);
  }
  std::size_t size() const { return names_.size(); }
  void add_to(std::size_t piece, std::uint64_t hash) {
    hashes_[piece] += hash;
    ++counts_[piece];
  }
  /// The first piece of others as one of these.
  void take(std::size_t piece, const Pieces& others) {
    hashes_[piece] = others.hashes_.front();
    counts_[piece] = others.counts_.front();
  }
  void add(std::uint64_t hash) { add_to(names_.size() - 1, hash); }

  std::vector<std::string> list(const Communicator& ranks) {
    all_reduce(ranks, Reduce::sum, hashes_);
    all_reduce(ranks, Reduce::sum, counts_);
    std::vector<std::string> lines;
    for (std::size_t i = 0; i < names_.size(); ++i)
      lines.push_back(fmt::format("{:016x} {} {}", hashes_[i], counts_[i], names_[i]));
    return lines;
  }

 private:
  std::vector<std::string> names_;
  std::vector<std::uint64_t> hashes_;
  std::vector<std::int64_t> counts_;
};

void add_nodes(const ChunkedMesh& chunked, Pieces& pieces) {
  const Mesh& mesh = chunked.mesh;
  pieces.begin("nodes");
  for (std::size_t n = 0; n < mesh.nodes.size(); ++n) {
    if (!owns_node(chunked, static_cast<int>(n))) continue;
    std::uint64_t h = mix_bits(static_cast<std::uint64_t>(mesh.node_numbers[n]));
    h = mix_bits(h ^ static_cast<std::uint64_t>(mesh.node_ids[n]));
    for (const double x : mesh.nodes[n]) h = mix_bits(h ^ to_bits(x));
    pieces.add(h);
  }
}

std::string name_block(const Mesh& mesh, const ElementBlock& block) {
  const std::string& part = mesh.parts[static_cast<std::size_t>(block.part)].name;
  return fmt::format("{} elements of part '{}'{}", find_topology(block.topology).name, part,
                     block.name.empty() ? "" : fmt::format(", block '{}'", block.name));
}

std::uint64_t hash_element(const ChunkedMesh& chunked, std::size_t element) {
  const Mesh& mesh = chunked.mesh;
  const ElementBlock& block = mesh.block_of(element);
  std::uint64_t h = mix_bits(~static_cast<std::uint64_t>(find_element_number(chunked, static_cast<int>(element))));
  h = mix_bits(h ^ static_cast<std::uint64_t>(mesh.element_ids[element]));
  for (const int n : mesh.corners(element))
    h = mix_bits(h ^ static_cast<std::uint64_t>(mesh.node_numbers[static_cast<std::size_t>(n)]));
  h = mix_bits(h ^ to_bits(mesh.thickness_of(element)));
  return mix_bits(mix_bits(h ^ static_cast<std::uint64_t>(block.section.points)) ^ to_bits(block.section.area));
}

void add_elements(const ChunkedMesh& chunked, Pieces& pieces) {
  const Mesh& mesh = chunked.mesh;
  const std::size_t first = pieces.size();
  for (const ElementBlock& block : mesh.elements.blocks) pieces.begin(name_block(mesh, block));
  for (std::size_t e = 0; e < mesh.elements.size(); ++e)
    pieces.add_to(first + static_cast<std::size_t>(mesh.elements.block_index(e)), hash_element(chunked, e));
}

void add_sets(const ChunkedMesh& chunked, Pieces& pieces) {
  const Mesh& mesh = chunked.mesh;
  for (const auto& [name, nodes] : mesh.node_sets) {
    if (name.find('/') == std::string::npos) continue;  // all nodes of a part
    pieces.begin(fmt::format("node set '{}'", name));
    for (const int n : nodes)
      if (owns_node(chunked, n))
        pieces.add(mix_bits(static_cast<std::uint64_t>(mesh.node_numbers[static_cast<std::size_t>(n)])));
  }
  for (const auto& [name, faces] : mesh.side_sets) {
    pieces.begin(fmt::format("side set '{}'", name));
    for (const ElementFace& face : faces)
      pieces.add(mix_bits(
          static_cast<std::uint64_t>(find_face_number(find_element_number(chunked, face.element), face.face))));
  }
}

/// Adds a file by its bytes: a restart does not read the fields again. Who reads them refuses what is no file.
void add_file(const std::string& path, Pieces& pieces) {
  if (std::error_code error; !std::filesystem::is_regular_file(path, error)) return;
  const PosixFile file(path, O_RDONLY);
  std::vector<std::uint64_t> words(std::size_t{1} << 17);
  const auto most = static_cast<std::int64_t>(8 * words.size());
  for (std::int64_t at = 0, bytes = file.size(); at < bytes; at += most) {
    const std::int64_t count = std::min(most, bytes - at);
    if (count < most) std::fill(words.begin(), words.end(), 0);
    file.read(words.data(), at, count);
    std::uint64_t h = mix_bits(static_cast<std::uint64_t>(at + count));
    for (const std::uint64_t word : words) h = mix_bits(h ^ word);
    pieces.add(h);
  }
}

void add_files(const Deck& deck, const Communicator& ranks, Pieces& pieces) {
  for (std::size_t i = 0; i < deck.start.fields.size(); ++i)
    pieces.begin(fmt::format("the file of start.fields.{}", i));
  fail_together(ranks, [&] {
    if (ranks.rank() != 0) return;
    for (std::size_t i = 0; i < deck.start.fields.size(); ++i) {
      Pieces own;
      own.begin("");
      add_file(deck.start.fields[i].file, own);
      pieces.take(pieces.size() - deck.start.fields.size() + i, own);
    }
  });
}

struct Piece {
  std::string_view hash, count;
};

/// Pieces by what they are; of several of one name (blocks of a part) the second is "... (2)".
std::map<std::string, Piece> split_pieces(const std::vector<std::string>& lines) {
  std::map<std::string, Piece> pieces;
  for (const std::string_view line : lines) {
    const auto hash = line.find(' '), count = line.find(' ', hash == std::string::npos ? hash : hash + 1);
    if (count == std::string::npos) continue;
    const std::string what(line.substr(count + 1));
    std::string name = what;
    for (int i = 2; pieces.contains(name); ++i) name = fmt::format("{} ({})", what, i);
    pieces[name] = {line.substr(0, hash), line.substr(hash + 1, count - hash - 1)};
  }
  return pieces;
}

}  // namespace

std::vector<std::string> list_mesh_pieces(const Deck& deck, const ChunkedMesh& chunked, const Communicator& ranks) {
  Pieces pieces;
  add_nodes(chunked, pieces);
  add_elements(chunked, pieces);
  add_sets(chunked, pieces);
  add_files(deck, ranks, pieces);
  return pieces.list(ranks);
}

std::string hash_mesh_pieces(const std::vector<std::string>& pieces) {
  std::uint64_t h = 0;
  for (const std::string& piece : pieces) {
    for (const char byte : piece) h = mix_bits(h ^ static_cast<unsigned char>(byte));
    h = mix_bits(h ^ 256);
  }
  return fmt::format("{:016x}", h);
}

std::vector<std::string> compare_mesh_pieces(const std::vector<std::string>& now,
                                             const std::vector<std::string>& checkpoint) {
  const auto here = split_pieces(now), there = split_pieces(checkpoint);
  std::vector<std::string> differences;
  for (const auto& [what, piece] : here) {
    const auto found = there.find(what);
    if (found == there.end())
      differences.push_back(fmt::format("{} ({}) is new", what, piece.count));
    else if (found->second.count != piece.count)
      differences.push_back(fmt::format("{}: {} ({} in the checkpoint)", what, piece.count, found->second.count));
    else if (found->second.hash != piece.hash)
      differences.push_back(fmt::format("{}: other ones, as many as in the checkpoint ({})", what, piece.count));
  }
  for (const auto& [what, piece] : there)
    if (!here.contains(what)) differences.push_back(fmt::format("{} ({}) is gone", what, piece.count));
  return differences;
}

}  // namespace percuss
