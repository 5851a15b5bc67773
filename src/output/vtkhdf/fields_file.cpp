#include "src/output/vtkhdf/fields_file.hpp"

#include <fmt/format.h>

#include <stdexcept>

#include "comm/agreement.hpp"
#include "comm/all_reduce.hpp"
#include "src/hdf5/hdf5_handle.hpp"
#include "src/output/files/atomic_file.hpp"
#include "src/output/files/first_rank.hpp"
#include "src/output/frame/earlier_results.hpp"
#include "src/output/frame/field_units.hpp"
#include "src/output/vtkhdf/vtkhdf_file.hpp"
#include "src/output/vtkhdf/xdmf_text.hpp"

namespace percuss {
namespace {

XdmfIndex make_index(const ChunkedMesh& chunked, const FieldsOptions& options, const Communicator& ranks) {
  XdmfIndex index;
  index.file = vtkhdf_frames.name_file(options.name);
  index.title = options.title;
  index.units = options.units;
  index.walls = options.walls;
  for (const auto& part : chunked.mesh.parts) index.parts.push_back(part.name);
  index.extents = find_part_extents(chunked, ranks);
  index.mesh = join_extents(index.extents);
  return index;
}

// The index by parts has a text for every part and frame. It is replaced when the frames are this share more than it
// has, so that all that is written of it in a run is some ten times its length.
constexpr std::size_t frames_per_new_one = 16;

}  // namespace

struct FieldsFile::Impl {
  Impl(const std::string& directory, const ChunkedMesh& chunked, const FieldsOptions& options,
       const Communicator& all_ranks)
      : ranks(all_ranks),
        xdmf_path(directory + "/" + name_fields(options.name) + ".xdmf"),
        parts_path(xdmf_path + "2"),
        fields(chunked.mesh),
        precision(options.precision),
        index(make_index(chunked, options, all_ranks)),
        file(directory + "/" + vtkhdf_frames.name_file(options.name), chunked, options, all_ranks) {
    write_index();
    write_parts_index();
  }

  Impl(const std::string& directory, const ChunkedMesh& chunked, const FieldsOptions& options,
       const Communicator& all_ranks, std::vector<double> times)
      : ranks(all_ranks),
        xdmf_path(directory + "/" + name_fields(options.name) + ".xdmf"),
        parts_path(xdmf_path + "2"),
        fields(chunked.mesh),
        precision(options.precision),
        index(make_index(chunked, options, all_ranks)),
        file(directory + "/" + vtkhdf_frames.name_file(options.name), chunked, options, all_ranks,
             static_cast<std::int64_t>(times.size())) {
    index.times = std::move(times);
  }

  void write_index() const;
  void write_parts_index();
  void write_parts_index_if_due();
  void remember_fields(std::span<const FieldData> written);

  Communicator ranks;
  std::string xdmf_path, parts_path;
  FrameFields fields;
  FieldPrecision precision;
  XdmfIndex index;
  std::size_t frames_in_parts_index = 0;
  VtkhdfFile file;
};

// Rank 0 writes the text for all.
void FieldsFile::Impl::write_index() const {
  run_on_first_rank(ranks, [&] { write_file_atomically(xdmf_path, make_xdmf_text(index), Durability::system); });
}

void FieldsFile::Impl::write_parts_index() {
  run_on_first_rank(ranks,
                    [&] { write_file_atomically(parts_path, make_xdmf_text_by_parts(index), Durability::system); });
  frames_in_parts_index = index.times.size();
}

void FieldsFile::Impl::write_parts_index_if_due() {
  const std::size_t frames = index.times.size();
  if (frames - frames_in_parts_index > frames_in_parts_index / frames_per_new_one) write_parts_index();
}

void FieldsFile::Impl::remember_fields(std::span<const FieldData> written) {
  const int bytes = precision == FieldPrecision::float32 ? 4 : 8;
  index.fields.clear();
  for (const auto& field : written)
    index.fields.push_back({field.name, field.place, field.components, field.number == FieldNumber::byte ? 1 : bytes,
                            name_field_unit(field.name, index.units)});
}

FieldsFile::FieldsFile(const std::string& directory, const ChunkedMesh& chunked, const FieldsOptions& options,
                       const Communicator& ranks) {
  const hdf5::QuietErrors quiet;
  impl_ = std::make_unique<Impl>(directory, chunked, options, ranks);
}

FieldsFile::FieldsFile(const std::string& directory, const ChunkedMesh& chunked, const FieldsOptions& options,
                       const Communicator& ranks, std::int64_t frames, std::span<const std::string> fields) {
  const hdf5::QuietErrors quiet;
  const FramesInFile kept = find_kept(chunked, frames);
  const std::string path = directory + "/" + vtkhdf_frames.name_file(options.name);
  std::vector<double> times;
  run_on_first_rank(ranks, [&] {
    times = check_earlier_results(vtkhdf_frames, path, kept, fields);
    cut_earlier_results(vtkhdf_frames, path, kept);
  });
  broadcast_values(ranks, times, 0);
  impl_ = std::make_unique<Impl>(directory, chunked, options, ranks, std::move(times));
}

void FieldsFile::sync() {
  if (!impl_) return;
  const hdf5::QuietErrors quiet;
  impl_->file.sync();
}

FieldsFile::~FieldsFile() {
  const hdf5::QuietErrors quiet;
  impl_.reset();
}

void FieldsFile::write_frame(double time, long step, std::span<const double> positions,
                             std::span<const FieldData> fields, std::span<const double> wall_displacements) {
  if (!impl_) throw std::logic_error("a frame is written to a closed fields file");
  const hdf5::QuietErrors quiet;
  const auto all = impl_->fields.complete(positions, fields);
  impl_->file.append_frame(time, step, positions, all, wall_displacements);
  impl_->remember_fields(all);
  impl_->index.times.push_back(time);
  impl_->write_index();
  impl_->write_parts_index_if_due();
}

void FieldsFile::close() {
  if (!impl_) return;
  const hdf5::QuietErrors quiet;
  const auto impl = std::move(impl_);
  impl->file.close();
  const bool has_written = !impl->index.fields.empty();  // else it continues with a file and has added nothing
  if (has_written && impl->frames_in_parts_index < impl->index.times.size()) impl->write_parts_index();
}

bool FieldsFile::is_in_place() const { return !impl_ || impl_->file.is_in_place(); }

}  // namespace percuss
