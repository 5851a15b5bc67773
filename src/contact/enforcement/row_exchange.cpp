#include "src/contact/enforcement/row_exchange.hpp"

#include <algorithm>
#include <cstring>

#include "comm/all_reduce.hpp"
#include "comm/exchange/item_exchange.hpp"
#include "kernels/core/host_copy.hpp"
#include "kernels/core/view_copy.hpp"
#include "kernels/core/views.hpp"
#include "src/index.hpp"

namespace percuss {
namespace {

/// Mark in the fold that a rank has rows; the lower bits count the ranks that touch its nodes.
constexpr int has_rows_mark = 1 << 24;

template <class Answer>
void append(const Answer& answer, std::vector<AnswerWord>& words) {
  constexpr std::size_t count = sizeof(Answer) / sizeof(AnswerWord);
  words.resize(words.size() + count);
  std::memcpy(words.data() + words.size() - count, &answer, sizeof(Answer));
}

/// Reads answers one after the other.
class AnswerReader {
 public:
  explicit AnswerReader(const std::vector<AnswerWord>& words) : next_(words.data()) {}

  template <class Answer>
  Answer read() {
    Answer answer{};
    std::memcpy(&answer, next_, sizeof(Answer));
    next_ += sizeof(Answer) / sizeof(AnswerWord);
    return answer;
  }

 private:
  const AnswerWord* next_;
};

/// A view of the values; most steps of most ranks have none.
template <class T>
void renew(const char* label, const std::vector<T>& values, Array<T>& view) {
  if (!values.empty() || view.extent(0) > 0) view = to_view(label, values);
}

bool has_lower_node(const SharedEntry& a, const SharedEntry& b) { return a.node < b.node; }

/// The answer to a rank: each of its nodes, with the entries of all others on it. entries: by node.
void answer_rank(int rank, const RowNotice* first, const RowNotice* end, const std::vector<SharedEntry>& entries,
                 const HostRowNodes& nodes, std::vector<AnswerWord>& words) {
  for (const RowNotice* notice = first; notice != end; ++notice) {
    if (notice != first && notice->node == (notice - 1)->node) continue;
    SharedEntry wanted;
    wanted.node = notice->node;
    const auto [low, high] = std::equal_range(entries.begin(), entries.end(), wanted, has_lower_node);
    NodeAnswer node = nodes.get(low->place);
    node.entries = static_cast<std::int32_t>(
        std::count_if(low, high, [rank](const SharedEntry& entry) { return entry.rank != rank; }));
    append(node, words);
    for (auto entry = low; entry != high; ++entry)
      if (entry->rank != rank) append(EntryAnswer{entry->key, entry->rank}, words);
  }
}

}  // namespace

void RowOutcome::merge(const RowOutcome& other) {
  sums.merge(other.sums);
  iterations = std::max(iterations, other.iterations);
  failures += other.failures;
  complementarity = std::max(complementarity, other.complementarity);
}

RowExchange::RowExchange(const ContactRanks& ranks)
    : ranks_(ranks),
      has_many_ranks_(ranks.ranks.size() > 1),
      exchange_(ranks.ranks),
      data_(ranks.ranks),
      notices_(ranks.ranks),
      swap_(ranks.ranks),
      team_(ranks.ranks),
      has_part_(at(ranks.ranks.size()), 0) {}

Traffic RowExchange::traffic() const {
  Traffic sum = data_.traffic();
  for (const Traffic& part : {notices_.traffic(), swap_.traffic()}) {
    sum.messages += part.messages;
    sum.bytes += part.bytes;
  }
  return sum;
}

void RowExchange::find_foreign_nodes(const Array<const RowTouch>& touches, int num_touches, RowSystem& system) {
  system.num_foreign = 0;
  if (!has_many_ranks_) return;
  foreign_ = percuss::find_foreign_nodes(ranks_, touches, num_touches);
  system.num_foreign = static_cast<int>(foreign_.numbers.size());
  renew("contact::foreign_nodes", foreign_.of_slot, system.foreign);
  renew("contact::foreign_number", foreign_.numbers, system.foreign_number);
}

RowMeeting RowExchange::meet(const RowSystem& system, bool is_same, bool everybody) {
  takes_part_ = system.num_rows > 0;
  if (!has_many_ranks_) return {takes_part_, is_same};
  const auto own = at(ranks_.ranks.rank());
  std::vector<int> fold(has_part_.size() + 1, 0);
  for (const PeerRun& run : foreign_.owners) fold[at(run.rank)] = 1;
  if (takes_part_) fold[own] = has_rows_mark;
  fold.back() = is_same ? 0 : 1;
  all_reduce(ranks_.ranks, Reduce::sum, fold);
  num_senders_ = fold[own] % has_rows_mark;
  const bool any_rows = std::any_of(fold.begin(), fold.end() - 1, [](int mark) { return mark != 0; });
  for (std::size_t r = 0; r < has_part_.size(); ++r) has_part_[r] = fold[r] != 0 || (everybody && any_rows) ? 1 : 0;
  if (any_rows) team_.meet(has_part_);
  takes_part_ = any_rows && team_.contains_this();
  return {any_rows, fold.back() == 0};
}

void RowExchange::announce_foreign_nodes(RowSystem& system) {
  system.num_remote = system.num_sent = 0;
  if (!has_many_ranks_) return;
  received_.clear();
  notice_plan_ = {};
  if (takes_part_) {
    received_ = notices_.exchange(foreign_.notice_runs, foreign_.notices, num_senders_, notice_plan_.from);
    notice_plan_.to = foreign_.notice_runs;
  }
  const std::vector<std::int64_t>& numbers = ranks_.mesh.node_numbers;
  std::vector<int> nodes;
  nodes.reserve(received_.size());
  for (const RowNotice& notice : received_)
    nodes.push_back(static_cast<int>(std::lower_bound(numbers.begin(), numbers.end(), notice.node) - numbers.begin()));
  renew("contact::remote_node", nodes, system.remote_node);
}

/// The entries of all ranks on own nodes that others touch, by node.
std::vector<SharedEntry> RowExchange::list_entries_on_own_nodes(const RowSources& sources,
                                                                const RowSystem& system) const {
  if (received_.empty()) return {};
  const int own = ranks_.ranks.rank();
  const auto nodes = to_host(system.remote_node), place = to_host(system.place_of_node);
  std::vector<char> is_touched(ranks_.mesh.nodes.size(), 0);
  for (std::size_t k = 0; k < received_.size(); ++k) is_touched[at(nodes(k))] = 1;
  std::vector<SharedEntry> entries = list_own_entries(ranks_, sources, system, is_touched);
  for (const PeerRun& run : notice_plan_.from) {
    for (auto k = at(run.first); k < at(run.first + run.count); ++k)
      entries.push_back({received_[k].node, received_[k].key, own, place(at(nodes(k))), run.rank, -1});
  }
  std::stable_sort(entries.begin(), entries.end(), has_lower_node);
  return entries;
}

/// The answers of the owners: places of foreign nodes, and the entries of all ranks on these.
void RowExchange::take_answers(const std::vector<AnswerWord>& words, int first_place, HostRowNodes& nodes,
                               std::vector<SharedEntry>& entries) const {
  AnswerReader reader(words);
  for (const PeerRun& run : foreign_.owners) {
    for (std::int64_t f = run.first; f < run.first + run.count; ++f) {
      const int place = first_place + static_cast<int>(f);
      const auto node = reader.read<NodeAnswer>();
      nodes.set(place, node);
      for (std::int64_t e = 0; e < node.entries; ++e) {
        const auto entry = reader.read<EntryAnswer>();
        entries.push_back({foreign_.numbers[at(f)], entry.key, run.rank, place, static_cast<int>(entry.rank), -1});
      }
    }
  }
  std::size_t f = 0;
  for (std::size_t k = 0; k < foreign_.notices.size(); ++k) {
    const RowNotice& notice = foreign_.notices[k];
    while (foreign_.numbers[f] != notice.node) ++f;
    entries.push_back({notice.node, notice.key, ranks_.numbering.find_node_owner(notice.node),
                       first_place + static_cast<int>(f), ranks_.ranks.rank(), foreign_.entries[k]});
  }
}

/// Positions, velocities and masses of the foreign nodes, after those of the own ones, and what is swapped for them.
void RowExchange::receive_nodes(const RowInputs&, const RowSources& sources, RowSystem& system) {
  if (!has_many_ranks_) return;
  if (foreign_.numbers.empty() && received_.empty()) {
    lists_ = {};
    prepare_swap(system);
    return;
  }
  HostRowNodes nodes(system);
  std::vector<SharedEntry> entries = list_entries_on_own_nodes(sources, system);
  std::vector<AnswerWord> words;
  std::vector<int> counts;
  for (const PeerRun& run : notice_plan_.from) {
    const std::size_t before = words.size();
    const RowNotice* first = received_.data() + run.first;
    answer_rank(run.rank, first, first + run.count, entries, nodes, words);
    counts.push_back(static_cast<int>(words.size() - before));
  }
  take_answers(data_.exchange_sized(reverse(notice_plan_), counts, words), system.num_nodes, nodes, entries);
  nodes.write(system);
  lists_ = list_swaps(std::move(entries), ranks_.ranks.rank());
  prepare_swap(system);
}

void RowExchange::prepare_swap(RowSystem& system) {
  system.num_sent = static_cast<int>(lists_.sent.size());
  system.num_remote = static_cast<int>(lists_.key.size());
  renew("contact::sent_entries", lists_.sent, system.sent);
  renew("contact::remote_key", lists_.key, system.remote_key);
  renew("contact::remote_place", lists_.place, system.remote_place);
  reserve(system.remote, system.num_remote);
  reserve(sent_values_, system.num_sent);
  send_buffer_ = Kokkos::create_mirror_view(sent_values_);
  receive_buffer_ = Kokkos::create_mirror_view(system.remote);
  swap_.prepare<RowItem>(lists_.plan, as_items(send_buffer_).first(lists_.sent.size()),
                         as_items(receive_buffer_).first(lists_.key.size()));
}

void RowExchange::end_swap(RowSystem& system) {
  swap_.end();
  copy_values(system.remote, receive_buffer_);
}

void RowExchange::send_pushes(const Array<const NormalPush>& sent, const RowSystem& system, Array<NormalPush>& remote) {
  if (!has_many_ranks_) return;
  const auto host = to_host(sent);
  const std::vector<NormalPush> items(host.data(), host.data() + system.num_sent);
  const std::vector<NormalPush> received = data_.exchange(lists_.plan, items);
  reserve(remote, system.num_remote);
  const auto mirror = Kokkos::create_mirror_view(remote);
  for (std::size_t k = 0; k < received.size(); ++k) mirror(k) = received[k];
  copy_values(remote, mirror);
}

/// Gathers rows on the first rank, which solves them; each rank gets the impulses of its own, and all the report.
template <class Report, class Row, class Impulse, class Solve>
Report RowExchange::solve_on_first_rank(const std::vector<Row>& rows, std::vector<Impulse>& impulses,
                                        const Solve& solve) {
  const ExchangePlan plan = exchange_.plan(order_by_destination(std::vector<int>(rows.size(), 0)).to);
  const std::vector<Row> gathered = data_.exchange(plan, rows);
  std::vector<Impulse> found;
  Report report;
  if (ranks_.ranks.rank() == 0) report = solve(gathered, found);
  impulses = data_.exchange(reverse(plan), found);
  wait_mpi([&] { return MPI_Bcast(&report, sizeof(report), MPI_BYTE, 0, ranks_.ranks.handle()); }, "MPI_Bcast");
  return report;
}

CoupledReport RowExchange::solve_together(const std::vector<CoupledRow>& rows, double dt,
                                          std::vector<RowImpulse>& impulses) {
  if (!has_many_ranks_) return solve_in_key_order(rows, dt, impulses);
  return solve_on_first_rank<CoupledReport>(
      rows, impulses, [dt](const auto& gathered, auto& found) { return solve_in_key_order(gathered, dt, found); });
}

RigidReport RowExchange::solve_rigid(const RigidRowList& list, const RigidQuery& query,
                                     std::vector<RigidImpulse>& impulses) {
  const auto solve = [&](const auto& rows, const std::vector<int>& others, auto& found) {
    return solve_rigid_rows(rows, others, list.responses, query, found);
  };
  if (!has_many_ranks_) return solve(list.rows, list.others, impulses);
  std::vector<int> others = list.others;
  others.push_back(static_cast<int>(list.rows.size()));
  all_reduce(ranks_.ranks, Reduce::sum, others);
  const bool is_any = others.back() > 0;
  others.pop_back();
  if (!is_any) return solve(std::vector<RigidRow>{}, others, impulses);
  return solve_on_first_rank<RigidReport>(
      list.rows, impulses, [&](const auto& gathered, auto& found) { return solve(gathered, others, found); });
}

void RowExchange::reduce(RowOutcome& outcome) {
  if (!has_many_ranks_) return;
  outcome.sums.normal_work.normalize();
  outcome.sums.friction_work.normalize();
  outcome.sums.stored.normalize();
  outcome.sums.stored_slip.normalize();
  reduce_outcome_(ranks_.ranks, outcome);
}

}  // namespace percuss
