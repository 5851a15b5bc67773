#include "src/app/process/external_files.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "src/error.hpp"
#include "src/hdf5/hdf5_structure.hpp"
#include "src/mesh/formats/exodus/trial_process.hpp"
#include "src/output/checkpoint/sealed_file.hpp"
#include "src/output/formats/result_names.hpp"
#include "src/regular_file.hpp"

namespace percuss {
namespace {

/// Throws InputError if the file's links lead to other files, or nowhere; its message begins with `place`.
void refuse_external(const std::string& path, const std::string& place) {
  if (!describe_irregular_file(path).empty() || !hdf5::has_hdf5_signature(path)) return;
  std::error_code ignored;
  const std::uintmax_t bytes = std::filesystem::file_size(path, ignored);
  try {
    run_trial_process([&] { hdf5::check_structure(path, hdf5::ExternalFiles::refuse); }, find_patience(bytes));
  } catch (const InputError& error) {
    throw InputError(fmt::format("{}: {}", place, error.what()));
  }
}

}  // namespace

void refuse_external_meshes(const Deck& deck) {
  for (const PartDeck& part : deck.parts) {
    const auto* exodus = std::get_if<FileMesh>(&part.shape);
    if (exodus == nullptr) continue;
    refuse_external(exodus->file,
                    fmt::format("{}: error: part '{}': {}", deck.where(part.place), part.name, exodus->file));
  }
  for (const StartFieldsDeck& fields : deck.start.fields)
    refuse_external(fields.file, fmt::format("{}: error: start.fields: {}", deck.where(fields.place), fields.file));
}

void refuse_external_checkpoint(const std::string& path) { refuse_external(path, path + ": error"); }

void refuse_other_file(const std::string& path) {
  if (std::filesystem::path(path).extension() == ".h5")
    return;  // one that is damaged is reported later, in other words
  if (!describe_irregular_file(path).empty() || hdf5::has_hdf5_signature(path)) return;
  throw InputError(
      fmt::format("{}: error: not a checkpoint (it is no HDF5 file): name checkpoint.h5 or its folder", path));
}

void check_results_to_go_on_with(const std::string& folder, const std::string& checkpoint, bool allow_external) {
  std::vector<std::string> names{"history.csv", "checkpoint.h5", "summary.json"};
  for (std::string& name : list_fields_files(folder)) {
    if (holds_frames(name)) names.push_back(std::move(name));
  }
  for (const std::string& name : names) {
    const std::string path = folder + "/" + name;
    if (const std::string kind = describe_irregular_file(path); !kind.empty())
      throw InputError(fmt::format("{}: error: this is {}", path, kind));
  }
  if (allow_external) return;
  for (const std::string& name : names) {
    const std::string path = folder + "/" + name;
    if (holds_frames(name)) refuse_external(path, path + ": error");
  }
  const std::string newest = folder + "/checkpoint.h5";
  // One that is damaged, which is why the run continues from an older one, is not opened.
  std::error_code ignored;
  if (!std::filesystem::equivalent(newest, checkpoint, ignored) && is_sealed(newest))
    refuse_external(newest, newest + ": error");
}

}  // namespace percuss
