#pragma once
// What a fuzzing target gives: one reader of untrusted bytes. It is driven by libFuzzer (fuzz_main.cpp, Clang only) and
// by a short replay that is a test (replay_main.cpp).

#include <string>
#include <vector>

namespace percuss::fuzz {

/// Reads the bytes as the product would. Returns if they are read or refused in the ways that the product has for
/// wrong input; everything else (another exception, a crash, a hang, a leak) is a finding.
void try_bytes(const std::string& bytes);

/// Inputs to start from, right and wrong ones.
std::vector<std::string> make_seeds();

/// Words of the format, from which libFuzzer makes its dictionary.
std::vector<std::string> make_words();

}  // namespace percuss::fuzz
