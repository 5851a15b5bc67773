#include "src/output/checkpoint/sealed_file.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <bit>
#include <cstdint>
#include <optional>
#include <vector>

#include "comm/all_reduce.hpp"
#include "kernels/core/same_bits.hpp"
#include "src/fail_together.hpp"
#include "src/output/checkpoint/checkpoint_place.hpp"
#include "src/output/files/posix_file.hpp"

namespace percuss {
namespace {

constexpr std::uint64_t magic = 0x31306c6165737270;  // "prseal01"
constexpr std::int64_t block_bytes = std::int64_t{1} << 20;

struct Seal {
  std::uint64_t mark = magic;
  std::int64_t bytes = 0;  // before the seal
  std::uint64_t hash = 0;  // of these
  std::uint64_t own = 0;   // of the three above
};

std::uint64_t hash_seal(const Seal& seal) {
  return mix_bits(mix_bits(mix_bits(seal.mark) ^ static_cast<std::uint64_t>(seal.bytes)) ^ seal.hash);
}

/// Hash of a block, zeros behind its end. Every step can be undone, so that a change of one word always shows; four
/// lanes, because one would wait for its own multiplications.
std::uint64_t hash_block(const std::vector<std::uint64_t>& words, std::int64_t index) {
  std::uint64_t lane[4] = {1, 2, 3, 4};
  for (std::size_t i = 0; i < words.size(); ++i) {
    std::uint64_t& h = lane[i % 4];
    h = std::rotl((h ^ words[i]) * 0x9ddfea08eb382d69ull, 29);
  }
  std::uint64_t h = mix_bits(static_cast<std::uint64_t>(index));
  for (const std::uint64_t l : lane) h = mix_bits(h ^ l);
  return h;
}

std::int64_t count_blocks(std::int64_t bytes) { return (bytes + block_bytes - 1) / block_bytes; }

/// The share of blocks [first, end) in the hash of the first `bytes` bytes; shares add up.
std::uint64_t hash_blocks(const PosixFile& file, std::int64_t bytes, std::int64_t first, std::int64_t end) {
  std::vector<std::uint64_t> words(block_bytes / 8);
  std::uint64_t sum = 0;
  for (std::int64_t b = first; b < end; ++b) {
    const std::int64_t count = std::min(block_bytes, bytes - b * block_bytes);
    if (count < block_bytes) std::fill(words.begin(), words.end(), 0);
    file.read(words.data(), b * block_bytes, count);
    sum += hash_block(words, b);
  }
  return sum;
}

std::uint64_t hash_share(const Communicator& ranks, const std::string& path, std::int64_t bytes) {
  const std::int64_t blocks = count_blocks(bytes);
  std::uint64_t hash = 0;
  fail_together(ranks, [&] {
    hash = hash_blocks(PosixFile(path, O_RDONLY), bytes, blocks * ranks.rank() / ranks.size(),
                       blocks * (ranks.rank() + 1) / ranks.size());
  });
  all_reduce(ranks, Reduce::sum, hash);
  return hash;
}

std::string say_what_to_do(const std::string& path) {
  const std::string older = find_previous_checkpoint(path);
  if (::access(older.c_str(), F_OK) == 0) return "use the older one: " + older;
  return "there is no older one in its folder; start the run again";
}

std::optional<Seal> find_seal(const std::string& path) {
  const PosixFile file(path, O_RDONLY);
  const std::int64_t bytes = file.size() - static_cast<std::int64_t>(sizeof(Seal));
  if (bytes < 0) return std::nullopt;
  Seal seal;
  file.read(&seal, bytes, sizeof seal);
  if (seal.mark != magic || seal.own != hash_seal(seal) || seal.bytes != bytes) return std::nullopt;
  return seal;
}

/// Checks a file that was just sealed.
void check_whole(const std::string& path, const Seal& seal) {
  const auto found = find_seal(path);
  if (found && found->hash == seal.hash) return;
  throw SystemError(
      fmt::format("cannot write '{}' (read back, it does not end with what was written): check the disk", path));
}

Seal read_seal(const std::string& path) {
  if (const auto seal = find_seal(path)) return *seal;
  throw InputError(fmt::format("{}: error: not a checkpoint, or not a whole one (the mark at its end is missing): {}",
                               path, say_what_to_do(path)));
}

void compare(const std::string& path, const Seal& seal, std::uint64_t hash) {
  if (seal.hash == hash) return;
  throw InputError(
      fmt::format("{}: error: the checkpoint is damaged (its content has changed since it was written): {}", path,
                  say_what_to_do(path)));
}

}  // namespace

void seal_file(const Communicator& ranks, const std::string& path) {
  std::int64_t bytes = 0;
  fail_together(ranks, [&] { bytes = PosixFile(path, O_RDONLY).size(); });
  Seal seal;
  seal.bytes = bytes;
  seal.hash = hash_share(ranks, path, bytes);
  seal.own = hash_seal(seal);
  fail_together(ranks, [&] {
    if (ranks.rank() != 0) return;
    PosixFile file(path, O_RDWR | O_NOFOLLOW);
    file.write(&seal, bytes, sizeof seal);
    file.sync();
    file.close();
    check_whole(path, seal);
  });
  // The bytes that were hashed may have been read wrongly.
  if (hash_share(ranks, path, bytes) != seal.hash)
    throw SystemError(fmt::format("cannot write '{}' (read twice, it is not the same): check the disk", path));
}

void check_seal(const Communicator& ranks, const std::string& path) {
  Seal seal;
  fail_together(ranks, [&] { seal = read_seal(path); });
  compare(path, seal, hash_share(ranks, path, seal.bytes));
}

void check_seal(const std::string& path) {
  const Seal seal = read_seal(path);
  compare(path, seal, hash_blocks(PosixFile(path, O_RDONLY), seal.bytes, 0, count_blocks(seal.bytes)));
}

bool is_sealed(const std::string& path) {
  try {
    check_seal(path);
    return true;
  } catch (const InputError&) {
    return false;
  } catch (const SystemError&) {
    return false;
  }
}

}  // namespace percuss
