#include "kernels/shell/shell_damping.hpp"

#include "kernels/element/damping_launcher.hpp"
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

template <bool HasTriangles>
struct ShellDamping {
  using Damped = DampedShells;
  using Scratch = ShellScratch;
  const DampingStep<DampedShells>& of;
  const TeamChunk& chunk;
  const ShellScratch& scratch;

  KOKKOS_FUNCTION void damp() const {
    const DampedSection section = of.damped.sections(chunk.c);
    LivingLanes<double> living(of.motion.failing, of.motion.lives, chunk.c);
    chunk.for_each_pack(living, &of.fields.state(chunk.chunks.first_state(chunk.c)),
                        chunk.chunks.record_size(chunk.c) * shell_width, [&](const ChunkPack& pack) {
                          Vector3<Lanes> f[4], m[4];
                          if constexpr (HasTriangles)
                            damp_pack(section, pack, find_shapes(pack.corners), {f, m});
                          else
                            damp_pack(section, pack, Quadrilaterals{}, {f, m});
                          if (living.can_fail()) {
                            settle_forces(living.load_force_share(), f);
                            settle_forces(living.load_force_share(), m);
                          }
                          scratch.scatter(0, f, pack);
                          scratch.scatter(1, m, pack);
                        });
  }

  template <class Shapes>
  KOKKOS_FUNCTION void damp_pack(const DampedSection& section, const ChunkPack& pack, const Shapes& shapes,
                                 const CornerLoads<Lanes>& out) const {
    const GatheredShells motion(scratch, pack.corners);
    const Lanes thickness =
        load_pack(reinterpret_cast<const double*>(pack.record) + ShellRecord::thickness * shell_width);
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

}  // namespace

void damp_shells(const ExecSpace& space, const ElementChunks& chunks, const DampedShells& damped,
                 const ElementMotion& motion, const DampingFields& fields) {
  constexpr const char* label = "percuss::damp_shells";
  if (damped.has_triangles)
    launch_damping<ShellDamping<true>>(label, space, chunks, damped, motion, fields);
  else
    launch_damping<ShellDamping<false>>(label, space, chunks, damped, motion, fields);
}

}  // namespace percuss
