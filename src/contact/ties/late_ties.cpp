#include "src/contact/ties/late_ties.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <span>

#include "comm/gather_items.hpp"
#include "src/contact/surface/number_map.hpp"
#include "src/contact/surface/surface_share.hpp"
#include "src/contact/ties/tie_thickness.hpp"
#include "src/error.hpp"
#include "src/index.hpp"

namespace percuss {
namespace {

/// Numbers in a record: the tie, the face, its corners, the side, and weights, offset, corners and size of the
/// geometry, area.
constexpr std::size_t record_size = 1 + 1 + 4 + 1 + 4 + 3 + 12 + 1 + 1;
constexpr double never_tied = -1, tied_at_start = -2;  // in place of the tie

void write_record(const TiedNode& tied, double* out) {
  const auto put = [&](double value) { *out++ = value; };
  put(tied.tie);
  put(static_cast<double>(tied.face));
  for (const std::int64_t corner : tied.corners) put(static_cast<double>(corner));
  put(tied.side);
  for (const double weight : tied.geometry.weight) put(weight);
  const auto put_point = [&](const Point3& p) {
    for (const double value : {p.x, p.y, p.z}) put(value);
  };
  put_point(tied.geometry.offset);
  for (const Point3& corner : tied.geometry.face.corner) put_point(corner);
  put(tied.geometry.size);
  put(tied.area);
}

TiedNode read_record(std::int64_t node, const double* in) {
  TiedNode tied;
  tied.node = node;
  const auto take_number = [&] { return static_cast<std::int64_t>(*in++); };
  const auto take_point = [&] {
    const Point3 p{in[0], in[1], in[2]};
    in += 3;
    return p;
  };
  tied.tie = static_cast<int>(take_number());
  tied.face = take_number();
  for (std::int64_t& corner : tied.corners) corner = take_number();
  tied.side = static_cast<int>(take_number());
  for (double& weight : tied.geometry.weight) weight = *in++;
  tied.geometry.offset = take_point();
  for (Point3& corner : tied.geometry.face.corner) corner = take_point();
  tied.geometry.size = *in++;
  tied.area = *in;
  return tied;
}

void sort_numbers(std::vector<std::int64_t>& numbers) {
  std::sort(numbers.begin(), numbers.end());
  numbers.erase(std::unique(numbers.begin(), numbers.end()), numbers.end());
}

bool holds_number(const std::vector<std::int64_t>& ascending, std::int64_t number) {
  return std::binary_search(ascending.begin(), ascending.end(), number);
}

/// Numbers of the tied nodes of a tie, of all ranks, ascending.
std::vector<std::int64_t> list_tied(const TiedSurfaces& ties, std::size_t tie, const Communicator& ranks) {
  std::vector<std::int64_t> own;
  for (const TiedNode& tied : ties.nodes)
    if (at(tied.tie) == tie) own.push_back(tied.node);
  own = gather_items(ranks, own);
  std::sort(own.begin(), own.end());
  return own;
}

std::vector<std::int64_t> number_faces(const ChunkedMesh& chunked, const std::vector<ElementFace>& faces) {
  const std::vector<std::int64_t> elements = list_element_numbers(chunked);
  std::vector<std::int64_t> numbers;
  numbers.reserve(faces.size());
  for (const ElementFace& face : faces) numbers.push_back(find_face_number(elements[at(face.element)], face.face));
  return numbers;
}

}  // namespace

LateTies::LateTies(const ChunkedMesh& chunked, const Deck& deck, const TiedSurfaces& ties, const Communicator& ranks)
    : chunked_(chunked), deck_(deck), ranks_(ranks) {
  const Mesh& mesh = chunked.mesh;
  sides_a_.resize(deck.contact.ties.size());
  faces_b_.resize(deck.contact.ties.size());
  for (std::size_t t = 0; t < deck.contact.ties.size(); ++t) {
    const TieDeck& tie = deck.contact.ties[t];
    if (!tie.is_late()) continue;
    any_ = true;
    for (const int node : select_surface_nodes(mesh, deck, tie.a).nodes) {
      const std::int64_t number = mesh.node_numbers[at(node)];
      if (chunked.numbering.find_node_owner(number) != ranks.rank()) continue;
      numbers_.push_back(number);
      if (tie.sticks == TieDeck::Sticks::on_contact) sides_a_[t].push_back(number);
    }
  }
  sort_numbers(numbers_);
  records_.assign(numbers_.size() * record_size, 0);
  for (std::size_t n = 0; n < numbers_.size(); ++n) records_[n * record_size] = never_tied;
  for (const TiedNode& tied : ties.nodes)
    if (const int n = find_number(numbers_, tied.node); n >= 0) records_[at(n) * record_size] = tied_at_start;
}

bool LateTies::grows(const ActiveContact& active) const {
  for (std::size_t t = 0; t < deck_.contact.ties.size(); ++t)
    if (deck_.contact.ties[t].sticks == TieDeck::Sticks::on_contact && active.has_tie(t)) return true;
  return false;
}

ReleasedTies LateTies::switch_now(const ActiveContact& before, const ActiveContact& now,
                                  const std::vector<Vec3>& places, TiedSurfaces& ties,
                                  std::vector<std::string>& lines) {
  ReleasedTies free;
  for (std::size_t t = 0; t < deck_.contact.ties.size(); ++t) {
    if (before.has_tie(t) == now.has_tie(t)) continue;
    if (now.has_tie(t)) {
      add_tied_nodes({chunked_, deck_, ranks_, places}, t, ties);
      lines.push_back(describe_tie(deck_, ties, t));
    } else {
      ReleasedTies own = end(t, ties);
      lines.push_back(fmt::format("tie of '{}' and '{}' ends: {} nodes are free", deck_.contact.ties[t].a.name,
                                  deck_.contact.ties[t].b.name, own.nodes.size()));
      free.nodes.insert(free.nodes.end(), own.nodes.begin(), own.nodes.end());
      free.faces.insert(free.faces.end(), own.faces.begin(), own.faces.end());
    }
  }
  sort_numbers(free.nodes);
  sort_numbers(free.faces);
  refresh(now, ties);
  return free;
}

ReleasedTies LateTies::end(std::size_t tie, TiedSurfaces& ties) const {
  ReleasedTies free{list_tied(ties, tie, ranks_), number_faces(chunked_, ties.faces[tie][0])};
  std::erase_if(ties.nodes, [&](const TiedNode& tied) { return at(tied.tie) == tie; });
  ties.known[tie].clear();
  ties.faces[tie] = {};
  return free;
}

bool LateTies::may_stick(std::size_t tie, std::int64_t node) const {
  if (!holds_number(sides_a_[tie], node)) return false;
  return records_[at(find_number(numbers_, node)) * record_size] == never_tied;
}

bool LateTies::is_of_side_b(std::size_t tie, std::int64_t face) const { return holds_number(faces_b_[tie], face); }

std::int64_t LateTies::stick(std::size_t tie, const std::vector<std::int64_t>& nodes, const std::vector<Vec3>& places,
                             TiedSurfaces& ties) {
  const std::int64_t before = ties.counts[tie].tied;
  stick_nodes({chunked_, deck_, ranks_, places}, tie, nodes, ties);
  return ties.counts[tie].tied - before;
}

void LateTies::note(const TiedSurfaces& ties) {
  for (const TiedNode& tied : ties.nodes) {
    const int n = find_number(numbers_, tied.node);
    if (n < 0 || !deck_.contact.ties[at(tied.tie)].is_late()) continue;
    double* const record = records_.data() + at(n) * record_size;
    if (*record == never_tied) write_record(tied, record);
  }
}

void LateTies::refresh(const ActiveContact& active, TiedSurfaces& ties) {
  const Mesh& mesh = chunked_.mesh;
  ties.untied.resize(deck_.contact.ties.size());
  for (std::size_t t = 0; t < deck_.contact.ties.size(); ++t) {
    if (!deck_.contact.ties[t].is_late() || !active.has_tie(t)) continue;
    std::vector<std::int64_t>& known = ties.known[t];
    known.clear();
    for (const std::int64_t number : list_tied(ties, t, ranks_))
      if (find_number(mesh.node_numbers, number) >= 0) known.push_back(number);
    ties.faces[t] = list_tied_faces({chunked_, deck_, ranks_, mesh.nodes}, t, known);
    std::vector<std::int64_t>& untied = ties.untied[t];
    untied.clear();
    for (const ElementFace& face : ties.faces[t][0])
      for (const int node : mesh.elements.face_nodes(face))
        if (!holds_number(known, mesh.node_numbers[at(node)])) untied.push_back(mesh.node_numbers[at(node)]);
    untied = gather_items(ranks_, untied);
    sort_numbers(untied);
    if (deck_.contact.ties[t].sticks != TieDeck::Sticks::on_contact) continue;
    faces_b_[t] = gather_items(ranks_, number_faces(chunked_, ties.faces[t][1]));
    std::sort(faces_b_[t].begin(), faces_b_[t].end());
  }
}

bool LateTies::archive(CheckpointArchive& archive, const ActiveContact& active, TiedSurfaces& ties) {
  if (!any_) return false;
  archive.rows("contact/ties/late", find_rows_of_nodes(chunked_, numbers_), static_cast<int>(record_size),
               std::span<double>(records_));
  if (!archive.is_loading()) return false;
  std::erase_if(ties.nodes, [&](const TiedNode& tied) { return !deck_.contact.ties[at(tied.tie)].when.from.empty(); });
  for (std::size_t n = 0; n < numbers_.size(); ++n) {
    const double* const record = records_.data() + n * record_size;
    if (!(*record >= 0)) continue;
    if (!(*record < static_cast<double>(deck_.contact.ties.size())))
      throw InputError("the checkpoint has a tied node of a tie that the deck does not have");
    ties.nodes.push_back(read_record(numbers_[n], record));
  }
  std::sort(ties.nodes.begin(), ties.nodes.end(), [](const TiedNode& a, const TiedNode& b) { return a.node < b.node; });
  for (std::size_t t = 0; t < deck_.contact.ties.size(); ++t)
    if (!active.has_tie(t)) end(t, ties);
  refresh(active, ties);
  return true;
}

}  // namespace percuss
