#include "src/checks/rules.hpp"

#include <iterator>

namespace percuss {

const std::vector<CheckRule>& check_rules() {
  static const std::vector<CheckRule> rules = {
      {"unit_system", check_unit_system},
      {"density", check_density},
      {"wave_speed", check_wave_speed},
      {"scene_size", check_scene_size, true},
      {"gravity_size", check_gravity_size},
      {"yield_stress", check_yield_stress},
      {"hardening_modulus", check_hardening},
      {"failure_strain", check_failure_strain},
      {"viscosity", check_viscosity},
      {"mass_scaling", check_mass_scaling},
      {"part_size", check_part_size, true},
      {"shell_thickness", check_shell_thickness, true},
      {"single_layer", check_single_layer, true},
      {"duplicate_part", check_duplicate_parts, true},
      {"enclosed_part", check_enclosed_parts, true},
      {"angle_in_radians", check_angles},
      {"stopped_velocity", check_stopped_velocity, true},
      {"unused_velocity", check_unused_velocity, true},
      {"fast_velocity", check_fast_velocity, true},
      {"prescribed_speed", check_prescribed_speed},
      {"curve_end", check_curve_end},
      {"pressure_size", check_pressure_size},
      {"gravity_direction", check_gravity_direction},
      {"still_scene", check_still_scene, true},
      {"idle_part", check_idle_parts, true},
      {"unreached_body", check_unreached_bodies, true},
      {"no_contact", check_missing_contact, true},
      {"deep_overlap", check_deep_overlap, true},
      {"behind_wall", check_behind_wall, true},
      {"friction", check_friction},
      {"tie_distance", check_tie_distance, true},
      {"end_time", check_end_time},
      {"step_scale", check_step_scale},
      {"output_interval", check_output_interval},
      {"output_count", check_output_count},
      {"history_point", check_history_points, true},
      {"audit_limit", check_audit_limits},
  };
  return rules;
}

std::vector<Warning> check_scene(const CheckedScene& scene) {
  std::vector<Warning> warnings;
  for (const CheckRule& rule : check_rules()) {
    if (rule.needs_mesh && scene.measures == nullptr) continue;
    const std::vector<Warning> found = rule.check(scene);
    warnings.insert(warnings.end(), found.begin(), found.end());
  }
  return warnings;
}

}  // namespace percuss
