#pragma once
// The values of a deck as text, to compare two decks by.

#include <string>
#include <vector>

#include "src/deck/yaml/yaml_tree.hpp"

namespace percuss {

/// Every value on which the motion depends, "time.step_scale = 0.9", in ascending order of their paths; equal numbers
/// have equal texts. Left out is what a run may change when it continues: output, audit, title, units, silence,
/// time.end, time.max_steps, time.until, time.collapse_ratio, contact.rebalance; and the names of mesh files, whose
/// content counts. With sensors, which look at the history, output.history counts too.
std::vector<std::string> list_motion_values(const Node& deck);

/// The values that are left out there: "? output.fields.every = 1". They stand behind those in a checkpoint.
std::vector<std::string> list_free_values(const Node& deck);

/// What differs between two such lists, a text each: "time.step_scale is 0.5 (0.9 in the checkpoint)". Values that are
/// free to change do not count.
std::vector<std::string> compare_motion_values(const std::vector<std::string>& now,
                                               const std::vector<std::string>& checkpoint);

/// Compares the values that are free to change; nothing, if the checkpoint has none of them (an older one).
std::vector<std::string> compare_free_values(const std::vector<std::string>& now,
                                             const std::vector<std::string>& checkpoint);

}  // namespace percuss
