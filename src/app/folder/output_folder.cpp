#include "src/app/folder/output_folder.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <array>
#include <cctype>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <system_error>
#include <utility>
#include <vector>

#include "src/app/folder/folder_lock.hpp"
#include "src/error.hpp"
#include "src/output/formats/result_names.hpp"
#include "src/output/frame/frame_layout.hpp"
#include "src/regular_file.hpp"

namespace percuss {
namespace {

namespace fs = std::filesystem;

// Every file that a run writes beside those of fields.
constexpr std::array<const char*, 7> result_files{"summary.json",          "columns.json", "ranks.csv",
                                                  "run_deck.yaml",         "history.csv",  "checkpoint.h5",
                                                  "checkpoint_previous.h5"};

// Files that are written beside their place first have a name with this behind it then.
constexpr const char* unfinished = ".tmp";

/// The deck of the run that left its results in the folder; empty if there is none.
std::string read_earlier_deck(const std::string& folder) {
  std::ifstream file(fs::path(folder) / "run_deck.yaml", std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

/// Whether a deck has a key of this name.
bool has_key(const std::string& deck, const std::string& name) {
  const auto is_of_name = [](char c) {
    return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_' || c == '-';
  };
  for (std::size_t at = deck.find(name); at != std::string::npos; at = deck.find(name, at + 1)) {
    const std::size_t end = deck.find_first_not_of(" \"'", at + name.size());
    if ((at == 0 || !is_of_name(deck[at - 1])) && end != std::string::npos && deck[end] == ':') return true;
  }
  return false;
}

/// Files of field outputs of the earlier run: others may have such names too.
std::vector<std::string> list_output_files(const std::string& folder, const std::string& behind = "") {
  const std::string deck = read_earlier_deck(folder), begin = name_fields("") + "_";
  std::vector<std::string> files = list_fields_files(folder, behind);
  std::erase_if(files, [&](const std::string& file) {
    const std::string stem = fs::path(file).stem().string();
    return !stem.starts_with(begin) || !has_key(deck, stem.substr(begin.size()));
  });
  return files;
}

/// Files that a run may have left in the folder: all that have a fixed name, and those of field outputs that are there.
std::vector<std::string> list_result_files(const std::string& folder) {
  std::vector<std::string> files(result_files.begin(), result_files.end());
  for (std::string& name : name_fields_files("")) files.push_back(std::move(name));
  for (std::string& file : list_output_files(folder)) files.push_back(std::move(file));
  return files;
}

bool holds_results(const fs::path& folder) {
  std::error_code ignored;
  for (const std::string& file : list_result_files(folder.string())) {
    if (fs::exists(folder / file, ignored)) return true;
  }
  return false;
}

void remove_file(const fs::path& file) {
  std::error_code error;
  fs::remove(file, error);
  if (error) throw SystemError(fmt::format("{} cannot be removed ({})", file.string(), error.message()));
}

/// Whether both name the same file or folder, and it is there.
bool is_lock(const fs::path& file) { return file.filename().string().starts_with(lock_file_name); }

}  // namespace

std::string default_output_folder(const std::string& deck_file) {
  const fs::path deck = fs::path(deck_file).lexically_normal();
  std::string scene = deck.stem().string();
  if (scene == "deck") {
    std::error_code ignored;
    const std::string folder = fs::absolute(deck, ignored).lexically_normal().parent_path().filename().string();
    if (!folder.empty()) scene = folder;
  }
  return (fs::path("out") / scene).string();
}

std::string find_checkpoint(const std::string& file_or_folder) {
  std::error_code ignored;
  if (!fs::is_directory(file_or_folder, ignored)) return file_or_folder;
  return (fs::path(file_or_folder) / "checkpoint.h5").string();
}

std::string find_restart_folder(const std::string& checkpoint) {
  const std::string folder = fs::path(checkpoint).parent_path().string();
  return folder.empty() ? "." : folder;
}

bool lies_in_folder(const std::string& checkpoint, const std::string& folder) {
  std::error_code ignored;
  const std::string behind_links = fs::weakly_canonical(checkpoint, ignored).string();
  return is_same_file(find_restart_folder(checkpoint), folder) ||
         is_same_file(find_restart_folder(behind_links), folder);
}

void check_folder_is_writable(const std::string& folder) {
  if (::access(folder.c_str(), W_OK | X_OK) == 0) return;
  throw SystemError(fmt::format("folder {} cannot be written to ({})", folder, std::strerror(errno)));
}

void make_output_folder(const std::string& folder) {
  std::error_code error;
  const fs::path path(folder);
  if (fs::exists(path, error) && !fs::is_directory(path, error)) {
    throw InputError(
        fmt::format("{}: error: not a folder (results go to a folder): choose another with --out", folder));
  }
  fs::create_directories(path, error);
  if (error) throw SystemError(fmt::format("folder {} cannot be created ({})", folder, error.message()));
  check_folder_is_writable(folder);
}

void check_folder_is_empty(const std::string& folder) {
  std::error_code error;
  const fs::path path(folder);
  bool is_empty = true;
  for (fs::directory_iterator at(path, error); !error && at != fs::directory_iterator(); at.increment(error))
    is_empty = is_empty && is_lock(at->path());
  if (error) throw SystemError(fmt::format("folder {} cannot be read ({})", folder, error.message()));
  if (is_empty) return;
  const char* what = holds_results(path) ? "it holds the results of an earlier run" : "it is not empty";
  throw InputError(fmt::format(
      "{}: error: {} (results are not overwritten without --force): choose another folder with --out, or give --force",
      folder, what));
}

void refuse_to_remove(const std::string& path, const std::string& what, const std::string& folder) {
  for (const std::string& file : list_result_files(folder)) {
    if (!is_same_file(fs::path(folder) / file, path)) continue;
    throw InputError(fmt::format(
        "{}: error: --force would remove this {} (it is {} in the folder of results {}): choose another folder with "
        "--out",
        path, what, file, folder));
  }
}

void remove_results(const std::string& folder) {
  const std::vector<std::string> begun = list_output_files(folder, unfinished);
  for (const std::string& file : list_result_files(folder)) {
    remove_file(fs::path(folder) / file);
    remove_file(fs::path(folder) / (file + unfinished));
  }
  for (const std::string& file : begun) remove_file(fs::path(folder) / (file + unfinished));
}

}  // namespace percuss
