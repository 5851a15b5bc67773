#include "src/contact/enforcement/contact_forces.hpp"

#include <algorithm>
#include <array>
#include <numeric>
#include <span>

#include "comm/all_reduce.hpp"
#include "comm/exact_reduction.hpp"
#include "comm/gather_items.hpp"
#include "kernels/core/host_copy.hpp"
#include "kernels/core/small_space.hpp"
#include "kernels/core/view_copy.hpp"

namespace percuss {
namespace {

struct PartOfChunk {
  int chunk, part;
};

/// The part of every chunk of the whole mesh.
std::vector<int> find_parts_of_chunks(const ChunkedMesh& chunked, const Communicator& ranks) {
  std::vector<PartOfChunk> own;
  own.reserve(chunked.chunks.size());
  for (const Chunk& chunk : chunked.chunks) own.push_back({chunk.number, chunk.part});
  std::vector<int> parts(static_cast<std::size_t>(chunked.numbering.chunk_count()), -1);
  for (const PartOfChunk& item : gather_items(ranks, own)) parts[static_cast<std::size_t>(item.chunk)] = item.part;
  return parts;
}

/// Whether a side names the whole part.
bool names(const std::vector<Selector>& side, const std::string& part) {
  return std::any_of(side.begin(), side.end(), [&](const Selector& s) { return !s.inside && s.name == part; });
}

/// Whether the force acts on a part, and whether it comes from it.
struct PartSides {
  bool one, other;
};
PartSides find_part_sides(const ForceDeck& force, const std::string& part) {
  if (force.kind == ForceDeck::Kind::wall) return {true, false};
  return {names(force.on, part), names(force.from, part)};
}

bool comes_from_wall(const ForceDeck& force, const WallDeck& wall) {
  return force.kind == ForceDeck::Kind::wall ? wall.name == force.wall : force.from.empty();
}

std::vector<ForceDeck> list_contact_forces(const Deck& deck) {
  std::vector<ForceDeck> forces;
  for (const ForceDeck& force : deck.output.forces) {
    if (force.is_of_contact()) forces.push_back(force);
  }
  return forces;
}

Vec3 round(ExactSum* sums) { return {sums[0].round(), sums[1].round(), sums[2].round()}; }

void normalize(ForceSums& sums) {
  for (ExactSum& sum : sums.impulse) sum.normalize();
  for (ExactSum& sum : sums.moment) sum.normalize();
  sums.normal.normalize();
  sums.tangential.normalize();
}

}  // namespace

ContactForces::ContactForces(const Deck& deck, const ChunkedMesh& chunked, const Communicator& ranks)
    : deck_(deck), chunked_(chunked), ranks_(ranks), forces_(list_contact_forces(deck)) {
  const std::vector<ForceDeck>& forces = forces_;
  if (forces.empty()) return;
  sums_.resize(forces.size());
  const std::vector<int> parts = find_parts_of_chunks(chunked, ranks_);
  std::vector<std::uint32_t> one(parts.size(), 0), other(parts.size(), 0), walls(deck.walls.size(), 0);
  std::uint32_t from_all = 0;
  for (std::size_t f = 0; f < forces.size(); ++f) {
    const std::uint32_t bit = std::uint32_t{1} << f;
    const Vec3 about = forces[f].about.value_or(Vec3{});
    if (forces[f].kind == ForceDeck::Kind::contact && forces[f].from.empty()) from_all |= bit;
    names_.push_back("contact/force/" + identify(forces[f]) + "/");
    about_.push_back({about[0], about[1], about[2]});
    for (std::size_t c = 0; c < parts.size(); ++c) {
      const PartSides sides = find_part_sides(forces[f], deck.parts[static_cast<std::size_t>(parts[c])].name);
      if (sides.one) one[c] |= bit;
      if (sides.other) other[c] |= bit;
    }
    for (std::size_t w = 0; w < walls.size(); ++w) {
      if (comes_from_wall(forces[f], deck.walls[w])) walls[w] |= bit;
    }
  }
  sides_ = {to_view("contact::first_nodes", chunked.numbering.first_node), to_view("contact::force_on", one),
            to_view("contact::force_from", other), to_view("contact::force_walls", walls), from_all};
  part_of_chunk_ = parts;
  one_ = one;
  if (!names_surfaces()) lay_out(one_);
}

bool ContactForces::names_surfaces() const {
  const auto is_it = [&](const Selector& side) { return is_surface(deck_, side); };
  return std::any_of(forces_.begin(), forces_.end(), [&](const ForceDeck& force) {
    return std::any_of(force.on.begin(), force.on.end(), is_it) ||
           std::any_of(force.from.begin(), force.from.end(), is_it);
  });
}

void ContactForces::set_surface(const ContactRanks& ranks, const SurfaceShare& share) {
  if (!names_surfaces()) return;
  const bool is_first = !surfaces_;
  surfaces_.reset();
  surfaces_.emplace(ranks, chunked_, deck_, share, forces_);
  if (!is_first) return;
  // Faces that erosion will expose belong to nodes of these parts.
  for (std::size_t c = 0; c < one_.size(); ++c)
    one_[c] |= surfaces_->parts()[static_cast<std::size_t>(part_of_chunk_[c])];
  lay_out(one_);
}

/// The books of the pushes.
void ContactForces::lay_out(const std::vector<std::uint32_t>& one) {
  const std::size_t forces = sums_.size();
  std::vector<int> first(one.size() * forces, -1);
  int next = 0;
  for (std::size_t f = 0; f < forces; ++f) {
    ChunkRows rows;
    for (const Chunk& chunk : chunked_.chunks) {
      const auto c = static_cast<std::size_t>(chunk.number);
      const bool is_of_side = (one[c] >> f & 1) != 0;
      const std::int64_t nodes = chunked_.numbering.first_node[c + 1] - chunked_.numbering.first_node[c];
      rows.counts.push_back(is_of_side ? nodes : 0);
      if (is_of_side) first[c * forces + f] = next;
      next += static_cast<int>(rows.counts.back());
    }
    book_rows_.push_back(std::move(rows));
  }
  books_ = {static_cast<int>(forces), to_view("contact::book_first", first),
            Rows4<double>("contact::books", static_cast<std::size_t>(next))};
}

void ContactForces::book(const WorkSpace& space, const SolvedRows& solved) {
  if (is_empty()) return;
  const RowSystem& system = solved.system;
  Array<const RowSurfaces> surfaces;
  if (surfaces_) surfaces = surfaces_->find(system, solved.node_numbers, solved.x);
  mark_rows(space, {sides_, surfaces}, solved.node_numbers, system, marks_);
  list_sent_pushes(space, system, marks_, sent_);
  space.fence();
  solved.exchange.send_pushes(sent_, system, remote_);
  book_pushes(space, {system, marks_, remote_}, sides_, solved.node_numbers, solved.dt, books_);
  for (std::size_t f = 0; f < sums_.size(); ++f) {
    sums_[f].merge(sum_contact_force(space, static_cast<int>(f), about_[f], system, marks_, partial_));
    normalize(sums_[f]);
  }
}

void ContactForces::archive(CheckpointArchive& archive) {
  for (std::size_t f = 0; f < sums_.size(); ++f) {
    double is_there = 1;
    if (!archive.has_number(names_[f] + "booked")) continue;
    archive.number(names_[f] + "booked", is_there);
    archive.sums(names_[f] + "impulse", sums_[f].impulse);
    archive.sums(names_[f] + "moment", sums_[f].moment);
    archive.sum(names_[f] + "normal", sums_[f].normal);
    archive.sum(names_[f] + "tangential", sums_[f].tangential);
    archive_books(archive, f);
  }
}

void ContactForces::archive_books(CheckpointArchive& archive, std::size_t f) {
  const auto count = [](const ChunkRows& rows) {
    return static_cast<std::size_t>(std::accumulate(rows.counts.begin(), rows.counts.end(), std::int64_t{0}));
  };
  std::size_t first = 0;
  for (std::size_t before = 0; before < f; ++before) first += count(book_rows_[before]);
  const std::size_t end = first + count(book_rows_[f]);
  const auto part = Kokkos::subview(books_.sums, std::pair(first, end), Kokkos::ALL);
  const auto host = to_host(part);
  archive.rows(names_[f] + "pushes", book_rows_[f], 4, std::span<double>(host.data(), host.size()));
  if (archive.is_loading()) copy_values(part, host);
}

void ContactForces::sum_areas(const AreaNodes& nodes, std::vector<ContactImpulse>& taken) {
  for (std::size_t f = 0; f < taken.size(); ++f) {
    AreaSums share;
    run_where_it_pays(static_cast<int>(nodes.numbers.extent(0)) / 4, [&](const auto& space) {
      share = percuss::sum_areas(space, static_cast<int>(f), nodes, sides_, books_, area_partial_);
    });
    share.area.normalize();
    std::array<ExactSum, 1> area{share.area};
    sum_over_ranks(ranks_, area);
    all_reduce(ranks_, Reduce::largest, share.press);
    taken[f].area = area[0].round();
    taken[f].press = share.press;
  }
  set_values(books_.sums, 0.0);
}

std::vector<ContactImpulse> ContactForces::take(const AreaNodes& nodes) {
  std::vector<ContactImpulse> taken;
  for (ForceSums& share : sums_) {
    std::array<ExactSum, 8> sums{share.impulse[0], share.impulse[1], share.impulse[2], share.moment[0],
                                 share.moment[1],  share.moment[2],  share.normal,     share.tangential};
    sum_over_ranks(ranks_, sums);
    taken.push_back({round(&sums[0]), round(&sums[3]), sums[6].round(), sums[7].round()});
    share = {};
  }
  sum_areas(nodes, taken);
  return taken;
}

}  // namespace percuss
