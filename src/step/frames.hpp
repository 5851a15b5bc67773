#pragma once
// Writes frames of the fields that the deck asks for.

#include <string>
#include <vector>

#include "src/contact/contact_stage.hpp"
#include "src/output/fields_file.hpp"
#include "src/step/model.hpp"
#include "src/step/state.hpp"

namespace percuss {

class Frames {
 public:
  /// Creates the fields file in the directory. The deck, the model and the contact stage outlive this. Collective over
  /// the model's ranks, as are all calls. Throws SystemError.
  Frames(const std::string& directory, const Deck& deck, const ChunkedMesh& chunked, const Model& model,
         const ContactStage& contact);

  void write(const State& state);
  void close() { file_.close(); }

 private:
  const Deck& deck_;
  const Model& model_;
  const ContactStage& contact_;
  std::vector<double> body_, chunk_;  // constant fields, only if asked for
  FieldsFile file_;
};

}  // namespace percuss
