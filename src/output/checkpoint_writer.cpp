#include <fmt/format.h>
#include <unistd.h>

#include <array>
#include <bit>
#include <cerrno>
#include <cstdio>
#include <numeric>

#include "comm/exact_reduction.hpp"
#include "src/output/atomic_file.hpp"
#include "src/output/checkpoint_file.hpp"
#include "src/output/checkpoint_names.hpp"
#include "src/output/first_rank.hpp"
#include "src/output/hdf5_file.hpp"
#include "src/output/sealed_file.hpp"

namespace percuss {
namespace {

namespace names = checkpoint_names;
using hdf5::check;

// More than a dataset's header, a group and its index take; the file gives back what is left.
constexpr std::uint64_t metadata_bytes = std::uint64_t{64} << 10;

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

// The older checkpoint gets a second name, so that there is one under the first name at any time; where the file system
// has no second names, it is renamed.
void keep_as_previous(const std::string& path) {
  if (::access(path.c_str(), F_OK) != 0) return;
  const std::string previous = find_previous_checkpoint(path), link = previous + ".tmp";
  ::unlink(link.c_str());
  const bool linked = ::link(path.c_str(), link.c_str()) == 0;
  if (std::rename(linked ? link.c_str() : path.c_str(), previous.c_str()) != 0)
    throw make_io_error("write", previous, errno);
}

}  // namespace

std::string find_previous_checkpoint(const std::string& path) {
  const auto dot = path.rfind(".h5");
  return (dot == std::string::npos ? path : path.substr(0, dot)) + "_previous.h5";
}

CheckpointWriter::CheckpointWriter(const std::string& path, const CheckpointHeader& header, const ChunkedMesh& mesh,
                                   const Communicator& ranks)
    : path_(path), temporary_(path + ".tmp"), ranks_(ranks), blocks_(ranks, mesh), mesh_(mesh) {
  if (ranks.size() > 1) transfer_ = hdf5::create_collective_transfer();
  run_or_abandon([&] { create(header); });
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
    const std::string message = fmt::format("cannot write '{}' ({}; while HDF5 was to {}){}", path_, error.reason,
                                            error.what(), suggest_for_errno(error.error_number));
    if (ranks_.size() > 1) hdf5::end_all_ranks(ranks_, message);
    abandon();
    throw SystemError(message);
  } catch (const SystemError&) {  // agreed on by all ranks
    abandon();
    throw;
  }
}

void CheckpointWriter::abandon() {
  hdf5::turn_to_memory(file_, ranks_);
  hdf5::close_abandoned(file_, flushing_ ? hdf5::Failure::in_a_flush : hdf5::Failure::elsewhere);
  if (ranks_.rank() == 0) ::unlink(temporary_.c_str());
}

void CheckpointWriter::create(const CheckpointHeader& header) {
  file_ = hdf5::create_durable_file(temporary_, ranks_);
  run_on_first_rank(ranks_, [&] { disk_ = DiskReservation(temporary_); });
  make_groups(names::header);
  write_header(header);
}

void CheckpointWriter::write_header(const CheckpointHeader& header) {
  reserve(2 * metadata_bytes + header.deck.size() + header.warnings.size());
  const hdf5::Handle group(check(H5Gopen2(file_.get(), names::header, H5P_DEFAULT), "open group"), H5Gclose);
  const auto number = [&](const char* name, std::int64_t value) {
    hdf5::write_attribute(group.get(), name, std::array<std::int64_t, 1>{value});
  };
  const auto text = [&](const char* name, const std::string& value) {
    hdf5::write_attribute(group.get(), name, value);
  };
  number("format", names::format);
  number("elements", header.elements);
  number("nodes", header.nodes);
  number("step", header.step);
  number("time_bits", std::bit_cast<std::int64_t>(header.time));
  text("version", header.version);
  text("precision", header.precision);
  text("title", header.title.substr(0, 1000));
  text("mesh", header.mesh);
  text("written", header.written);
  const auto long_text = [&](const char* name, const std::string& value) {
    const auto* bytes = reinterpret_cast<const std::uint8_t*>(value.data());
    write_once<std::uint8_t>(std::string(names::header) + "/" + name, {bytes, value.size()});
  };
  long_text(names::deck, header.deck);
  long_text(names::warnings, header.warnings);
  trim();
}

/// The groups of a path, each within the one before it.
void CheckpointWriter::make_groups(const std::string& path) {
  for (std::size_t end = 0; end != std::string::npos;) {
    end = path.find('/', end + 1);
    const std::string group = path.substr(0, end);
    if (groups_.insert(group).second) hdf5::create_group(file_.get(), group);
  }
}

/// Rank 0 writes values that all have.
template <class T>
void CheckpointWriter::write_once(const std::string& name, std::span<const T> values) {
  const bool first = ranks_.rank() == 0;
  const hsize_t count = values.size();
  const hdf5::RowBlock block{count, first ? 0 : count, first ? count : 0, transfer_ ? transfer_.get() : H5P_DEFAULT};
  const hid_t file_type = sizeof(T) == 1 ? H5T_STD_U8LE : H5T_STD_I64LE;
  hdf5::write_dataset(file_.get(), name, file_type, block, hdf5::memory_type<T>(), values.data());
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
  run_or_abandon([&] {
    const std::string path = std::string(names::state) + "/" + name;
    reserve(metadata_bytes + block.all * sizeof(T));
    make_groups(path.substr(0, path.rfind('/')));
    const hid_t file_type = std::is_same_v<T, double> ? H5T_IEEE_F64LE : H5T_STD_I64LE;
    hdf5::write_dataset(file_.get(), path, file_type, block, hdf5::memory_type<T>(), written.data());
    trim();
  });
}

void CheckpointWriter::rows(const std::string& name, const ChunkRows& rows, int components, std::span<double> values) {
  write_rows<double>(name, rows, components, values);
}
void CheckpointWriter::rows(const std::string& name, const ChunkRows& rows, int components,
                            std::span<std::int64_t> values) {
  write_rows<std::int64_t>(name, rows, components, values);
}

void CheckpointWriter::number(const std::string& name, double& value) {
  number_names_.push_back(name);
  numbers_.push_back(std::bit_cast<std::int64_t>(value));
}
void CheckpointWriter::number(const std::string& name, std::int64_t& value) {
  number_names_.push_back(name);
  numbers_.push_back(value);
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
    const bool first = ranks_.rank() == 0;
    const hsize_t count = values.size();
    hdf5::write_texts(file_.get(), group + name, values,
                      {count, first ? 0 : count, first ? count : 0, transfer_ ? transfer_.get() : H5P_DEFAULT});
  };
  std::uint64_t longest = 1;
  for (const auto* list : {&number_names_, &sum_names_}) {
    for (const std::string& name : *list) longest = std::max<std::uint64_t>(longest, name.size());
  }
  reserve(4 * metadata_bytes + 8 * (numbers_.size() + sums_.size()) +
          longest * (number_names_.size() + sum_names_.size()));
  texts(names::number_names, number_names_);
  write_once<std::int64_t>(group + names::numbers, numbers_);
  texts(names::sum_names, sum_names_);
  write_once<std::int64_t>(group + names::sums, sums_);
  trim();
}

// As in VtkhdfFile: HDF5 does not tell how long a file is that several ranks write, but a flush cuts it to its data.
void CheckpointWriter::reserve(std::uint64_t bytes) {
  run_on_first_rank(ranks_, [&] { disk_.reserve(disk_.size(), bytes); });
}

void CheckpointWriter::trim() {
  flushing_ = true;
  check(H5Fflush(file_.get(), H5F_SCOPE_GLOBAL), "flush the file");
  flushing_ = false;
  if (ranks_.size() > 1) {
    run_on_first_rank(ranks_, [&] { disk_.trim_if_unused(); });
    return;
  }
  hsize_t bytes = 0;
  check(H5Fget_filesize(file_.get(), &bytes), "ask for the size of the file");
  disk_.trim(bytes);
}

void CheckpointWriter::finish() {
  run_or_abandon([&] {
    write_numbers();
    check(file_.reset(), "close the file");
  });
  try {
    seal_file(ranks_, temporary_);
    run_on_first_rank(ranks_, [&] {
      keep_as_previous(path_);
      if (std::rename(temporary_.c_str(), path_.c_str()) != 0) throw make_io_error("write", path_, errno);
      sync_folder_of(path_);
    });
  } catch (const std::exception&) {
    if (ranks_.rank() == 0) ::unlink(temporary_.c_str());
    throw;
  }
}

}  // namespace percuss
