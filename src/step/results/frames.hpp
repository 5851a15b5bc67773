#pragma once
// Writes frames of the fields that the deck asks for, in one file or in two of different formats.

#include <optional>
#include <string>
#include <vector>

#include "src/contact/contact_stage.hpp"
#include "src/output/exodus/exodus_results.hpp"
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
  void sync();
  void close();
  /// Whether the files still have their names: not if somebody removed or replaced one.
  bool is_in_place() const;
  /// In the file.
  std::int64_t count() const { return count_; }

 private:
  void note_constant_fields(const ChunkedMesh& chunked);

  const Model& model_;
  const ContactStage& contact_;
  std::vector<std::string> names_;  // of the fields
  std::vector<std::size_t> drawn_walls_;
  std::vector<double> body_, chunk_;  // constant fields, only if asked for
  std::optional<FieldsFile> vtkhdf_;
  std::optional<ExodusResults> exodus_;
  std::int64_t count_ = 0;
};

}  // namespace percuss
