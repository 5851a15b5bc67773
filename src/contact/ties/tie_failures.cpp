#include "src/contact/ties/tie_failures.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <span>

#include "comm/all_reduce.hpp"
#include "comm/gather_items.hpp"
#include "kernels/core/host_copy.hpp"
#include "src/contact/surface/number_map.hpp"
#include "src/contact/ties/tie_areas.hpp"
#include "src/error.hpp"
#include "src/index.hpp"

namespace percuss {
namespace {

/// A node whose tie fails.
struct ReleasedNode {
  std::int64_t node = 0;  // number
  std::int64_t tie = 0;   // of the deck
};

bool holds(const std::vector<std::int64_t>& ascending, std::int64_t number) {
  return std::binary_search(ascending.begin(), ascending.end(), number);
}

}  // namespace

TieFailures::TieFailures(const ChunkedMesh& chunked, const Deck& deck, const TiedSurfaces& ties,
                         const std::vector<std::int64_t>& late, const Communicator& ranks)
    : chunked_(chunked), ranks_(ranks) {
  for (const TieDeck& tie : deck.contact.ties) {
    is_glue_.push_back(tie.cohesive ? 1 : 0);
    law_of_tie_.push_back(tie.can_fail() ? static_cast<int>(laws_.size()) : -1);
    if (!tie.can_fail()) continue;
    laws_.push_back(
        {tie.normal_strength.value_or(0), tie.shear_strength.value_or(0), tie.normal_exponent, tie.shear_exponent});
  }
  if (laws_.empty()) return;
  sum_areas(deck, ties, late);
  refuse_bare(deck, ties);
  use(ties);
}

void TieFailures::sum_areas(const Deck& deck, const TiedSurfaces& ties, const std::vector<std::int64_t>& late) {
  std::vector<std::int64_t> of_start;
  for (const TiedNode& tied : ties.nodes)
    if (law_of_tie_[at(tied.tie)] >= 0) of_start.push_back(tied.node);
  std::set_union(of_start.begin(), of_start.end(), late.begin(), late.end(), std::back_inserter(numbers_));
  areas_ = sum_tie_areas({chunked_, deck, ranks_, chunked_.mesh.nodes}, ties, numbers_);
  has_failed_.assign(numbers_.size(), 0);
}

void TieFailures::refuse_bare(const Deck& deck, const TiedSurfaces& ties) const {
  std::vector<std::int64_t> bare(law_of_tie_.size(), 0);
  for (const TiedNode& tied : ties.nodes) {
    if (law_of_tie_[at(tied.tie)] < 0 || deck.contact.ties[at(tied.tie)].is_late()) continue;
    if (!(areas_[at(find_number(numbers_, tied.node))] > 0)) ++bare[at(tied.tie)];
  }
  all_reduce(ranks_, Reduce::sum, bare);
  for (std::size_t t = 0; t < bare.size(); ++t) {
    if (bare[t] == 0) continue;
    const TieDeck& tie = deck.contact.ties[t];
    throw InputError(fmt::format(
        "{}: error: tie of '{}' and '{}' cannot fail by stress ({} of its nodes are on no face of side a that is tied "
        "with all its corners): tie a surface of whole faces, or leave out failure and cohesive",
        deck.where(tie.place), tie.a.name, tie.b.name, bare[t]));
  }
}

void TieFailures::use(const TiedSurfaces& ties) {
  if (laws_.empty()) return;
  in_use_.clear();
  tie_in_use_.clear();
  std::vector<int> law, side;
  std::vector<double> area;
  for (const TiedNode& tied : ties.nodes) {
    if (is_glue_[at(tied.tie)] != 0) continue;  // it has no row, and judges itself
    in_use_.push_back(tied.node);
    tie_in_use_.push_back(tied.tie);
    side.push_back(tied.side);
    law.push_back(law_of_tie_[at(tied.tie)]);
    area.push_back(law.back() < 0 ? 1 : tied.area > 0 ? tied.area : areas_[at(find_number(numbers_, tied.node))]);
  }
  strengths_ = {to_view("contact::tie_laws", law), to_view("contact::tie_strengths", laws_),
                to_view("contact::tie_areas", area), to_view("contact::tie_sides", side)};
  int some = std::any_of(law.begin(), law.end(), [](int l) { return l >= 0; }) ? 1 : 0;
  all_reduce(ranks_, Reduce::largest, some);
  any_left_ = some != 0;
}

std::vector<std::int64_t> TieFailures::judge(const Array<const double>& use) {
  noted_.clear();
  std::vector<std::int64_t> counts(law_of_tie_.size(), 0);
  const auto host = to_host(use);
  for (std::size_t t = 0; t < in_use_.size(); ++t) {
    if (!(host(t) >= 1)) continue;
    noted_.push_back(at(find_number(numbers_, in_use_[t])));
    ++counts[at(tie_in_use_[t])];
  }
  all_reduce(ranks_, Reduce::sum, counts);
  return counts;
}

void TieFailures::note(const std::vector<std::int64_t>& nodes) {
  for (const std::int64_t node : nodes)
    if (const int n = find_number(numbers_, node); n >= 0) noted_.push_back(at(n));
}

ReleasedTies TieFailures::release(TiedSurfaces& ties) {
  std::vector<ReleasedNode> own;
  for (const std::size_t n : noted_) {
    has_failed_[n] = 1;
    const auto tied = std::lower_bound(ties.nodes.begin(), ties.nodes.end(), numbers_[n],
                                       [](const TiedNode& t, std::int64_t number) { return t.node < number; });
    const bool is_tied = tied != ties.nodes.end() && tied->node == numbers_[n];  // not where its tie has ended since
    if (is_tied) own.push_back({tied->node, tied->tie});
  }
  noted_.clear();
  ReleasedTies free;
  ties.released.resize(ties.known.size());
  for (const ReleasedNode& node : gather_items(ranks_, own)) {
    free.nodes.push_back(node.node);
    ties.released[at(node.tie)].push_back(node.node);
  }
  std::sort(free.nodes.begin(), free.nodes.end());
  count_ += static_cast<std::int64_t>(free.nodes.size());
  std::erase_if(ties.nodes, [&](const TiedNode& tied) { return holds(free.nodes, tied.node); });
  const Mesh& mesh = chunked_.mesh;
  const std::vector<std::int64_t> elements = list_element_numbers(chunked_);
  for (std::size_t t = 0; t < ties.known.size(); ++t) {
    std::sort(ties.released[t].begin(), ties.released[t].end());
    std::vector<std::int64_t>& tied = ties.known[t];
    std::erase_if(tied, [&](std::int64_t number) { return holds(free.nodes, number); });
    std::erase_if(ties.faces[t][0], [&](const ElementFace& face) {
      const std::array<int, 4> nodes = mesh.elements.face_nodes(face);
      const bool is_free =
          std::none_of(nodes.begin(), nodes.end(), [&](int node) { return holds(tied, mesh.node_numbers[at(node)]); });
      if (is_free) free.faces.push_back(find_face_number(elements[at(face.element)], face.face));
      return is_free;
    });
  }
  return free;
}

bool TieFailures::archive(CheckpointArchive& archive, TiedSurfaces& ties) {
  if (laws_.empty()) return false;
  archive.rows("contact/ties/failed", find_rows_of_nodes(chunked_, numbers_), 1, std::span<double>(has_failed_));
  if (!archive.is_loading()) return false;
  noted_.clear();
  for (std::size_t n = 0; n < numbers_.size(); ++n)
    if (has_failed_[n] != 0) noted_.push_back(n);
  auto failed = static_cast<std::int64_t>(noted_.size());
  all_reduce(ranks_, Reduce::sum, failed);
  release(ties);
  count_ = failed;
  return count_ > 0;
}

}  // namespace percuss
