#include "src/contact/ranks/remote_items.hpp"

#include <utility>

#include "src/index.hpp"

namespace percuss {
namespace {

/// The requested items of a list, and the runs that are left of it.
struct WantedRuns {
  std::vector<PeerRun> runs;
  std::vector<int> items;
};

WantedRuns keep_wanted(const std::vector<PeerRun>& runs, const std::vector<int>& items,
                       const std::vector<char>& is_wanted) {
  WantedRuns kept;
  for (const PeerRun& run : runs) {
    const auto before = static_cast<std::int64_t>(kept.items.size());
    for (std::int64_t k = run.first; k < run.first + run.count; ++k)
      if (is_wanted[static_cast<std::size_t>(k)] != 0) kept.items.push_back(items[static_cast<std::size_t>(k)]);
    const std::int64_t count = static_cast<std::int64_t>(kept.items.size()) - before;
    if (count > 0) kept.runs.push_back({run.rank, before, count});
  }
  return kept;
}

}  // namespace

ItemPart RemoteItems::select_among(const ItemPart& part, DataExchange& data, const std::vector<char>& is_wanted) {
  std::vector<char> flags;
  flags.reserve(part.asked.size());
  for (const int item : part.asked) flags.push_back(is_wanted[at(item)]);
  const std::vector<char> of_others = data.exchange(part.request, flags);
  WantedRuns asked = keep_wanted(part.request.to, part.asked, flags);
  WantedRuns published = keep_wanted(part.request.from, part.published, of_others);
  ItemPart chosen;
  chosen.request = {std::move(asked.runs), std::move(published.runs)};
  chosen.asked = std::move(asked.items);
  chosen.published = std::move(published.items);
  for (std::size_t i = 0; i < part.own.size(); ++i) {
    if (is_wanted[at(part.own[i])] == 0) continue;
    chosen.own.push_back(part.own[i]);
    chosen.own_places.push_back(part.own_places[i]);
  }
  return chosen;
}

}  // namespace percuss
