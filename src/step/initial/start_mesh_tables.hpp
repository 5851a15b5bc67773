#pragma once
// Tables of the start from a mesh file with results: the state that another run has left, by the names that percuss
// gives its variables (docs/output.md).

#include <string>
#include <vector>

#include "comm/communicator.hpp"
#include "src/deck/deck.hpp"
#include "src/step/initial/start_file.hpp"

namespace percuss {

/// A table, and the part whose ids it has; empty: of any.
struct StartPiece {
  std::string part;
  StartTable table;
};

enum class StartPlace { elements, nodes };

/// Displacements that a file has and a start does not use.
struct FileDisplacement {
  std::string name;    // of the variable with the largest value; empty: there is none
  double largest = 0;  // magnitude of that [length]
};

/// The tables of a block of the file each, of elements or of nodes. Blocks that are called like a part, as in
/// fields.exo, have the ids of that part. Throws InputError with the file's name: it is damaged, has no such time,
/// none of the variables, not one that the deck requests, or not all its components; a number that is not finite or
/// absurd; an id twice in a block. SystemError.
/// Reads the tables of a file. For elements, `unused` gets the displacements that the file has.
std::vector<StartPiece> read_mesh_tables(const Deck& deck, const StartFieldsDeck& fields, StartPlace place,
                                         FileDisplacement& unused);

/// Gives all ranks those of rank 0. Collective.
void share_displacement(const Communicator& ranks, FileDisplacement& displacement);
void share_pieces(const Communicator& ranks, std::vector<StartPiece>& pieces);

}  // namespace percuss
