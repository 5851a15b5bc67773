// Wrong decks: parts that are made of parts, placed and joined.

#include "tests/src/deck/wrong_decks.hpp"

namespace percuss {

std::vector<WrongDeck> wrong_part_decks() {
  return {
      {"MirrorOfAnUnknownPart", append("mirror: [{parts: [rot], normal: x}]"), "6:10",
       "mirror.0 names part 'rot', which is unknown (did you mean 'rod'?)"},
      {"MirrorWithoutANewName", append("mirror: [{parts: [rod], normal: x, suffix: ''}]"), "6:10",
       "mirror.0 would call a part 'rod'"},
      {"MirrorTwice", append("mirror: [{parts: [rod, rod], normal: x}]"), "6:10",
       "mirror.0 would make a part 'rod_mirror' (the deck has one already)"},
      {"PatternOfNeitherKind", append("pattern: [{parts: [rod]}]"), "6:11",
       "'pattern.0' has neither linear nor circular"},
      {"PatternOfOne", append("pattern: [{parts: [rod], linear: {count: 1, step: [1, 0, 0]}}]"), "6:42",
       "pattern.0.linear.count is 1 (must be at least 2)"},
      {"PatternOfTooMany", append("pattern: [{parts: [rod], linear: {count: 2000000000, step: [1, 0, 0]}}]"), "6:42",
       "pattern.0.linear.count is 2000000000 (must be at most 1000)"},
      {"PatternInPlace", append("pattern: [{parts: [rod], linear: {count: 2, step: [0, 0, 0]}}]"), "6:51",
       "pattern.0.linear.step is zero (the copies would coincide)"},
      {"PatternOfFullTurns", append("pattern: [{parts: [rod], circular: {count: 3, axis: z, step: 180}}]"), "6:36",
       "'pattern.0.circular' turns copy 3 by a multiple of 360 degrees"},
      {"PlaceOfAnUnknownPart", append("place: [{parts: [rot], direction: -z, lowest: {face: [0, 0, -1]}}]"), "6:9",
       "place.0.parts names part 'rot', which is unknown (did you mean 'rod'?)"},
      {"PlaceThatDoesNothing", append("place: [{parts: [rod], direction: -z}]"), "6:9",
       "'place.0' does nothing (must have lowest or rest_on)"},
      {"PlaceWithoutADirection", append("place: [{parts: [rod], lowest: {face: [0, 0, -1]}}]"), "6:9",
       "place.0 has no direction (there is no gravity at time 0, which would give it)"},
      {"PlaceOnItself", append("place: [{parts: [rod], direction: -z, rest_on: {part: rod}}]"), "6:48",
       "place.0.rest_on.part is 'rod' (it moves itself)"},
      {"PlaceOnNoWall", append("place: [{parts: [rod], direction: -z, rest_on: {wall: floor}}]"), "6:48",
       "place.0.rest_on.wall is 'floor', which is no name of a wall"},
      {"PlaceOnNothing", append("place: [{parts: [rod], direction: -z, rest_on: {clearance: 1}}]"), "6:48",
       "'place.0.rest_on' has neither wall nor part"},
      {"LowestCornerOfAnEdge", append("place: [{parts: [rod], direction: -z, lowest: {corner: [0, 1, 1]}}]"), "6:56",
       "place.0.lowest.corner is [0, 1, 1] (must be a list of 3, each -1 or 1)"},
      {"LowestOfTwoKinds",
       append("place: [{parts: [rod], direction: -z, lowest: {corner: [1, 1, 1], face: [0, 0, 1]}}]"), "6:47",
       "'place.0.lowest' has several keys"},
      {"JoinSideWithoutAPart", append("join: [{sides: [x_min]}]"), "6:17",
       "join.0.sides.0 is 'x_min' (must be a side or a set with its part"},
  };
}

}  // namespace percuss
