#include "src/step/restart/checkpoint.hpp"

#include <fmt/chrono.h>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <bit>
#include <chrono>

#include "comm/all_reduce.hpp"
#include "comm/halo/node_copies.hpp"
#include "kernels/core/host_copy.hpp"
#include "kernels/core/same_bits.hpp"
#include "kernels/core/small_space.hpp"
#include "kernels/core/view_copy.hpp"
#include "kernels/element/element_records.hpp"
#include "src/deck/yaml/deck_values.hpp"
#include "src/error.hpp"
#include "src/step/model/whole_mesh.hpp"
#include "src/step/restart/archive_lives.hpp"
#include "src/step/restart/mesh_pieces.hpp"

namespace percuss {
namespace {

/// Calls visit(record, its scalars, whether the lane only repeats the element before) for every lane of this rank.
/// records: of all elements, on the host.
template <class Records, class Visit>
void visit_records(const HostChunks& chunks, const Records& records, const Visit& visit) {
  for (int c = 0; c < chunks.count; ++c) {
    for (int i = 0; i < count_lanes(chunks, c); ++i)
      visit(find_record(chunks, records, c, i), chunks.record_size(c), i >= count_elements(chunks, c));
  }
}

/// Element records, element after element: without the packs, whose width depends on the machine.
void archive_elements(CheckpointArchive& archive, const Model& model, const State& state) {
  const HostChunks chunks(model.chunks);
  ChunkRows rows;
  std::size_t total = 0;
  for (int c = 0; c < chunks.count; ++c) {
    rows.counts.push_back(std::int64_t{count_elements(chunks, c)} * chunks.record_size(c));
    total += static_cast<std::size_t>(rows.counts.back());
  }
  std::vector<double> records(total);
  const auto packs = to_host(state.elements);
  std::size_t next = 0;
  if (!archive.is_loading()) {
    visit_records(chunks, packs, [&](const ElementRecord& record, int size, bool is_repeated) {
      if (is_repeated) return;
      for (int s = 0; s < size; ++s) records[next++] = record.get(s);
    });
  }
  archive.rows("elements/records", rows, 1, records);
  if (!archive.is_loading()) return;
  visit_records(chunks, packs, [&](const LaneRecord<Real>& record, int size, bool is_repeated) {
    if (is_repeated) next -= static_cast<std::size_t>(size);  // the last element's again
    for (int s = 0; s < size; ++s) record[s] = static_cast<Real>(records[next++]);
  });
  copy_values(state.elements, packs);
}

void archive_eroded(CheckpointArchive& archive, State& state) {
  Books& books = state.books;
  for (std::size_t k = 0; k < work_kinds; ++k)
    archive.sum(fmt::format("books/eroded_{}", WorkKind::names[k]), books.eroded_work[k]);
  archive.sum("books/eroded_kinetic", books.eroded_kinetic);
  archive.sum("books/eroded_mass", books.eroded_mass);
  archive.number("books/eroded_elements", books.eroded_elements);
  archive.number("books/total_mass", state.total_mass);
}

/// The chunks' own slots; those of pressure follow from the positions, those of other ranks come from them.
void archive_slots(CheckpointArchive& archive, const char* name, const Model& model, const Rows3<double>& slots) {
  const auto first_slot = to_host(model.chunks.first_slot);
  const auto count = static_cast<std::size_t>(model.chunks.count);
  ChunkRows rows;
  for (std::size_t c = 0; c < count; ++c) rows.counts.push_back(first_slot(c + 1) - first_slot(c));
  const auto own = static_cast<std::size_t>(first_slot(count));
  archive.rows(name, rows, 3, Kokkos::subview(slots, std::pair(std::size_t{0}, own), Kokkos::ALL));
}

/// Rotary inertia of nodes of beams beyond a number, by node: diagonal and rest; zeros where there is none.
std::array<Rows3<double>, 2> spread_tensors(const Model& model, const State& state) {
  const auto nodes = static_cast<std::size_t>(model.node_count);
  const std::array<Rows3<double>, 2> by_node{Rows3<double>("percuss::tensor_diagonals", nodes),
                                             Rows3<double>("percuss::tensor_rests", nodes)};
  const SpinTensors of = state.spin_tensors;
  const auto diagonal = by_node[0], rest = by_node[1];
  parallel_for(
      "percuss::spread_tensors", RangeOf(ExecSpace(), 0, static_cast<int>(of.node.extent(0))),
      KOKKOS_LAMBDA(const int i) {
        for (int k = 0; k < 3; ++k) {
          diagonal(of.node(i), k) = of.excess(i, k);
          rest(of.node(i), k) = of.excess(i, 3 + k);
        }
      });
  return by_node;
}

void collect_tensors(const std::array<Rows3<double>, 2>& by_node, const State& state) {
  const SpinTensors of = state.spin_tensors;
  const auto diagonal = by_node[0], rest = by_node[1];
  parallel_for(
      "percuss::collect_tensors", RangeOf(ExecSpace(), 0, static_cast<int>(of.node.extent(0))),
      KOKKOS_LAMBDA(const int i) {
        for (int k = 0; k < 3; ++k) {
          of.excess(i, k) = diagonal(of.node(i), k);
          of.excess(i, 3 + k) = rest(of.node(i), k);
        }
      });
}

void archive_tensors(CheckpointArchive& archive, const ChunkRows& nodes, const Model& model, State& state) {
  const auto by_node = spread_tensors(model, state);
  archive.rows("nodes/spin_tensor_diagonal", nodes, 3, by_node[0]);
  archive.rows("nodes/spin_tensor_rest", nodes, 3, by_node[1]);
  if (archive.is_loading()) collect_tensors(by_node, state);
}

/// Archives what shells add.
void archive_spins(CheckpointArchive& archive, const ChunkRows& nodes, const Model& model, State& state) {
  if (!model.has_rotations) return;
  archive.rows("nodes/w", nodes, 3, state.w);
  if (model.has_beams) archive_tensors(archive, nodes, model, state);
  archive_slots(archive, "elements/slot_moment", model, state.slot_moment);
}

void archive_bound(CheckpointArchive& archive, State& state) {
  StepBound& bound = state.bound;
  archive.number_or_infinity("bound/step", bound.step);  // no element left: no bound
  archive.number("bound/element", bound.element);
  archive.number("bound/element_id", bound.element_id);
}

void archive_books(CheckpointArchive& archive, Books& books) {
  archive.sum("books/external_work", books.external_work);
  archive.sums("books/impulse", books.impulse);
  archive.sums("books/moment_impulse", books.moment_impulse);
  archive.number("books/contact_work", books.contact_work);
  archive.number("books/friction_work", books.friction_work);
  archive.sum("books/damping_work", books.damping_work);
}

std::vector<std::string> split_lines(const std::string& text) {
  std::vector<std::string> lines;
  for (std::size_t begin = 0; begin < text.size();) {
    const auto end = std::min(text.find('\n', begin), text.size());
    lines.push_back(text.substr(begin, end - begin));
    begin = end + 1;
  }
  return lines;
}

/// The first few of a list, and how many more there are.
std::string join_first(const std::vector<std::string>& items) {
  constexpr std::size_t most = 5;
  const auto end = items.begin() + static_cast<std::ptrdiff_t>(std::min(most, items.size()));
  std::string text = fmt::format("{}", fmt::join(items.begin(), end, ", "));
  if (items.size() > most) text += fmt::format(" and {} more", items.size() - most);
  return text;
}

}  // namespace

void archive_state(CheckpointArchive& archive, const ChunkedMesh& chunked, const Model& model, State& state) {
  archive.number("time", state.time);
  archive.integer("step", state.step);
  archive.number("dt", state.dt);
  archive.number("next_dt", state.next_dt);
  archive_bound(archive, state);
  const ChunkRows nodes = find_owned_node_rows(chunked);
  archive.rows("nodes/x", nodes, 3, state.x);
  archive.rows("nodes/v", nodes, 3, state.v);
  archive.rows("nodes/impulse", nodes, 3, state.impulse);
  archive_elements(archive, model, state);
  archive_slots(archive, "elements/slot_force", model, state.slot_force);
  archive_spins(archive, nodes, model, state);
  if (model.damps_stiffness) {
    archive_slots(archive, "elements/damping_force", model, state.damping_force);
    if (model.has_rotations) archive_slots(archive, "elements/damping_moment", model, state.damping_moment);
  }
  const ChunkRows chunks{std::vector<std::int64_t>(chunked.chunks.size(), 1), {}};
  archive.rows("chunks/work", chunks, work_kinds, state.results.work);
  if (model.resists_folding) archive.rows("chunks/resists", chunks, 1, state.results.resists);
  archive_books(archive, state.books);
  if (!model.can_erode) return;
  archive_lives(archive, model, state);
  archive_eroded(archive, state);
}

void complete_state(const ChunkedMesh& chunked, const Model& model, const State& state) {
  if (model.ranks.size() == 1) return;
  UnstructuredExchange exchange(model.ranks);
  SharedNodes shared = find_shared_nodes(exchange, chunked.mesh.node_numbers);
  for (std::size_t n = 0; n < shared.owners.size(); ++n) {
    shared.owners[n] = chunked.numbering.find_node_owner(chunked.mesh.node_numbers[n]);
  }
  NodeCopies copies(model.ranks, shared);
  std::vector<Rows3<double>> rows{state.x, state.v, state.impulse};
  if (model.has_rotations) rows.push_back(state.w);
  for (const auto& values : rows) {
    copies.begin(ExecSpace(), values);
    copies.end(ExecSpace(), values);
  }
  if (!model.has_rotations || !model.has_beams) return;
  const auto tensors = spread_tensors(model, state);
  for (const auto& values : tensors) {
    copies.begin(ExecSpace(), values);
    copies.end(ExecSpace(), values);
  }
  collect_tensors(tensors, state);
}

CheckpointHeader make_checkpoint_header(const Deck& deck, const std::vector<std::string>& pieces,
                                        const ChunkedMesh& chunked, const State& state) {
  CheckpointHeader header;
  header.version = PERCUSS_VERSION;
  header.precision = precision_name;
  header.title = deck.title;
  header.deck = fmt::format("{}", fmt::join(deck.motion_values, "\n"));
  header.values = deck.resolved;
  header.mesh = hash_mesh_pieces(pieces);
  header.pieces = fmt::format("{}", fmt::join(pieces, "\n"));
  header.written = fmt::format("{:%Y-%m-%d %H:%M:%S} UTC", fmt::gmtime(std::chrono::system_clock::now()));
  header.elements = chunked.numbering.element_count();
  header.nodes = chunked.numbering.node_count();
  header.step = state.step;
  header.time = state.time;
  return header;
}

void check_checkpoint_header(const std::string& path, const CheckpointHeader& checkpoint, const CheckpointHeader& now,
                             const Deck& deck) {
  if (checkpoint.version != now.version || checkpoint.precision != now.precision) {
    throw InputError(
        fmt::format("{}: error: the checkpoint was written by percuss {} in {} precision (this is percuss {} in {} "
                    "precision): continue with the version that wrote it",
                    path, checkpoint.version, checkpoint.precision, now.version, now.precision));
  }
  const auto differences = compare_motion_values(deck.motion_values, split_lines(checkpoint.deck));
  if (!differences.empty()) {
    throw InputError(
        fmt::format("{}: error: the deck differs from that of {} (a restart must have the same scene): {}; only title, "
                    "units, {}, audit, silence, paths of mesh files, time.end, time.max_steps, time.until, "
                    "time.collapse_ratio and contact.rebalance may change",
                    deck.file, path, join_first(differences),
                    deck.sensors.empty() ? "output" : "output without output.history, which sensors look at"));
  }
  if (checkpoint.mesh == now.mesh) return;
  const auto pieces = compare_mesh_pieces(split_lines(now.pieces), split_lines(checkpoint.pieces));
  throw InputError(
      fmt::format("{}: error: the mesh differs from that of {} (a restart must have the same mesh): {}; was "
                  "a mesh file changed, or a section by elements?",
                  deck.file, path, join_first(pieces)));
}

std::vector<std::string> list_changed_values(const CheckpointHeader& checkpoint, const Deck& deck) {
  return compare_free_values(deck.motion_values, split_lines(checkpoint.deck));
}

void refuse_changed_regions(const CheckpointHeader& checkpoint, const Deck& deck,
                            const std::vector<std::string>& changes) {
  constexpr std::string_view outputs = "output.field_outputs.";
  for (const std::string& change : changes) {
    if (!change.starts_with(outputs)) continue;
    const std::string name = change.substr(outputs.size(), change.find('.', outputs.size()) - outputs.size());
    const std::string path = fmt::format("{}{}.", outputs, name),
                      key = change.substr(std::min(path.size(), change.size()));
    const bool is_region = key.starts_with("elements") || key.starts_with("faces");
    if (!is_region || checkpoint.deck.find(path) == std::string::npos) continue;
    throw InputError(
        fmt::format("{}: error: field output '{}' shows other elements than in the run of the checkpoint "
                    "({}): give it another name, or continue in another folder with --out",
                    deck.file, name, change));
  }
}

}  // namespace percuss
