#pragma once
// Parameter tables that code of a user reads: collections by name, in each tables by label, in each rows of integers,
// numbers and words.

#include <string>

namespace percuss {

/// Forgets all tables.
void forget_user_tables();

/// Adds the tables of a file, of which each line is one of "collection,NAME", "table,LABEL,KIND,..." with a kind
/// integer, float or string for each column, and "row,VALUE,...". Throws InputError with file and line.
void read_user_tables(const std::string& file);

}  // namespace percuss
