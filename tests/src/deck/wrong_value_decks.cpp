// Decks with values of the wrong type or out of range.

#include "tests/src/deck/wrong_decks.hpp"

namespace percuss {
namespace {

std::vector<WrongDeck> wrong_numbers() {
  return {
      {"WordForNumber", change("7850", "heavy"), "5:36", "density is 'heavy' in material 'steel' (must be a number)"},
      {"EmptyForNumber", change("7850", ""), "5:27", "density is empty in material 'steel'"},
      {"TildeForNumber", change("7850", "~"), "5:27", "density is empty in material 'steel'"},
      {"ListForNumber", change("7850", "[7850]"), "5:36", "density is [7850] in material 'steel' (must be a number)"},
      {"MapForNumber", change("7850", "{a: 1}"), "5:36", "density is a map in material 'steel' (must be a number)"},
      {"TrueForNumber", change("7850", "true"), "5:36", "density is true in material 'steel' (must be a number)"},
      {"QuotedNumber", change("7850", "\"7850\""), "5:36",
       "density is the text '7850' in material 'steel' (must be a number; remove"},
      {"DecimalComma", append("loads: {gravity: [0, 0, '-9,81']}"), "6:25", "loads.gravity.2 is the text '-9,81'"},
      {"UnknownEstimate", change("step_scale: 0.9", "step_estimate: mesh"), "1:33",
       "time.step_estimate is 'mesh' (must be element | global)"},
      {"DecimalCommaPlain", change("{end: 1.0, step_scale: 0.9}", "\n  end: 1,5"), "2:8", "decimals take a point: 1.5"},
      {"Hexadecimal", change("7850", "0x1eaa"), "5:36", "a number in decimal digits"},
      {"HexadecimalCells", change("cells: [2,", "cells: [0x2,"), "3:40", "an integer in decimal digits"},
      {"OctalTrap", change("cells: [2,", "cells: [010,"), "3:40", "leading zeros"},
      {"Underscores", change("7850", "7_850"), "5:36", "without separators: 7850"},
      {"FortranExponent", change("200e9", "2.0d11"), "5:58", "powers of ten take e: 2.0e11"},
      {"NumberWithUnit", change("7850", "7850 kg/m^3"), "5:36", "without a unit or other text: 7850"},
      {"NotANumber", change("7850", ".nan"), "5:36", "density is '.nan' in material 'steel' (must be finite)"},
      {"NotANumberInWords", change("7850", "NaN"), "5:36", "must be finite"},
      {"Infinity", change("end: 1.0", "end: .inf"), "1:13", "time.end is '.inf' (must be finite)"},
      {"MinusInfinity", append("initial: [{velocity: [-.inf, 0, 0]}]"), "6:23",
       "initial.0.velocity.0 is '-.inf' (must be finite)"},
      {"Overflow", change("end: 1.0", "end: 1e999"), "1:13", "within the range of double precision"},
      {"Underflow", change("end: 1.0", "end: 1e-999"), "1:13", "within the range of double precision"},
      {"FractionForInteger", change("cells: [2, 2, 2]", "cells: [2, 2, 2.5]"), "3:46",
       "cells.2 is 2.5 in part 'rod' (must be an integer"},
      {"ExponentForInteger", change("cells: [2,", "cells: [1e1,"), "3:40", "must be an integer: digits alone"},
      {"WordForInteger", change("cells: [2,", "cells: [two,"), "3:40",
       "box.cells.0 is 'two' in part 'rod' (must be an integer)"},
      {"TrueForInteger", change("cells: [2,", "cells: [yes,"), "3:40", "must be an integer"},
      {"NumberForBoolean", append("contact: {reuse_search: 1}"), "6:25",
       "contact.reuse_search is 1 (must be true or false)"},
      {"OddSearch", append("contact: {search: tree}"), "6:19",
       "contact.search is 'tree' (must be blocks | points_in_box)"},
      {"WordForEdges", append("contact: {edges: sharp}"), "6:18", "contact.edges is 'sharp' (must be true or false)"},
      {"YesForBoolean", append("contact: {reuse_search: yes}"), "6:25",
       "contact.reuse_search is 'yes' (must be true or false)"},
      {"ListForText", append("title: [a]"), "6:8", "title is ['a'] (must be a text)"},
  };
}

std::vector<WrongDeck> wrong_ranges() {
  return {
      {"NegativeDensity", change("7850", "-7850"), "5:36", "density is -7850 in material 'steel' (must be positive)"},
      {"ZeroDensity", change("7850", "0"), "5:36", "density is 0 in material 'steel' (must be positive)"},
      {"NegativeModulus", change("200e9", "-200e9"), "5:58",
       "youngs_modulus is -200e9 in material 'steel' (must be positive)"},
      {"IncompressibleRatio", change("0.3}", "0.5}"), "5:81",
       "poissons_ratio is 0.5 in material 'steel' (must be between -1 and 0.5"},
      {"RatioOfMinusOne", change("0.3}", "-1}"), "5:81", "poissons_ratio is -1 in material 'steel'"},
      {"EndOfZero", change("end: 1.0", "end: 0"), "1:13", "time.end is 0 (must be positive)"},
      {"EndBeforeStart", change("end: 1.0", "end: -1"), "1:13", "time.end is -1 (must be positive)"},
      {"StepScaleAboveOne", change("0.9", "1.1"), "1:30", "time.step_scale is 1.1 (must be above 0, at most 1)"},
      {"StepScaleOfZero", change("0.9", "0"), "1:30", "time.step_scale is 0"},
      {"NegativeMaxSteps", change("step_scale: 0.9", "max_steps: -5"), "1:29",
       "time.max_steps is -5 (must be at least 1)"},
      {"NegativeFriction", append("contact: {friction: -0.1}"), "6:21",
       "contact.friction is -0.1 (must be zero or positive)"},
      {"FlatBox", change("size: [1, 1, 1]", "size: [1, 1, 0]"), "3:28",
       "box.size.2 is 0 in part 'rod' (must be positive)"},
      {"NoCells", change("cells: [2, 2, 2]", "cells: [2, 0, 2]"), "3:43",
       "box.cells.1 is 0 in part 'rod' (must be at least 1)"},
      {"HugeCell", change("cells: [2, 2, 2]", "cells: [2, 3000000000, 2]"), "3:43", "must be at most 2147483647"},
      {"HugeInteger", change("cells: [2, 2, 2]", "cells: [2, 99999999999999999999, 2]"), "3:43",
       "an integer below 9e18"},
      {"HugeMesh", change("cells: [2, 2, 2]", "cells: [2000000000, 2000000000, 2000000000]"), "3:3",
       "part 'rod' has 8e+27 elements"},
      {"HugeNodes", change("cells: [2, 2, 2]", "cells: [1000000000, 1, 1]"), "3:3", "4e+09 nodes"},
      {"HugeArray",
       change("cells: [2, 2, 2]}", "cells: [2, 2, 2]}, array: {count: [99999, 99999, 1], pitch: [1, 1, 1]}"), "3:3",
       "make it coarser"},
      {"HugeTotal",
       change("cells: [2, 2, 2]}, material: steel}",
              "cells: [1000, 1000, 1200]}, material: steel}\n  b: {box: {size: [1, 1, 1], cells: [1000, 1000, 1200]}, "
              "material: steel}"),
       "2:1", "make them coarser"},
      {"CoarseCylinder",
       change("box: {size: [1, 1, 1], cells: [2, 2, 2]}", "cylinder: {radius: 1, length: 1, cells: [2, 4]}"), "3:50",
       "cylinder.cells.0 is 2 in part 'rod' (must be at least 3)"},
      {"TubeInsideOut",
       change("box: {size: [1, 1, 1], cells: [2, 2, 2]}",
              "tube: {inner_radius: 2, outer_radius: 1, length: 1, cells: [1, 8, 1]}"),
       "3:47", "tube.outer_radius is 1 in part 'rod' (must be larger than inner_radius, 2)"},
      {"TubeWithoutArc",
       change("box: {size: [1, 1, 1], cells: [2, 2, 2]}",
              "tube: {inner_radius: 1, outer_radius: 2, length: 1, cells: [1, 8, 1], arc: 0}"),
       "3:84", "tube.arc is 0 in part 'rod' (must be above 0, at most 360)"},
      {"TubeBeyondItsTurn",
       change("box: {size: [1, 1, 1], cells: [2, 2, 2]}",
              "tube: {inner_radius: 1, outer_radius: 2, length: 1, cells: [1, 8, 1], arc: 361}"),
       "3:84", "tube.arc is 361 in part 'rod' (must be above 0, at most 360)"},
      {"ArrayOnOneSpot", change("2]}, ", "2]}, array: {count: [1, 3, 1], pitch: [1, 0, 1]}, "), "3:88",
       "the 3 copies along y would coincide"},
      {"StaggerTooFar", change("2]}, ", "2]}, array: {count: [1, 1, 1], pitch: [1, 1, 1], stagger: 2}, "), "3:104",
       "array.stagger is 2 in part 'rod' (must be from -1 to 1)"},
      {"WallWithoutNormal", append("walls: [{normal: [0, 0, 0]}]"), "6:18",
       "walls.0.normal is [0, 0, 0] (must be a vector that is not zero)"},
      {"ManyFrames", append("output: {fields: {every: 1e-9}}"), "6:26", "it would write 1e+09 frames"},
      {"NegativeEvery", append("output: {history: {every: -1}}"), "6:27",
       "output.history.every is -1 (must be zero or positive)"},
  };
}

std::vector<WrongDeck> wrong_lists_and_curves() {
  return {
      {"ShortVector", append("loads: {gravity: [0, 0]}"), "6:18",
       "loads.gravity is [0, 0] (must be a list of 3, each a number)"},
      {"LongVector", append("loads: {gravity: [0, 0, 0, 9]}"), "6:18", "loads.gravity is [0, 0, 0, 9]"},
      {"NumberForVector", append("loads: {gravity: 9.81}"), "6:18", "loads.gravity is 9.81 (must be a list of 3"},
      {"DeadLoadWithoutDirection", append("loads: {pressure: [{faces: rod, value: 1, direction: [0, 0, 0]}]}"), "6:54",
       "loads.pressure.0.direction is [0, 0, 0] (must be a vector that is not zero)"},
      {"EmptyTable", append("loads: {pressure: [{faces: rod, value: {table: []}}]}"), "6:48",
       "at least one row [time, value]"},
      {"TableGoesBack", append("loads: {pressure: [{faces: rod, value: {table: [[0, 1], [2, 1], [1, 1]]}}]}"), "6:65",
       "has time 1 after 2 (times must ascend)"},
      {"TableOfTriples", append("loads: {pressure: [{faces: rod, value: {table: [[0, 1, 2]]}}]}"), "6:49",
       "must be a list of 2"},
      {"CurveOfNothing", append("loads: {pressure: [{faces: rod, value: {}}]}"), "6:33",
       "neither table nor expression"},
      {"CurveOfBoth", append("loads: {pressure: [{faces: rod, value: {table: [[0, 1]], expression: t}}]}"), "6:33",
       "both table and expression"},
      {"CurveMisspelt", append("loads: {pressure: [{faces: rod, value: {expresion: t}}]}"), "6:41",
       "did you mean 'expression'?"},
      {"UnknownFunction", append("loads: {pressure: [{faces: rod, value: {expression: sine(t)}}]}"), "6:53", "sine"},
      {"UnbalancedExpression", append("loads: {pressure: [{faces: rod, value: {expression: (t + 1}}]}"), "6:53",
       "is '(t + 1'"},
      {"AssignmentInExpression", append("loads: {pressure: [{faces: rod, value: {expression: t = 3}}]}"), "6:53",
       "'=' at position 3 assigns"},
      {"InfiniteAtStart", append("loads: {pressure: [{faces: rod, value: {expression: 1 / t}}]}"), "6:40",
       "loads.pressure.0.value is infinite at t = 0"},
      {"NotANumberAtEnd", append("loads: {pressure: [{faces: rod, value: {expression: sqrt(0.99 - t)}}]}"), "6:40",
       "is not a number at t = 1"},
      {"BoxOfSpaceInsideOut", append("conditions: [{nodes: {inside: [[1, 0, 0], [0, 1, 1]]}, fixed: x}]"), "6:31",
       "the lowest corner comes first, but 1 > 0 in x"},
  };
}

}  // namespace

std::vector<WrongDeck> wrong_value_decks() {
  std::vector<WrongDeck> all = wrong_numbers();
  for (const auto& part : {wrong_ranges(), wrong_lists_and_curves()}) all.insert(all.end(), part.begin(), part.end());
  return all;
}

}  // namespace percuss
