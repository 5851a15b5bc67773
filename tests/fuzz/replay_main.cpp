// A target without a fuzzer: all seeds and the same damaged ones every time, as a test; or the seeds as files.
//
//   replay_NAME N            tries the seeds and N damaged inputs
//   replay_NAME --write DIR  writes DIR/seeds/* and DIR/words

#include <fmt/format.h>

#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>

#include "comm/communicator.hpp"
#include "tests/fuzz/target.hpp"
#include "tests/random.hpp"

namespace {

using percuss::fuzz::try_bytes;
using percuss::test::RandomIndex;

/// One change: a bit flipped, a byte set, a piece cut, repeated or taken from another seed, a word put in.
void damage(std::string& bytes, const std::vector<std::string>& seeds, const std::vector<std::string>& words,
            RandomIndex& random) {
  if (bytes.empty()) bytes = seeds[random.below(seeds.size())];
  if (bytes.empty()) return;
  const std::size_t at = random.below(bytes.size());
  switch (random.below(6)) {
    case 0:
      bytes[at] = static_cast<char>(static_cast<unsigned char>(bytes[at]) ^ (1U << random.below(8)));
      break;
    case 1:
      bytes[at] = static_cast<char>(random.below(256));
      break;
    case 2:
      bytes.erase(at, 1 + random.below(64));
      break;
    case 3:
      bytes.insert(at, bytes.substr(random.below(bytes.size()), 1 + random.below(64)));
      break;
    case 4: {
      const std::string& other = seeds[random.below(seeds.size())];
      if (!other.empty()) bytes.insert(at, other.substr(random.below(other.size()), 1 + random.below(64)));
      break;
    }
    default:
      if (!words.empty()) bytes.insert(at, words[random.below(words.size())]);
  }
}

void replay(long count) {
  const std::vector<std::string> seeds = percuss::fuzz::make_seeds(), words = percuss::fuzz::make_words();
  for (const std::string& seed : seeds) try_bytes(seed);
  RandomIndex random;
  for (long i = 0; i < count; ++i) {
    std::string bytes = seeds[random.below(seeds.size())];
    for (std::size_t changes = 1 + random.below(4); changes > 0; --changes) damage(bytes, seeds, words, random);
    try_bytes(bytes);
  }
  fmt::print("{} seeds and {} damaged inputs\n", seeds.size(), count);
}

/// In the format of libFuzzer's dictionaries: a line a word, in quotes, odd bytes as \xNN.
std::string quote(const std::string& word) {
  std::string text = "\"";
  for (const char c : word) {
    const bool is_plain = c >= ' ' && c <= '~' && c != '"' && c != '\\';
    text += is_plain ? std::string(1, c) : fmt::format("\\x{:02x}", static_cast<unsigned char>(c));
  }
  return text + "\"\n";
}

void write_inputs(const std::filesystem::path& folder) {
  std::filesystem::create_directories(folder / "seeds");
  int number = 0;
  for (const std::string& seed : percuss::fuzz::make_seeds()) {
    std::ofstream(folder / "seeds" / fmt::format("{:04}", number++), std::ios::binary) << seed;
  }
  std::ofstream words(folder / "words");
  for (const std::string& word : percuss::fuzz::make_words()) words << quote(word);
}

}  // namespace

int main(int argc, char** argv) {
  const percuss::MpiSession mpi(argc, argv);
  try {
    if (argc == 3 && std::string(argv[1]) == "--write") {
      write_inputs(argv[2]);
    } else {
      replay(argc > 1 ? std::strtol(argv[1], nullptr, 10) : 0);
    }
  } catch (const std::exception& error) {
    fmt::print(stderr, "an input was neither read nor refused: {}\n", error.what());
    return 1;
  }
  return 0;
}
