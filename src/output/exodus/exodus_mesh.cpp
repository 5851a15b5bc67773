#include "src/output/exodus/exodus_mesh.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace percuss {
namespace {

// Most bytes of metadata that a variable takes, and that a file starts with.
constexpr std::uint64_t variable_bytes = std::uint64_t{16} << 10, file_bytes = std::uint64_t{512} << 10;
// Id and coordinates; corners and id; and the dimension scales, whose numbers several ranks store.
constexpr std::uint64_t exodus_bytes_per_node = 4 * 8 + 4, exodus_bytes_per_element = 8 * 9 + 2 * 4;

constexpr std::size_t line_length = 80;    // of titles and information records
constexpr std::size_t string_length = 32;  // of QA records
constexpr std::size_t least_name_length = 64;
constexpr float format_version = 8.11F;
constexpr int all_integers_are_long = 0xe000;  // ids, maps and connectivity (exodusII.h: EX_ALL_INT64_DB)
constexpr std::uint64_t growing = 0;           // length of such a dimension

/// No more than the format holds, without half a character of UTF-8.
std::string cut_text(std::string text, std::size_t most) {
  if (text.size() <= most) return text;
  while (most > 0 && (static_cast<unsigned char>(text[most]) & 0xc0) == 0x80) --most;
  text.resize(most);
  return text;
}

/// Names of the variables of a kind of set.
struct SetNames {
  const char *count, *prefix, *size, *members;
};
constexpr SetNames node_set_names{"num_node_sets", "ns", "num_nod_ns", "node_ns"};
constexpr SetNames side_set_names{"num_side_sets", "ss", "num_side_ss", "elem_ss"};

}  // namespace

unsigned choose_chunk_index(std::size_t blocks) {
  constexpr std::size_t blocks_with_most = 64;
  constexpr unsigned least = 32;
  return std::max(least, hdf5::most_chunk_index / static_cast<unsigned>(1 + (blocks - 1) / blocks_with_most));
}

std::string name_of_block(const char* kind, std::size_t block) { return fmt::format("{}{}", kind, block + 1); }

void ExodusMesh::write_texts(const std::string& name, std::span<const std::string> names,
                             std::span<const std::string> texts) const {
  netcdf().write_texts(name, names, file.block_of_first_rank(1).transfer, ranks.rank() == 0, texts);
}

std::uint64_t ExodusMesh::find_bytes() const {
  std::uint64_t bytes =
      file_bytes + nodes * exodus_bytes_per_node + elements * exodus_bytes_per_element + blocks.size() * variable_bytes;
  for (const auto* kind : {&sets.of_nodes, &sets.of_sides}) {
    for (const ExodusSet& set : *kind) bytes += 2 * (variable_bytes + sizeof(std::int64_t) * set.members.size());
  }
  return bytes;
}

void ExodusMesh::write_header() const {
  write_attributes();
  create_dimensions();
}

void ExodusMesh::write_mesh(const Mesh& mesh) const {
  write_nodes(mesh);
  write_elements(mesh);
  write_sets(false);
  write_sets(true);
  write_records();
}

std::size_t ExodusMesh::find_name_length() const {
  std::size_t length = least_name_length;
  for (const ExodusBlock& block : blocks) length = std::max(length, block.name.size());
  for (const auto* kind : {&sets.of_nodes, &sets.of_sides}) {
    for (const ExodusSet& set : *kind) length = std::max(length, set.name.size());
  }
  return length;
}

void ExodusMesh::write_attributes() const {
  write_float_attribute(file.id(), "api_version", format_version);
  write_float_attribute(file.id(), "version", format_version);
  write_int_attribute(file.id(), "floating_point_word_size", sizeof(double));
  write_int_attribute(file.id(), "file_size", 1);
  write_int_attribute(file.id(), "maximum_name_length", static_cast<int>(find_name_length()));
  write_int_attribute(file.id(), "int64_status", all_integers_are_long);
  hdf5::write_attribute(file.id(), "title", cut_text(options.title, line_length));
}

void ExodusMesh::create_dimensions() const {
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
    create(name_of_block("num_el_in_blk", b), static_cast<std::size_t>(blocks[b].elements));
    create(name_of_block("num_nod_per_el", b), blocks[b].corners());
  }
  create("num_qa_rec", 1);
  create("num_info", 2);
  create("num_glo_var", 1);
}

void ExodusMesh::write_nodes(const Mesh& mesh) const {
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
void ExodusMesh::write_entities(const std::string& prefix, const std::string& dimension,
                                std::span<const std::string> names) const {
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

void ExodusMesh::write_sets(bool are_sides) const {
  const SetNames& of = are_sides ? side_set_names : node_set_names;
  const std::vector<ExodusSet>& found = are_sides ? sets.of_sides : sets.of_nodes;
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
    if (are_sides) netcdf().write_integers(fmt::format("side_ss{}", s + 1), size, rows, found[s].sides);
  }
}

void ExodusMesh::write_elements(const Mesh& mesh) const {
  std::vector<std::string> names;
  for (const ExodusBlock& block : blocks) names.push_back(block.name);
  write_entities("eb", "num_el_blk", names);
  hdf5::Table map(file.id(), "elem_num_map", H5T_STD_I64LE, 1, elements);
  std::int64_t next = 1;
  for (std::size_t b = 0; b < blocks.size(); ++b) {
    write_connectivity(mesh, b);
    std::vector<std::int64_t> own = blocks[b].pick(std::span<const std::int64_t>(mesh.element_ids), 1, 0);
    if (options.are_faces) {  // ids are unique in this format
      for (std::size_t i = 0; i < own.size(); ++i) own[i] = next + blocks[b].places[i];
    }
    next += blocks[b].elements;
    map.append(blocks[b].rows->gather(std::span<const std::int64_t>(own), 1), block_of(blocks[b]));
  }
  dimensions.attach(file.id(), "elem_num_map", std::array<std::string, 1>{"num_elem"});
}

void ExodusMesh::write_connectivity(const Mesh& mesh, std::size_t block) const {
  const std::string name = name_of_block("connect", block);
  const std::vector<std::int64_t> corners = list_connectivity(mesh, blocks[block]);
  const std::array<std::string, 2> names{name_of_block("num_el_in_blk", block), name_of_block("num_nod_per_el", block)};
  netcdf().write_integer_rows(
      name, names, block_of(blocks[block]),
      blocks[block].rows->gather(std::span<const std::int64_t>(corners), static_cast<int>(blocks[block].corners())));
  const hdf5::Handle dataset(hdf5::check(H5Dopen2(file.id(), name.c_str(), H5P_DEFAULT), "open dataset " + name),
                             H5Dclose);
  hdf5::write_attribute(dataset.get(), "elem_type", blocks[block].element_type());
}

// Date and time are left empty: equal runs give equal bytes.
void ExodusMesh::write_records() const {
  write_texts("qa_records", std::array<std::string, 3>{"num_qa_rec", "four", "len_string"},
              std::array<std::string, 4>{"percuss", PERCUSS_VERSION, "", ""});
  write_texts("info_records", std::array<std::string, 2>{"num_info", "len_line"},
              std::array<std::string, 2>{cut_text("title: " + options.title, line_length),
                                         cut_text("units: " + options.units, line_length)});
}

}  // namespace percuss
