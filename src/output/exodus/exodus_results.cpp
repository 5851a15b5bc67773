#include "src/output/exodus/exodus_results.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <optional>
#include <stdexcept>

#include "src/output/earlier/earlier_results.hpp"
#include "src/output/exodus/exodus_blocks.hpp"
#include "src/output/exodus/exodus_sets.hpp"
#include "src/output/exodus/exodus_variables.hpp"
#include "src/output/exodus/netcdf_variables.hpp"
#include "src/output/fields/field_units.hpp"
#include "src/output/files/first_rank.hpp"
#include "src/output/hdf5/durable_file.hpp"
#include "src/output/hdf5/frame_table.hpp"

namespace percuss {
namespace {

// Most bytes of metadata that a frame adds beside the index of its tables, that a variable takes, and that a file
// starts with.
constexpr std::uint64_t frame_metadata_bytes = std::uint64_t{64} << 10, variable_bytes = std::uint64_t{16} << 10,
                        file_bytes = std::uint64_t{512} << 10;
// Id and coordinates; corners and id; and the dimension scales, whose numbers several ranks store.
constexpr std::uint64_t exodus_bytes_per_node = 4 * 8 + 4, exodus_bytes_per_element = 8 * 9 + 2 * 4;

constexpr std::size_t line_length = 80;    // of titles and information records
constexpr std::size_t string_length = 32;  // of QA records
constexpr std::size_t least_name_length = 64;
constexpr float format_version = 8.11F;
constexpr int all_integers_are_long = 0xe000;  // ids, maps and connectivity (exodusII.h: EX_ALL_INT64_DB)
constexpr std::uint64_t growing = 0;           // length of such a dimension

/// Half the entries of a node of the index of each variable, which is there whole from the first frame on: in a file of
/// many blocks nodes are small, so that they take about as much as with few.
unsigned choose_chunk_index(std::size_t blocks) {
  constexpr std::size_t blocks_with_most = 64;
  constexpr unsigned least = 32;
  return std::max(least, hdf5::most_chunk_index / static_cast<unsigned>(1 + (blocks - 1) / blocks_with_most));
}

/// No more than the format holds, without half a character of UTF-8.
std::string cut_text(std::string text, std::size_t most) {
  if (text.size() <= most) return text;
  while (most > 0 && (static_cast<unsigned char>(text[most]) & 0xc0) == 0x80) --most;
  text.resize(most);
  return text;
}

/// What the variables of a kind of set are called.
struct SetNames {
  const char *count, *prefix, *size, *members;
};
constexpr SetNames node_set_names{"num_node_sets", "ns", "num_nod_ns", "node_ns"};
constexpr SetNames side_set_names{"num_side_sets", "ss", "num_side_ss", "elem_ss"};

std::string name_block_dimension(const char* kind, std::size_t block) { return fmt::format("{}{}", kind, block + 1); }

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
  void write_texts(const std::string& name, std::span<const std::string> names, std::span<const std::string> texts);

  void create(const Mesh& mesh);
  std::uint64_t find_bytes() const;
  std::size_t find_name_length() const;
  void write_header();
  void create_dimensions();
  void write_nodes(const Mesh& mesh);
  void write_elements(const Mesh& mesh);
  void write_connectivity(const Mesh& mesh, std::size_t block);
  void write_entities(const std::string& prefix, const std::string& dimension, std::span<const std::string> names);
  void write_sets(const SetNames& of, const std::vector<ExodusSet>& found);
  void write_records();
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

void ExodusResults::Impl::write_texts(const std::string& name, std::span<const std::string> names,
                                      std::span<const std::string> texts) {
  netcdf().write_texts(name, names, file.block_of_first_rank(1).transfer, ranks.rank() == 0, texts);
}

std::uint64_t ExodusResults::Impl::find_bytes() const {
  std::uint64_t bytes =
      file_bytes + nodes * exodus_bytes_per_node + elements * exodus_bytes_per_element + blocks.size() * variable_bytes;
  for (const auto* kind : {&sets.of_nodes, &sets.of_sides}) {
    for (const ExodusSet& set : *kind) bytes += 2 * (variable_bytes + sizeof(std::int64_t) * set.members.size());
  }
  return bytes;
}

void ExodusResults::Impl::create(const Mesh& mesh) {
  sets = list_exodus_sets(mesh, blocks, options, ranks);
  file.create(find_bytes(), [&] {
    write_header();
    create_dimensions();
    create_steps();
    write_nodes(mesh);
    write_elements(mesh);
    write_sets(node_set_names, sets.of_nodes);
    write_sets(side_set_names, sets.of_sides);
    write_records();
  });
  sets = {};
}

std::size_t ExodusResults::Impl::find_name_length() const {
  std::size_t length = least_name_length;
  for (const ExodusBlock& block : blocks) length = std::max(length, block.name.size());
  for (const auto* kind : {&sets.of_nodes, &sets.of_sides}) {
    for (const ExodusSet& set : *kind) length = std::max(length, set.name.size());
  }
  return length;
}

void ExodusResults::Impl::write_header() {
  write_float_attribute(file.id(), "api_version", format_version);
  write_float_attribute(file.id(), "version", format_version);
  write_int_attribute(file.id(), "floating_point_word_size", sizeof(double));
  write_int_attribute(file.id(), "file_size", 1);
  write_int_attribute(file.id(), "maximum_name_length", static_cast<int>(find_name_length()));
  write_int_attribute(file.id(), "int64_status", all_integers_are_long);
  hdf5::write_attribute(file.id(), "title", cut_text(options.title, line_length));
}

void ExodusResults::Impl::create_dimensions() {
  const auto create = [&](const std::string& name, std::size_t length) { dimensions.create(file.id(), name, length); };
  // The first one that grows is that of the time steps for netCDF.
  create("time_step", growing);
  create("frame_rows", growing);
  create("len_string", string_length + 1);
  create("len_line", line_length + 1);
  create("four", 4);
  create("len_name", find_name_length() + 1);
  create("num_dim", 3);
  create("num_nodes", nodes);
  create("num_elem", elements);
  create("num_el_blk", blocks.size());
  for (std::size_t b = 0; b < blocks.size(); ++b) {
    create(name_block_dimension("num_el_in_blk", b), static_cast<std::size_t>(blocks[b].elements));
    create(name_block_dimension("num_nod_per_el", b), blocks[b].corners());
  }
  create("num_qa_rec", 1);
  create("num_info", 2);
  create("num_glo_var", 1);
}

void ExodusResults::Impl::create_steps() {
  times.emplace(file.id(), "time_whole", hdf5::FrameTable::Shape{1, true, true});
  dimensions.attach(times->id(), std::array<std::string, 1>{"time_step"});
  globals.emplace(file.id(), "vals_glo_var", hdf5::FrameTable::Shape{1, false, true});
  dimensions.attach(globals->id(), std::array<std::string, 2>{"frame_rows", "num_glo_var"});
  write_texts("name_glo_var", std::array<std::string, 2>{"num_glo_var", "len_name"},
              std::array<std::string, 1>{"step"});
}

void ExodusResults::Impl::write_nodes(const Mesh& mesh) {
  std::vector<double> coordinates(mesh.nodes.size());
  for (std::size_t d = 0; d < 3; ++d) {
    for (std::size_t n = 0; n < coordinates.size(); ++n) coordinates[n] = mesh.nodes[n][d];
    netcdf().write_numbers(std::string("coord") + "xyz"[d], "num_nodes", node_block(),
                           node_rows.gather(std::span<const double>(coordinates), 1));
  }
  write_texts("coor_names", std::array<std::string, 2>{"num_dim", "len_name"},
              std::array<std::string, 3>{"x", "y", "z"});
  netcdf().write_integers("node_num_map", "num_nodes", node_block(),
                          node_rows.gather(std::span<const std::int64_t>(mesh.node_ids), 1));
}

/// Ids from 1, and names, of blocks or sets.
void ExodusResults::Impl::write_entities(const std::string& prefix, const std::string& dimension,
                                         std::span<const std::string> names) {
  std::vector<std::int64_t> ids, in_use(names.size(), 1);
  for (std::size_t i = 0; i < names.size(); ++i) ids.push_back(static_cast<std::int64_t>(i) + 1);
  const hdf5::RowBlock one = file.block_of_first_rank(names.size());
  const std::string id = prefix + "_prop1";
  netcdf().write_integers(prefix + "_status", dimension, one, in_use);
  netcdf().write_integers(id, dimension, one, ids);
  const hdf5::Handle property(hdf5::check(H5Dopen2(file.id(), id.c_str(), H5P_DEFAULT), "open dataset " + id),
                              H5Dclose);
  hdf5::write_attribute(property.get(), "name", std::string("ID"));
  write_texts(prefix + "_names", std::array<std::string, 2>{dimension, "len_name"}, names);
}

void ExodusResults::Impl::write_sets(const SetNames& of, const std::vector<ExodusSet>& found) {
  if (found.empty()) return;
  std::vector<std::string> names;
  names.reserve(found.size());
  for (const ExodusSet& set : found) names.push_back(set.name);
  dimensions.create(file.id(), of.count, names.size());
  write_entities(of.prefix, of.count, names);
  for (std::size_t s = 0; s < found.size(); ++s) {
    const std::string size = fmt::format("{}{}", of.size, s + 1);
    dimensions.create(file.id(), size, found[s].members.size());
    const hdf5::RowBlock rows = file.block_of_first_rank(found[s].members.size());
    netcdf().write_integers(fmt::format("{}{}", of.members, s + 1), size, rows, found[s].members);
    if (&of == &side_set_names) netcdf().write_integers(fmt::format("side_ss{}", s + 1), size, rows, found[s].sides);
  }
}

void ExodusResults::Impl::write_elements(const Mesh& mesh) {
  std::vector<std::string> names;
  for (const ExodusBlock& block : blocks) names.push_back(block.name);
  write_entities("eb", "num_el_blk", names);
  hdf5::Table map(file.id(), "elem_num_map", H5T_STD_I64LE, 1, elements);
  for (std::size_t b = 0; b < blocks.size(); ++b) {
    write_connectivity(mesh, b);
    const auto own = blocks[b].pick(std::span<const std::int64_t>(mesh.element_ids), 1, 0);
    map.append(blocks[b].rows->gather(std::span<const std::int64_t>(own), 1), block_of(blocks[b]));
  }
  dimensions.attach(file.id(), "elem_num_map", std::array<std::string, 1>{"num_elem"});
}

void ExodusResults::Impl::write_connectivity(const Mesh& mesh, std::size_t block) {
  const std::string name = name_block_dimension("connect", block);
  const std::vector<std::int64_t> corners = list_connectivity(mesh, blocks[block]);
  const std::array<std::string, 2> names{name_block_dimension("num_el_in_blk", block),
                                         name_block_dimension("num_nod_per_el", block)};
  netcdf().write_integer_rows(
      name, names, block_of(blocks[block]),
      blocks[block].rows->gather(std::span<const std::int64_t>(corners), static_cast<int>(blocks[block].corners())));
  const hdf5::Handle dataset(hdf5::check(H5Dopen2(file.id(), name.c_str(), H5P_DEFAULT), "open dataset " + name),
                             H5Dclose);
  hdf5::write_attribute(dataset.get(), "elem_type", blocks[block].element_type());
}

// Date and time are left empty: equal runs give equal bytes.
void ExodusResults::Impl::write_records() {
  write_texts("qa_records", std::array<std::string, 3>{"num_qa_rec", "four", "len_string"},
              std::array<std::string, 4>{"percuss", PERCUSS_VERSION, "", ""});
  write_texts("info_records", std::array<std::string, 2>{"num_info", "len_line"},
              std::array<std::string, 2>{cut_text("title: " + options.title, line_length),
                                         cut_text("units: " + options.units, line_length)});
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
                        std::array<std::string, 2>{"frame_rows", name_block_dimension("num_el_in_blk", b)});
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
  impl_ = std::make_unique<Impl>(directory + "/" + exodus_frames.file_name, chunked, options, ranks);
  impl_->create(chunked.mesh);
}

ExodusResults::ExodusResults(const std::string& directory, const ChunkedMesh& chunked, const FieldsOptions& options,
                             const Communicator& ranks, std::int64_t frames, std::span<const std::string> fields) {
  const hdf5::QuietErrors quiet;
  const std::string path = directory + "/" + exodus_frames.file_name;
  const FramesInFile kept = find_kept(chunked, frames);
  run_on_first_rank(ranks, [&] {
    check_earlier_results(exodus_frames, path, kept, fields);
    cut_earlier_results(exodus_frames, path, kept);
  });
  impl_ = std::make_unique<Impl>(path, chunked, options, ranks);
  impl_->file.open(frames, [&] { impl_->open_steps(); });
}

void ExodusResults::check(const std::string& directory, const ChunkedMesh& chunked, const Communicator& ranks,
                          std::int64_t frames, std::span<const std::string> fields) {
  const std::string path = directory + "/" + exodus_frames.file_name;
  run_on_first_rank(ranks, [&] { check_earlier_results(exodus_frames, path, find_kept(chunked, frames), fields); });
}

ExodusResults::~ExodusResults() {
  const hdf5::QuietErrors quiet;
  impl_.reset();
}

ExodusResults::ExodusResults(ExodusResults&&) noexcept = default;

ExodusResults& ExodusResults::operator=(ExodusResults&& other) noexcept {
  const hdf5::QuietErrors quiet;
  impl_ = std::move(other.impl_);
  return *this;
}

void ExodusResults::write_frame(double time, long step, std::span<const double> positions,
                                std::span<const FieldData> fields) {
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
