#include <fmt/format.h>
#include <unistd.h>

#include <array>
#include <bit>
#include <cerrno>
#include <numeric>
#include <stdexcept>

#include "comm/exact_reduction.hpp"
#include "src/output/checkpoint/checkpoint_file.hpp"
#include "src/output/checkpoint/checkpoint_names.hpp"
#include "src/output/checkpoint/checkpoint_place.hpp"
#include "src/output/checkpoint/sealed_file.hpp"
#include "src/output/files/atomic_file.hpp"
#include "src/output/files/first_rank.hpp"
#include "src/output/hdf5/hdf5_file.hpp"

namespace percuss {
namespace {

namespace names = checkpoint_names;
using hdf5::check;

// More than a dataset's header, a group and its index take; the file gives back what is left.
constexpr std::uint64_t metadata_bytes = std::uint64_t{64} << 10;
constexpr std::size_t longest_title = 1000;  // bytes

/// [local rows][components] in the order of the chunks.
template <class T>
std::vector<T> put_in_order(const ChunkRows& rows, int components, std::span<const T> values) {
  const auto width = static_cast<std::size_t>(components);
  std::vector<T> ordered(rows.places.size() * width);
  for (std::size_t i = 0; i < rows.places.size(); ++i) {
    const T* row = &values[static_cast<std::size_t>(rows.places[i]) * width];
    std::copy_n(row, width, ordered.begin() + static_cast<std::ptrdiff_t>(i * width));
  }
  return ordered;
}

}  // namespace

CheckpointWriter::CheckpointWriter(const std::string& path, const CheckpointHeader& header, const ChunkedMesh& mesh,
                                   const Communicator& ranks)
    : path_(path), temporary_(path + ".tmp"), header_(header), ranks_(ranks), blocks_(ranks, mesh), mesh_(mesh) {
  header_.title = header.title.substr(0, longest_title);
  if (ranks.size() > 1) transfer_ = hdf5::create_collective_transfer();
  run_or_abandon([&] { create(); });
}

void CheckpointWriter::refuse_value(const std::string& name) const {
  throw std::logic_error(fmt::format("a checkpoint refuses a value of {} that it only writes", name));
}

CheckpointWriter::~CheckpointWriter() {
  if (!file_) return;
  const hdf5::QuietErrors quiet;
  abandon();
}

// Does the work; if that fails, nothing is left of the file.
template <class Work>
void CheckpointWriter::run_or_abandon(Work&& work) {
  const hdf5::QuietErrors quiet;
  try {
    work();
  } catch (const hdf5::Error& error) {
    if (ranks_.size() > 1) hdf5::end_all_ranks(ranks_, make_message(error));
    abandon();
    throw SystemError(make_message(error));
  } catch (const SystemError&) {  // agreed on by all ranks
    abandon();
    throw;
  } catch (const std::exception& error) {
    // To give up a file that several ranks write takes all of them, and this rank may be the only one here.
    if (ranks_.size() > 1) hdf5::end_all_ranks(ranks_, fmt::format("cannot write '{}' ({})", path_, error.what()));
    abandon();
    throw;
  }
}

std::string CheckpointWriter::make_message(const hdf5::Error& error) const {
  return fmt::format("cannot write '{}' ({}; while HDF5 was to {}){}", path_, error.reason, error.what(),
                     suggest_for_errno(error.error_number));
}

void CheckpointWriter::abandon() {
  hdf5::turn_away(file_, ranks_);
  file_.release();
  remove_temporary();
}

// Its room on the disk is given back at once, though HDF5 keeps it open. What stands at its name by now may be another
// file, or a link to one.
void CheckpointWriter::remove_temporary() const {
  if (ranks_.rank() != 0) return;
  disk_.release();
  ::unlink(temporary_.c_str());
}

void CheckpointWriter::create() {
  file_ = hdf5::create_durable_file(temporary_, ranks_);
  run_on_first_rank(ranks_, [&] { disk_ = DiskReservation(temporary_); });
  make_groups(names::header);
  write_header();
}

void CheckpointWriter::write_header() {
  reserve(2 * metadata_bytes + header_.deck.size() + header_.values.size() + header_.pieces.size() +
          header_.warnings.size());
  const hdf5::Handle group(check(H5Gopen2(file_.get(), names::header, H5P_DEFAULT), "open group"), H5Gclose);
  const auto number = [&](const char* name, std::int64_t value) {
    hdf5::write_attribute(group.get(), name, std::array<std::int64_t, 1>{value});
  };
  const auto text = [&](const char* name, const std::string& value) {
    hdf5::write_attribute(group.get(), name, value);
  };
  number("format", names::format);
  number("elements", header_.elements);
  number("nodes", header_.nodes);
  number("step", header_.step);
  number("time_bits", std::bit_cast<std::int64_t>(header_.time));
  text("version", header_.version);
  text("precision", header_.precision);
  text("title", header_.title);
  text("mesh", header_.mesh);
  text("written", header_.written);
  text(names::earlier, header_.earlier);
  const auto long_text = [&](const char* name, const std::string& value) {
    const auto* bytes = reinterpret_cast<const std::uint8_t*>(value.data());
    write_once<std::uint8_t>(std::string(names::header) + "/" + name, {bytes, value.size()});
  };
  long_text(names::deck, header_.deck);
  long_text(names::values, header_.values);
  long_text(names::pieces, header_.pieces);
  long_text(names::warnings, header_.warnings);
}

/// The groups of a path, each within the one before it.
void CheckpointWriter::make_groups(const std::string& path) {
  for (std::size_t end = 0; end != std::string::npos;) {
    end = path.find('/', end + 1);
    const std::string group = path.substr(0, end);
    if (groups_.insert(group).second) hdf5::create_group(file_.get(), group);
  }
}

hdf5::RowBlock CheckpointWriter::make_block_of_first_rank(hsize_t count) {
  const bool first = ranks_.rank() == 0;
  return {count, first ? 0 : count, first ? count : 0, transfer_ ? transfer_.get() : H5P_DEFAULT, &record_};
}

/// Rank 0 writes values that all have.
template <class T>
void CheckpointWriter::write_once(const std::string& name, std::span<const T> values) {
  const hid_t file_type = sizeof(T) == 1 ? H5T_STD_U8LE : H5T_STD_I64LE;
  hdf5::write_dataset(file_.get(), name, file_type, make_block_of_first_rank(values.size()), hdf5::memory_type<T>(),
                      values.data());
}

template <class T>
void CheckpointWriter::write_rows(const std::string& name, const ChunkRows& rows, int components,
                                  std::span<const T> values) {
  const std::vector<std::int64_t> first = find_first_rows(ranks_, mesh_, rows.counts);
  const std::vector<T> ordered = rows.places.empty() ? std::vector<T>() : put_in_order(rows, components, values);
  const auto own_rows = std::accumulate(rows.counts.begin(), rows.counts.end(), std::int64_t{0});
  const std::span<const T> own = rows.places.empty() ? values : ordered;
  const std::vector<T> written =
      blocks_.gather(first, components, own.first(static_cast<std::size_t>(own_rows * components)));
  hdf5::RowBlock block = blocks_.block(first, components);
  if (transfer_) block.transfer = transfer_.get();
  block.record = &record_;
  run_or_abandon([&] {
    const std::string path = std::string(names::state) + "/" + name;
    reserve(metadata_bytes + block.all * sizeof(T));
    make_groups(path.substr(0, path.rfind('/')));
    const hid_t file_type = std::is_same_v<T, double> ? H5T_IEEE_F64LE : H5T_STD_I64LE;
    hdf5::write_dataset(file_.get(), path, file_type, block, hdf5::memory_type<T>(), written.data());
  });
}

void CheckpointWriter::rows(const std::string& name, const ChunkRows& rows, int components, std::span<double> values) {
  write_rows<double>(name, rows, components, values);
}
void CheckpointWriter::rows(const std::string& name, const ChunkRows& rows, int components,
                            std::span<std::int64_t> values) {
  write_rows<std::int64_t>(name, rows, components, values);
}

void CheckpointWriter::words(const std::string& name, std::span<std::int64_t> values) {
  number_names_.push_back(name);
  number_counts_.push_back(static_cast<std::int64_t>(values.size()));
  numbers_.insert(numbers_.end(), values.begin(), values.end());
}

void CheckpointWriter::sum(const std::string& name, ExactSum& value) {
  ExactSum total = value;
  sum_over_ranks(ranks_, std::span(&total, 1));
  sum_names_.push_back(name);
  sums_.insert(sums_.end(), total.limb, total.limb + ExactSum::limb_count);
  sums_.push_back(total.not_finite);
}

void CheckpointWriter::write_numbers() {
  const std::string group = std::string(names::header) + "/";
  const auto texts = [&](const char* name, const std::vector<std::string>& values) {
    hdf5::write_texts(file_.get(), group + name, values, make_block_of_first_rank(values.size()));
  };
  std::uint64_t longest = 1;
  for (const auto* list : {&number_names_, &sum_names_}) {
    for (const std::string& name : *list) longest = std::max<std::uint64_t>(longest, name.size());
  }
  reserve(5 * metadata_bytes + 8 * (number_counts_.size() + numbers_.size() + sums_.size()) +
          longest * (number_names_.size() + sum_names_.size()));
  texts(names::number_names, number_names_);
  write_once<std::int64_t>(group + names::number_counts, number_counts_);
  write_once<std::int64_t>(group + names::numbers, numbers_);
  texts(names::sum_names, sum_names_);
  write_once<std::int64_t>(group + names::sums, sums_);
  const hdf5::Handle header(check(H5Gopen2(file_.get(), names::header, H5P_DEFAULT), "open group"), H5Gclose);
  header_.content = fmt::format("{:016x}", record_.find_content(ranks_));
  hdf5::write_attribute(header.get(), names::content, header_.content);
  trim();
}

// Behind all that was reserved before: what is too much goes in trim().
void CheckpointWriter::reserve(std::uint64_t bytes) {
  run_on_first_rank(ranks_, [&] { disk_.reserve(static_cast<std::uint64_t>(disk_.file().size()), bytes); });
}

// As in VtkhdfFile: HDF5 does not tell how long a file is that several ranks write, but a flush cuts it to its data.
// Once, at the end: a flush takes a dozen messages between ranks, and whoever stops a run may not wait for them.
void CheckpointWriter::trim() {
  check(H5Fflush(file_.get(), H5F_SCOPE_GLOBAL), "flush the file");
  if (ranks_.size() > 1) {
    run_on_first_rank(ranks_, [&] { disk_.trim_if_unused(); });
    return;
  }
  hsize_t bytes = 0;
  check(H5Fget_filesize(file_.get(), &bytes), "ask for the size of the file");
  disk_.trim(bytes);
}

/// Checks that a restart would read the state in memory.
void CheckpointWriter::compare() const {
  const hdf5::QuietErrors quiet;
  ranks_.barrier();  // all have closed it
  fail_together(ranks_, [&] {
    try {
      record_.compare(hdf5::open_to_compare(temporary_).get());
      if (ranks_.rank() == 0 && read_unsealed_header(temporary_) != header_)
        throw hdf5::Error("read back the header", "it is not what was written");
    } catch (const hdf5::Error& error) {
      throw SystemError(make_message(error));
    } catch (const InputError& error) {  // what was just written is no input
      throw SystemError(
          fmt::format("cannot write '{}' (it cannot be read back: {}){}", path_, error.what(), suggest_for_errno(EIO)));
    }
  });
}

void CheckpointWriter::finish(const std::string& known_whole) {
  run_or_abandon([&] {
    write_numbers();
    check(file_.reset(), "close the file");
  });
  try {
    compare();
    seal_file(ranks_, temporary_);
    run_on_first_rank(ranks_, [&] {
      disk_.file().check_place();
      replace_checkpoint(temporary_, path_, known_whole);
    });
  } catch (const std::exception&) {
    remove_temporary();
    throw;
  }
}

}  // namespace percuss
