// Wrong decks: fields and history.

#include "tests/src/deck/wrong_decks.hpp"

namespace percuss {

std::vector<WrongDeck> wrong_output_decks() {
  return {
      {"FieldOutputWithoutEvery", append("output: {field_outputs: {rim: {elements: rod}}}"), "6:26",
       "every is missing in field output 'rim' (required: a number, positive)"},
      {"FieldOutputOfAnUnknownPart", append("output: {field_outputs: {rim: {every: 1, elements: [rod, rot]}}}"), "6:58",
       "unknown part 'rot' in field output 'rim' (did you mean 'rod'?)"},
      {"FieldOutputOfAnUnknownSide", append("output: {field_outputs: {rim: {every: 1, faces: rod/x_mid}}}"), "6:49",
       "part 'rod' has no side 'x_mid' in field output 'rim'"},
      {"FieldOutputOfNoElements", append("output: {field_outputs: {rim: {every: 1, elements: []}}}"), "6:52",
       "elements is [] in field output 'rim' (must be at least one part, element block or element set)"},
      {"FieldOutputOfNoFaces", append("output: {field_outputs: {rim: {every: 1, faces: []}}}"), "6:49",
       "faces is [] in field output 'rim' (must be at least one part or surface)"},
      {"FieldOutputOfAllElements", append("output: {field_outputs: {rim: {every: 1, elements: all}}}"), "6:52",
       "elements is 'all' in field output 'rim' (must be a part, an element block, an element set or a list of these)"},
      {"FieldOutputOfElementsAndFaces", append("output: {field_outputs: {rim: {every: 1, elements: rod, faces: all}}}"),
       "6:57", "field output 'rim' has both elements and faces (must have one of them at most)"},
      {"FieldOutputByParts", append("output: {field_outputs: {rim: {every: 1, parts: [rod]}}}"), "6:42",
       "unknown key 'parts' in field output 'rim' (did you mean 'elements'?"},
      {"FieldOutputByVariables", append("output: {field_outputs: {rim: {every: 1, variables: [stress]}}}"), "6:42",
       "unknown key 'variables' in field output 'rim' (did you mean 'write'?)"},
      {"FieldOutputOfAnUnknownField", append("output: {field_outputs: {rim: {every: 1, write: [velocty]}}}"), "6:50",
       "unknown field 'velocty' in write (did you mean 'velocity'?)"},
      {"FieldOutputWithoutShells", append("output: {field_outputs: {rim: {every: 1, write: [stress_point_1]}}}"),
       "6:50", "output.field_outputs.rim.write has stress_point_1 (no part has shells)"},
      {"FieldOutputOfManyFrames", append("output: {field_outputs: {rim: {every: 1e-9}}}"), "6:39",
       "output.field_outputs.rim.every is 1e-09 (it would write 1e+09 frames"},
      {"FieldOutputWithAPathForAName", append("output: {field_outputs: {a/b: {every: 1}}}"), "6:26",
       "field output name 'a/b' cannot be used"},
      {"FieldOutputWithALongName",
       append(
           "output: {field_outputs: {nnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnn: {every: 1}}}"),
       "6:26", "has 65 characters (at most 64: files are named by it)"},
      {"FieldOutputTwice", append("output: {field_outputs: {rim: {every: 1}, rim: {every: 2}}}"), "6:43", "rim"},
      {"FieldOutputsAsAList", append("output: {field_outputs: [{every: 1}]}"), "6:25", "output.field_outputs is"},
      {"MotionOfAPartTwice", append("output: {history: {motion: [rod, rod]}}"), "6:34",
       "output.history.motion.1 is 'rod' (must be a name from parts, each once)"},
  };
}

}  // namespace percuss
