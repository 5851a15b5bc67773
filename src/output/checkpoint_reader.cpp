#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <bit>
#include <cerrno>

#include "src/fail_together.hpp"
#include "src/mesh/trial_process.hpp"
#include "src/output/atomic_file.hpp"
#include "src/output/checkpoint_file.hpp"
#include "src/output/checkpoint_names.hpp"
#include "src/output/hdf5_reading.hpp"
#include "src/output/sealed_file.hpp"

namespace percuss {
namespace {

namespace names = checkpoint_names;
using hdf5::check;

constexpr int words_per_sum = ExactSum::limb_count + 1;

[[noreturn]] void refuse(const std::string& path, const std::string& problem) {
  throw InputError(fmt::format("{}: error: {}", path, problem));
}

std::uint64_t find_file_bytes(const std::string& path) {
  const int descriptor = ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
  if (descriptor < 0) throw make_io_error("read", path, errno);
  const off_t size = ::lseek(descriptor, 0, SEEK_END);
  ::close(descriptor);
  return static_cast<std::uint64_t>(size);
}

hdf5::Handle open_hdf5(const std::string& path) {
  const hdf5::Handle access(check(H5Pcreate(H5P_FILE_ACCESS), "open the file"), H5Pclose);
  check(H5Pset_file_locking(access.get(), false, true), "open the file");
  return {check(H5Fopen(path.c_str(), H5F_ACC_RDONLY, access.get()), "open it as HDF5"), H5Fclose};
}

/// Calls work(); what HDF5 cannot do becomes an error of the input.
template <class Work>
void read_or_refuse(const std::string& path, const Work& work) {
  const hdf5::QuietErrors quiet;
  try {
    work();
  } catch (const hdf5::Error& error) {
    if (error.error_number != 0) throw make_io_error("read", path, error.error_number);
    refuse(path,
           fmt::format("not a checkpoint that this percuss can read (cannot {}: {})", error.what(), error.reason));
  }
}

CheckpointHeader read_header(hid_t file, std::uint64_t bytes, const std::string& path) {
  const hdf5::Handle group = hdf5::open_group(file, names::header);
  const auto number = [&](const char* name) { return hdf5::read_whole_number(group.get(), name); };
  const auto text = [&](const char* name) { return hdf5::read_text(group.get(), name); };
  if (number("format") != names::format) {
    refuse(path,
           fmt::format("the checkpoint has format {} (percuss {} writes and reads format {}) go on with percuss {}",
                       number("format"), PERCUSS_VERSION, names::format, text("version")));
  }
  CheckpointHeader header;
  header.version = text("version");
  header.precision = text("precision");
  header.title = text("title");
  header.mesh = text("mesh");
  header.written = text("written");
  header.elements = number("elements");
  header.nodes = number("nodes");
  header.step = number("step");
  header.time = std::bit_cast<double>(number("time_bits"));
  const auto long_text = [&](const char* name) {
    const auto length = hdf5::read_shape(group.get(), name).rows;
    const auto text_bytes = hdf5::read_rows<std::uint8_t>(group.get(), name, 0, length, bytes);
    return std::string(text_bytes.begin(), text_bytes.end());
  };
  header.deck = long_text(names::deck);
  header.warnings = long_text(names::warnings);
  return header;
}

/// Reads all rows of all datasets of a group and of the groups in it, and keeps none.
void read_all(hid_t group, std::uint64_t bytes) {
  constexpr hsize_t at_once = 1 << 20;
  for (const std::string& name : hdf5::list_names(group, ".")) {
    const hdf5::Handle object(check(H5Oopen(group, name.c_str(), H5P_DEFAULT), "open " + name), H5Oclose);
    if (H5Iget_type(object.get()) == H5I_GROUP) {
      read_all(object.get(), bytes);
      continue;
    }
    const hdf5::Handle type(check(H5Dget_type(object.get()), "read " + name), H5Tclose);
    const bool is_integer = H5Tget_class(type.get()) == H5T_INTEGER;
    const hsize_t all = hdf5::read_shape(group, name).rows;
    for (hsize_t row = 0; row < all; row += at_once) {
      const hsize_t rows = std::min(at_once, all - row);
      if (is_integer)
        hdf5::read_rows<std::int64_t>(group, name, row, rows, bytes);
      else
        hdf5::read_rows<double>(group, name, row, rows, bytes);
    }
  }
}

}  // namespace

CheckpointReader::CheckpointReader(const std::string& path, const ChunkedMesh& mesh, const Communicator& ranks)
    : path_(path), ranks_(ranks), mesh_(mesh) {
  check_seal(ranks, path);
  // A seal is no signature: what it fits may still be more than HDF5 can take.
  fail_together(ranks, [&] {
    const auto read = [&] {
      load();
      read_all(hdf5::open_group(file_.get(), names::state).get(), file_bytes_);
    };
    if (ranks.rank() == 0) rehearse(path_, find_file_bytes(path_), read);
  });
  fail_together(ranks, [&] { read_or_refuse(path_, [&] { load(); }); });
}

/// The header, the numbers and the sums.
void CheckpointReader::load() {
  file_bytes_ = find_file_bytes(path_);
  file_ = open_hdf5(path_);
  header_ = read_header(file_.get(), file_bytes_, path_);
  const hdf5::Handle group = hdf5::open_group(file_.get(), names::header);
  const auto integers = [&](const char* name) {
    return hdf5::read_rows<std::int64_t>(group.get(), name, 0, hdf5::read_shape(group.get(), name).rows, file_bytes_);
  };
  const auto number_names = hdf5::read_texts(group.get(), names::number_names);
  const auto sum_names = hdf5::read_texts(group.get(), names::sum_names);
  const auto numbers = integers(names::numbers);
  sums_ = integers(names::sums);
  if (numbers.size() != number_names.size() || sums_.size() != words_per_sum * sum_names.size())
    refuse(path_, "the checkpoint has another number of values than of names");
  for (std::size_t i = 0; i < numbers.size(); ++i) numbers_[number_names[i]] = numbers[i];
  for (std::size_t i = 0; i < sum_names.size(); ++i) sum_places_[sum_names[i]] = words_per_sum * i;
}

std::int64_t CheckpointReader::find_number(const std::string& name) const {
  const auto found = numbers_.find(name);
  if (found == numbers_.end()) refuse(path_, fmt::format("the checkpoint has no {} (this scene needs one)", name));
  return found->second;
}

void CheckpointReader::number(const std::string& name, double& value) {
  value = std::bit_cast<double>(find_number(name));
}
void CheckpointReader::number(const std::string& name, std::int64_t& value) { value = find_number(name); }

void CheckpointReader::sum(const std::string& name, ExactSum& value) {
  const auto found = sum_places_.find(name);
  if (found == sum_places_.end()) refuse(path_, fmt::format("the checkpoint has no {} (this scene needs one)", name));
  value = {};
  if (ranks_.rank() != 0) return;
  const std::int64_t* words = &sums_[found->second];
  std::copy_n(words, ExactSum::limb_count, value.limb);
  value.not_finite = words[ExactSum::limb_count];
}

/// The rows of this rank's chunks: a read for each run of chunks that follow each other.
template <class T>
void CheckpointReader::read_runs(const std::string& name, const std::vector<std::int64_t>& first, int components,
                                 std::vector<T>& into) const {
  const hdf5::Handle group = hdf5::open_group(file_.get(), names::state);
  const auto width = static_cast<hsize_t>(components);
  const auto start = [&](int chunk) { return static_cast<hsize_t>(first[static_cast<std::size_t>(chunk)]) * width; };
  const hdf5::Shape shape = hdf5::read_shape(group.get(), name);
  const hsize_t expected = static_cast<hsize_t>(first.back()) * width;
  if (shape.rows != expected || shape.components != 1) {
    refuse(path_, fmt::format("{} has {} values in the checkpoint (this scene has {})", name, shape.rows, expected));
  }
  const auto& chunks = mesh_.chunks;
  for (std::size_t begin = 0, end = 0; begin < chunks.size(); begin = end) {
    for (end = begin + 1; end < chunks.size() && chunks[end].number == chunks[end - 1].number + 1;) ++end;
    const hsize_t row = start(chunks[begin].number), rows = start(chunks[end - 1].number + 1) - row;
    const auto values = hdf5::read_rows<T>(group.get(), name, row, rows, file_bytes_);
    into.insert(into.end(), values.begin(), values.end());
  }
}

template <class T>
void CheckpointReader::read_rows(const std::string& name, const ChunkRows& rows, int components, std::span<T> values) {
  const std::vector<std::int64_t> first = find_first_rows(ranks_, mesh_, rows.counts);
  fail_together(ranks_, [&] {
    std::vector<T> read;
    read_or_refuse(path_, [&] { read_runs(name, first, components, read); });
    if (rows.places.empty()) {
      std::copy(read.begin(), read.end(), values.begin());
      return;
    }
    const auto width = static_cast<std::size_t>(components);
    for (std::size_t i = 0; i < rows.places.size(); ++i) {
      std::copy_n(&read[i * width], width, &values[static_cast<std::size_t>(rows.places[i]) * width]);
    }
  });
}

void CheckpointReader::rows(const std::string& name, const ChunkRows& rows, int components, std::span<double> values) {
  read_rows(name, rows, components, values);
}
void CheckpointReader::rows(const std::string& name, const ChunkRows& rows, int components,
                            std::span<std::int64_t> values) {
  read_rows(name, rows, components, values);
}

CheckpointHeader read_checkpoint_header(const std::string& path) {
  check_seal(path);
  CheckpointHeader header;
  read_or_refuse(path, [&] { header = read_header(open_hdf5(path).get(), find_file_bytes(path), path); });
  return header;
}

bool is_checkpoint(const std::string& path) {
  const hdf5::QuietErrors quiet;
  try {
    return H5Lexists(open_hdf5(path).get(), names::header, H5P_DEFAULT) > 0;
  } catch (const hdf5::Error&) {
    return false;
  }
}

std::string describe_checkpoint(const std::string& path) {
  const CheckpointHeader header = read_checkpoint_header(path);
  std::string text = fmt::format("{}: checkpoint of a percuss run, whole and undamaged, {:.4g} MB\n", path,
                                 static_cast<double>(find_file_bytes(path)) * 1e-6);
  if (!header.title.empty()) text += fmt::format("title:   {}\n", header.title);
  text += fmt::format("state:   t = {:.6g}, step {}\n", header.time, header.step);
  text += fmt::format("mesh:    {} elements, {} nodes, hash {}\n", header.elements, header.nodes, header.mesh);
  text += fmt::format("written: {} by percuss {}, {} precision\n", header.written, header.version, header.precision);
  return text + "go on:   percuss run DECK --restart " + path + "\n";
}

}  // namespace percuss
