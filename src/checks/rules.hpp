#pragma once
// The rules on suspicious input: valid decks that are probably not what the user meant. Pure functions from a scene to
// warnings; docs/checks.md has the purpose, limit and reason of each.

#include <string>
#include <vector>

#include "src/checks/checked_scene.hpp"

namespace percuss {

/// A rule by its name; a deck silences it by `silence`.
struct CheckRule {
  /// Part of the scene that a rule needs: CheckedScene::deck, measures too, or all of it.
  enum class Needs { deck, mesh, start };

  std::string name;
  std::vector<Warning> (*check)(const CheckedScene& scene);
  Needs needs = Needs::deck;
};

/// All of them, by subject.
const std::vector<CheckRule>& check_rules();

/// Findings of the rules on the deck, and, where scene.measures is known, those on the mesh: in the order of the table,
/// what the deck silences included.
std::vector<Warning> check_input(const CheckedScene& scene);

/// Findings of the rules on the state at the start, of which check_input() knows nothing. All of the scene is known.
std::vector<Warning> check_start(const CheckedScene& scene);

/// How parts move when a run ends.
struct EndMotion {
  double time = 0;              // of the velocities
  std::vector<Vec3> low, high;  // [parts] range of each component of the velocity over the nodes [length / time]
};

/// Bodies that have met nothing in a run that has come to time.end: what the scene was at its start is in `scene`.
std::vector<Warning> check_flown_bodies(const CheckedScene& scene, const EndMotion& end);

/// Forces of the history that were 0 in every row of such a run. has_acted: [Deck::output.forces].
std::vector<Warning> check_idle_columns(const CheckedScene& scene, const std::vector<unsigned char>& has_acted);

// Units (unit_rules.cpp)
std::vector<Warning> check_unit_system(const CheckedScene& scene);
std::vector<Warning> check_density(const CheckedScene& scene);
std::vector<Warning> check_wave_speed(const CheckedScene& scene);
std::vector<Warning> check_scene_size(const CheckedScene& scene);
std::vector<Warning> check_gravity_size(const CheckedScene& scene);
std::vector<Warning> check_scene_mass(const CheckedScene& scene);

// Materials and numerical settings (material_rules.cpp)
std::vector<Warning> check_yield_stress(const CheckedScene& scene);
std::vector<Warning> check_hardening(const CheckedScene& scene);
std::vector<Warning> check_failure_strain(const CheckedScene& scene);
std::vector<Warning> check_viscosity(const CheckedScene& scene);
std::vector<Warning> check_fluid_hourglass(const CheckedScene& scene);
std::vector<Warning> check_shell_points(const CheckedScene& scene);
std::vector<Warning> check_no_viscosity(const CheckedScene& scene);
std::vector<Warning> check_mass_scaling(const CheckedScene& scene);
std::vector<Warning> check_cowper_symonds(const CheckedScene& scene);
std::vector<Warning> check_softening_size(const CheckedScene& scene);
std::vector<Warning> check_late_softening(const CheckedScene& scene);
std::vector<Warning> check_damage_sign(const CheckedScene& scene);
std::vector<Warning> check_poissons_ratio(const CheckedScene& scene);
std::vector<Warning> check_strain_ratios(const CheckedScene& scene);
std::vector<Warning> check_hardening_strain(const CheckedScene& scene);
std::vector<Warning> check_unstable_rubber(const CheckedScene& scene);  // rubber_rules.cpp
std::vector<Warning> check_foam_rates(const CheckedScene& scene);       // foam_rules.cpp
std::vector<Warning> check_specific_heat(const CheckedScene& scene);
std::vector<Warning> check_start_temperature(const CheckedScene& scene);

// Sizes and positions of parts (size_rules.cpp)
std::vector<Warning> check_part_size(const CheckedScene& scene);
std::vector<Warning> check_shell_thickness(const CheckedScene& scene);
std::vector<Warning> check_single_layer(const CheckedScene& scene);
std::vector<Warning> check_soft_tetrahedra(const CheckedScene& scene);
std::vector<Warning> check_shear_locking(const CheckedScene& scene);
std::vector<Warning> check_soft_bending(const CheckedScene& scene);
std::vector<Warning> check_thick_shell_across(const CheckedScene& scene);
std::vector<Warning> check_incompressible_solids(const CheckedScene& scene);
std::vector<Warning> check_triangles(const CheckedScene& scene);
std::vector<Warning> check_duplicate_parts(const CheckedScene& scene);
std::vector<Warning> check_enclosed_parts(const CheckedScene& scene);
std::vector<Warning> check_angles(const CheckedScene& scene);

// Masses, rigid bodies and cross sections (body_rules.cpp)
std::vector<Warning> check_added_mass(const CheckedScene& scene);
std::vector<Warning> check_rigid_mass(const CheckedScene& scene);
std::vector<Warning> check_rigid_inertia(const CheckedScene& scene);
std::vector<Warning> check_beam_section(const CheckedScene& scene);
std::vector<Warning> check_section_torsion(const CheckedScene& scene);
std::vector<Warning> check_weld_strength(const CheckedScene& scene);
std::vector<Warning> check_shell_reference(const CheckedScene& scene);

// Relaxations (relaxation_rules.cpp)
std::vector<Warning> check_idle_relaxation(const CheckedScene& scene);
std::vector<Warning> check_loose_relaxation(const CheckedScene& scene);

// Parts that are held or joined as a whole, elements of a material that fails (mesh_rules.cpp)
std::vector<Warning> check_held_parts(const CheckedScene& scene);
std::vector<Warning> check_loose_skins(const CheckedScene& scene);
std::vector<Warning> check_join_glue(const CheckedScene& scene);
std::vector<Warning> check_failure_size(const CheckedScene& scene);
std::vector<Warning> check_softening_strain(const CheckedScene& scene);

// Supports, and what hangs on nothing (support_rules.cpp)
std::vector<Warning> check_velocity_part(const CheckedScene& scene);
std::vector<Warning> check_point_support(const CheckedScene& scene);
std::vector<Warning> check_loose_beams(const CheckedScene& scene);

// Velocities, conditions and loads (condition_rules.cpp)
std::vector<Warning> check_stopped_velocity(const CheckedScene& scene);
std::vector<Warning> check_velocity_jump(const CheckedScene& scene);
std::vector<Warning> check_unused_velocity(const CheckedScene& scene);
std::vector<Warning> check_fast_velocity(const CheckedScene& scene);
std::vector<Warning> check_prescribed_speed(const CheckedScene& scene);
std::vector<Warning> check_pressure_size(const CheckedScene& scene);
std::vector<Warning> check_gravity_direction(const CheckedScene& scene);

// Tables over time (curve_rules.cpp)
std::vector<Warning> check_curve_end(const CheckedScene& scene);
std::vector<Warning> check_curve_time(const CheckedScene& scene);
std::vector<Warning> check_short_pulse(const CheckedScene& scene);

// Loads that act on nothing, or stop everything (load_rules.cpp).
std::vector<Warning> check_idle_loads(const CheckedScene& scene);
std::vector<Warning> check_flat_membranes(const CheckedScene& scene);
std::vector<Warning> check_standing_fluids(const CheckedScene& scene);
std::vector<Warning> check_fluid_surfaces(const CheckedScene& scene);
std::vector<Warning> check_symmetry_planes(const CheckedScene& scene);
std::vector<Warning> check_damping_size(const CheckedScene& scene);
std::vector<Warning> check_idle_forces(const CheckedScene& scene);
std::vector<Warning> check_wall_place(const CheckedScene& scene);
std::vector<Warning> check_wall_radius(const CheckedScene& scene);
std::vector<Warning> check_wall_thickness(const CheckedScene& scene);
std::vector<Warning> check_spring_length(const CheckedScene& scene);

// Who moves and who meets whom (motion_rules.cpp)
std::vector<Warning> check_still_scene(const CheckedScene& scene);
std::vector<Warning> check_idle_parts(const CheckedScene& scene);
std::vector<Warning> check_unreached_bodies(const CheckedScene& scene);
std::vector<Warning> check_wall_motion(const CheckedScene& scene);
std::vector<Warning> check_missing_contact(const CheckedScene& scene);
std::vector<Warning> check_beam_contact(const CheckedScene& scene);
std::vector<Warning> check_restitution(const CheckedScene& scene);

// Bodies that rest on each other (resting_rules.cpp)
std::vector<Warning> check_lagrange_rigid(const CheckedScene& scene);
std::vector<Warning> check_undamped_friction(const CheckedScene& scene);

// Contact (contact_rules.cpp)
std::vector<Warning> check_crossing_parts(const CheckedScene& scene);
std::vector<Warning> check_deep_overlap(const CheckedScene& scene);
std::vector<Warning> check_penalty_speed(const CheckedScene& scene);
std::vector<Warning> check_behind_wall(const CheckedScene& scene);
std::vector<Warning> check_inside_wall(const CheckedScene& scene);
std::vector<Warning> check_friction(const CheckedScene& scene);
std::vector<Warning> check_tie_distance(const CheckedScene& scene);
std::vector<Warning> check_tie_hinges(const CheckedScene& scene);
std::vector<Warning> check_tie_sides(const CheckedScene& scene);
std::vector<Warning> check_glue_zone(const CheckedScene& scene);
std::vector<Warning> check_glue_step(const CheckedScene& scene);
std::vector<Warning> check_contact_tolerance(const CheckedScene& scene);

// The steps of parts (step_rules.cpp)
std::vector<Warning> check_slow_parts(const CheckedScene& scene);
std::vector<Warning> check_sharp_elements(const CheckedScene& scene);
std::vector<Warning> check_idle_mass_scaling(const CheckedScene& scene);

// Time and output (output_rules.cpp)
std::vector<Warning> check_end_time(const CheckedScene& scene);
std::vector<Warning> check_step_scale(const CheckedScene& scene);
std::vector<Warning> check_no_output(const CheckedScene& scene);
std::vector<Warning> check_output_interval(const CheckedScene& scene);
std::vector<Warning> check_output_count(const CheckedScene& scene);
std::vector<Warning> check_history_points(const CheckedScene& scene);
std::vector<Warning> check_audit_limits(const CheckedScene& scene);

}  // namespace percuss
