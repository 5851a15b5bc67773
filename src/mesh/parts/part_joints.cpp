#include "src/mesh/parts/part_joints.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <span>
#include <tuple>
#include <unordered_map>
#include <utility>

#include "comm/agreement.hpp"
#include "src/deck/text/nearest_name.hpp"
#include "src/error.hpp"
#include "src/fail_together.hpp"
#include "src/mesh/hex_geometry.hpp"
#include "src/mesh/parts/shared_meshes.hpp"

namespace percuss {
namespace {

struct Box {
  Vec3 low, high;
};

std::int64_t find_id(const ScenePart& part, std::int64_t node) {
  return part.file ? part.file->mesh.node_ids[static_cast<std::size_t>(node)] : part.first_node_id + node;
}

Box find_box(const ScenePart& part) {
  constexpr double far = std::numeric_limits<double>::infinity();
  Box box{{far, far, far}, {-far, -far, -far}};
  for (std::int64_t n = 0; n < part.nodes; ++n) {
    const Vec3 x = find_node_place(part, n);
    for (std::size_t k = 0; k < 3; ++k) {
      box.low[k] = std::min(box.low[k], x[k]);
      box.high[k] = std::max(box.high[k], x[k]);
    }
  }
  return box;
}

bool holds(const Box& box, const Vec3& x, double margin) {
  for (std::size_t k = 0; k < 3; ++k) {
    if (!(x[k] >= box.low[k] - margin && x[k] <= box.high[k] + margin)) return false;
  }
  return true;
}

/// Sets of keys that are one node.
class MergedKeys {
 public:
  void merge(std::int64_t a, std::int64_t b) {
    a = find_root(a);
    b = find_root(b);
    parents_[std::max(a, b)] = std::min(a, b);
  }

  /// (root, key) of all that are merged, ascending.
  std::vector<std::pair<std::int64_t, std::int64_t>> list() {
    std::vector<std::pair<std::int64_t, std::int64_t>> members;
    std::vector<std::int64_t> keys;
    for (const auto& [key, parent] : parents_) keys.push_back(key);
    for (const std::int64_t key : keys) members.emplace_back(find_root(key), key);
    std::sort(members.begin(), members.end());
    return members;
  }

 private:
  std::int64_t find_root(std::int64_t key) {
    std::int64_t& parent = parents_.emplace(key, key).first->second;
    if (parent == key) return key;
    const std::int64_t root = find_root_above(parent);
    parents_[key] = root;
    return root;
  }
  std::int64_t find_root_above(std::int64_t key) const {
    for (auto at = parents_.find(key); at->second != key; at = parents_.find(key)) key = at->second;
    return key;
  }

  std::unordered_map<std::int64_t, std::int64_t> parents_;  // a root is its own
};

/// A node that may have others at its place.
struct Candidate {
  std::array<std::int64_t, 3> cell{};
  std::int64_t key = 0;
  std::size_t part = 0;
  Vec3 place{};
};

/// Nodes of the joined parts in cells as wide as the tolerance: those within it lie in neighbouring cells.
class CandidateCells {
 public:
  CandidateCells(const Vec3& low, double tolerance) : low_(low), tolerance_(tolerance) {}

  void add(std::int64_t key, std::size_t part, const Vec3& x) {
    Candidate& c = candidates_.emplace_back(Candidate{{}, key, part, x});
    for (std::size_t k = 0; k < 3; ++k)
      c.cell[k] = static_cast<std::int64_t>(std::floor((x[k] - low_[k]) / tolerance_));
  }

  /// Whether some cell has more nodes of one part than elements larger than the tolerance can have there.
  bool is_crowded() {
    constexpr std::size_t most = 8;
    std::sort(candidates_.begin(), candidates_.end(), [](const Candidate& a, const Candidate& b) {
      return std::tie(a.cell, a.part, a.key) < std::tie(b.cell, b.part, b.key);
    });
    for (std::size_t i = most; i < candidates_.size(); ++i) {
      if (candidates_[i].cell == candidates_[i - most].cell && candidates_[i].part == candidates_[i - most].part)
        return true;
    }
    return false;
  }

  /// Visits near pairs; call after is_crowded().
  template <class Visit>
  void for_each_pair(const Visit& visit) const {
    for (const Candidate& c : candidates_) {
      for (std::int64_t step = 0; step < 27; ++step) {
        const std::array<std::int64_t, 3> cell{c.cell[0] + step % 3 - 1, c.cell[1] + step / 3 % 3 - 1,
                                               c.cell[2] + step / 9 - 1};
        auto other = std::lower_bound(candidates_.begin(), candidates_.end(), cell,
                                      [](const Candidate& a, const auto& wanted) { return a.cell < wanted; });
        for (; other != candidates_.end() && other->cell == cell; ++other) {
          if (other->part > c.part && find_distance(c.place, other->place) <= tolerance_) visit(c, *other);
        }
      }
    }
  }

 private:
  Vec3 low_;
  double tolerance_;
  std::vector<Candidate> candidates_;
};

/// Finds, on rank 0, what is one node.
class JointFinder {
 public:
  JointFinder(const Deck& deck, SceneParts& scene) : deck_(deck), scene_(scene) {}

  void find() {
    share_meshes();
    for (const JoinDeck& join : deck_.joins) merge_touching(join);
    const auto members = merged_.list();
    for (std::size_t first = 0, last = 0; first < members.size(); first = last) {
      while (last < members.size() && members[last].first == members[first].first) ++last;
      add_node(std::span(members).subspan(first, last - first));
    }
    std::sort(scene_.joined.begin(), scene_.joined.end(), [](const auto& a, const auto& b) { return a.key < b.key; });
    for (const auto& [parts, joint] : joints_) scene_.joints.push_back(joint);
    for (const JoinDeck& join : deck_.joins) require_joints(join);
  }

 private:
  /// Nodes of the file that several of its parts use.
  void share_meshes() {
    const std::vector<std::size_t> first = find_first_sharers(deck_);
    std::map<std::size_t, std::unordered_map<std::int64_t, std::int64_t>> keys_of_mesh;
    for (std::size_t p = 0; p < first.size(); ++p) {
      if (std::count(first.begin(), first.end(), first[p]) < 2) continue;
      const ScenePart& part = scene_.parts[p];
      const PartMesh& mesh = part.file->mesh;
      const std::size_t own = mesh.file_nodes.size();
      for (std::size_t n = 0; n < mesh.nodes.size(); ++n) {
        const std::int64_t in_file = mesh.file_nodes[n % own], copy = static_cast<std::int64_t>(n / own);
        const std::int64_t key = part.first_key + static_cast<std::int64_t>(n);
        const auto [at, is_new] = keys_of_mesh[first[p]].emplace(in_file + (copy << 32), key);
        if (!is_new) merged_.merge(at->second, key);
      }
    }
  }

  std::vector<std::size_t> list_parts(const JoinDeck& join) const {
    std::vector<std::size_t> parts;
    for (std::size_t p = 0; p < deck_.parts.size(); ++p) {
      const auto& names = join.parts;
      if (names.empty() || std::find(names.begin(), names.end(), deck_.parts[p].name) != names.end())
        parts.push_back(p);
    }
    return parts;
  }

  /// [nodes of the part] 1: of the sides that the entry names; empty: it names none of this part, and all are meant.
  std::vector<char> mark_sides(const JoinDeck& join, const ScenePart& part) const {
    std::vector<char> marks;
    for (const std::string& side : join.sides) {
      if (side.substr(0, side.find('/')) != part.name) continue;
      marks.resize(static_cast<std::size_t>(part.nodes), 0);
      mark_side(join, part, side.substr(side.find('/') + 1), marks);
    }
    return marks;
  }

  void mark_side(const JoinDeck& join, const ScenePart& part, const std::string& name, std::vector<char>& marks) const {
    const auto& names = part.node_sets;
    const auto found = std::find(names.begin(), names.end(), name);
    if (found == names.end())
      throw InputError(fmt::format("{}: error: join: part '{}' has no side or set '{}'{}", deck_.where(join.place),
                                   part.name, name, name_hint(name, names)));
    if (part.file) {
      for (const int n : part.file->mesh.node_sets.at(name)) marks[static_cast<std::size_t>(n)] = 1;
      return;
    }
    const ShapeSource& source = *part.generated->source;
    for (std::size_t n = 0; n < marks.size(); ++n) {
      const auto local = static_cast<int>(n % static_cast<std::size_t>(source.node_count()));
      if ((source.node_sides(local) >> (found - names.begin()) & 1U) != 0) marks[n] = 1;
    }
  }

  void merge_touching(const JoinDeck& join) {
    const std::vector<std::size_t> parts = list_parts(join);
    std::vector<Box> boxes;
    for (const std::size_t p : parts) boxes.push_back(find_box(scene_.parts[p]));
    Box all = boxes.front();
    for (const Box& box : boxes) {
      for (std::size_t k = 0; k < 3; ++k) {
        all.low[k] = std::min(all.low[k], box.low[k]);
        all.high[k] = std::max(all.high[k], box.high[k]);
      }
    }
    const double size = find_distance(all.low, all.high), tolerance = join.tolerance.value_or(join_share * size);
    if (!std::isfinite(size)) return;  // refused by the checks of the parts
    // Finer cells than round-off tells apart would have more numbers than there are.
    CandidateCells cells(all.low, std::max(tolerance, 1e-14 * size));
    for (std::size_t i = 0; i < parts.size(); ++i) {
      const ScenePart& part = scene_.parts[parts[i]];
      const std::vector<char> wanted = mark_sides(join, part);
      for (std::int64_t n = 0; n < part.nodes; ++n) {
        if (!wanted.empty() && wanted[static_cast<std::size_t>(n)] == 0) continue;
        const Vec3 x = find_node_place(part, n);
        for (std::size_t j = 0; j < parts.size(); ++j) {
          if (j == i || !holds(boxes[j], x, tolerance)) continue;
          cells.add(part.first_key + n, parts[i], x);
          break;
        }
      }
    }
    if (cells.is_crowded()) refuse(join, fmt::format("the tolerance, {:g}, is larger than elements", tolerance));
    cells.for_each_pair([&](const Candidate& a, const Candidate& b) { merged_.merge(a.key, b.key); });
  }

  [[noreturn]] void refuse(const JoinDeck& join, const std::string& why) const {
    throw InputError(fmt::format("{}: error: join: {}: give a tolerance between round-off and the shortest edge",
                                 deck_.where(join.place), why));
  }

  std::size_t find_part(std::int64_t key) const {
    const auto behind = std::upper_bound(scene_.parts.begin(), scene_.parts.end(), key,
                                         [](std::int64_t k, const ScenePart& part) { return k < part.first_key; });
    std::size_t part = static_cast<std::size_t>(behind - scene_.parts.begin()) - 1;
    return part;
  }

  /// members: (root, key) of all that are one.
  void add_node(std::span<const std::pair<std::int64_t, std::int64_t>> members) {
    std::vector<std::size_t> parts;
    std::vector<double> moved;
    const std::int64_t root = members.front().first;
    const ScenePart& of_root = scene_.parts[find_part(root)];
    const Vec3 place = find_node_place(of_root, root - of_root.first_key);
    const std::int64_t id = find_id(of_root, root - of_root.first_key);
    for (const auto& [same, key] : members) {
      const std::size_t p = find_part(key);
      const ScenePart& part = scene_.parts[p];
      if (!parts.empty() && parts.back() == p) refuse_two_nodes(part, members);
      parts.push_back(p);
      moved.push_back(find_distance(place, find_node_place(part, key - part.first_key)));
      scene_.joined.push_back({key, root, id, place});
    }
    for (std::size_t i = 0; i < parts.size(); ++i) {
      for (std::size_t j = i + 1; j < parts.size(); ++j) {
        PartJoint& joint = joints_[{parts[i], parts[j]}];
        joint.part = static_cast<int>(parts[i]);
        joint.other = static_cast<int>(parts[j]);
        ++joint.nodes;
        joint.farthest = std::max({joint.farthest, moved[i], moved[j]});
      }
    }
  }

  [[noreturn]] void refuse_two_nodes(const ScenePart& part,
                                     std::span<const std::pair<std::int64_t, std::int64_t>> members) const {
    std::string ids;
    for (const auto& [root, key] : members) {
      if (key < part.first_key || key >= part.first_key + part.nodes) continue;
      ids += (ids.empty() ? "" : " and ") + std::to_string(find_id(part, key - part.first_key));
    }
    const JoinDeck none;
    refuse(deck_.joins.empty() ? none : deck_.joins.front(),
           fmt::format("nodes {} of part '{}' would become one (nodes of other parts lie within the tolerance of both)",
                       ids, part.name));
  }

  /// Refuses a join that holds nothing: it is hardly meant.
  void require_joints(const JoinDeck& join) const {
    for (const std::size_t p : list_parts(join)) {
      const bool is_joined = std::any_of(joints_.begin(), joints_.end(), [&](const auto& entry) {
        return entry.first.first == p || entry.first.second == p;
      });
      if (is_joined || join.parts.empty()) continue;
      throw InputError(fmt::format(
          "{}: error: join: no node of part '{}' lies at a node of the other parts (nothing would hold it): check the "
          "places and cells of the parts, or give a larger tolerance",
          deck_.where(join.place), scene_.parts[p].name));
    }
  }

  const Deck& deck_;
  SceneParts& scene_;
  MergedKeys merged_;
  std::map<std::pair<std::size_t, std::size_t>, PartJoint> joints_;
};

bool may_share(const Deck& deck) {
  if (!deck.joins.empty()) return true;
  const std::vector<std::size_t> first = find_first_sharers(deck);
  for (std::size_t p = 0; p < first.size(); ++p) {
    if (first[p] != p) return true;
  }
  return false;
}

}  // namespace

void join_parts(const Deck& deck, const Communicator& ranks, SceneParts& scene) {
  if (!may_share(deck)) return;
  fail_together(ranks, [&] {
    const bool is_whole = std::all_of(scene.parts.begin(), scene.parts.end(),
                                      [](const ScenePart& part) { return part.error.empty(); });  // else refused later
    if (ranks.rank() == 0 && is_whole) JointFinder(deck, scene).find();
  });
  broadcast_values(ranks, scene.joined, 0);
  broadcast_values(ranks, scene.joints, 0);
}

}  // namespace percuss
