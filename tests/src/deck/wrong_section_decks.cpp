// Decks whose keys are missing, unknown or at odds with each other.

#include "tests/src/deck/wrong_decks.hpp"

namespace percuss {
namespace {

/// The part as a line, with more keys behind it.
std::string change_to_line(const std::string& more) {
  return change("box: {size: [1, 1, 1], cells: [2, 2, 2]}", "line: {from: [0, 0, 0], to: [1, 0, 0], cells: 2}" + more);
}

std::vector<WrongDeck> missing_keys() {
  return {
      {"NoTime", change("time: {end: 1.0, step_scale: 0.9}", "title: x"), "1:1", "time is missing (required: a map)"},
      {"NoEnd", change("end: 1.0, ", ""), "1:1", "time.end is missing (required: a number, positive)"},
      {"NoParts", "time: {end: 1}\nmaterials: {}\n", "1:1", "parts is missing", 2},
      {"EmptyParts",
       "time: {end: 1}\nparts: {}\nmaterials: {m: {model: elastic, density: 1, youngs_modulus: 1, poissons_ratio: "
       "0}}\n",
       "2:1", "parts is empty (there must be at least one)"},
      {"PartsWithoutValue",
       "time: {end: 1}\nparts:\nmaterials: {m: {model: elastic, density: 1, youngs_modulus: 1, poissons_ratio: 0}}\n",
       "2:1", "parts is empty"},
      {"NoMaterials", "time: {end: 1}\nparts: {rod: {box: {size: [1, 1, 1], cells: [1, 1, 1]}, material: steel}}\n",
       "1:1", "materials is missing"},
      {"PartWithoutMaterial", change(", material: steel", ""), "3:3", "material is missing in part 'rod'"},
      {"PartWithoutShape", change("box: {size: [1, 1, 1], cells: [2, 2, 2]}, ", ""), "3:3",
       "part 'rod' has no shape (must be one of box, cylinder, tube, sphere, shell_plate, shell_tube, shell_sphere, "
       "shell_box_tube, line, exodus, mesh)"},
      {"PartWithTwoShapes", change("material: steel}", "material: steel, sphere: {radius: 1, cells: 4}}"), "3:68",
       "part 'rod' has 2 shapes, box and sphere"},
      {"ShellWithoutThickness",
       change("box: {size: [1, 1, 1], cells: [2, 2, 2]}", "shell_plate: {size: [1, 1], cells: [2, 2]}"), "3:3",
       "part 'rod' has no thickness (its shells need one)"},
      {"ThicknessOfASolid", change("material: steel}", "material: steel, thickness: 0.1}"), "3:68",
       "thickness has no effect in part 'rod' (only shells have a thickness)"},
      {"ReferenceOfASolid", change("material: steel}", "material: steel, reference: top}"), "3:68",
       "reference has no effect in part 'rod' (only shells have a thickness)"},
      {"LineWithoutSection", change_to_line(""), "3:3", "part 'rod' has no section (its beams need one)"},
      {"LineWithoutLength",
       change("box: {size: [1, 1, 1], cells: [2, 2, 2]}", "line: {from: [1, 0, 0], to: [1, 0, 0], cells: 2}"), "3:37",
       "line.to is where line.from is in part 'rod' (a line of beams needs a length)", 2},
      {"SectionOfASolid", change("material: steel}", "material: steel, section: {truss: {area: 1}}}"), "3:68",
       "section has no effect in part 'rod' (only beams have a cross section)"},
      {"SectionOfTwoKinds", change_to_line(", section: {round: {radius: 1}, truss: {area: 1}}"), "3:68",
       "section has 2 kinds in part 'rod' (must be one of truss, round, tube, rectangle, box, general)"},
      {"UnknownSection", change_to_line(", section: {rectangel: {size: [1, 2]}}"), "3:69", "did you mean 'rectangle'?"},
      {"RectangleWithoutDirection", change_to_line(", section: {rectangle: {size: [1, 2]}}"), "3:59",
       "part 'rod' has no toward (its section is not the same all around"},
      {"DirectionOfATruss", change_to_line(", section: {truss: {area: 1}}, toward: y"), "3:88",
       "toward has no effect in part 'rod' (a truss does not bend)"},
      {"DirectionWithoutSection", change_to_line(", toward: y"), "3:3", "part 'rod' has no section"},
      {"TubeOfWrongRadii", change_to_line(", section: {tube: {outer_radius: 1, inner_radius: 1}}"), "3:107",
       "inner_radius is 1 in part 'rod' (must be smaller than outer_radius, 1)"},
      {"BoxOfThickWalls", change_to_line(", section: {box: {size: [2, 3], wall: 1}}, toward: y"), "3:95",
       "wall is 1 in part 'rod' (must be less than half of the width 2)"},
      {"ElementsOfBeams", change_to_line(", section: {round: {radius: 1}}, elements: tetrahedra"), "3:90",
       "elements has no effect in part 'rod' (its elements are beams)"},
      {"HourglassOfBeams", change_to_line(", section: {round: {radius: 1}}, hourglass: viscous"), "3:90",
       "hourglass has no effect in part 'rod' (its elements are beams"},
      {"GlobalStepOfBeams",
       "time: {end: 1.0, step_estimate: global}\n"
       "parts: {bar: {line: {from: [0, 0, 0], to: [1, 0, 0], cells: 2}, section: {round: {radius: 1}}, material: "
       "steel}}\n"
       "materials: {steel: {model: elastic, density: 7850, youngs_modulus: 200e9, poissons_ratio: 0.3}}\n",
       "1:33", "time.step_estimate is global (part 'bar' has beams"},
      {"UnknownElements", change("material: steel}", "material: steel, elements: tets}"), "3:78",
       "elements is 'tets' in part 'rod' (must be hexahedra | tetrahedra"},
      {"ElementsOfShells",
       change("box: {size: [1, 1, 1], cells: [2, 2, 2]}",
              "shell_plate: {size: [1, 1], cells: [2, 2]}, thickness: 0.1, elements: tetrahedra"),
       "3:69", "elements has no effect in part 'rod' (its elements are shells)"},
      {"UnknownReference",
       change("box: {size: [1, 1, 1], cells: [2, 2, 2]}",
              "shell_plate: {size: [1, 1], cells: [2, 2]}, thickness: 0.1, reference: side"),
       "3:80", "reference is 'side' in part 'rod' (must be middle | bottom | top or a number)"},
      {"UnknownRule", append("silence: [frictoin]"), "6:11",
       "silence names 'frictoin' (no warning has this rule): did you mean 'friction'?"},
      {"RuleThatIsNoList", append("silence: friction"), "6:10", "silence is 'friction' (must be a list of rules)"},
      {"RotationWithoutShells", append("conditions: [{nodes: rod, fixed: [x, ry]}]"), "6:38",
       "ry has no effect (only nodes of shells, beams and rigid parts have rotations, and there are none)"},
      {"UnknownFormatOfFields", append("output: {fields: {every: 1, format: exodos}}"), "6:37",
       "output.fields.format is 'exodos' (must be vtkhdf | exodus"},
      {"FormatOfFieldsTwice", append("output: {fields: {every: 1, format: [exodus, exodus]}}"), "6:37",
       "output.fields.format is ['exodus', 'exodus'] (must be formats, each once)"},
      {"PointFieldWithoutShells", append("output: {fields: {every: 1, write: [stress_point_1]}}"), "6:37",
       "output.fields.write has stress_point_1 (no part has shells)"},
      {"PointFieldOfAPointTooMany",
       "time: {end: 1.0}\n"
       "parts: {cap: {shell_sphere: {radius: 1, cells: 2}, thickness: 0.1, points: 3, material: steel}}\n"
       "materials: {steel: {model: elastic, density: 7850, youngs_modulus: 200e9, poissons_ratio: 0.3}}\n"
       "output: {fields: {every: 1, write: [stress_point_3, equivalent_plastic_strain_point_4]}}\n",
       "4:53",
       "output.fields.write has equivalent_plastic_strain_point_4 (shells have at most 3 points; set "
       "parts.NAME.points"},
      {"PointFieldOfAnElasticShell",
       "time: {end: 1.0}\n"
       "parts: {cap: {shell_sphere: {radius: 1, cells: 2}, thickness: 0.1, material: steel}}\n"
       "materials: {steel: {model: elastic, density: 7850, youngs_modulus: 200e9, poissons_ratio: 0.3}}\n"
       "output: {fields: {every: 1, write: [stress_point_4]}}\n",
       "4:37", "output.fields.write has stress_point_4 (shells have at most 3 points; set parts.NAME.points for more"},
      {"GlobalStepOfShells",
       "time: {end: 1.0, step_estimate: global}\n"
       "parts: {cap: {shell_sphere: {radius: 1, cells: 2}, thickness: 0.1, material: steel}}\n"
       "materials: {steel: {model: elastic, density: 7850, youngs_modulus: 200e9, poissons_ratio: 0.3}}\n",
       "1:33", "time.step_estimate is global (part 'cap' has shells"},
      {"PartIsAWord", change("{box: {size: [1, 1, 1], cells: [2, 2, 2]}, material: steel}", "steel"), "3:8",
       "part 'rod' is 'steel' (must be a map)"},
      {"BoxWithoutCells", change(", cells: [2, 2, 2]", ""), "3:9", "box.cells is missing in part 'rod'"},
      {"MaterialWithoutModel", change("model: elastic, ", ""), "5:3",
       "model is missing in material 'steel' (required: elastic | j2_plasticity | "},
      {"MaterialWithoutDensity", change("density: 7850, ", ""), "5:3", "density is missing in material 'steel'"},
      {"PlasticityWithoutYield", change("model: elastic", "model: j2_plasticity"), "5:3",
       "yield_stress is missing in material 'steel'"},
      {"InitialWithoutVelocity", append("initial: [{part: rod}]"), "6:11", "'initial.0' has no velocity"},
      {"RadialVelocityWithoutCenter", append("initial: [{radial_velocity: {speed: 1}}]"), "6:12",
       "initial.0.radial_velocity.center is missing"},
      {"RadialVelocityWithoutSpeed", append("initial: [{radial_velocity: {center: [0, 0, 0]}}]"), "6:12",
       "initial.0.radial_velocity.speed is missing"},
      {"ConditionWithoutKind", append("conditions: [{nodes: rod}]"), "6:14",
       "'conditions.0' does nothing (must have exactly one of fixed, symmetry, velocity, displacement)"},
      {"ConditionWithoutNodes", append("conditions: [{fixed: x}]"), "6:14", "conditions.0.nodes is missing"},
      {"PressureWithoutFaces", append("loads: {pressure: [{value: 1}]}"), "6:20", "loads.pressure.0.faces is missing"},
      {"FieldsWithoutEvery", append("output: {fields: {write: [stress]}}"), "6:10", "output.fields.every is missing"},
      {"PointWithoutPlace", append("output: {history: {nodes: [{name: tip}]}}"), "6:28", "neither near nor id"},
      {"PointWithoutName", append("output: {history: {nodes: [{id: 3}]}}"), "6:28",
       "output.history.nodes.0.name is missing"},
      {"NoSuchMeshFile", change("box: {size: [1, 1, 1], cells: [2, 2, 2]}", "exodus: {file: no_such_mesh.e}"), "3:24",
       "exodus.file is 'no_such_mesh.e' in part 'rod' (there is no file"},
  };
}

std::vector<WrongDeck> unknown_names() {
  return {
      {"SectionMisspelt", append("contacts: {surfaces: all}"), "6:1",
       "unknown key 'contacts' (did you mean 'contact'?)"},
      {"KeyMisspelt", change("step_scale", "stepscale"), "1:18",
       "unknown key 'stepscale' in 'time' (did you mean 'step_scale'?)"},
      {"SwappedLetters", change("density", "denisty"), "5:27",
       "unknown key 'denisty' in material 'steel' (did you mean 'density'?)", 2},
      {"KeyInCapitals", change("end", "END"), "1:8", "did you mean 'end'?", 2},
      {"KeyOfNothing", append("elements: {colour: red}"), "6:12",
       "unknown key 'colour' in 'elements' (known: integration, hourglass, bulk_viscosity, resist_folding, "
       "skip_resting, tetrahedra)"},
      {"KeyOfOtherModel", change("poissons_ratio: 0.3", "poissons_ratio: 0.3, yield_stress: 1e8"), "5:86",
       "a key of model j2_plasticity, not of elastic"},
      {"ShapeMisspelt", change("box:", "bx:"), "3:9", "unknown key 'bx' in part 'rod' (did you mean 'box'?)", 2},
      {"UnknownModel", change("elastic", "elstic"), "5:18", "did you mean 'elastic'?)"},
      {"UnknownMaterial", change("material: steel", "material: stel"), "3:61",
       "unknown material 'stel' in part 'rod' (did you mean 'steel'?)"},
      {"UnknownPart", append("initial: [{part: rot, velocity: [1, 0, 0]}]"), "6:18",
       "unknown part 'rot' (did you mean 'rod'?)"},
      {"UnknownSide", append("conditions: [{nodes: rod/xmin, fixed: x}]"), "6:22",
       "part 'rod' has no side 'xmin' (did you mean 'x_min'?)"},
      {"UnknownSideListed", append("conditions: [{nodes: rod/left, fixed: x}]"), "6:22",
       "known: x_min, x_max, y_min, y_max, z_min, z_max"},
      {"EmptySide", append("conditions: [{nodes: rod/, fixed: x}]"), "6:22", "part 'rod' has no side ''"},
      {"DisplacementThatJumps", append("conditions: [{nodes: rod, displacement: {x: 0.01}}]"), "6:45",
       "is 0.01 at time 0 (must be 0 there: the node would jump): start the table at [0, 0]"},
      {"UnknownContactSurface", append("contact: {surfaces: [[rod, wall]]}"), "6:28", "unknown part 'wall'"},
      {"UnknownField", append("output: {fields: {every: 1, write: [velocty]}}"), "6:37",
       "unknown field 'velocty' in output.fields.write (did you mean 'velocity'?)"},
      {"UnknownHistoryPart", append("output: {history: {parts: [rot]}}"), "6:28",
       "unknown part 'rot' (did you mean 'rod'?)"},
      {"HistoryPartTwice", append("output: {history: {parts: [rod, rod]}}"), "6:33",
       "part 'rod' is named twice in output.history.parts"},
      {"HistoryPartNoList", append("output: {history: {parts: rod}}"), "6:27",
       "output.history.parts is 'rod' (must be all or a list of parts)"},
      {"HistoryPartsAllListed", append("output: {history: {parts: [all]}}"), "6:28",
       "output.history.parts.0 is 'all' (must be a name from parts)"},
      {"HistoryPartWithSide", append("output: {history: {parts: [rod/x_min]}}"), "6:28",
       "output.history.parts.0 is 'rod/x_min' (must be a name from parts"},
      {"ForceOfNoKind", append("output: {history: {forces: [{name: f}]}}"), "6:29",
       "output.history.forces.0 has no kind of force (must have exactly one of contact, wall, support, section)"},
      {"ForceOfTwoKinds", append("output: {history: {forces: [{name: f, support: rod, contact: [rod, all]}]}}"), "6:29",
       "output.history.forces.0 has contact and support"},
      {"ForceOfUnknownPart", append("output: {history: {forces: [{name: f, contact: [rod, [rot]]}]}}"), "6:55",
       "unknown part 'rot' (did you mean 'rod'?)"},
      {"ForceOnAll", append("output: {history: {forces: [{name: f, contact: [all, rod]}]}}"), "6:49",
       "output.history.forces.0.contact.0 is 'all' (must be a part or a list of parts)"},
      {"ForceOfUnknownWall",
       append("walls: [{name: left, normal: x}]\noutput: {history: {forces: [{name: f, wall: lift}]}}"), "7:29",
       "force 'f' is of the wall 'lift' (no wall has this name) (did you mean 'left'?)"},
      {"WallTwice", append("walls: [{name: left, normal: x}, {name: left, normal: y, speed: 1}]"), "6:34",
       "two walls have the name 'left'"},
      {"ForceTwice", append("output: {history: {forces: [{name: f, support: rod}, {name: f, contact: [rod, all]}]}}"),
       "6:54", "name 'f' is given twice in output.history.forces"},
      {"SectionWithoutPoint", append("output: {history: {forces: [{name: f, section: {normal: x}}]}}"), "6:39",
       "output.history.forces.0.section.point is missing"},
      {"FieldTwice", append("output: {fields: {every: 1, write: [mass, mass]}}"), "6:43",
       "field 'mass' is named twice"},
      {"UnknownHourglass", append("elements: {hourglass: {kind: stifness}}"), "6:30", "did you mean 'stiffness'?"},
      {"UnknownHourglassWord", append("elements: {hourglass: assumed_strian}"), "6:23",
       "elements.hourglass is 'assumed_strian' (must be assumed_strain | stiffness | viscous; did you mean"},
      {"UnknownIntegration", append("elements: {integration: reduced}"), "6:25",
       "elements.integration is 'reduced' (must be one_point | full"},
      {"UnknownOverlap", append("contact: {overlap: ignore}"), "6:20",
       "contact.overlap is 'ignore' (must be accept | push_out | refuse)"},
      {"PenaltyScaleNegative", append("contact: {penalty_scale: -1}"), "6:26",
       "contact.penalty_scale is -1 (must be positive)"},
      {"ToleranceZero", append("contact: {tolerance: 0}"), "6:22", "contact.tolerance is 0 (must be positive)"},
      {"UnknownEnforcement", append("contact: {enforcement: langrange}"), "6:24", "did you mean 'lagrange'?"},
      {"UnknownSurfaces", append("contact: {surfaces: al}"), "6:21", "contact.surfaces is 'al' (must be all | none"},
      {"UnknownAxis", change("material: steel", "axis: w, material: steel"), "3:57",
       "axis is 'w' in part 'rod' (must be x | y | z"},
      {"UnknownFixedAxis", append("conditions: [{nodes: rod, fixed: [x, q]}]"), "6:38",
       "conditions.0.fixed.1 is 'q' (must be x | y | z | rx | ry | rz)"},
      {"AxisTwice", append("conditions: [{nodes: rod, fixed: [x, x]}]"), "6:38", "each axis once"},
  };
}

std::vector<WrongDeck> at_odds() {
  return {
      {"PartNamedAll", change("rod:", "all:"), "3:3", "part name 'all' cannot be used"},
      {"PartNameWithSlash", change("rod:", "rod/a:"), "3:3", "part name 'rod/a' cannot be used"},
      {"HourglassOfFullIntegration", append("elements: {integration: full, hourglass: viscous}"), "6:31",
       "elements.hourglass has no effect (integration is full"},
      {"CoefficientOfAssumedStrain", append("elements: {hourglass: {coefficient: 0.1}}"), "6:24",
       "elements.hourglass.coefficient has no effect (assumed_strain follows from the material): give kind: stiffness"},
      {"HourglassOfFullPart", change("material: steel", "material: steel, integration: full, hourglass: viscous"),
       "3:87", "hourglass has no effect in part 'rod' (integration is full"},
      {"CoefficientOfAssumedStrainInPart", change("material: steel", "material: steel, hourglass: {coefficient: 0.1}"),
       "3:80", "hourglass.coefficient has no effect in part 'rod' (assumed_strain follows from the material)"},
      {"IntegrationOfTetrahedra", change("material: steel", "material: steel, elements: tetrahedra, integration: full"),
       "3:90", "integration has no effect in part 'rod' (its elements are tetrahedra; this applies to hexahedra)"},
      {"FrictionTwice", append("contact: {friction: {pairs: [{a: rod, friction: 1}, {a: rod, friction: 2}]}}"), "6:53",
       "contact.friction.pairs.1 names 'rod' again (the first such pair gives the friction)"},
      {"FrictionWithoutValue", append("contact: {friction: {pairs: [{a: rod}]}}"), "6:30",
       "contact.friction.pairs.0.friction is missing"},
      {"WallOfMassAndSpeed", append("walls: [{normal: x, speed: 1, mass: 2}]"), "6:31",
       "walls.0.mass has no effect (speed already prescribes the motion of the wall)"},
      {"StartSpeedWithoutMass", append("walls: [{normal: x, start_speed: 1}]"), "6:21",
       "walls.0.start_speed has no effect (it applies only to a wall with a mass)"},
      {"WallWithoutShape", append("walls: [{point: [0, 0, 1]}]"), "6:9", "walls.0.normal is missing (required: "},
      {"RoundWallWithNormal", append("walls: [{normal: x, sphere: {radius: 1}}]"), "6:10",
       "walls.0.normal has no effect (a cylinder or a sphere has none)"},
      {"RoundWallWithMass", append("walls: [{mass: 2, sphere: {radius: 1}}]"), "6:10",
       "walls.0.mass has no effect (a cylinder or a sphere has none)"},
      {"RoundWallTwice", append("walls: [{sphere: {radius: 1}, cylinder: {axis: x, radius: 1}}]"), "6:10",
       "walls.0.sphere has no effect (the wall is a cylinder)"},
      {"RoundWallWithoutDirection", append("walls: [{speed: 2, sphere: {radius: 1}}]"), "6:10",
       "walls.0.speed has no direction"},
      {"RoundWallWithoutSpeed", append("walls: [{direction: x, sphere: {radius: 1}}]"), "6:10",
       "walls.0.direction has no effect (the wall has no speed)"},
      {"PlaneWithDirection", append("walls: [{normal: x, direction: x}]"), "6:21",
       "walls.0.direction has no effect (a plane moves along its normal)"},
      {"RoundWallWithPenalty",
       append("walls: [{sphere: {radius: 1}, direction: x, speed: 1, friction: 0.1}]\ncontact: {enforcement: penalty}"),
       "6:55", "walls.0.friction cannot be used with contact.enforcement: penalty"},
      {"RectangleAlongNormal", append("walls: [{normal: x, rectangle: {along: -x, size: [1, 1]}}]"), "6:32",
       "walls.0.rectangle.along points along the normal"},
      {"WallOfMassWithPenalty", append("walls: [{normal: x, mass: 2}]\ncontact: {enforcement: penalty}"), "6:21",
       "walls.0.mass cannot be used with contact.enforcement: penalty"},
      {"WallOfMassBesideRigidParts",
       change("material: steel}", "material: steel, rigid: true}") + "walls: [{normal: x, mass: 2}]\n", "6:21",
       "walls.0.mass cannot be used beside rigid parts such as 'rod'"},
      {"ConditionOfTwoKinds", append("conditions: [{nodes: rod, fixed: x, symmetry: y}]"), "6:14",
       "'conditions.0' has fixed and symmetry"},
      {"MotionWithoutAxis", append("conditions: [{nodes: rod, velocity: {}}]"), "6:37",
       "conditions.0.velocity is a map (must be a map from directions x, y, z, rx, ry, rz to curves)"},
      {"MotionOfUnknownAxis", append("conditions: [{nodes: rod, velocity: {w: 1}}]"), "6:38",
       "unknown key 'w' in 'conditions.0.velocity'"},
      {"PartAndNodes", append("initial: [{part: rod, nodes: rod, velocity: [1, 0, 0]}]"), "6:23",
       "both part and nodes"},
      {"CenterWithoutSpin", append("initial: [{velocity: [1, 0, 0], center: [0, 0, 0]}]"), "6:33",
       "there is no angular_velocity"},
      {"NearAndId", append("output: {history: {nodes: [{name: a, id: 1, near: [0, 0, 0]}]}}"), "6:28",
       "both near and id"},
      {"PointNamedTwice", append("output: {history: {nodes: [{name: a, id: 1}], elements: [{name: a, id: 2}]}}"),
       "6:58", "name 'a' is given twice"},
      {"CheckpointNever", append("output: {checkpoint: {}}"), "6:22", "neither every nor wall"},
      {"NoPairs", append("contact: {surfaces: []}"), "6:21", "at least one pair"},
      {"PairOfThree", append("contact: {surfaces: [[rod, rod, rod]]}"), "6:22", "must be a pair [a, b]"},
      {"PairTwice", append("contact: {surfaces: [[rod, rod/x_min], {a: rod/x_min, b: rod, friction: 0.5}]}"), "6:40",
       "contact.surfaces.1 names 'rod/x_min' and 'rod' again (the first such pair gives the friction): leave out one"},
      {"PairWithoutB", append("contact: {surfaces: [{a: rod}]}"), "6:22", "contact.surfaces.0.b is missing"},
      {"TieWithoutB", append("contact: {ties: [{a: rod}]}"), "6:18", "contact.ties.0.b is missing"},
      {"TieIsAPair", append("contact: {ties: [[rod, rod]]}"), "6:18",
       "contact.ties.0 is ['rod', 'rod'] (must be a map)"},
      {"TieToUnknownPart", append("contact: {ties: [{a: rod, b: wall}]}"), "6:30", "unknown part 'wall'"},
      {"TieDistanceZero", append("contact: {ties: [{a: rod, b: rod, distance: 0}]}"), "6:45",
       "contact.ties.0.distance is 0 (must be positive)"},
      {"TiesWithSprings", append("contact: {enforcement: penalty, ties: [{a: rod/x_min, b: rod/x_max}]}"), "6:39",
       "ties cannot be held by contact.enforcement: penalty"},
      {"JoinIsAWord", append("join: yes_please"), "6:7", "(must be true | false or a list of joints)"},
      {"JoinOfOnePart", append("join: [{parts: [rod]}]"), "6:16", "(must be a list of at least two parts)"},
      {"JoinOfAPartTwice", append("join: [{parts: [rod, rod]}]"), "6:22", "each part is named once"},
      {"JoinOfAnUnknownPart", append("join: [{parts: [rod, bar]}]"), "6:22", "unknown part 'bar'"},
      {"JoinOfASide", append("join: [{parts: [rod, rod/x_min]}]"), "6:22", "(must be a name from parts, or all)"},
      {"JoinToleranceZero", append("join: [{tolerance: 0}]"), "6:20", "join.0.tolerance is 0 (must be positive)"},
      {"JoinWithAnUnknownKey", append("join: [{part: rod}]"), "6:9", "unknown key 'part'"},
      {"SectionIsAList", append("contact: [all]"), "6:10", "contact is ['all'] (must be a map)"},
      {"ListIsAMap", append("initial: {part: rod, velocity: [1, 0, 0]}"), "6:10",
       "initial is a map (must be a list, each a map)"},
      {"AllAtOnce", change("7850", "-1") + "contacts: {}\ninitial: [{part: rot, velocity: [1, 0, x]}]\n", "6:1",
       "unknown key 'contacts'", 4},
  };
}

/// Joints and sets of nodes.
std::vector<WrongDeck> joined_bodies() {
  return {
      {"JointOfAPartThatDeforms", append("joints: {pin: {kind: spherical, bodies: [rod], at: [0, 0, 0]}}"), "6:42",
       "joint 'pin' is to hold part 'rod', which deforms (joints hold rigid bodies)"},
      {"JointOfAnUnknownBody",
       change("material: steel}", "material: steel, rigid: true}") +
           "joints: {pin: {kind: spherical, bodies: [rods], at: [0, 0, 0]}}\n",
       "6:42", "joint 'pin' is to hold 'rods', which is no rigid body (did you mean 'rod'?)"},
      {"JointOfABodyToItself",
       change("material: steel}", "material: steel, rigid: true}") +
           "joints: {pin: {kind: spherical, bodies: [rod, rod], at: [0, 0, 0]}}\n",
       "6:47", "joint 'pin' joins 'rod' to itself"},
      {"JointOfThree",
       change("material: steel}", "material: steel, rigid: true}") +
           "joints: {pin: {kind: spherical, bodies: [rod, a, b], at: [0, 0, 0]}}\n",
       "6:41", "bodies has 3 names in joint 'pin' (must have two, or one", 3},
      {"JointOfNone",
       change("material: steel}", "material: steel, rigid: true}") +
           "joints: {pin: {kind: spherical, bodies: [], at: [0, 0, 0]}}\n",
       "6:41", "bodies has 0 names in joint 'pin'"},
      {"JointWithTwoPoints",
       change("material: steel}", "material: steel, rigid: true}") +
           "joints: {pin: {kind: spherical, bodies: [rod], at: [0, 0, 0], at: [1, 0, 0]}}\n",
       "6:63", "'at'"},
      {"JointWithoutPoint",
       change("material: steel}", "material: steel, rigid: true}") +
           "joints: {pin: {kind: spherical, bodies: [rod]}}\n",
       "6:10", "at is missing in joint 'pin'"},
      {"HingeWithoutAxis",
       change("material: steel}", "material: steel, rigid: true}") +
           "joints: {pin: {kind: revolute, bodies: [rod], at: [0, 0, 0]}}\n",
       "6:15", "joint 'pin' has no axis (a revolute joint turns about one)"},
      {"BallWithAxis",
       change("material: steel}", "material: steel, rigid: true}") +
           "joints: {pin: {kind: spherical, bodies: [rod], at: [0, 0, 0], axis: x}}\n",
       "6:63", "joint 'pin' has an axis (a spherical joint turns about every one)"},
      {"JointTwice",
       change("material: steel}", "material: steel, rigid: true}") +
           "joints: {a: {kind: spherical, bodies: [rod], at: [1, 0, 0]}, b: {kind: revolute, bodies: [rod], at: [1, 0, "
           "0], axis: x}}\n",
       "6:62", "joint 'b' joins the same bodies at the same point as 'a'"},
      {"SetOfAnUnknownBody",
       change("material: steel}", "material: steel, rigid: true}") +
           "rigid_sets: {end: {nodes: rod/x_max, body: rob}}\n",
       "6:44", "rigid_sets.end.body is 'rob', which is no rigid body (did you mean 'rod'?)"},
      {"SetOfAPartThatDeforms", append("rigid_sets: {end: {nodes: rod/x_max, body: rod}}"), "6:44",
       "rigid_sets.end.body is 'rod', which is no rigid body (that part deforms)"},
      {"SetWithTheNameOfABody",
       change("material: steel}", "material: steel, rigid: true}") + "rigid_sets: {rod: {nodes: rod/x_max}}\n", "6:14",
       "rigid set 'rod' has the name of another rigid body"},
      {"SetOfAnUnknownSide", append("rigid_sets: {end: {nodes: rod/xmax}}"), "6:27", "part 'rod' has no side 'xmax'"},
      {"SetInertiaOfNoMasses", append("rigid_sets: {end: {nodes: rod/x_max, inertia: [1, 1, 3, 0, 0, 0]}}"), "6:47",
       "inertia is not a valid inertia tensor in rigid set 'end'"},
  };
}

/// `start` with a preload of the part rod.
std::string start(const std::string& more) {
  return "start: {relaxation: {}, preload: {b: {point: [0.5, 0.5, 0.3], normal: z, " + more + "}}}\n";
}

std::vector<WrongDeck> wrong_starts() {
  return {
      {"PreloadWithoutRelaxation",
       append("start: {preload: {b: {part: rod, point: [0, 0, 0.3], normal: z, force: 1}}}"), "6:9",
       "start.preload has no effect (it acts during a relaxation): give the key relaxation as well"},
      {"PreloadWithoutForce", append(start("part: rod, force: 0")), "6:35",
       "preload 'b' has force 0 (must pull or push): leave it out"},
      {"PreloadOfAllParts", append(start("part: all, force: 1")), "6:35",
       "preload 'b' is of part all (must be of one part): name the part"},
      {"PreloadOfARigidPart",
       change("material: steel}", "material: steel, rigid: true}") + start("part: rod, force: 1"), "6:35",
       "preload 'b' is of part 'rod' (which is rigid and has no stresses)"},
      {"PreloadOfRubber", change("model: elastic", "model: neo_hookean") + start("part: rod, force: 1"), "6:35",
       "preload 'b' is of part 'rod' of material 'steel' (whose stress does not grow in increments)"},
      {"RelaxationToNothing", append("start: {relaxation: {tolerance: 0}}"), "6:33", "must be above 0 and below 1"},
  };
}

}  // namespace

std::vector<WrongDeck> wrong_section_decks() {
  std::vector<WrongDeck> all = missing_keys();
  for (const auto& part : {unknown_names(), at_odds(), joined_bodies(), wrong_starts()})
    all.insert(all.end(), part.begin(), part.end());
  return all;
}

}  // namespace percuss
