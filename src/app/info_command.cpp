#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <string_view>

#include "src/app/commands.hpp"
#include "src/app/folder/folder_lock.hpp"
#include "src/app/reports/mesh_report.hpp"
#include "src/app/reports/summary_report.hpp"
#include "src/hdf5/hdf5_structure.hpp"
#include "src/mesh/formats/exodus/trial_process.hpp"
#include "src/output/checkpoint/checkpoint_file.hpp"
#include "src/output/files/safe_text.hpp"
#include "src/output/formats/result_names.hpp"
#include "src/output/summary.hpp"
#include "src/output/vtkhdf/describe_fields.hpp"
#include "src/regular_file.hpp"

namespace percuss {
namespace {

namespace fs = std::filesystem;

enum class Content { json, hdf5, classic_netcdf, other };

// By the first bytes; names mislead.
Content identify(const std::string& file) {
  std::ifstream stream(file, std::ios::binary);
  std::array<char, 8> bytes{};
  if (!stream) throw SystemError(fmt::format("{} cannot be opened", file));
  stream.read(bytes.data(), bytes.size());
  const std::string_view start(bytes.data(), static_cast<std::size_t>(stream.gcount()));
  if (start == std::string_view("\x89HDF\r\n\x1a\n", 8)) return Content::hdf5;
  if (start.starts_with("CDF")) return Content::classic_netcdf;
  const auto first = start.find_first_not_of(" \t\r\n");
  return first != std::string_view::npos && start[first] == '{' ? Content::json : Content::other;
}

// A netCDF-4 mesh and a fields file are both HDF5.
std::string describe_hdf5(const std::string& file) {
  if (is_checkpoint(file) || fs::path(file).filename().string().starts_with("checkpoint"))
    return describe_checkpoint(file);
  std::string not_fields;
  try {
    return describe_fields_file(file);
  } catch (const InputError& error) {
    not_fields = error.what();
  }
  try {
    return describe_mesh_file(file);
  } catch (const InputError& error) {
    const std::string extension = fs::path(file).extension().string();
    throw InputError(extension == ".vtkhdf" ? not_fields : std::string(error.what()));
  }
}

/// Refuses what is no regular file, and HDF5 files whose links lead astray.
void check_source(const std::string& file, hdf5::ExternalFiles external) {
  if (const std::string kind = describe_irregular_file(file); !kind.empty())
    throw InputError(fmt::format("{}: error: this is {}", file, kind));
  if (!hdf5::has_hdf5_signature(file)) return;
  try {
    hdf5::check_structure(file, external);
  } catch (const InputError& error) {
    throw InputError(fmt::format("{}: error: {}", file, error.what()));
  }
}

/// Whether a run holds the folder, or one was killed there; empty if neither.
std::string describe_holder_of(const std::string& folder, const std::string& status) {
  std::string holder = describe_lock(folder);
  if (holder.empty() && status == "running")
    holder = "it was killed or could not write its final summary: the summary says running, but no run is under way";
  return holder.empty() ? "" : fmt::format("{:<10}{}\n", "run", holder);
}

std::string describe_folder(const std::string& folder, hdf5::ExternalFiles external) {
  std::string text, status;
  const fs::path path(folder);
  std::vector<std::string> frames;
  for (std::string& name : list_fields_files(folder)) {
    if (holds_frames(name)) frames.push_back(std::move(name));
  }
  std::vector<std::string> files{"summary.json", "checkpoint.h5"};
  files.insert(files.end(), frames.begin(), frames.end());
  for (const std::string& file : files) {
    if (fs::exists(path / file)) check_source((path / file).string(), external);
  }
  if (fs::exists(path / "summary.json")) {
    const Summary summary = read_summary((path / "summary.json").string());
    text += format_summary(summary);
    status = summary.status;
  }
  text = describe_holder_of(folder, status) + text;
  for (const std::string& name : frames) {
    const std::string file = (path / name).string();
    if (!text.empty()) text += '\n';
    text += describe_hdf5(file);
  }
  if (fs::exists(path / "checkpoint.h5")) {
    if (!text.empty()) text += '\n';
    text += describe_checkpoint((path / "checkpoint.h5").string());
  }
  if (text.empty())
    throw InputError(fmt::format("{}: error: no percuss results (no summary.json or {})", folder,
                                 fmt::join(name_fields_files(""), ", ")));
  return text;
}

std::string describe(const std::string& file, hdf5::ExternalFiles external) {
  std::error_code ignored;
  if (!fs::exists(file, ignored)) throw InputError(file + ": error: no such file");
  if (fs::is_directory(file, ignored)) return describe_folder(file, external);
  check_source(file, external);
  switch (identify(file)) {
    case Content::json:
      return format_summary(read_summary(file));
    case Content::hdf5:
      return describe_hdf5(file);
    case Content::classic_netcdf:
      return describe_mesh_file(file);
    case Content::other:
      break;
  }
  if (is_mesh_file(file)) return describe_mesh_file(file);
  const std::string extension = fs::path(file).extension().string();
  const bool is_deck = extension == ".yaml" || extension == ".yml";
  throw InputError(file + ": error: not a summary, a fields file or a mesh of a known format" +
                   (is_deck ? " (a deck? then: percuss check " + file + ")" : ""));
}

/// Bytes of a file, or of the files in a folder; 0 if nothing can be found out.
std::uintmax_t find_bytes(const fs::path& path) {
  std::error_code ignored;
  if (!fs::is_directory(path, ignored)) return fs::is_regular_file(path, ignored) ? fs::file_size(path, ignored) : 0;
  std::uintmax_t bytes = 0;
  for (const fs::directory_entry& entry : fs::directory_iterator(path, ignored))
    if (entry.is_regular_file(ignored)) bytes += entry.file_size(ignored);
  return bytes;
}

}  // namespace

ExitCode info_command(const Command& command) {
  const auto external = command.allow_external ? hdf5::ExternalFiles::allow : hdf5::ExternalFiles::refuse;
  rehearse(command.file, find_bytes(command.file), [&] { describe(command.file, external); });
  std::string text = describe(command.file, external);
  if (!text.ends_with('\n')) text += '\n';
  print_text(stdout, text);
  return ExitCode::done;
}

}  // namespace percuss
