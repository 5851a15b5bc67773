#include "src/deck/warning_rules.hpp"

namespace percuss {

const std::vector<WarningRule>& warning_rules() {
  static const std::vector<WarningRule> rules = {
      // units (src/checks/rules/unit_rules.cpp)
      {"unit_system", "density and stiffness that fit no system of units, of a deck that names none"},
      {"density", "density that no material has in the named units"},
      {"wave_speed", "wave speed that no solid has in the named units"},
      {"scene_size", "a scene that is tiny or huge in the units of its materials"},
      {"gravity_size", "gravity that does not fit the units of the materials"},
      // materials and settings (src/checks/rules/material_rules.cpp)
      {"yield_stress", "yield stress far above or below what the Young's modulus suggests"},
      {"hardening_modulus", "hardening modulus near the Young's modulus"},
      {"failure_strain", "failure strain given as a percentage"},
      {"viscosity", "bulk viscosity or hourglass coefficient outside the usual range"},
      {"mass_scaling", "mass scaling that may add much of a part's mass"},
      {"unused_material", "material that no part uses"},
      {"fluid_hourglass", "fluid with the hourglass control of solids"},
      // sizes and places of parts (src/checks/rules/size_rules.cpp)
      {"part_size", "parts of very different size"},
      {"shell_thickness", "implausible shell thickness"},
      {"single_layer", "sheet of solid elements, one element thick"},
      {"duplicate_part", "two parts at the same place"},
      {"enclosed_part", "part inside another solid part"},
      {"angle_in_radians", "angle that looks like radians"},
      // velocities, conditions and loads (src/checks/rules/condition_rules.cpp, motion_rules.cpp)
      {"stopped_velocity", "initial velocity of nodes that a condition holds"},
      {"unused_velocity", "initial velocity that later entries replace everywhere"},
      {"fast_velocity", "initial velocity above the wave speed"},
      {"prescribed_speed", "prescribed motion faster than the wave speed"},
      {"curve_end", "table that is cut off before the run ends"},
      {"pressure_size", "pressure that is not small beside the stiffness"},
      {"gravity_direction", "gravity that pulls away from all walls"},
      {"still_scene", "scene in which nothing moves"},
      {"idle_part", "part without velocity, condition, load and contact"},
      {"unreached_body", "moving body that touches nothing before the end"},
      // contact (src/checks/rules/motion_rules.cpp, contact_rules.cpp)
      {"no_contact", "parts that have no contact and whose boxes meet"},
      {"beam_contact", "beams, which have no contact, whose box meets another body or a wall"},
      {"penalty_speed", "penalty contact that is too soft for how fast bodies meet"},
      {"deep_overlap", "overlap at the start that is deep beside an element or a thickness"},
      {"behind_wall", "nodes that begin behind a wall"},
      {"friction", "coefficient of friction that no surface has"},
      {"tie_distance", "tie that reaches beyond an element"},
      {"key_without_effect", "setting that does nothing as the others stand"},
      // time and output (src/checks/rules/output_rules.cpp)
      {"end_time", "run of a few steps, or of far too many"},
      {"step_scale", "step far below the stable one"},
      {"output_interval", "output interval longer than the run"},
      {"output_count", "more output than anyone looks at"},
      {"history_point", "history point far off the mesh"},
      {"audit_limit", "audit limit that stops nothing"},
      // the mesh (src/mesh)
      {"flat_corner", "element with a corner without volume"},
      {"sliver_element", "a few elements far thinner than the others"},
      {"shell_normals", "shells turned against their neighbours"},
      {"file_ids", "ids of a mesh file that are not positive and different"},
      {"raised_ids", "ids of a mesh file that an earlier part uses"},
      {"unread_content", "content of a mesh file that is no mesh, or that is not read"},
      {"unused_nodes", "nodes of a mesh file without an element"},
      {"coordinate_precision", "coordinates too far from the origin for the elements"},
      // ranks and runs (src/app, src/step)
      {"idle_ranks", "ranks without elements"},
      {"crowded_cores", "more threads than cores"},
      {"uneven_ranks", "ranks with many more elements than the mean"},
      {"few_contact_points", "ranks with too few contact nodes and faces to be worth it"},
      {"plan_without_erosion", "plan of a scene whose elements can fail"},
      {"unconverged_contact", "contact enforcement that does not converge"},
      {"deep_penetration", "contact nodes deep in a face during the run"},
      {"mass_scaling_limit", "mass scaling during the run that has reached its limit"},
      {"inverted_corners", "elements with a negative Jacobian at a corner"},
      {"contact_energy", "energy that contact gives"},
      {"element_energy", "elements that give more energy than they took"},
      {"hourglass_energy", "hourglass modes with much of the internal energy"},
      {"energy_error", "energy balance that is off at the end"},
  };
  return rules;
}

}  // namespace percuss
