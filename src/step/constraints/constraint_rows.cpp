#include "src/step/constraints/constraint_rows.hpp"

#include <algorithm>

#include "src/index.hpp"
#include "src/step/springs/end_pairs.hpp"

namespace percuss {
namespace {

/// Adds a term to the equations of an entry, which its first term has begun.
void add_term(const ChunkedMesh& chunked, const PairOfEnds& sides, const std::string& place,
              const EquationTermDeck& term, const std::array<std::vector<Item>, 2>& nodes, NodeEquations& equations) {
  const std::vector<NodePair> pairs = pair_nodes(chunked, sides, place, "constraint", nodes);
  for (std::size_t i = 0; i < pairs.size(); ++i)
    equations[i].push_back({pairs[i].second.number, term.direction, term.factor});
}

/// Terms of one displacement are one, so that no factor counts from another one of its own.
std::vector<ConstraintTerm> merge_terms(const std::vector<NodeTerm>& terms, const ConstraintModel& constraints) {
  std::vector<ConstraintTerm> merged;
  for (const NodeTerm& term : terms) {
    const int unknown = 3 * find_place(constraints, term.number) + static_cast<int>(term.direction);
    const auto same =
        std::find_if(merged.begin(), merged.end(), [&](const ConstraintTerm& of) { return of.unknown == unknown; });
    if (same == merged.end())
      merged.push_back({unknown, term.factor});
    else
      same->factor += term.factor;
  }
  return merged;
}

/// A list is one row less than it has nodes: each moves as the first.
void add_equal_rows(int constraint, const EqualLists& lists, const ConstraintModel& constraints,
                    std::vector<ConstraintRow>& rows) {
  for (std::size_t k = 0; k < 3; ++k) {
    if (!constraints.constraints[at(constraint)].equal[k]) continue;
    for (const auto& list : lists)
      for (std::size_t i = 1; i < list.size(); ++i)
        rows.push_back({constraint, k, merge_terms({{list.front(), k, 1}, {list[i], k, -1}}, constraints)});
  }
}

}  // namespace

int find_place(const ConstraintModel& constraints, std::int64_t number) {
  const auto& nodes = constraints.nodes;
  return static_cast<int>(std::lower_bound(nodes.begin(), nodes.end(), number) - nodes.begin());
}

std::vector<NodeEquations> find_equations(const Deck& deck, const ChunkedMesh& chunked) {
  std::vector<NamedEnd> ends;
  for (const ConstraintDeck& constraint : deck.constraints)
    for (const EquationTermDeck& term : constraint.equation) ends.push_back({constraint.name, term.of});
  const std::vector<std::vector<Item>> nodes = find_end_nodes(deck, chunked, ends, "constraint");
  std::vector<NodeEquations> all;
  auto next = nodes.begin();
  for (const ConstraintDeck& constraint : deck.constraints) {
    NodeEquations& equations = all.emplace_back();
    if (constraint.equation.empty()) continue;
    const std::vector<Item>& first = *next;
    for (const Item& item : first)
      equations.push_back({{item.number, constraint.equation[0].direction, constraint.equation[0].factor}});
    ++next;
    for (std::size_t i = 1; i < constraint.equation.size(); ++i, ++next) {
      const PairOfEnds sides{constraint.name, {}, constraint.place, next->size() > 1};
      add_term(chunked, sides, deck.where(constraint.place), constraint.equation[i], {first, *next}, equations);
    }
  }
  return all;
}

std::vector<ConstraintRow> make_constraint_rows(const std::vector<EqualLists>& lists,
                                                const std::vector<NodeEquations>& equations,
                                                const ConstraintModel& constraints) {
  std::vector<ConstraintRow> rows;
  for (std::size_t c = 0; c < lists.size(); ++c) {
    if (equations[c].empty()) add_equal_rows(static_cast<int>(c), lists[c], constraints, rows);
    for (const std::vector<NodeTerm>& terms : equations[c])
      rows.push_back({static_cast<int>(c), 0, merge_terms(terms, constraints)});
  }
  return rows;
}

}  // namespace percuss
