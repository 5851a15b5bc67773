#pragma once
// Hints for names that do not exist: "did you mean ...?"

#include <string>
#include <string_view>
#include <vector>

namespace percuss {

/// Number of insertions, deletions, replacements and swaps of neighbours that turn one word into the other
/// (optimal string alignment distance), letter case ignored.
int edit_distance(std::string_view a, std::string_view b);

/// The known name nearest to `wanted`: a few letters away, or one that begins with it; empty if none is near.
std::string nearest_name(std::string_view wanted, const std::vector<std::string>& known);

/// " (did you mean 'x'?)" if a known name is near, else " (known: a, b, c)", or nothing if nothing is known.
std::string name_hint(std::string_view wanted, const std::vector<std::string>& known);

}  // namespace percuss
