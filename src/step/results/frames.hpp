#pragma once
// Writes frames of the fields that the deck asks for.

#include <string>
#include <vector>

#include "src/contact/contact_stage.hpp"
#include "src/output/fields/fields_file.hpp"
#include "src/step/model/model.hpp"
#include "src/step/model/state.hpp"

namespace percuss {

class Frames {
 public:
  /// Creates the fields file in the directory. The deck, the model and the contact stage outlive this. Collective over
  /// the model's ranks, as are all calls. Throws SystemError.
  Frames(const std::string& directory, const Deck& deck, const ChunkedMesh& chunked, const Model& model,
         const ContactStage& contact);

  /// Goes on with the fields file of an earlier run behind its first `frames`. Throws InputError, too.
  Frames(const std::string& directory, const Deck& deck, const ChunkedMesh& chunked, const Model& model,
         const ContactStage& contact, std::int64_t frames);

  /// Throws what that would throw of the file, and changes nothing.
  static void check(const std::string& directory, const Deck& deck, const ChunkedMesh& chunked, const Model& model,
                    std::int64_t frames);

  void write(const State& state);
  /// Waits until the disk has the frames written so far.
  void sync() { file_.sync(); }
  void close() { file_.close(); }
  /// Whether the file still has its name: not if somebody removed or replaced it.
  bool is_in_place() const { return file_.is_in_place(); }
  /// In the file.
  std::int64_t count() const { return count_; }

 private:
  void note_constant_fields(const ChunkedMesh& chunked);

  const Model& model_;
  const ContactStage& contact_;
  std::vector<std::string> names_;    // of the fields
  std::vector<double> body_, chunk_;  // constant fields, only if asked for
  FieldsFile file_;
  std::int64_t count_ = 0;
};

}  // namespace percuss
