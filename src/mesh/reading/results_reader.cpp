#include "src/mesh/reading/results_reader.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <fstream>
#include <string_view>

#include "src/error.hpp"
#include "src/mesh/formats/exodus/exodus_file.hpp"
#include "src/mesh/formats/exodus/trial_process.hpp"
#include "src/mesh/formats/vtu/legacy_vtk.hpp"
#include "src/mesh/formats/vtu/vtu_file.hpp"
#include "src/regular_file.hpp"

namespace percuss {
namespace {

enum class ResultsFormat { none, exodus, vtu, legacy_vtk };

constexpr std::array<std::string_view, 9> results_extensions{".e",   ".exo", ".ex2", ".exii", ".g",
                                                             ".gen", ".nc",  ".vtu", ".vtk"};

std::string read_beginning(const std::string& path) {
  if (!describe_irregular_file(path).empty()) return "";
  std::ifstream stream(path, std::ios::binary);
  std::array<char, 4096> bytes{};
  stream.read(bytes.data(), bytes.size());
  return {bytes.data(), static_cast<std::size_t>(stream.gcount())};
}

ResultsFormat find_results_format(const std::string& path) {
  const std::string first = read_beginning(path);
  if (is_vtu_file(first)) return ResultsFormat::vtu;
  if (is_legacy_vtk_file(first)) return ResultsFormat::legacy_vtk;
  if (first.starts_with("CDF") || first.starts_with("\x89HDF\r\n\x1a\n")) return ResultsFormat::exodus;
  const auto is_end = [&](std::string_view extension) { return path.ends_with(extension); };
  if (!std::any_of(results_extensions.begin(), results_extensions.end(), is_end)) return ResultsFormat::none;
  if (path.ends_with(".vtk")) return ResultsFormat::legacy_vtk;
  return path.ends_with(".vtu") ? ResultsFormat::vtu : ResultsFormat::exodus;
}

FileResults read_vtk_results(ResultsFormat format, const std::string& path, const ResultsWish& wish) {
  return format == ResultsFormat::vtu ? read_vtu_results(path, wish) : read_legacy_vtk_results(path, wish);
}

FileResults read_results_of(ResultsFormat format, const std::string& path, const ResultsWish& wish) {
  if (path.ends_with(".vtkhdf"))
    throw InputError(
        "results are read from Exodus II, .vtu and .vtk files: write them with output.fields.format: exodus");
  if (format == ResultsFormat::exodus) return ExodusFile(path).read_results(wish);
  if (wish.time) throw InputError("a VTK file has no times: leave out the key time");
  return read_vtk_results(format, path, wish);
}

}  // namespace

bool has_results_format(const std::string& path) { return find_results_format(path) != ResultsFormat::none; }

ResultsContents read_results_contents(const std::string& path) {
  const ResultsFormat format = find_results_format(path);
  if (format == ResultsFormat::none) return {};
  if (format == ResultsFormat::exodus) return ExodusFile(path).read_results_contents();
  const FileResults results = read_vtk_results(format, path, {});
  return {{}, results.element_names, results.node_names};
}

FileResults read_file_results(const std::string& path, const ResultsWish& wish) {
  const ResultsFormat format = find_results_format(path);
  try {
    const auto read = [&] { return read_results_of(format, path, wish); };
    if (format == ResultsFormat::exodus) {
      std::ifstream stream(path, std::ios::binary | std::ios::ate);
      const auto bytes = stream ? static_cast<std::uintmax_t>(stream.tellg()) : 0;
      run_trial_process([&] { read(); }, find_patience(bytes));
    }
    return read();
  } catch (const InputError& error) {
    const std::string text = error.what();
    throw InputError(text.starts_with(path) ? text : fmt::format("{}: error: {}", path, text));
  }
}

}  // namespace percuss
