#pragma once
// Writes frames of the fields that the deck asks for.

#include <string>
#include <vector>

#include "src/output/fields_file.hpp"
#include "src/step/model.hpp"
#include "src/step/state.hpp"

namespace percuss {

class Frames {
 public:
  /// Creates the fields file in the directory. Throws SystemError.
  Frames(const std::string& directory, const Deck& deck, const ChunkedMesh& chunked, const Model& model);

  void write(const State& state);
  void close() { file_.close(); }

 private:
  const Deck& deck_;
  const Model& model_;
  std::vector<double> body_, chunk_;  // constant fields, only if asked for
  FieldsFile file_;
};

}  // namespace percuss
