#include "src/output/sealed_file.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <bit>
#include <cerrno>
#include <cstdint>
#include <cstring>
#include <vector>

#include "comm/all_reduce.hpp"
#include "src/fail_together.hpp"
#include "src/output/atomic_file.hpp"
#include "src/output/checkpoint_file.hpp"

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

std::uint64_t mix(std::uint64_t h) {  // the finaliser of SplitMix64 (Steele et al. 2014)
  h += 0x9e3779b97f4a7c15ull;
  h = (h ^ (h >> 30)) * 0xbf58476d1ce4e5b9ull;
  h = (h ^ (h >> 27)) * 0x94d049bb133111ebull;
  return h ^ (h >> 31);
}

std::uint64_t hash_seal(const Seal& seal) {
  return mix(mix(mix(seal.mark) ^ static_cast<std::uint64_t>(seal.bytes)) ^ seal.hash);
}

/// Of a block, zeros behind its end. Every step can be undone, so that a change of one word always shows; four lanes,
/// because one would wait for its own multiplications.
std::uint64_t hash_block(const std::vector<std::uint64_t>& words, std::int64_t index) {
  std::uint64_t lane[4] = {1, 2, 3, 4};
  for (std::size_t i = 0; i < words.size(); ++i) {
    std::uint64_t& h = lane[i % 4];
    h = std::rotl((h ^ words[i]) * 0x9ddfea08eb382d69ull, 29);
  }
  std::uint64_t h = mix(static_cast<std::uint64_t>(index));
  for (const std::uint64_t l : lane) h = mix(h ^ l);
  return h;
}

class File {
 public:
  File(const std::string& path, int flags) : path_(path), descriptor_(::open(path.c_str(), flags | O_CLOEXEC)) {
    if (descriptor_ < 0) throw make_io_error("open", path, errno);
  }
  ~File() { ::close(descriptor_); }
  File(const File&) = delete;
  File& operator=(const File&) = delete;

  std::int64_t size() const {
    struct stat status {};
    if (::fstat(descriptor_, &status) != 0) throw make_io_error("read", path_, errno);
    return status.st_size;
  }

  void read(void* into, std::int64_t offset, std::int64_t count) const {
    auto* at = static_cast<char*>(into);
    while (count > 0) {
      const ssize_t got = ::pread(descriptor_, at, static_cast<std::size_t>(count), offset);
      if (got < 0 && errno == EINTR) continue;
      if (got <= 0) throw make_io_error("read", path_, got == 0 ? EIO : errno);
      at += got, offset += got, count -= got;
    }
  }

  void write(const void* from, std::int64_t offset, std::int64_t count) const {
    const auto* at = static_cast<const char*>(from);
    while (count > 0) {
      const ssize_t done = ::pwrite(descriptor_, at, static_cast<std::size_t>(count), offset);
      if (done < 0 && errno == EINTR) continue;
      if (done <= 0) throw make_io_error("write", path_, done == 0 ? ENOSPC : errno);
      at += done, offset += done, count -= done;
    }
  }

  void sync() const {
    if (::fsync(descriptor_) != 0) throw make_io_error("write", path_, errno);
  }

 private:
  std::string path_;
  int descriptor_;
};

std::int64_t count_blocks(std::int64_t bytes) { return (bytes + block_bytes - 1) / block_bytes; }

/// The share of blocks [first, end) in the hash of the first `bytes` bytes; shares add up.
std::uint64_t hash_blocks(const File& file, std::int64_t bytes, std::int64_t first, std::int64_t end) {
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
    hash = hash_blocks(File(path, O_RDONLY), bytes, blocks * ranks.rank() / ranks.size(),
                       blocks * (ranks.rank() + 1) / ranks.size());
  });
  all_reduce(ranks, Reduce::sum, hash);
  return hash;
}

std::string say_what_to_do(const std::string& path) {
  const std::string older = find_previous_checkpoint(path);
  if (::access(older.c_str(), F_OK) == 0) return "use the older one: " + older;
  return "there is no older one beside it: begin the run again";
}

Seal read_seal(const std::string& path) {
  const File file(path, O_RDONLY);
  const std::int64_t size = file.size();
  Seal seal;
  if (size >= static_cast<std::int64_t>(sizeof seal)) {
    file.read(&seal, size - static_cast<std::int64_t>(sizeof seal), sizeof seal);
    if (seal.mark == magic && seal.own == hash_seal(seal) &&
        seal.bytes == size - static_cast<std::int64_t>(sizeof seal))
      return seal;
  }
  throw InputError(fmt::format("{}: error: not a checkpoint, or not a whole one (it does not end as checkpoints do) {}",
                               path, say_what_to_do(path)));
}

void compare(const std::string& path, const Seal& seal, std::uint64_t hash) {
  if (seal.hash == hash) return;
  throw InputError(fmt::format("{}: error: the checkpoint is damaged (its content has changed since it was written) {}",
                               path, say_what_to_do(path)));
}

}  // namespace

void seal_file(const Communicator& ranks, const std::string& path) {
  std::int64_t bytes = 0;
  fail_together(ranks, [&] { bytes = File(path, O_RDONLY).size(); });
  Seal seal;
  seal.bytes = bytes;
  seal.hash = hash_share(ranks, path, bytes);
  seal.own = hash_seal(seal);
  fail_together(ranks, [&] {
    if (ranks.rank() != 0) return;
    const File file(path, O_RDWR);
    file.write(&seal, bytes, sizeof seal);
    file.sync();
  });
}

void check_seal(const Communicator& ranks, const std::string& path) {
  Seal seal;
  fail_together(ranks, [&] { seal = read_seal(path); });
  compare(path, seal, hash_share(ranks, path, seal.bytes));
}

void check_seal(const std::string& path) {
  const Seal seal = read_seal(path);
  compare(path, seal, hash_blocks(File(path, O_RDONLY), seal.bytes, 0, count_blocks(seal.bytes)));
}

}  // namespace percuss
