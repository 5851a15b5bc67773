#pragma once
// Writes frames of the fields that an output requests, in a file of each of its formats.

#include <map>
#include <memory>
#include <string>
#include <vector>

#include "src/contact/contact_stage.hpp"
#include "src/output/frame/frame_writer.hpp"
#include "src/step/model/model.hpp"
#include "src/step/model/state.hpp"
#include "src/step/results/fields/frame_scene.hpp"

namespace percuss {

class Frames {
 public:
  /// region: what it shows; none: the whole mesh. The model, the contact stage and the region outlive this. Collective
  /// over the model's ranks, as are all calls. Throws SystemError.
  Frames(const FrameScene& scene, const FieldsDeck& fields, const FieldRegion* region);

  /// Creates the files in the directory.
  void create(const FrameScene& scene, const FieldsDeck& fields);
  /// Goes on with the files of an earlier run behind their first `frames`. Throws InputError, too.
  void go_on(const FrameScene& scene, const FieldsDeck& fields, std::int64_t frames);
  /// Throws what that would throw of the files, and changes nothing.
  static void check(const FrameScene& scene, const FieldsDeck& fields, const FieldRegion* region, std::int64_t frames);

  void write(const State& state) { put(collect(state)); }
  /// Keeps the frame of a state in memory, and that kept before.
  void keep(const State& state);
  /// Writes those kept of states after this step, if they are older than the other. Forgets all.
  void write_kept(std::int64_t after_step, std::int64_t before_step);
  /// Waits until the disk has the frames written so far.
  void sync();
  void close();
  /// Whether the files still have their names: not if somebody removed or replaced one.
  bool is_in_place() const;
  /// Number of frames in the file.
  std::int64_t count() const { return count_; }

 private:
  /// All that a frame is written from.
  struct Frame {
    double time = 0;
    std::int64_t step = 0;
    std::vector<double> positions;
    std::map<std::string, std::vector<double>> values;  // by field
    std::vector<FieldData> fields;                      // of these values
    std::vector<double> walls;
  };

  void note_constant_fields(const ChunkedMesh& chunked);
  void choose_elements(std::vector<double>& values) const;
  Frame collect(const State& state) const;
  void put(const Frame& frame);

  const Model& model_;
  const ContactStage& contact_;
  const FieldRegion* region_;
  std::vector<std::string> names_;  // of the fields
  std::vector<std::size_t> drawn_walls_;
  std::vector<double> body_, chunk_;                   // constant fields, only if requested
  std::vector<std::unique_ptr<FrameWriter>> writers_;  // one a format
  std::vector<Frame> kept_;                            // two at most, the later one last
  std::int64_t count_ = 0;
};

}  // namespace percuss
