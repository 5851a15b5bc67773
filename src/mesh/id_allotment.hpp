#pragma once
// Makes the user's ids of nodes or elements unique over all parts.

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <utility>
#include <vector>

namespace percuss {

/// Parts that come with ids keep them, as long as no earlier part has one of them; else all their ids are raised by the
/// highest so far. Generated parts count on from there.
class IdAllotment {
 public:
  /// Adds a part of `count` nodes or elements; `ids` is empty if it comes without. Ids are positive and unique.
  void add(std::vector<std::int64_t> ids, std::int64_t count) { parts_.push_back({std::move(ids), count, 0, false}); }

  /// Gives every part its ids, in the order in which they were added.
  void assign() {
    assign_own();
    for (Part& part : parts_) {
      if (!part.ids.empty()) continue;
      part.first = highest_ + 1;
      highest_ += part.count;
    }
  }

  /// The ids, after assign(), of a part that came with some, and the first id of one that came without.
  const std::vector<std::int64_t>& ids(std::size_t part) const { return parts_[part].ids; }
  std::int64_t first_id(std::size_t part) const { return parts_[part].first; }

  /// Whether, after assign(), the ids that the part came with were raised.
  bool raised(std::size_t part) const { return parts_[part].raised; }

 private:
  struct Part {
    std::vector<std::int64_t> ids;
    std::int64_t count = 0, first = 0;
    bool raised = false;
  };

  void assign_own() {
    std::vector<std::int64_t> used, merged;  // ascending
    for (Part& part : parts_) {
      if (part.ids.empty()) continue;
      std::vector<std::int64_t> ids = part.ids;
      std::sort(ids.begin(), ids.end());
      part.raised = intersects(used, ids);
      if (part.raised) {
        for (auto* list : {&ids, &part.ids}) {
          for (std::int64_t& id : *list) id += highest_;
        }
      }
      highest_ = std::max(highest_, ids.back());
      merged.clear();
      std::merge(used.begin(), used.end(), ids.begin(), ids.end(), std::back_inserter(merged));
      used.swap(merged);
    }
  }

  static bool intersects(const std::vector<std::int64_t>& a, const std::vector<std::int64_t>& b) {
    for (auto i = a.begin(), j = b.begin(); i != a.end() && j != b.end();) {
      if (*i == *j) return true;
      *i < *j ? ++i : ++j;
    }
    return false;
  }

  std::vector<Part> parts_;
  std::int64_t highest_ = 0;
};

}  // namespace percuss
