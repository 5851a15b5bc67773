#include "src/checks/rules.hpp"

#include <utility>

namespace percuss {
namespace {

using Needs = CheckRule::Needs;

/// The first warnings of a rule, and one that stands for the others.
std::vector<Warning> shorten(std::vector<Warning> warnings, const Deck& deck) {
  constexpr std::size_t most = 5;
  if (warnings.size() <= most + 1) return warnings;
  const std::size_t others = warnings.size() - most;
  warnings.resize(most);
  warnings.push_back(
      {warnings.front().rule,
       fmt::format("{} more warnings like the {} above are not listed (same rule): check the listed ones first", others,
                   most),
       deck.file, 0, 1});
  return warnings;
}

std::vector<Warning> apply(const CheckedScene& scene, Needs needs) {
  std::vector<Warning> warnings;
  for (const CheckRule& rule : check_rules()) {
    if (rule.needs != needs) continue;
    for (Warning& warning : shorten(rule.check(scene), scene.deck)) warnings.push_back(std::move(warning));
  }
  return warnings;
}

}  // namespace

const std::vector<CheckRule>& check_rules() {
  static const std::vector<CheckRule> rules = {
      {"unit_system", check_unit_system},
      {"density", check_density},
      {"wave_speed", check_wave_speed},
      {"scene_size", check_scene_size, Needs::mesh},
      {"gravity_size", check_gravity_size},
      {"scene_mass", check_scene_mass, Needs::mesh},
      {"yield_stress", check_yield_stress},
      {"hardening_modulus", check_hardening},
      {"failure_strain", check_failure_strain},
      {"viscosity", check_viscosity},
      {"fluid_hourglass", check_fluid_hourglass, Needs::mesh},
      {"no_viscosity", check_no_viscosity, Needs::start},
      {"mass_scaling", check_mass_scaling},
      {"idle_mass_scaling", check_idle_mass_scaling, Needs::start},
      {"cowper_symonds", check_cowper_symonds},
      {"damage_sign", check_damage_sign},
      {"failure_size", check_failure_size, Needs::mesh},
      {"softening_size", check_softening_size, Needs::mesh},
      {"softening_strain", check_softening_strain, Needs::mesh},
      {"late_softening", check_late_softening},
      {"poissons_ratio", check_poissons_ratio},
      {"hardening_strain", check_hardening_strain},
      {"strain_ratios", check_strain_ratios},
      {"unstable_rubber", check_unstable_rubber},
      {"foam_rates", check_foam_rates},
      {"specific_heat", check_specific_heat},
      {"start_temperature", check_start_temperature},
      {"added_mass", check_added_mass, Needs::mesh},
      {"rigid_mass", check_rigid_mass, Needs::mesh},
      {"rigid_inertia", check_rigid_inertia, Needs::mesh},
      {"beam_section", check_beam_section, Needs::mesh},
      {"section_torsion", check_section_torsion},
      {"weld_strength", check_weld_strength},
      {"shell_reference", check_shell_reference},
      {"idle_relaxation", check_idle_relaxation},
      {"loose_relaxation", check_loose_relaxation},
      {"part_size", check_part_size, Needs::mesh},
      {"shell_thickness", check_shell_thickness, Needs::mesh},
      {"single_layer", check_single_layer, Needs::mesh},
      {"soft_tetrahedra", check_soft_tetrahedra, Needs::mesh},
      {"shear_locking", check_shear_locking, Needs::mesh},
      {"soft_bending", check_soft_bending, Needs::mesh},
      {"thick_shell_across", check_thick_shell_across, Needs::mesh},
      {"incompressible_solids", check_incompressible_solids, Needs::mesh},
      {"shell_triangles", check_triangles, Needs::mesh},
      {"shell_points", check_shell_points, Needs::mesh},
      {"duplicate_part", check_duplicate_parts, Needs::mesh},
      {"enclosed_part", check_enclosed_parts, Needs::mesh},
      {"join_glue", check_join_glue, Needs::mesh},
      {"angle_in_radians", check_angles},
      {"stopped_velocity", check_stopped_velocity, Needs::mesh},
      {"velocity_part", check_velocity_part, Needs::mesh},
      {"velocity_jump", check_velocity_jump, Needs::mesh},
      {"unused_velocity", check_unused_velocity, Needs::mesh},
      {"held_part", check_held_parts, Needs::mesh},
      {"point_support", check_point_support, Needs::mesh},
      {"loose_beam", check_loose_beams, Needs::mesh},
      {"loose_skin", check_loose_skins, Needs::mesh},
      {"fast_velocity", check_fast_velocity, Needs::mesh},
      {"prescribed_speed", check_prescribed_speed},
      {"curve_end", check_curve_end},
      {"curve_time", check_curve_time},
      {"short_pulse", check_short_pulse, Needs::start},
      {"idle_load", check_idle_loads, Needs::mesh},
      {"flat_membrane", check_flat_membranes, Needs::mesh},
      {"standing_fluid", check_standing_fluids},
      {"fluid_surface", check_fluid_surfaces, Needs::mesh},
      {"symmetry_plane", check_symmetry_planes, Needs::mesh},
      {"damping_size", check_damping_size, Needs::mesh},
      {"wall_place", check_wall_place, Needs::mesh},
      {"wall_radius", check_wall_radius, Needs::mesh},
      {"wall_thickness", check_wall_thickness, Needs::mesh},
      {"spring_length", check_spring_length, Needs::mesh},
      {"pressure_size", check_pressure_size},
      {"gravity_direction", check_gravity_direction},
      {"still_scene", check_still_scene, Needs::mesh},
      {"idle_part", check_idle_parts, Needs::mesh},
      {"unreached_body", check_unreached_bodies, Needs::mesh},
      {"wall_motion", check_wall_motion, Needs::mesh},
      {"no_contact", check_missing_contact, Needs::mesh},
      {"beam_contact", check_beam_contact, Needs::mesh},
      {"restitution", check_restitution, Needs::mesh},
      {"lagrange_rigid", check_lagrange_rigid, Needs::mesh},
      {"undamped_friction", check_undamped_friction, Needs::start},
      {"crossing_parts", check_crossing_parts, Needs::start},
      {"deep_overlap", check_deep_overlap, Needs::start},
      {"behind_wall", check_behind_wall, Needs::start},
      {"inside_wall", check_inside_wall, Needs::start},
      {"penalty_speed", check_penalty_speed, Needs::mesh},
      {"friction", check_friction},
      {"tie_distance", check_tie_distance, Needs::mesh},
      {"tie_hinge", check_tie_hinges, Needs::start},
      {"tie_sides", check_tie_sides, Needs::start},
      {"glue_zone", check_glue_zone, Needs::start},
      {"glue_step", check_glue_step, Needs::mesh},
      {"contact_tolerance", check_contact_tolerance},
      {"idle_force", check_idle_forces},
      {"end_time", check_end_time, Needs::start},
      {"slow_part", check_slow_parts, Needs::start},
      {"sharp_element", check_sharp_elements, Needs::start},
      {"step_scale", check_step_scale, Needs::start},
      {"no_output", check_no_output, Needs::start},
      {"output_interval", check_output_interval},
      {"output_count", check_output_count},
      {"history_point", check_history_points, Needs::mesh},
      {"audit_limit", check_audit_limits},
  };
  return rules;
}

std::vector<Warning> check_input(const CheckedScene& scene) {
  std::vector<Warning> warnings = apply(scene, Needs::deck);
  if (scene.measures == nullptr) return warnings;
  for (Warning& warning : apply(scene, Needs::mesh)) warnings.push_back(std::move(warning));
  return warnings;
}

std::vector<Warning> check_start(const CheckedScene& scene) { return apply(scene, Needs::start); }

}  // namespace percuss
