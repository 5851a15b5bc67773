#include "src/mesh/formats/nastran/nastran_sets.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "src/mesh/files/text_numbers.hpp"

namespace percuss {
namespace {

bool has_id(const std::vector<std::int64_t>& ids, std::int64_t id) {
  return std::binary_search(ids.begin(), ids.end(), id);
}

/// Cuts at commas and blanks; whether a comma ends the line.
bool cut_words(std::string_view line, TextPlace place, std::vector<std::pair<std::string_view, TextPlace>>& words) {
  constexpr std::string_view between = " \t,";
  const std::string_view text = strip_blanks(line.substr(0, line.find('$')));
  for (std::size_t first = text.find_first_not_of(between); first != std::string_view::npos;) {
    const std::size_t end = std::min(text.find_first_of(between, first), text.size());
    words.emplace_back(text.substr(first, end - first), place);
    first = text.find_first_not_of(between, end);
  }
  return text.ends_with(',');
}

}  // namespace

/// Ids, FIRST THRU LAST, BY STEP and EXCEPT behind these, ALL. Returns false if there is something else.
bool NastranSets::add_members(const Words& words, std::vector<Member>& members) {
  enum class Next : std::uint8_t { id, last, step, except } next = Next::id;
  for (const auto& [word, place] : words) {
    const auto number = parse_integer(word);
    const std::string upper = number ? std::string() : to_upper(word);
    const bool is_behind_range = next == Next::id && !members.empty() && members.back().last > members.back().first;
    if (upper == "ALL" && members.empty()) {
      members.push_back({1, std::numeric_limits<std::int64_t>::max(), 1, place, {}});
    } else if (upper == "THRU" && next == Next::id && !members.empty()) {
      next = Next::last;
    } else if (upper == "BY" && is_behind_range) {
      next = Next::step;
    } else if (upper == "EXCEPT" && is_behind_range) {
      next = Next::except;
    } else if (!number) {
      return false;
    } else if (next == Next::last) {
      if (*number < members.back().first) return false;
      members.back().last = *number;
      next = Next::id;
    } else if (next == Next::step) {
      if (*number < 1) return false;
      members.back().step = *number;
      next = Next::id;
    } else if (next == Next::except && *number <= members.back().last) {
      members.back().except.push_back(*number);
    } else {
      members.push_back({*number, *number, 1, place, {}});
      next = Next::id;
    }
  }
  for (Member& member : members) std::sort(member.except.begin(), member.except.end());
  return next == Next::id || next == Next::except;
}

/// SET N = ..., over lines that end with a comma. Of several with one number the first counts.
void NastranSets::read_control(const std::vector<std::pair<std::string_view, TextPlace>>& lines) {
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const std::string_view line = strip_blanks(lines[i].first);
    const std::size_t equals = line.find('=');
    if (to_upper(line.substr(0, 4)) != "SET " || equals == std::string_view::npos) continue;
    const auto id = parse_integer(line.substr(4, equals - 4));
    Words words;
    bool goes_on = cut_words(line.substr(equals + 1), lines[i].second, words);
    while (goes_on && i + 1 < lines.size()) {
      ++i;
      goes_on = cut_words(lines[i].first, lines[i].second, words);
    }
    Set set{NastranSetKind::unknown, true, {}};
    if (id && *id > 0 && add_members(words, set.members))
      sets_.emplace(*id, std::move(set));
    else
      has_other_sets_ = true;
  }
}

std::string NastranSets::read_card(const NastranCards& card) {
  Set set;
  const std::string what = card.name() == "SET1" ? "" : to_upper(card.field(1));
  std::size_t first = card.name() == "SET1" ? 1 : 2;
  if (what == "GRID") set.kind = NastranSetKind::nodes;
  if (what == "ELEM") set.kind = NastranSetKind::elements;
  if (what == "PROP") set.kind = NastranSetKind::properties;
  if (card.name() != "SET1" && set.kind == NastranSetKind::unknown) return fmt::format("{} ({})", card.name(), what);
  if (card.name() == "SET") {
    const std::string form = to_upper(card.field(first++));
    if (form != "LIST") return fmt::format("SET ({})", form);
  }
  Words words;
  for (std::size_t i = first; i < card.field_count(); ++i)
    if (!card.is_blank(i)) words.emplace_back(card.field(i), card.place_of(i));
  if (!add_members(words, set.members))
    card.refuse(fmt::format("set {} is not a list of ids, also as FIRST THRU LAST", card.integer(0)));
  const auto [found, is_new] = sets_.try_emplace(card.integer(0));
  if (!is_new && !found->second.is_of_control) card.refuse(fmt::format("set {} is defined twice", card.integer(0)));
  found->second = std::move(set);
  return {};
}

/// Single ids are all listed as they are; of a range those that exist.
std::vector<std::pair<std::int64_t, TextPlace>> NastranSets::list(const Set& set,
                                                                  const std::vector<std::int64_t>& ids) const {
  std::vector<std::pair<std::int64_t, TextPlace>> found;
  std::size_t visited = 0;  // ids of ranges, whether they are members or not
  for (const Member& member : set.members) {
    if (found.size() + visited > 100 * (ids.size() + 1000)) names_.refuse(member.place, "the set has too many members");
    if (member.first == member.last) {
      found.emplace_back(member.first, member.place);
      continue;
    }
    for (auto id = std::lower_bound(ids.begin(), ids.end(), member.first); id != ids.end() && *id <= member.last;
         ++id, ++visited) {
      const std::uint64_t above = static_cast<std::uint64_t>(*id) - static_cast<std::uint64_t>(member.first);
      if (above % static_cast<std::uint64_t>(member.step) == 0 && !has_id(member.except, *id))
        found.emplace_back(*id, member.place);
    }
  }
  return found;
}

bool NastranSets::holds(const Set& set, const std::vector<std::int64_t>& ids,
                        const std::vector<std::int64_t>& others) const {
  const auto members = list(set, ids);
  return std::any_of(members.begin(), members.end(), [&](const auto& member) { return has_id(ids, member.first); }) &&
         std::all_of(members.begin(), members.end(),
                     [&](const auto& member) { return has_id(ids, member.first) || has_id(others, member.first); });
}

void NastranSets::give(const NastranIds& ids, const NastranNames& named, TextBuilder& to,
                       std::set<std::string>& unread) const {
  if (has_other_sets_) unread.insert("SET (of no ids)");
  for (const auto& [id, set] : sets_) {
    const NastranSetKind kind = set.kind == NastranSetKind::unknown ? named.find_kind(id) : set.kind;
    const bool is_open = kind == NastranSetKind::unknown;
    const bool of_nodes = is_open ? holds(set, ids.nodes, {}) : kind == NastranSetKind::nodes;
    const bool of_elements = is_open ? holds(set, ids.elements, ids.others) : kind == NastranSetKind::elements;
    const auto call = [&, name = named.find_set(id), number = id](const char* word) {
      const std::string called = name.empty() ? fmt::format("{}_{}", word, number) : name;
      to.number_set(called, number);
      return called;
    };
    if (of_nodes) {
      const std::string name = call("nodes");
      for (const auto& [node, place] : list(set, ids.nodes)) to.add_set_node(name, node, place);
    }
    if (of_elements) {
      const std::string name = call("elements");
      for (const auto& [element, place] : list(set, ids.elements))
        if (!has_id(ids.others, element)) to.add_set_element(name, {element, IdSpace::elements}, place);
    }
    if (kind == NastranSetKind::properties) {
      const std::string name = call("parts");
      for (const auto& [property, place] : list(set, ids.properties)) to.add_set_block(name, property, place);
    }
    if (!of_nodes && !of_elements && kind != NastranSetKind::properties)
      unread.insert("SET (of other ids than those of nodes or elements)");
  }
}

}  // namespace percuss
