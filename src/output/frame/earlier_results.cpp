#include "src/output/frame/earlier_results.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <functional>

#include "src/mesh/formats/exodus/trial_process.hpp"
#include "src/output/files/atomic_file.hpp"
#include "src/output/hdf5/hdf5_reading.hpp"

namespace percuss {
namespace {

constexpr double most_steps = 9e15;  // that a double counts

hsize_t find_known_bytes(const std::string& path) {
  std::error_code ignored;
  const auto bytes = std::filesystem::file_size(path, ignored);
  return ignored ? 0 : static_cast<hsize_t>(bytes);
}

/// An earlier file that this process alone reads or cuts.
class EarlierFile {
 public:
  EarlierFile(const FrameLayout& format, const std::string& path, unsigned mode)
      : format_(format), bytes_(find_known_bytes(path)), file_(hdf5::open_unlocked(path, mode)) {}

  hsize_t count_frames() const {
    const std::int64_t frames = format_.count_frames(file_.get());
    if (frames < 0) throw hdf5::Error("count the frames", "their number is negative");
    return static_cast<hsize_t>(frames);
  }

  std::vector<double> read_times(hsize_t first, hsize_t count) const {
    return hdf5::read_rows<double>(file_.get(), format_.times, first, count, bytes_);
  }

  /// Why the file does not fit; empty if it does.
  std::string find_problem(const FramesInFile& kept, std::span<const std::string> fields) const {
    const FramesInFile mesh = format_.find_mesh(file_.get());
    if (mesh.nodes != kept.nodes || mesh.elements != kept.elements) return "it has another mesh";
    if (count_frames() < kept.frames)
      return fmt::format("it has {} frames, but the checkpoint expects {}", count_frames(), kept.frames);
    const std::set<std::string> found = format_.list_fields(file_.get(), fields);
    const bool has_none = kept.frames == 0 && found.empty();
    if (!has_none && found != std::set<std::string>(fields.begin(), fields.end()))
      return "its fields are not those of this deck";
    return "";
  }

  LaterStates read_later_frames(hsize_t first) const {
    const hsize_t all = count_frames();
    if (all <= first) return {};
    const std::vector<double> times = read_times(first, all - first);
    const auto steps = hdf5::read_rows<double>(file_.get(), format_.steps, first, all - first, bytes_);
    LaterStates later;
    for (std::size_t i = 0; i < std::min(times.size(), steps.size()); ++i) {
      if (!(steps[i] >= 0 && steps[i] < most_steps))
        throw hdf5::Error(fmt::format("read {}", format_.steps), "a step number is not a count");
      later.push_back({times[i], static_cast<std::int64_t>(steps[i])});
    }
    return later;
  }

  void cut(const FramesInFile& kept) {
    format_.cut(file_.get(), kept);
    hdf5::check(file_.reset(), "close the file");
  }

 private:
  const FrameLayout& format_;
  hsize_t bytes_;
  hdf5::Handle file_;
};

/// work(file) in a process of its own first: libraries may crash on damaged files.
template <class Work>
auto read_earlier(const FrameLayout& format, const std::string& path, const Work& work) {
  const auto open_and_work = [&] {
    const hdf5::QuietErrors quiet;
    return work(EarlierFile(format, path, H5F_ACC_RDONLY));
  };
  rehearse(path, find_known_bytes(path), [&] { open_and_work(); });
  return open_and_work();
}

}  // namespace

FramesInFile find_kept(const ChunkedMesh& chunked, std::int64_t frames) {
  return {static_cast<hsize_t>(frames), static_cast<hsize_t>(chunked.numbering.node_count()),
          static_cast<hsize_t>(chunked.numbering.element_count())};
}

std::vector<double> check_earlier_results(const FrameLayout& format, const std::string& path, const FramesInFile& kept,
                                          std::span<const std::string> fields) {
  std::string problem;
  try {
    std::vector<double> times = read_earlier(format, path, [&](const EarlierFile& file) {
      problem = file.find_problem(kept, fields);
      return problem.empty() ? file.read_times(0, kept.frames) : std::vector<double>();
    });
    if (problem.empty()) return times;
  } catch (const hdf5::Error& error) {
    problem = fmt::format("cannot {}: {}", error.what(), error.reason);
  }
  throw InputError(fmt::format("{}: error: {} (the restart would continue this file): choose another folder with --out",
                               path, problem));
}

LaterStates find_later_frames(const FrameLayout& format, const std::string& path, std::int64_t frames) {
  if (find_known_bytes(path) == 0) return {};
  const auto first = static_cast<hsize_t>(std::max<std::int64_t>(frames, 0));
  try {
    return read_earlier(format, path, [&](const EarlierFile& file) { return file.read_later_frames(first); });
  } catch (const hdf5::Error&) {  // no such file of percuss
  } catch (const InputError&) {   // nor one that the library can read
  }
  return {};
}

void cut_earlier_results(const FrameLayout& format, const std::string& path, const FramesInFile& kept) {
  const hdf5::QuietErrors quiet;
  try {
    EarlierFile(format, path, H5F_ACC_RDWR).cut(kept);
  } catch (const hdf5::Error& error) {
    throw SystemError(fmt::format("cannot cut '{}' to its first {} frames ({}; while HDF5 was to {}){}", path,
                                  kept.frames, error.reason, error.what(), suggest_for_errno(error.error_number)));
  }
}

}  // namespace percuss
