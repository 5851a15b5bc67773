#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <bit>
#include <cerrno>
#include <cmath>
#include <type_traits>

#include "src/fail_together.hpp"
#include "src/hdf5/hdf5_structure.hpp"
#include "src/mesh/formats/exodus/trial_process.hpp"
#include "src/output/checkpoint/checkpoint_file.hpp"
#include "src/output/checkpoint/checkpoint_names.hpp"
#include "src/output/checkpoint/sealed_file.hpp"
#include "src/output/files/atomic_file.hpp"
#include "src/output/hdf5/hdf5_reading.hpp"
#include "src/output/hdf5/write_record.hpp"
#include "src/regular_file.hpp"

namespace percuss {
namespace {

namespace names = checkpoint_names;
using hdf5::check;

constexpr int words_per_sum = ExactSum::limb_count + 1;
constexpr const char* other_number_of_names = "the checkpoint has another number of values than of names";

[[noreturn]] void refuse(const std::string& path, const std::string& problem) {
  throw InputError(fmt::format("{}: error: {}", path, problem));
}

std::string describe_missing(const std::string& name) {
  return fmt::format("the checkpoint has no {} (this scene needs one): continue with the deck that wrote it", name);
}

std::string describe_other_count(const std::string& name, std::size_t held, std::size_t expected) {
  return fmt::format("{} has {} values in the checkpoint (this scene has {}): continue with the deck that wrote it",
                     name, held, expected);
}

std::uint64_t find_file_bytes(const std::string& path) {
  const int descriptor = ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
  if (descriptor < 0) throw make_io_error("read", path, errno);
  const off_t size = ::lseek(descriptor, 0, SEEK_END);
  ::close(descriptor);
  return static_cast<std::uint64_t>(size);
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

[[noreturn]] void refuse_value_of(const std::string& path, const std::string& name) {
  refuse(path, fmt::format("the checkpoint has a value of {} that is impossible (it is damaged, or another program has "
                           "changed it): continue from another checkpoint",
                           name));
}

void check_structure(const std::string& path) {
  try {
    hdf5::check_structure(path, hdf5::ExternalFiles::allow);  // app/external_files.hpp refuses them
  } catch (const InputError& error) {
    refuse(path, error.what());
  }
}

void check_source(const std::string& path) {
  if (const std::string kind = describe_irregular_file(path); !kind.empty()) refuse(path, "the checkpoint is " + kind);
}

CheckpointHeader read_header(hid_t file, std::uint64_t bytes, const std::string& path) {
  const hdf5::Handle group = hdf5::open_group(file, names::header);
  const auto number = [&](const char* name) { return hdf5::read_whole_number(group.get(), name); };
  const auto text = [&](const char* name) { return hdf5::read_text(group.get(), name); };
  if (number("format") != names::format) {
    refuse(path,
           fmt::format("the checkpoint has format {} (percuss {} writes and reads format {}): continue with percuss {}",
                       number("format"), PERCUSS_VERSION, names::format, text("version")));
  }
  CheckpointHeader header;
  header.version = text("version");
  header.precision = text("precision");
  header.title = text("title");
  header.mesh = text("mesh");
  header.written = text("written");
  if (check(H5Aexists(group.get(), names::content), "look for the hash of the content") > 0)
    header.content = text(names::content);
  if (check(H5Aexists(group.get(), names::earlier), "look for the cost of earlier runs") > 0)
    header.earlier = text(names::earlier);
  header.elements = number("elements");
  header.nodes = number("nodes");
  header.step = number("step");
  header.time = std::bit_cast<double>(number("time_bits"));
  if (!std::isfinite(header.time)) refuse_value_of(path, "time");
  const auto long_text = [&](const char* name) {
    const auto length = hdf5::read_shape(group.get(), name).rows;
    const auto text_bytes = hdf5::read_rows<std::uint8_t>(group.get(), name, 0, length, bytes);
    return std::string(text_bytes.begin(), text_bytes.end());
  };
  header.deck = long_text(names::deck);
  header.values = long_text(names::values);
  header.pieces = long_text(names::pieces);
  header.warnings = long_text(names::warnings);
  return header;
}

/// Reads all that the file holds; its hash must be the one that the writer found in memory.
void check_content(const CheckpointHeader& header, hid_t file, std::uint64_t bytes, const std::string& path) {
  const std::uint64_t found = hdf5::find_content(hdf5::open_group(file, "/").get(), bytes);
  if (!header.content.empty() && header.content != fmt::format("{:016x}", found))
    refuse(path, "the checkpoint is damaged (its content is not the state that was saved): use an older one");
}

}  // namespace

CheckpointReader::CheckpointReader(const std::string& path, const ChunkedMesh& mesh, const Communicator& ranks)
    : path_(path), ranks_(ranks), mesh_(mesh) {
  fail_together(ranks, [&] { check_source(path); });
  check_seal(ranks, path);
  // A seal is no signature: what it fits may still be more than HDF5 can take.
  fail_together(ranks, [&] {
    const auto read = [&] {
      load();
      check_content(header_, file_.get(), file_bytes_, path_);
    };
    if (ranks.rank() == 0) rehearse(path_, find_file_bytes(path_), read);
  });
  fail_together(ranks, [&] {
    read_or_refuse(path_, [&] {
      load();
      if (ranks.rank() == 0) check_content(header_, file_.get(), file_bytes_, path_);
    });
  });
}

/// The header, the numbers and the sums.
void CheckpointReader::load() {
  check_structure(path_);
  file_bytes_ = find_file_bytes(path_);
  file_ = hdf5::open_unlocked(path_, H5F_ACC_RDONLY);
  header_ = read_header(file_.get(), file_bytes_, path_);
  const hdf5::Handle group = hdf5::open_group(file_.get(), names::header);
  const auto integers = [&](const char* name) {
    return hdf5::read_rows<std::int64_t>(group.get(), name, 0, hdf5::read_shape(group.get(), name).rows, file_bytes_);
  };
  const auto number_names = hdf5::read_texts(group.get(), names::number_names);
  const auto sum_names = hdf5::read_texts(group.get(), names::sum_names);
  numbers_ = integers(names::numbers);
  sums_ = integers(names::sums);
  place_numbers(number_names, integers(names::number_counts));
  if (sums_.size() != words_per_sum * sum_names.size()) refuse(path_, other_number_of_names);
  for (std::size_t i = 0; i < sum_names.size(); ++i) sum_places_[sum_names[i]] = words_per_sum * i;
}

void CheckpointReader::place_numbers(const std::vector<std::string>& names, const std::vector<std::int64_t>& counts) {
  if (names.size() != counts.size()) refuse(path_, other_number_of_names);
  number_places_.clear();
  std::size_t first = 0;
  for (std::size_t i = 0; i < names.size(); ++i) {
    const std::size_t left = numbers_.size() - first;
    if (counts[i] < 0 || static_cast<std::uint64_t>(counts[i]) > left) refuse(path_, other_number_of_names);
    number_places_[names[i]] = {first, static_cast<std::size_t>(counts[i])};
    first += static_cast<std::size_t>(counts[i]);
  }
  if (first != numbers_.size()) refuse(path_, other_number_of_names);
}

void CheckpointReader::words(const std::string& name, std::span<std::int64_t> values) {
  const auto found = number_places_.find(name);
  if (found == number_places_.end()) refuse(path_, describe_missing(name));
  const Place& place = found->second;
  if (place.count != values.size()) refuse(path_, describe_other_count(name, place.count, values.size()));
  std::copy_n(numbers_.begin() + static_cast<std::ptrdiff_t>(place.first), place.count, values.begin());
}

void CheckpointReader::sum(const std::string& name, ExactSum& value) {
  const auto found = sum_places_.find(name);
  if (found == sum_places_.end()) refuse(path_, describe_missing(name));
  const std::int64_t* words = &sums_[found->second];
  std::copy_n(words, ExactSum::limb_count, value.limb);
  value.not_finite = words[ExactSum::limb_count];
  if (!std::isfinite(value.round())) refuse_value(name);
  if (ranks_.rank() != 0) value = {};
}

void CheckpointReader::refuse_value(const std::string& name) const { refuse_value_of(path_, name); }

void CheckpointReader::expect_rows(const std::string& name, std::span<const std::int64_t> counts, int components) {
  // Larger ones could only add up to what the file has by an overflow.
  const auto most = static_cast<std::int64_t>(file_bytes_);
  fail_together(ranks_, [&] {
    if (std::any_of(counts.begin(), counts.end(), [&](std::int64_t n) { return n < 0 || n > most; }))
      refuse_value(name);
  });
  const std::int64_t all = find_first_rows(ranks_, mesh_, counts).back();
  fail_together(ranks_, [&] { read_or_refuse(path_, [&] { check_length(name, all, components); }); });
}

/// Refuses an array of the state that does not have so many rows.
void CheckpointReader::check_length(const std::string& name, std::int64_t rows, int components) const {
  const hdf5::Handle group = hdf5::open_group(file_.get(), names::state);
  const hdf5::Shape shape = hdf5::read_shape(group.get(), name);
  const hsize_t expected = static_cast<hsize_t>(rows) * static_cast<hsize_t>(components);
  if (shape.rows == expected && shape.components == 1) return;
  refuse(path_, describe_other_count(name, shape.rows, expected));
}

/// The rows of this rank's chunks: a read for each run of chunks that follow each other.
template <class T>
void CheckpointReader::read_runs(const std::string& name, const std::vector<std::int64_t>& first, int components,
                                 std::vector<T>& into) const {
  check_length(name, first.back(), components);
  const hdf5::Handle group = hdf5::open_group(file_.get(), names::state);
  const auto width = static_cast<hsize_t>(components);
  const auto start = [&](int chunk) { return static_cast<hsize_t>(first[static_cast<std::size_t>(chunk)]) * width; };
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
    if constexpr (std::is_floating_point_v<T>) {
      if (!std::all_of(read.begin(), read.end(), [](double value) { return std::isfinite(value); })) refuse_value(name);
    }
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

CheckpointHeader read_unsealed_header(const std::string& path) {
  CheckpointHeader header;
  read_or_refuse(path, [&] {
    header = read_header(hdf5::open_unlocked(path, H5F_ACC_RDONLY).get(), find_file_bytes(path), path);
  });
  return header;
}

CheckpointHeader read_checkpoint_header(const std::string& path) {
  check_source(path);
  check_seal(path);
  const std::uint64_t bytes = find_file_bytes(path);
  CheckpointHeader header;
  const auto read = [&] {
    read_or_refuse(path, [&] {
      check_structure(path);
      const hdf5::Handle file = hdf5::open_unlocked(path, H5F_ACC_RDONLY);
      header = read_header(file.get(), bytes, path);
      check_content(header, file.get(), bytes, path);
    });
  };
  rehearse(path, bytes, read);
  read();
  return header;
}

bool is_checkpoint(const std::string& path) {
  const hdf5::QuietErrors quiet;
  try {
    return H5Lexists(hdf5::open_unlocked(path, H5F_ACC_RDONLY).get(), names::header, H5P_DEFAULT) > 0;
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
  return text + "continue: percuss run DECK --restart " + path + "\n";
}

}  // namespace percuss
