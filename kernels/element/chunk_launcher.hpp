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
  typename Body::Parameters parameters = Body::find_parameters(of, chunk.c);
  typename Body::Lives lives(of.motion.failing, of.motion.lives, chunk.c);
  RecordWatch<Body::largest_record> watch(watched);
  const auto size = body.find_record_size();
  chunk.for_each_pack(lives, &of.fields.state(of.chunks.first_state(chunk.c)), size, [&](const ChunkPack& pack) {
    watch.keep(pack.record, size);
    body.advance(parameters, pack, lives, sums);
    watch.compare(pack.record, size);
  });
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
    const ChunkRest rest = look_at_rest(chunk);
    if (rest.skips()) return;
    const Scratch scratch(member, chunk.slot_count);
    scratch.fill(chunk, motion);
    scratch.clear(chunk);
    Body body(*this, chunk, scratch);
    typename Body::Sums sums;
    rest.leave(advance_packs(*this, chunk, body, sums, rest.is_at_rest()));
    body.leave();
    sums.leave_work(chunk.c, fields.results);
    sums.leave_step(chunk.c, chunk.first_element, chunk.count, fields.results);
    scratch.leave(chunk, fields.slot_force, fields.slot_moment);
  }

  KOKKOS_FUNCTION ChunkRest look_at_rest(const TeamChunk& chunk) const {
    const bool may_rest = motion.skips_rest && Body::may_rest(*this, chunk.c);
    if constexpr (Scratch::has_spins) {
      return {Of::chunks, fields.results, chunk.c, may_rest, motion.v, motion.w};
    } else {
      return {Of::chunks, fields.results, chunk.c, may_rest, motion.v};
    }
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
