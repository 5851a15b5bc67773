#include "src/contact/enforcement/contact_forces.hpp"

#include <algorithm>
#include <array>

#include "comm/exact_reduction.hpp"
#include "comm/gather_items.hpp"
#include "kernels/core/host_copy.hpp"

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

bool names(const std::vector<std::string>& parts, const std::string& part) {
  return std::find(parts.begin(), parts.end(), part) != parts.end();
}

/// Whether the force acts on a part, and whether it comes from it.
struct PartSides {
  bool one, other;
};
PartSides find_part_sides(const ForceDeck& force, const std::string& part) {
  if (force.kind == ForceDeck::Kind::wall) return {true, false};
  const bool one = names(force.on, part);
  return {one, force.from.empty() ? !one : names(force.from, part)};
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

ContactForces::ContactForces(const Deck& deck, const ChunkedMesh& chunked, const Communicator& ranks) : ranks_(ranks) {
  const std::vector<ForceDeck> forces = list_contact_forces(deck);
  if (forces.empty()) return;
  sums_.resize(forces.size());
  const std::vector<int> parts = find_parts_of_chunks(chunked, ranks_);
  std::vector<std::uint32_t> one(parts.size(), 0), other(parts.size(), 0), walls(deck.walls.size(), 0);
  for (std::size_t f = 0; f < forces.size(); ++f) {
    const std::uint32_t bit = std::uint32_t{1} << f;
    const Vec3 about = forces[f].about.value_or(Vec3{});
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
            to_view("contact::force_from", other), to_view("contact::force_walls", walls)};
}

template <class Space>
void ContactForces::book(const Space& space, const RowSystem& system, const Array<const std::int64_t>& node_numbers) {
  if (is_empty()) return;
  mark_rows(space, sides_, node_numbers, system, marks_);
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
  }
}

std::vector<ContactImpulse> ContactForces::take() {
  std::vector<ContactImpulse> taken;
  for (ForceSums& share : sums_) {
    std::array<ExactSum, 8> sums{share.impulse[0], share.impulse[1], share.impulse[2], share.moment[0],
                                 share.moment[1],  share.moment[2],  share.normal,     share.tangential};
    sum_over_ranks(ranks_, sums);
    taken.push_back({round(&sums[0]), round(&sums[3]), sums[6].round(), sums[7].round()});
    share = {};
  }
  return taken;
}

template void ContactForces::book(const ExecSpace&, const RowSystem&, const Array<const std::int64_t>&);
#if defined(PERCUSS_SMALL_SPACE)
template void ContactForces::book(const SmallSpace&, const RowSystem&, const Array<const std::int64_t>&);
#endif

}  // namespace percuss
