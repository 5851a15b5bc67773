#include "src/contact/ties/breaking_ties.hpp"

#include <fmt/format.h>

namespace percuss {

std::int64_t BreakingTies::judge(const Array<const double>& uses, double time) {
  const std::vector<std::int64_t> counts = failures_.judge(uses);
  failing_ = 0;
  for (std::size_t t = 0; t < counts.size(); ++t) {
    if (counts[t] == 0) continue;
    failing_ += counts[t];
    const TieDeck& tie = deck_.contact.ties[t];
    warnings_.push_back({"tie_failure",
                         fmt::format("nodes of the tie of '{}' and '{}' have failed (their stress has reached the "
                                     "strength in failure): failed_ties in history.csv counts them",
                                     tie.a.name, tie.b.name),
                         deck_.where(tie.place), time, static_cast<long>(counts[t])});
  }
  return failing_;
}

ReleasedTies BreakingTies::release(TiedSurfaces& ties) {
  failing_ = 0;
  return failures_.release(ties);
}

}  // namespace percuss
