#include "kernels/shell/shell_damping.hpp"

#include "kernels/element/chunk_records.hpp"
#include "kernels/shell/living_shells.hpp"
#include "kernels/shell/membrane.hpp"
#include "kernels/shell/shell_corners.hpp"

namespace percuss {

namespace {

/// Forces on the rates of the element: beta times those of elasticity. g: at n+1.
template <class T, class Shapes>
PERCUSS_FORCE_INLINE ShellRates<T> find_damping_on_rates(const DampedSection& section, const ShellGeometry<T>& g,
                                                         const T& thickness, const ShellRates<T>& rate,
                                                         const Shapes& shapes) {
  const T none(0.0), volume = T(section.beta) * g.area * thickness;
  ShellRates<T> on{};
  T membrane[3] = {none, none, none}, bending[3] = {none, none, none};
  section.elasticity.add_stress(membrane, rate.membrane);
  section.elasticity.add_stress(bending, rate.curvature);
  const T lever = T(0.25 * section.bending_square) * thickness * thickness * volume;
  T shear = T(shell_shear_correction * section.elasticity.shear_modulus);
  if constexpr (Shapes::has_triangles) shear = find_shear_share(g, thickness, shapes) * shear;
  for (int k = 0; k < 3; ++k) {
    on.membrane[k] = volume * membrane[k];
    on.curvature[k] = lever * bending[k];
  }
  for (int k = 0; k < 2; ++k) {
    on.shear[k] = volume * shear * rate.shear[k];
    on.membrane_hourglass[k] = on.bending_hourglass[k] = on.shear_hourglass[k] = on.corner_drilling[k] = none;
  }
  on.drilling = none;
  return on;
}

/// The motion of a pack's corners.
struct GatheredShells {
  Vector3<Lanes> x[4], v[4], w[4];

  KOKKOS_FUNCTION GatheredShells(const ShellScratch& scratch, const std::uint16_t* corners) {
    gather_corners(scratch.nodes, corners, x);
    gather_corners(scratch.nodes + 4, corners, v);
    gather_corners(scratch.nodes + 8, corners, w);
  }
};

template <bool HasTriangles>
struct DampShellChunk {
  ElementChunks chunks;
  DampedShells damped;
  ShellMotion motion;
  SpinDampingFields fields;

  KOKKOS_FUNCTION void operator()(const ChunkMember& member) const {
    const int c = damped.chunks(member.league_rank());
    const int first_slot = chunks.first_slot(c);
    const int slot_count = chunks.first_slot(c + 1) - first_slot;
    const int* const slots_to_nodes = &chunks.slots_to_nodes(first_slot);
    const ShellScratch scratch(member, slot_count);
    for (int s = 0; s < slot_count; ++s) {
      const std::size_t n = 3 * static_cast<std::size_t>(slots_to_nodes[s]);
      double* const node = scratch.nodes + shell_node_record * s;
      copy_row(motion.x.data() + n, node);
      copy_row(motion.v.data() + n, node + 4);
      copy_row(motion.w.data() + n, node + 8);
      for (int k = 0; k < shell_force_record; ++k) scratch.forces[shell_force_record * s + k] = 0;
    }
    damp_packs(c, scratch);
    const ChunkSlots slots{slots_to_nodes, first_slot, slot_count};
    double power = set_damping(motion.v, slots, {scratch.forces, shell_force_record}, fields.force, fields.slot_force);
    power += set_damping(motion.w, slots, {scratch.forces + 4, shell_force_record}, fields.moment, fields.slot_moment);
    fields.work(c, viscous_work) -= 0.5 * motion.dt * power;
  }

  KOKKOS_FUNCTION void damp_packs(int c, const ShellScratch& scratch) const {
    const DampedSection section = damped.sections(c);
    const int record_size = chunks.record_size(c) * shell_width;
    const int first = chunks.first_element(c), end = chunks.first_element(c + 1);
    const auto* record = reinterpret_cast<const double*>(&fields.state(chunks.first_state(c)));
    const std::uint16_t* next_corners =
        &chunks.corner_slots(static_cast<std::size_t>(chunks.first_pack(c)) * corners_of_shell_pack);
    LivingShells<Lanes> living(motion.failing, motion.lives, c, chunks.points(c));
    for (int e = first; e < end; e += shell_width, record += record_size, next_corners += corners_of_shell_pack) {
      const int lanes = end - e < shell_width ? end - e : shell_width;
      const std::uint16_t* corners = next_corners;
      if (living.can_fail() && !living.take_pack(corners)) continue;
      Vector3<Lanes> f[4], m[4];
      const Lanes thickness = load_pack(record + ShellRecord::thickness * shell_width);
      if constexpr (HasTriangles)
        damp_pack(section, GatheredShells(scratch, corners), thickness, find_shapes(corners), {f, m});
      else
        damp_pack(section, GatheredShells(scratch, corners), thickness, Quadrilaterals{}, {f, m});
      if (living.can_fail()) {
        ShellResult<Lanes> result{{Lanes(0.0), Lanes(0.0)}, Lanes(1e300), Lanes(1.0), Lanes(1.0)};
        living.settle(result, f, m);
      }
      scatter_corners(f, corners, lanes, scratch.forces);
      scatter_corners(m, corners, lanes, scratch.forces + 4);
    }
  }

  template <class Shapes>
  static KOKKOS_FUNCTION void damp_pack(const DampedSection& section, const GatheredShells& motion,
                                        const Lanes& thickness, const Shapes& shapes, const CornerLoads<Lanes>& out) {
    const ShellGeometry<Lanes> g = find_shell_geometry(find_differences(motion.x), shapes);
    if (section.is_membrane) {
      const ShellRates<Lanes> rate = find_membrane_rates(g, turn(g.frame, find_differences(motion.v)), shapes).shell;
      return find_membrane_forces(g, find_damping_on_rates(section, g, thickness, rate, shapes), out);
    }
    const Vector3<Lanes> turned[4] = {g.frame * motion.w[0], g.frame * motion.w[1], g.frame * motion.w[2],
                                      g.frame * motion.w[3]};
    ShellRates<Lanes> rate = find_shell_rates(g, turn(g.frame, find_differences(motion.v)), turned, shapes);
    if (section.offset != 0) move_to_middle(Lanes(section.offset), rate);
    ShellRates<Lanes> on = find_damping_on_rates(section, g, thickness, rate, shapes);
    if (section.offset != 0) move_to_corners(Lanes(section.offset), on);
    find_shell_forces(g, on, out.force, out.moment, shapes);
  }
};

/// Where solids are in single precision there are no shells.
template <bool HasTriangles>
void launch(const ExecSpace& space, int count, const ElementChunks& chunks, const DampedShells& damped,
            const ShellMotion& motion, const SpinDampingFields& fields) {
  if constexpr (!is_single_precision) {
    Kokkos::parallel_for("percuss::damp_shells", ShellScratch::make_policy(space, count, chunks.largest_slot_count),
                         DampShellChunk<HasTriangles>{chunks, damped, motion, fields});
  }
}

}  // namespace

void damp_shells(const ExecSpace& space, const ElementChunks& chunks, const DampedShells& damped,
                 const ShellMotion& motion, const SpinDampingFields& fields) {
  const int count = static_cast<int>(damped.chunks.extent(0));
  if (count == 0) return;
  if (damped.has_triangles)
    launch<true>(space, count, chunks, damped, motion, fields);
  else
    launch<false>(space, count, chunks, damped, motion, fields);
}

}  // namespace percuss
