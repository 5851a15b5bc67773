#include "src/output/exodus/exodus_results.hpp"

#include <fmt/format.h>

#include <array>
#include <optional>
#include <stdexcept>

#include "src/output/exodus/exodus_blocks.hpp"
#include "src/output/exodus/exodus_mesh.hpp"
#include "src/output/exodus/exodus_sets.hpp"
#include "src/output/exodus/exodus_variables.hpp"
#include "src/output/exodus/netcdf_variables.hpp"
#include "src/output/files/first_rank.hpp"
#include "src/output/frame/earlier_results.hpp"
#include "src/output/frame/field_units.hpp"
#include "src/output/hdf5/durable_file.hpp"
#include "src/output/hdf5/frame_table.hpp"

namespace percuss {
namespace {

// Most bytes of metadata that a frame adds beside the index of its tables.
constexpr std::uint64_t frame_metadata_bytes = std::uint64_t{64} << 10;

}  // namespace

struct ExodusResults::Impl {
  Impl(const std::string& path, const ChunkedMesh& chunked, const FieldsOptions& given, const Communicator& all_ranks)
      : ranks(all_ranks),
        options(given),
        blocks(list_exodus_blocks(chunked, all_ranks)),
        file(path, all_ranks,
             {hdf5::LinkOrder::by_creation, choose_chunk_index(blocks.size()), [this] { release(); },
              exodus_frames.count_frames}),
        fields(chunked.mesh),
        nodes(static_cast<std::size_t>(chunked.numbering.node_count())),
        elements(static_cast<std::size_t>(chunked.numbering.element_count())),
        node_rows(all_ranks, find_owned_nodes(chunked, all_ranks), chunked.mesh.node_numbers,
                  chunked.numbering.node_count()) {}

  NetcdfFile netcdf() { return {file.id(), dimensions}; }
  hdf5::RowBlock node_block() { return file.complete(node_rows.block()); }
  hdf5::RowBlock block_of(const ExodusBlock& block) { return file.complete(block.rows->block()); }
  void write_texts(const std::string& name, std::span<const std::string> names, std::span<const std::string> texts) {
    mesh_file().write_texts(name, names, texts);
  }
  ExodusMesh mesh_file() { return {ranks, options, blocks, sets, file, dimensions, nodes, elements, node_rows}; }

  void create(const Mesh& mesh);
  void create_steps();

  void open_steps();
  void create_variables(std::span<const FieldData> frame);
  void create_element_variables();
  void open_variables();
  std::uint64_t prepare_frame(std::span<const FieldData> frame);
  void write_frame(std::int64_t step, std::span<const FieldData> frame);
  void write_element_variables(std::span<const FieldData> frame);
  void release();

  Communicator ranks;
  FieldsOptions options;
  std::vector<ExodusBlock> blocks;
  hdf5::DurableFile file;
  FrameFields fields;
  std::size_t nodes, elements;  // of the whole mesh
  RowBlocks node_rows;
  ExodusSets sets;  // until they are written
  NetcdfDimensions dimensions;
  std::optional<hdf5::FrameTable> times, globals;
  std::vector<ExodusVariable> node_variables, element_variables;
  std::vector<hdf5::FrameTable> node_tables;     // [node variables]
  std::vector<hdf5::FrameTable> element_tables;  // [element variables][blocks]
};

void ExodusResults::Impl::release() {
  times.reset();
  globals.reset();
  node_tables.clear();
  element_tables.clear();
}

void ExodusResults::Impl::create(const Mesh& mesh) {
  sets = list_exodus_sets(mesh, blocks, options, ranks);
  const ExodusMesh writer = mesh_file();
  file.create(writer.find_bytes(), [&] {
    writer.write_header();
    create_steps();
    writer.write_mesh(mesh);
  });
  sets = {};
}

void ExodusResults::Impl::create_steps() {
  times.emplace(file.id(), "time_whole", hdf5::FrameTable::Shape{1, true, true});
  dimensions.attach(times->id(), std::array<std::string, 1>{"time_step"});
  globals.emplace(file.id(), "vals_glo_var", hdf5::FrameTable::Shape{1, false, true});
  dimensions.attach(globals->id(), std::array<std::string, 2>{"frame_rows", "num_glo_var"});
  write_texts("name_glo_var", std::array<std::string, 2>{"num_glo_var", "len_name"},
              std::array<std::string, 1>{"step"});
}

void ExodusResults::Impl::open_steps() {
  times.emplace(file.id(), "time_whole");
  globals.emplace(file.id(), "vals_glo_var");
}

void ExodusResults::Impl::create_variables(std::span<const FieldData> frame) {
  std::vector<std::string> names;
  for (const ExodusVariable& variable : node_variables) names.push_back(variable.name);
  dimensions.create(file.id(), "num_nod_var", names.size());
  write_texts("name_nod_var", std::array<std::string, 2>{"num_nod_var", "len_name"}, names);
  for (std::size_t v = 0; v < names.size(); ++v) {
    node_tables.emplace_back(file.id(), fmt::format("vals_nod_var{}", v + 1), hdf5::FrameTable::Shape{nodes});
    dimensions.attach(node_tables.back().id(), std::array<std::string, 2>{"frame_rows", "num_nodes"});
    const std::string unit = name_field_unit(frame[node_variables[v].field].name, options.units);
    if (!unit.empty()) hdf5::write_attribute(node_tables.back().id(), "units", unit);
  }
  if (!element_variables.empty()) create_element_variables();
}

void ExodusResults::Impl::create_element_variables() {
  std::vector<std::string> names;
  for (const ExodusVariable& variable : element_variables) names.push_back(variable.name);
  dimensions.create(file.id(), "num_elem_var", names.size());
  write_texts("name_elem_var", std::array<std::string, 2>{"num_elem_var", "len_name"}, names);
  const std::vector<std::int64_t> truth(blocks.size() * names.size(), 1);
  netcdf().write_integer_rows("elem_var_tab", std::array<std::string, 2>{"num_el_blk", "num_elem_var"},
                              file.block_of_first_rank(blocks.size()), truth);
  for (std::size_t v = 0; v < names.size(); ++v) {
    for (std::size_t b = 0; b < blocks.size(); ++b) {
      element_tables.emplace_back(file.id(), fmt::format("vals_elem_var{}eb{}", v + 1, b + 1),
                                  hdf5::FrameTable::Shape{static_cast<hsize_t>(blocks[b].elements)});
      dimensions.attach(element_tables.back().id(),
                        std::array<std::string, 2>{"frame_rows", name_of_block("num_el_in_blk", b)});
    }
  }
}

void ExodusResults::Impl::open_variables() {
  for (std::size_t v = 0; v < node_variables.size(); ++v)
    node_tables.emplace_back(file.id(), fmt::format("vals_nod_var{}", v + 1));
  for (std::size_t v = 0; v < element_variables.size(); ++v) {
    for (std::size_t b = 0; b < blocks.size(); ++b)
      element_tables.emplace_back(file.id(), fmt::format("vals_elem_var{}eb{}", v + 1, b + 1));
  }
}

std::uint64_t ExodusResults::Impl::prepare_frame(std::span<const FieldData> frame) {
  if (node_tables.empty()) {
    node_variables = list_exodus_variables(frame, FieldPlace::node);
    element_variables = list_exodus_variables(frame, FieldPlace::element);
    const bool is_there = hdf5::check(H5Lexists(file.id(), "name_nod_var", H5P_DEFAULT), "look for variables") > 0;
    if (is_there)
      open_variables();
    else
      create_variables(frame);
  }
  std::uint64_t bytes = frame_metadata_bytes + times->growth_bytes() + globals->growth_bytes();
  for (const auto* tables : {&node_tables, &element_tables}) {
    for (const hdf5::FrameTable& table : *tables) bytes += table.growth_bytes();
  }
  return bytes;
}

void ExodusResults::Impl::write_frame(std::int64_t step, std::span<const FieldData> frame) {
  std::vector<double> values(fields.local_nodes());
  for (std::size_t v = 0; v < node_variables.size(); ++v) {
    const FieldData& field = frame[node_variables[v].field];
    const auto width = static_cast<std::size_t>(field.components);
    const auto component = static_cast<std::size_t>(node_variables[v].component);
    for (std::size_t n = 0; n < values.size(); ++n) values[n] = field.values[n * width + component];
    node_tables[v].append(node_rows.gather(std::span<const double>(values), 1), node_block());
  }
  write_element_variables(frame);
  const auto number = static_cast<double>(step);
  globals->append(std::span<const double>(&number, 1), file.block_of_first_rank(1));
}

void ExodusResults::Impl::write_element_variables(std::span<const FieldData> frame) {
  auto table = element_tables.begin();
  for (const ExodusVariable& variable : element_variables) {
    const FieldData& field = frame[variable.field];
    for (const ExodusBlock& block : blocks) {
      const std::vector<double> own = block.pick(field.values, field.components, variable.component);
      (table++)->append(block.rows->gather(std::span<const double>(own), 1), block_of(block));
    }
  }
}

ExodusResults::ExodusResults(const std::string& directory, const ChunkedMesh& chunked, const FieldsOptions& options,
                             const Communicator& ranks) {
  const hdf5::QuietErrors quiet;
  impl_ = std::make_unique<Impl>(directory + "/" + exodus_frames.name_file(options.name), chunked, options, ranks);
  impl_->create(chunked.mesh);
}

ExodusResults::ExodusResults(const std::string& directory, const ChunkedMesh& chunked, const FieldsOptions& options,
                             const Communicator& ranks, std::int64_t frames, std::span<const std::string> fields) {
  const hdf5::QuietErrors quiet;
  const std::string path = directory + "/" + exodus_frames.name_file(options.name);
  const FramesInFile kept = find_kept(chunked, frames);
  run_on_first_rank(ranks, [&] {
    check_earlier_results(exodus_frames, path, kept, fields);
    cut_earlier_results(exodus_frames, path, kept);
  });
  impl_ = std::make_unique<Impl>(path, chunked, options, ranks);
  impl_->file.open(frames, [&] { impl_->open_steps(); });
}

ExodusResults::~ExodusResults() {
  const hdf5::QuietErrors quiet;
  impl_.reset();
}

void ExodusResults::write_frame(double time, long step, std::span<const double> positions,
                                std::span<const FieldData> fields, std::span<const double>) {
  if (!impl_) throw std::logic_error("a frame is written to a closed fields file");
  const hdf5::QuietErrors quiet;
  Impl& impl = *impl_;
  const std::vector<FieldData> frame = impl.fields.complete(positions, fields);
  impl.file.append_frame(
      {[&] { return impl.prepare_frame(frame); }, [&] { impl.write_frame(step, frame); },
       [&] { impl.times->append(std::span<const double>(&time, 1), impl.file.block_of_first_rank(1)); }});
}

void ExodusResults::sync() {
  if (!impl_) return;
  const hdf5::QuietErrors quiet;
  impl_->file.sync();
}

void ExodusResults::close() {
  if (!impl_) return;
  const hdf5::QuietErrors quiet;
  const auto impl = std::move(impl_);
  impl->file.close();
}

bool ExodusResults::is_in_place() const { return !impl_ || impl_->file.is_in_place(); }

}  // namespace percuss
