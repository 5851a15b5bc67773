#pragma once
// What code of users gets of an element.

namespace percuss {

/// Characteristic lengths that the user's code may tell of an element.
inline constexpr int most_user_lengths = 12;

/// An element as code of a user sees it, fixed from the start.
struct UserElement {
  double id = 0;                           // the user's
  double length = 0;                       // edge of a cube of its volume at the start
  double lengths[most_user_lengths] = {};  // characteristic lengths of its own, where the law requests them
  double place[3] = {};                    // of its middle at the start
};

}  // namespace percuss
