#pragma once
// Sets of Nastran: SET1 and SET3, SET of bulk data (OptiStruct), and SET of the case control.
//
// Some do not say what they are of. Such a set is one of nodes if all its ids are nodes, one of elements if all are
// elements, and both if both hold.

#include <cstdint>
#include <map>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "src/mesh/files/text_builder.hpp"
#include "src/mesh/formats/nastran/nastran_cards.hpp"
#include "src/mesh/formats/nastran/nastran_names.hpp"

namespace percuss {

/// Ids of a file, ascending.
struct NastranIds {
  std::vector<std::int64_t> nodes, elements, properties;
  std::vector<std::int64_t> others;  // of elements that are passed over
};

class NastranSets {
 public:
  explicit NastranSets(const TextNames& names) : names_(names) {}

  void read_control(const std::vector<std::pair<std::string_view, TextPlace>>& lines);
  /// An entry SET, SET1 or SET3. Returns what it has that is not read; empty: all is. Throws InputError.
  std::string read_card(const NastranCards& card);

  /// Adds them to the mesh; what is not read goes to unread.
  void give(const NastranIds& ids, const NastranNames& named, TextBuilder& to, std::set<std::string>& unread) const;

 private:
  struct Member {
    std::int64_t first = 0, last = 0, step = 1;
    TextPlace place;
    std::vector<std::int64_t> except;
  };
  struct Set {
    NastranSetKind kind = NastranSetKind::unknown;
    bool is_of_control = false;
    std::vector<Member> members;
  };
  using Words = std::vector<std::pair<std::string_view, TextPlace>>;

  static bool add_members(const Words& words, std::vector<Member>& members);
  bool holds(const Set& set, const std::vector<std::int64_t>& ids, const std::vector<std::int64_t>& others) const;
  std::vector<std::pair<std::int64_t, TextPlace>> list(const Set& set, const std::vector<std::int64_t>& ids) const;

  const TextNames& names_;
  std::map<std::int64_t, Set> sets_;
  bool has_other_sets_ = false;  // of the case control, of something else than ids
};

}  // namespace percuss
