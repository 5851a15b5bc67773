#include "kernels/element/centroid_forces.hpp"

#include "kernels/element/chunk_records.hpp"
#include "kernels/element/hex8/centroid.hpp"
#include "kernels/element/living_lanes.hpp"

namespace percuss {

namespace {

/// Some elements of a chunk, a lane each.
struct ElementLanes {
  int first, count;              // counted from the chunk's first
  const std::uint16_t* corners;  // [8][pack_size<Real>] of the first lane on
};

struct CentroidKernel {
  using Scratch = ChunkScratch<2, 1>;
  static constexpr int width = pack_size<double>;

  ElementChunks chunks;
  FluidChunks fluids;
  CentroidMotion motion;
  CentroidFields fields;

  KOKKOS_FUNCTION void operator()(const ChunkMember& member) const {
    const int i = member.league_rank();
    const TeamChunk chunk(chunks, fluids.list(i));
    const Scratch scratch(member, chunk.slot_count);
    scratch.fill_rows(chunk, motion.x.data(), motion.v.data());
    scratch.clear(chunk);
    const Collapsed shape = find_collapsed(find_family(chunks, chunk.c));
    LivingLanes<Real> living(motion.failing, motion.lives, chunk.c);
    chunk.for_each_pack(living, nullptr, 0, [&](const ChunkPack& pack) {
      for (int lane = 0; lane < pack.lanes; lane += width) {
        const int left = pack.lanes - lane;
        const ElementLanes lanes{pack.first + lane, left < width ? left : width, pack.corners + lane};
        push(i, scratch, shape, lanes, find_masses(chunk, living, lanes, lane));
      }
    });
    leave(i, chunk, scratch);
  }

  /// What counts of the mass of each lane. Lanes past the end repeat the last element.
  KOKKOS_FUNCTION Lanes find_masses(const TeamChunk& chunk, const LivingLanes<Real>& living, const ElementLanes& lanes,
                                    int first_lane) const {
    alignas(64) double mass[width];
    for (int lane = 0; lane < width; ++lane) {
      const int of = lane < lanes.count ? lane : lanes.count - 1;
      const double share = living.can_fail() ? living.find_force_share(first_lane + of) : 1;
      mass[lane] = share > 0 ? share * motion.mass(chunk.first_element + lanes.first + of) : 0;
    }
    return load_pack(mass);
  }

  KOKKOS_FUNCTION void push(int i, const Scratch& scratch, const Collapsed& shape, const ElementLanes& lanes,
                            const Lanes& mass) const {
    VectorModes<Lanes> a;
    gather_places(scratch, shape, lanes, a);
    const double share = motion.dt_mean > 0 ? 1 : fluids.start_weight(i);
    const Vector3<Lanes> gravity{Lanes(share * motion.gravity[0]), Lanes(share * motion.gravity[1]),
                                 Lanes(share * motion.gravity[2])};
    Vector3<Lanes> weight = gravity - find_accelerations(fluids.first_element(i) + lanes.first, lanes.count,
                                                         gather_mean(scratch, shape, lanes));
    weight = find_weight_share(a, mass, weight, gravity, Lanes(fluids.bulk_modulus(i))) * weight;
    Lanes f[3][8];
    find_centroid_forces(a, mass, weight, f);
    if (!shape.is_whole) add_weight_of_shares(shape, mass, weight, f);
    scatter(f, shape, lanes, scratch.forces);
  }

  PERCUSS_FORCE_INLINE static const std::uint16_t* find_corner(const Collapsed& shape, const ElementLanes& lanes,
                                                               int corner) {
    return lanes.corners + shape.corner[corner] * pack_size<Real>;
  }

  PERCUSS_NO_INLINE static void gather_places(const Scratch& scratch, const Collapsed& shape, const ElementLanes& lanes,
                                              VectorModes<Lanes>& a) {
    Lanes x[3][8];
    for (int corner = 0; corner < 8; ++corner) {
      Lanes place[3];
      gather_corner(scratch.nodes, Scratch::node_size, find_corner(shape, lanes, corner), place);
      for (int k = 0; k < 3; ++k) x[k][corner] = place[k];
    }
    for (int k = 0; k < 3; ++k) to_modes(x[k]);
    for (int m = 1; m < 8; ++m) a[m] = {x[0][m], x[1][m], x[2][m]};
  }

  /// Velocity of the mass at the corners.
  PERCUSS_NO_INLINE static Vector3<Lanes> gather_mean(const Scratch& scratch, const Collapsed& shape,
                                                      const ElementLanes& lanes) {
    Vector3<Lanes> mean{Lanes(0), Lanes(0), Lanes(0)};
    for (int corner = 0; corner < 8; ++corner) {
      Lanes v[3];
      gather_corner(scratch.nodes + 4, Scratch::node_size, find_corner(shape, lanes, corner), v);
      mean = mean + Lanes(shape.share[corner]) * Vector3<Lanes>{v[0], v[1], v[2]};
    }
    return mean;
  }

  /// From the mean velocities before, which those of now take the place of. first: element of fluids.
  KOKKOS_FUNCTION Vector3<Lanes> find_accelerations(int first, int count, const Vector3<Lanes>& now) const {
    alignas(64) double before[3][width], after[3][width];
    store_pack(after[0], now.x);
    store_pack(after[1], now.y);
    store_pack(after[2], now.z);
    for (int lane = 0; lane < width; ++lane)
      for (int k = 0; k < 3; ++k) before[k][lane] = fields.velocity(first + (lane < count ? lane : count - 1), k);
    for (int lane = 0; lane < count; ++lane)
      for (int k = 0; k < 3; ++k) fields.velocity(first + lane, k) = after[k][lane];
    const Lanes per_dt(motion.dt_mean > 0 ? 1 / motion.dt_mean : 0);
    return per_dt * (now - Vector3<Lanes>{load_pack(before[0]), load_pack(before[1]), load_pack(before[2])});
  }

  /// Subtracts the forces, element by element.
  PERCUSS_NO_INLINE static void scatter(const Lanes (&f)[3][8], const Collapsed& shape, const ElementLanes& lanes,
                                        double* forces) {
    alignas(64) double records[8][width][4];
    for (int corner = 0; corner < 8; ++corner) {
      const Lanes packs[3] = {f[0][corner], f[1][corner], f[2][corner]};
      transpose_to_records(packs, records[corner]);
    }
    for (int lane = 0; lane < lanes.count; ++lane)
      for (int corner = 0; corner < 8; ++corner) {
        const auto slot = static_cast<std::size_t>(find_corner(shape, lanes, corner)[lane]);
        subtract_record(records[corner][lane], forces + Scratch::force_size * slot);
      }
  }

  /// The forces into the slots of fluids, and what they amount to.
  KOKKOS_FUNCTION void leave(int i, const TeamChunk& chunk, const Scratch& scratch) const {
    double sum[CentroidSum::count] = {};
    for (int s = 0; s < chunk.slot_count; ++s) {
      const double *x = scratch.nodes + Scratch::node_size * s, *v = x + 4;
      const double* const f = scratch.forces + Scratch::force_size * s;
      const int slot = fluids.first_slot(i) + s;
      double r[3];
      for (int k = 0; k < 3; ++k) {
        r[k] = x[k] - motion.center[k];
        sum[CentroidSum::old_power] += fields.slot_force(slot, k) * v[k];
        sum[CentroidSum::power] += f[k] * v[k];
        fields.slot_force(slot, k) = f[k];
      }
      sum[CentroidSum::moment] += r[1] * f[2] - r[2] * f[1];
      sum[CentroidSum::moment + 1] += r[2] * f[0] - r[0] * f[2];
      sum[CentroidSum::moment + 2] += r[0] * f[1] - r[1] * f[0];
    }
    for (int k = 0; k < CentroidSum::count; ++k) fields.sums(i, k) = sum[k];
  }
};

}  // namespace

void apply_centroid_forces(const ExecSpace& space, const ElementChunks& chunks, const FluidChunks& fluids,
                           const CentroidMotion& motion, const CentroidFields& fields) {
  if (fluids.count() == 0) return;
  Kokkos::parallel_for("percuss::apply_centroid_forces",
                       CentroidKernel::Scratch::make_policy(space, fluids.count(), chunks.largest_slot_count, 0),
                       CentroidKernel{chunks, fluids, motion, fields});
}

}  // namespace percuss
