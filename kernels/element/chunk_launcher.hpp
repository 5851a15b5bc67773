#pragma once
// The one launcher of the elements of a step, for all families: a team a chunk, which goes through it pack by pack.
//
// A family has a body, which is made anew for each chunk and says what is its own:
//   Block, Parameters, Scratch, Sums, Lives      chunks of a material, what is read of it, records of nodes and forces
//                                                (ChunkScratch), sums of elements, which lanes live
//   largest_record                               numbers of a pack's record at most
//   find_parameters(of, c), may_rest(of, c)      of a chunk; whether an evaluation at rest leaves its material as it is
//   find_record_size()                           numbers of a pack's record
//   advance(parameters, pack, lives, sums)       a pack from n to n+1: its forces go into the scratch, its bounds and
//                                                its work into the sums
//   leave()                                      what else the chunk leaves

#include "kernels/element/chunk_records.hpp"
#include "kernels/element/chunk_rest.hpp"
#include "kernels/element/chunk_sums.hpp"
#include "kernels/element/element_motion.hpp"
#include "kernels/element/living_lanes.hpp"

namespace percuss {

/// A block in a step.
template <class Block>
struct BlockStep {
  ElementChunks chunks;
  Block block;
  ElementMotion motion;
  ChunkFields fields;
};

/// Advances the packs of a chunk that have elements which live. Returns whether a bit of the records has changed, if
/// watched.
template <class Body>
PERCUSS_FORCE_INLINE bool advance_packs(const BlockStep<typename Body::Block>& of, const TeamChunk& chunk, Body& body,
                                        typename Body::Sums& sums, bool watched) {
  constexpr int width = TeamChunk::width;
  typename Body::Parameters parameters = Body::find_parameters(of, chunk.c);
  typename Body::Lives lives(of.motion.failing, of.motion.lives, chunk.c);
  RecordWatch<Body::largest_record> watch(watched);
  const auto size = body.find_record_size();
  Real* record = &of.fields.state(of.chunks.first_state(chunk.c));
  const std::uint16_t* corners = chunk.corners();
  for (int e = 0; e < chunk.count; e += width, record += size, corners += 8 * width) {
    ChunkPack pack{e, chunk.count - e < width ? chunk.count - e : width, corners, record, record + size};
    if (lives.can_fail() && !lives.take_pack(pack.corners)) continue;
    watch.keep(record, size);
    body.advance(parameters, pack, lives, sums);
    watch.compare(record, size);
  }
  return watch.has_changed();
}

template <class Body>
struct ElementKernel : BlockStep<typename Body::Block> {
  using Of = BlockStep<typename Body::Block>;
  using Scratch = typename Body::Scratch;
  using Of::fields;
  using Of::motion;

  KOKKOS_FUNCTION void operator()(const ChunkMember& member) const {
    const TeamChunk chunk(Of::chunks, Of::block.chunks(member.league_rank()));
    const bool may_rest = motion.skips_rest && Body::may_rest(*this, chunk.c);
    if constexpr (Scratch::vectors == 3) {
      const ChunkRest rest(Of::chunks, fields.results, chunk.c, may_rest, motion.v, motion.w);
      if (rest.skips()) return;
      const Scratch scratch(member, chunk.slot_count);
      scratch.fill(chunk, motion.x.data(), motion.v.data(), motion.spins().data());
      advance_chunk(chunk, scratch, rest);
    } else {
      const ChunkRest rest(Of::chunks, fields.results, chunk.c, may_rest, motion.v);
      if (rest.skips()) return;
      const Scratch scratch(member, chunk.slot_count);
      scratch.fill(chunk, motion.x.data(), motion.v.data());
      advance_chunk(chunk, scratch, rest);
    }
  }

  KOKKOS_FUNCTION void advance_chunk(const TeamChunk& chunk, const Scratch& scratch, const ChunkRest& rest) const {
    scratch.clear(chunk);
    Body body(*this, chunk, scratch);
    typename Body::Sums sums;
    rest.leave(advance_packs(*this, chunk, body, sums, rest.is_at_rest()));
    body.leave();
    sums.leave_work(chunk.c, fields.results);
    sums.leave_step(chunk.c, chunk.first_element, chunk.count, fields.results);
    scratch.leave(chunk, fields.slot_force, fields.slot_moment);
  }
};

/// Advances the elements of a block from n to n+1. One without chunks costs nothing.
template <class Body, class Block>
void launch_elements(const char* label, const ExecSpace& space, const ElementChunks& chunks, const Block& block,
                     const ElementMotion& motion, const ChunkFields& fields) {
  if (block.chunks.extent(0) == 0) return;
  launch_chunks(label, space, chunks, block.chunks, ElementKernel<Body>{{chunks, block, motion, fields}});
}

}  // namespace percuss
