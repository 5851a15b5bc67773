#include "comm/partition/assign_parts.hpp"

#include <algorithm>
#include <map>
#include <numeric>
#include <tuple>
#include <utility>

namespace percuss {
namespace {

bool comes_before(const Overlap& a, const Overlap& b) {
  return std::tuple(-a.points, a.part, a.rank) < std::tuple(-b.points, b.part, b.rank);
}

}  // namespace

std::vector<Overlap> find_overlaps(int rank, const std::vector<int>& parts) {
  std::map<int, std::int64_t> counts;
  for (const int part : parts) ++counts[part];
  std::vector<Overlap> overlaps;
  overlaps.reserve(counts.size());
  for (const auto& [part, points] : counts) overlaps.push_back({rank, part, points});
  std::sort(overlaps.begin(), overlaps.end(), comes_before);
  overlaps.resize(std::min(overlaps.size(), most_overlaps));
  return overlaps;
}

std::vector<int> assign_parts(std::vector<Overlap> overlaps, int count) {
  std::sort(overlaps.begin(), overlaps.end(), comes_before);
  std::vector<int> rank_of_part(static_cast<std::size_t>(count), -1);
  std::vector<char> has_part(static_cast<std::size_t>(count), 0);
  for (const Overlap& overlap : overlaps) {
    int& rank = rank_of_part[static_cast<std::size_t>(overlap.part)];
    char& taken = has_part[static_cast<std::size_t>(overlap.rank)];
    if (rank >= 0 || taken != 0) continue;
    rank = overlap.rank;
    taken = 1;
  }
  int next = 0;
  for (int& rank : rank_of_part) {
    if (rank >= 0) continue;
    while (has_part[static_cast<std::size_t>(next)] != 0) ++next;
    rank = next++;
  }
  return rank_of_part;
}

namespace {

std::vector<int> fill_in(std::vector<int> rank_of_part, int count) {
  if (!rank_of_part.empty()) return rank_of_part;
  rank_of_part.resize(static_cast<std::size_t>(count));
  std::iota(rank_of_part.begin(), rank_of_part.end(), 0);
  return rank_of_part;
}

OwnedCommunicator order_by_part(const Communicator& ranks, const std::vector<int>& rank_of_part) {
  const auto part = std::find(rank_of_part.begin(), rank_of_part.end(), ranks.rank()) - rank_of_part.begin();
  return OwnedCommunicator::in_order(ranks, static_cast<int>(part));
}

}  // namespace

AssignedParts::AssignedParts(const Communicator& ranks, std::vector<int> rank_of_part)
    : rank_of_part_(fill_in(std::move(rank_of_part), ranks.size())), rcb_(*order_by_part(ranks, rank_of_part_)) {}

}  // namespace percuss
