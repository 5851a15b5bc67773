#include "src/step/restart/run_checkpoints.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <string_view>

namespace percuss {

namespace {

constexpr const char* file_name = "/checkpoint.h5";

bool is_plain(char c) {
  constexpr std::string_view signs = "_./:=,+@%-";
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
         signs.find(c) != std::string_view::npos;
}

}  // namespace

std::string quote_for_shell(const std::string& word) {
  if (!word.empty() && std::all_of(word.begin(), word.end(), is_plain)) return word;
  std::string quoted = "'";
  for (const char c : word) {
    if (c == '\'')
      quoted += "'\\''";  // the quote ends, a quote mark follows, and the next quote begins
    else
      quoted += c;
  }
  return quoted + "'";
}

RunCheckpoints::RunCheckpoints(const Deck& deck, const std::string& directory, bool allows_external_files)
    : deck_(deck),
      output_(deck.output),
      file_(directory.empty() ? "" : directory + file_name),
      allows_external_files_(allows_external_files),
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

std::string RunCheckpoints::describe_resume() const {
  std::string settings;
  for (const std::string& setting : deck_.settings) settings += " --set " + quote_for_shell(setting);
  return fmt::format("to continue: percuss run {}{} --restart {}{}", quote_for_shell(deck_.file), settings,
                     quote_for_shell(path_), allows_external_files_ ? " --allow-external" : "");
}

std::string RunCheckpoints::describe() const {
  std::error_code lost;  // with the folder itself
  if (path_.empty() || !std::filesystem::exists(path_, lost)) return "";
  return fmt::format("checkpoint: {}, step {}, t = {:.6g}; {}", path_, step_, time_, describe_resume());
}

}  // namespace percuss
