#include "src/step/restart/run_checkpoints.hpp"

#include <fmt/format.h>

#include <filesystem>

namespace percuss {

namespace {

constexpr const char* file_name = "/checkpoint.h5";

}  // namespace

RunCheckpoints::RunCheckpoints(const Deck& deck, const std::string& directory)
    : deck_file_(deck.file),
      output_(deck.output),
      file_(directory.empty() ? "" : directory + file_name),
      due_(deck.output.checkpoint_every) {}

bool RunCheckpoints::is_clock_due() const {
  if (file_.empty() || !output_.checkpoint_wall) return false;
  return std::chrono::duration<double>(Clock::now() - clock_).count() >= *output_.checkpoint_wall;
}

void RunCheckpoints::note(const std::string& path, const State& state) {
  path_ = path;
  step_ = state.step;
  time_ = state.time;
  due_.advance(state.time);
}

void RunCheckpoints::write(const CheckpointHeader& header, const ChunkedMesh& chunked, const Communicator& ranks,
                           const State& state, const std::function<void(CheckpointArchive&)>& archive) {
  CheckpointWriter writer(file_, header, chunked, ranks);
  archive(writer);
  writer.finish(path_);
  note(file_, state);
  clock_ = Clock::now();
}

std::string RunCheckpoints::describe() const {
  std::error_code lost;  // with the folder itself
  if (path_.empty() || !std::filesystem::exists(path_, lost)) return "";
  return fmt::format("checkpoint: {}, step {}, t = {:.6g}; to continue: percuss run {} --restart {}", path_, step_,
                     time_, deck_file_, path_);
}

}  // namespace percuss
