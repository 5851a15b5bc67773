#pragma once
// Where things are in a checkpoint: what its writer and its reader agree on.

#include <cstdint>

namespace percuss::checkpoint_names {

/// Changes when a reader of the other format could not make sense of a file.
inline constexpr std::int64_t format = 9;

inline constexpr const char* header = "percuss_checkpoint";  // group whose attributes are the header
inline constexpr const char* state = "state";                // group of the arrays
inline constexpr const char* content = "content";            // attribute: hash of the content, 16 digits
inline constexpr const char* earlier = "earlier";            // attribute: cost of the run so far
inline constexpr const char* deck = "deck";                  // datasets of the header's group
inline constexpr const char* values = "values";
inline constexpr const char* pieces = "mesh_pieces";
inline constexpr const char* warnings = "warnings";
inline constexpr const char* number_names = "number_names";
inline constexpr const char* number_counts = "number_counts";  // by name, how many numbers it has
inline constexpr const char* numbers = "numbers";              // name after name: bits of a double, or an integer
inline constexpr const char* sum_names = "sum_names";
inline constexpr const char* sums = "sums";  // limbs and count of each

}  // namespace percuss::checkpoint_names
