#include "src/step/restart/restart_removals.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "src/error.hpp"
#include "src/output/checkpoint/checkpoint_file.hpp"
#include "src/output/summary.hpp"

namespace percuss {
namespace {

namespace fs = std::filesystem;

bool is_beyond(const SavedState& state, const SavedState& end) {
  return state.time > end.time * (1 + same_time) || state.step > end.step;
}

std::string count_states(const LaterStates& states, const char* what, const std::string& file) {
  if (states.empty()) return "";
  return fmt::format("{} {}{} of {} up to t = {:.6g}", states.size(), what, states.size() == 1 ? "" : "s", file,
                     states.back().time);
}

std::string find_summary(const RestartInPlace& restart) {
  const std::string path = restart.folder + "/summary.json";
  if (!fs::exists(path)) return "";
  try {
    const Summary summary = read_summary(path);
    if (summary.status != "completed" || !is_beyond({summary.time, summary.steps}, restart.end)) return "";
    return fmt::format("the summary of a run that was completed at t = {:.6g}", summary.time);
  } catch (const std::exception&) {  // what cannot be read cannot be lost
    return "";
  }
}

/// The newest checkpoint of the folder, if the run continues from another one.
std::string find_checkpoint(const RestartInPlace& restart) {
  const std::string path = restart.folder + "/checkpoint.h5";
  std::error_code ignored;
  if (!fs::exists(path, ignored) || fs::equivalent(path, restart.checkpoint, ignored)) return "";
  try {
    const CheckpointHeader header = read_checkpoint_header(path);
    if (!is_beyond({header.time, header.step}, restart.end)) return "";
    return fmt::format("checkpoint.h5 of t = {:.6g}", header.time);
  } catch (const std::exception&) {
    return "";
  }
}

}  // namespace

std::string describe_removals(const RestartInPlace& restart, const CutStates& cut) {
  std::vector<std::string> parts{count_states(cut.rows, "row", "history.csv")};
  for (const CutFrames& of : cut.frames) parts.push_back(count_states(of.frames, "frame", of.file));
  parts.push_back(find_summary(restart));
  parts.push_back(find_checkpoint(restart));
  std::string text;
  for (const std::string& part : parts) {
    if (!part.empty()) text += (text.empty() ? "" : ", ") + part;
  }
  return text;
}

std::string refuse_removals(const RestartInPlace& restart, const std::string& removals) {
  return fmt::format(
      "{}: error: continuing from {} (t = {:.6g}) would delete results that this run does not compute again ({}): "
      "choose another folder with --out, restore the earlier time.end and output, or give --force",
      restart.folder, restart.checkpoint, restart.from.time, removals);
}

}  // namespace percuss
