// Wrong decks: welds, joints, springs of turns, rigid sets.

#include "tests/src/deck/wrong_decks.hpp"

namespace percuss {
namespace {

std::vector<WrongDeck> wrong_welds() {
  return {
      {"WeldRowWithoutPitch",
       append("welds: {w: {between: [rod, rod/x_min], from: [0, 0, 0], to: [1, 0, 0], radius: 1}}"), "6:12",
       "pitch is missing in weld 'w'"},
      {"WeldRowOfNoLength",
       append("welds: {w: {between: [rod, rod/x_min], from: [0, 0, 0], to: [0, 0, 0], pitch: 1, radius: 1}}"), "6:61",
       "to is the same place as from in weld 'w'"},
      {"WeldRowOfTooMany",
       append("welds: {w: {between: [rod, rod/x_min], from: [0, 0, 0], to: [1, 0, 0], pitch: 1e-9, radius: 1}}"),
       "6:79", "would have 1000000000 welds"},
      {"WeldRowAndPlaces",
       append("welds: {w: {between: [rod, rod/x_min], from: [0, 0, 0], to: [1, 0, 0], pitch: 1, at: [0, 0, 0], radius: "
              "1}}"),
       "6:12", "weld 'w' has places in several ways"},
      {"WeldsOfNoFile", append("welds: {w: {between: [rod, rod/x_min], file: no.csv}}"), "6:46",
       "file is 'no.csv' in weld 'w' (there is no file"},
  };
}

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
       "6:15", "joint 'pin' has no axis (a revolute joint turns about one axis)"},
      {"BallWithAxis",
       change("material: steel}", "material: steel, rigid: true}") +
           "joints: {pin: {kind: spherical, bodies: [rod], at: [0, 0, 0], axis: x}}\n",
       "6:63", "joint 'pin' has a key axis (a spherical joint turns about every axis): leave it out"},
      {"CrossOfSlantedAxes",
       change("material: steel}", "material: steel, rigid: true}") +
           "joints: {pin: {kind: universal, bodies: [rod], at: [0, 0, 0], axis: x, second_axis: [1, 1, 0]}}\n",
       "6:72", "joint 'pin' has axes whose angle is 45 degrees (those of a cross are perpendicular)"},
      {"TurnSpringOfAnUnknownBody",
       change("material: steel}", "material: steel, rigid: true}") +
           "turn_springs: {t: {bodies: [rod, rods], x: {stiffness: 1}}}\n",
       "6:34", "turn spring 't' is to act on 'rods', which is no rigid body (did you mean 'rod'?)"},
      {"TurnSpringOfOneBody",
       change("material: steel}", "material: steel, rigid: true}") +
           "turn_springs: {t: {bodies: [rod], x: {stiffness: 1}}}\n",
       "6:28", "must name two bodies"},
      {"TurnSpringOfNothing",
       change("material: steel}", "material: steel, rigid: true}") + "turn_springs: {t: {bodies: [rod, rods]}}\n",
       "6:19", "does nothing (must have x, y or z)", 2},
      {"TurnSpringOnOneLine",
       change("material: steel}", "material: steel, rigid: true}") +
           "turn_springs: {t: {bodies: [rod, rods], axes: [x, -x], x: {stiffness: 1}}}\n",
       "6:47", "has two directions on one line", 2},
      {"TurnSpringTwice",
       change("material: steel}", "material: steel, rigid: true}") +
           "turn_springs: {t: {bodies: [rod, rods], x: {stiffness: 1, table: [[0, 0], [1, 1]]}}}\n",
       "6:59", "has both stiffness and table (must have one of them)", 2},
      {"TurnSpringWithoutHold",
       change("material: steel}", "material: steel, rigid: true}") +
           "turn_springs: {t: {bodies: [rod, rods], x: {friction: 1}}}\n",
       "6:44", "has friction or stops, but no hold_stiffness", 2},
      {"TurnSpringStops",
       change("material: steel}", "material: steel, rigid: true}") +
           "turn_springs: {t: {bodies: [rod, rods], x: {least: 1, most: 0, hold_stiffness: 1}}}\n",
       "6:61", "(must be above least, 1)", 2},
      {"TurnSpringTable",
       change("material: steel}", "material: steel, rigid: true}") +
           "turn_springs: {t: {bodies: [rod, rods], x: {table: [[0, 0], [0, 1]]}}}\n",
       "6:61", "has angle 0 after 0 (angles must ascend)", 2},
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

}  // namespace

std::vector<WrongDeck> wrong_connection_decks() {
  std::vector<WrongDeck> all = wrong_welds();
  for (const WrongDeck& deck : joined_bodies()) all.push_back(deck);
  return all;
}

}  // namespace percuss
