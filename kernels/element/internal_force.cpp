#include "kernels/element/internal_force.hpp"

#include "kernels/core/transpose.hpp"

namespace percuss {

namespace {

using Lanes = Pack<double>;
constexpr int width = pack_size<double>;
constexpr int node_record = 8;   // x, y, z, -, vx, vy, vz, -: one cache line
constexpr int force_record = 4;  // fx, fy, fz, -

using Policy = Kokkos::TeamPolicy<ExecSpace, Kokkos::Schedule<Kokkos::Dynamic>>;
using Member = Policy::member_type;

template <class Material, HexKind Kind>
using LaneState = HexState<Lanes, Material, Kind>;

PERCUSS_FORCE_INLINE void load_symmetric(const double* from, Symmetric3<Lanes>& s) {
  s = {load_pack(from),
       load_pack(from + width),
       load_pack(from + 2 * width),
       load_pack(from + 3 * width),
       load_pack(from + 4 * width),
       load_pack(from + 5 * width)};
}
PERCUSS_FORCE_INLINE void store_symmetric(double* to, const Symmetric3<Lanes>& s) {
  store_pack(to, s.xx);
  store_pack(to + width, s.yy);
  store_pack(to + 2 * width, s.zz);
  store_pack(to + 3 * width, s.xy);
  store_pack(to + 4 * width, s.yz);
  store_pack(to + 5 * width, s.zx);
}
PERCUSS_FORCE_INLINE Vector3<Lanes> load_vector(const double* from) {
  return {load_pack(from), load_pack(from + width), load_pack(from + 2 * width)};
}
PERCUSS_FORCE_INLINE void store_vector(double* to, const Vector3<Lanes>& v) {
  store_pack(to, v.x);
  store_pack(to + width, v.y);
  store_pack(to + 2 * width, v.z);
}

template <class Material, HexKind Kind>
PERCUSS_FORCE_INLINE void load_state(const double* record, LaneState<Material, Kind>& s) {
  s.mass = load_pack(record + HexRecord::mass * width);
  s.viscous_pressure = load_pack(record + HexRecord::viscous_pressure * width);
  for (int i = 0; i < 3; ++i) s.polar.rotation.row[i] = load_vector(record + (HexRecord::rotation + 3 * i) * width);
  load_symmetric(record + HexRecord::stretch * width, s.polar.stretch);
  if constexpr (HexRecord::keeps_hourglass<Kind>) {
    for (int h = 0; h < 4; ++h) s.hourglass.mode[h] = load_vector(record + (HexRecord::hourglass + 3 * h) * width);
  }
  const double* history = record + HexRecord::history<Kind> * width;
  if constexpr (Kind == HexKind::full) {
    for (int p = 0; p < 8; ++p) {
      load_symmetric(record + (HexRecord::stress + 6 * p) * width, s.stress[p]);
      for (int i = 0; i < Material::history_count; ++i) s.history[p][i] = load_pack(history + (8 * i + p) * width);
    }
  } else {
    load_symmetric(record + HexRecord::stress * width, s.stress);
    for (int i = 0; i < Material::history_count; ++i) s.history[i] = load_pack(history + i * width);
  }
}

template <class Material, HexKind Kind>
PERCUSS_FORCE_INLINE void store_state(double* record, const LaneState<Material, Kind>& s) {
  store_pack(record + HexRecord::viscous_pressure * width, s.viscous_pressure);
  for (int i = 0; i < 3; ++i) store_vector(record + (HexRecord::rotation + 3 * i) * width, s.polar.rotation.row[i]);
  store_symmetric(record + HexRecord::stretch * width, s.polar.stretch);
  if constexpr (HexRecord::keeps_hourglass<Kind>) {
    for (int h = 0; h < 4; ++h) store_vector(record + (HexRecord::hourglass + 3 * h) * width, s.hourglass.mode[h]);
  }
  double* history = record + HexRecord::history<Kind> * width;
  if constexpr (Kind == HexKind::full) {
    for (int p = 0; p < 8; ++p) {
      store_symmetric(record + (HexRecord::stress + 6 * p) * width, s.stress[p]);
      for (int i = 0; i < Material::history_count; ++i) store_pack(history + (8 * i + p) * width, s.history[p][i]);
    }
  } else {
    store_symmetric(record + HexRecord::stress * width, s.stress);
    for (int i = 0; i < Material::history_count; ++i) store_pack(history + i * width, s.history[i]);
  }
}

/// Asks for the next pack's record while this one is computed: the hardware does not see across the pack's long body.
PERCUSS_FORCE_INLINE void prefetch([[maybe_unused]] const double* from, [[maybe_unused]] int count) {
#ifdef PERCUSS_HAS_SIMD
  constexpr int line = 8;
  for (int i = 0; i < count; i += line) __builtin_prefetch(from + i, 1, 3);
#endif
}

/// Modes of positions and velocities of the pack's elements, from the chunk's node records.
PERCUSS_FORCE_INLINE void gather_modes(const double* nodes, const std::uint16_t* corners, VectorModes<Lanes>& a,
                                       VectorModes<Lanes>& v) {
  Lanes u[6][8];
  for (int i = 0; i < 8; ++i) {
    const double* records[width];
    for (int lane = 0; lane < width; ++lane) {
      records[lane] = nodes + node_record * static_cast<int>(corners[i * width + lane]);
    }
    alignas(64) double packs[8][width];
    transpose_to_packs(records, packs);
    for (int k = 0; k < 3; ++k) {
      u[k][i] = load_pack(packs[k]);
      u[3 + k][i] = load_pack(packs[4 + k]);
    }
  }
  for (int k = 0; k < 6; ++k) to_modes(u[k]);
  for (int m = 1; m < 8; ++m) {
    a[m] = {u[0][m], u[1][m], u[2][m]};
    v[m] = {u[3][m], u[4][m], u[5][m]};
  }
}

/// Subtracts the corner forces of the first `lanes` elements from the chunk's force records, element by element.
PERCUSS_FORCE_INLINE void scatter_forces(const Lanes (&f)[3][8], const std::uint16_t* corners, int lanes,
                                         double* forces) {
  alignas(64) double records[4][width][8];  // two corners a record
  for (int pair = 0; pair < 4; ++pair) {
    alignas(64) double packs[8][width];
    for (int k = 0; k < 3; ++k) {
      store_pack(packs[k], f[k][2 * pair]);
      store_pack(packs[4 + k], f[k][2 * pair + 1]);
    }
    store_pack(packs[3], Lanes(0));
    store_pack(packs[7], Lanes(0));
    transpose_to_records(packs, records[pair]);
  }
  for (int lane = 0; lane < lanes; ++lane) {
    for (int i = 0; i < 8; ++i) {
      subtract_record(&records[i / 2][lane][4 * (i % 2)],
                      forces + force_record * static_cast<int>(corners[i * width + lane]));
    }
  }
}

/// Smallest step of a chunk and the element that has it; lowest element first among equals.
struct ChunkStep {
  double step;
  int element;
  int failed;
};

PERCUSS_FORCE_INLINE void take_lanes(const HexResult<Lanes>& result, int first_element, int lanes, ChunkStep& chunk) {
  alignas(64) double step[width];
  alignas(64) double volume[width];
  store_pack(step, result.stable_step);
  store_pack(volume, result.volume);
  for (int lane = 0; lane < lanes; ++lane) {
    const bool good = volume[lane] > 0 && step[lane] > 0;  // false for NaN
    if (!good && chunk.failed < 0) chunk.failed = first_element + lane;
    if (step[lane] < chunk.step) {
      chunk.step = step[lane];
      chunk.element = first_element + lane;
    }
  }
}

/// Sum over the first `lanes` lanes in their order.
PERCUSS_FORCE_INLINE double sum_lanes(const Lanes& value, int lanes) {
  alignas(64) double row[width];
  store_pack(row, value);
  double sum = 0;
  for (int lane = 0; lane < lanes; ++lane) sum += row[lane];
  return sum;
}

template <class Material, HexKind Kind>
struct AdvanceChunk {
  HexChunks chunks;
  HexBlock<Material, Kind> block;
  ElementMotion motion;
  Array<double> state;
  Rows3<double> slot_force;
  ChunkResults results;

  static std::size_t scratch_bytes(const HexChunks& chunks) {
    return (static_cast<std::size_t>(chunks.largest_slot_count) * (node_record + force_record) + 8) * sizeof(double) +
           128;
  }

  KOKKOS_FUNCTION void operator()(const Member& member) const {
    const int c = block.chunks(member.league_rank());
    const int first_slot = chunks.first_slot(c);
    const int slot_count = chunks.first_slot(c + 1) - first_slot;
    const auto scratch = [&](int record) {
      return static_cast<double*>(
          member.team_scratch(0).get_shmem_aligned(static_cast<std::size_t>(slot_count * record) * sizeof(double), 64));
    };
    double* nodes = scratch(node_record);
    double* forces = scratch(force_record);
    for (int s = 0; s < slot_count; ++s) {
      const int n = chunks.slots_to_nodes(first_slot + s);
      for (int k = 0; k < 3; ++k) {
        nodes[node_record * s + k] = motion.x(n, k);
        nodes[node_record * s + 4 + k] = motion.v(n, k);
      }
      nodes[node_record * s + 3] = nodes[node_record * s + 7] = 0;
      for (int k = 0; k < force_record; ++k) forces[force_record * s + k] = 0;
    }
    advance_packs(c, nodes, forces);
    for (int s = 0; s < slot_count; ++s) {
      for (int k = 0; k < 3; ++k) slot_force(first_slot + s, k) = forces[force_record * s + k];
    }
  }

  KOKKOS_FUNCTION void advance_packs(int c, const double* nodes, double* forces) const {
    constexpr int record_size = hex_record_size<Material, Kind> * width;
    const HexParameters<Material> parameters = block.parameters(chunks.parameters(c));
    const int first = chunks.first_element(c);
    const int end = chunks.first_element(c + 1);
    double* record = &state(chunks.first_state(c));
    const std::uint16_t* corners = &chunks.corner_slots(static_cast<std::size_t>(chunks.first_pack(c)) * 8 * width);
    ChunkStep step{1e300, first, -1};
    double work[3] = {0, 0, 0};
    for (int e = first; e < end; e += width, record += record_size, corners += 8 * width) {
      const int lanes = end - e < width ? end - e : width;
      prefetch(record + record_size, record_size);
      VectorModes<Lanes> a, v;
      gather_modes(nodes, corners, a, v);
      LaneState<Material, Kind> s;
      load_state<Material, Kind>(record, s);
      Lanes f[3][8];
      const HexResult<Lanes> result = advance_hex8(parameters, a, v, Lanes(motion.dt), s, f[0], f[1], f[2]);
      store_state<Material, Kind>(record, s);
      scatter_forces(f, corners, lanes, forces);
      take_lanes(result, e, lanes, step);
      work[0] += sum_lanes(result.work.internal, lanes);
      work[1] += sum_lanes(result.work.hourglass, lanes);
      work[2] += sum_lanes(result.work.viscous, lanes);
    }
    results.stable_step(c) = step.step;
    results.controlling_element(c) = step.element;
    results.failed_element(c) = step.failed;
    for (int k = 0; k < 3; ++k) results.work(c, k) += work[k];
  }
};

template <class Material, HexKind Kind>
void advance_block(const ExecSpace& space, const HexChunks& chunks, const HexBlock<Material, Kind>& block,
                   const ElementMotion& motion, const Array<double>& state, const Rows3<double>& slot_force,
                   const ChunkResults& results) {
  const int count = static_cast<int>(block.chunks.extent(0));
  if (count == 0) return;
  using Kernel = AdvanceChunk<Material, Kind>;
  Policy policy(space, count, 1);
  policy.set_scratch_size(0, Kokkos::PerTeam(static_cast<int>(Kernel::scratch_bytes(chunks)))).set_chunk_size(1);
  Kokkos::parallel_for("percuss::advance_elements", policy, Kernel{chunks, block, motion, state, slot_force, results});
}

}  // namespace

void advance_elements(const ExecSpace& space, const HexChunks& chunks, const HexBlocks& blocks,
                      const ElementMotion& motion, const Array<double>& state, const Rows3<double>& slot_force,
                      const ChunkResults& results) {
  std::apply(
      [&](const auto&... block) { (advance_block(space, chunks, block, motion, state, slot_force, results), ...); },
      blocks);
}

}  // namespace percuss
