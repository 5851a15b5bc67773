#include "src/mesh/formats/exodus/exodus_file.hpp"

#include <exodusII.h>
#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <map>
#include <string_view>

#include "src/error.hpp"
#include "src/hdf5/hdf5_structure.hpp"
#include "src/mesh/formats/exodus/exodus_coordinates.hpp"

namespace percuss {
namespace {

/// Least bytes that a count, an index or a coordinate takes in a file.
constexpr std::int64_t least_bytes = 4;

/// netCDF's own limit (NC_MAX_NAME).
constexpr int longest_name = 256;

[[noreturn]] void refuse_damaged(const std::string& what) {
  const char *message = nullptr, *function = nullptr;
  int code = 0;
  ex_get_err(&message, &function, &code);
  std::string reason = message ? message : "";
  while (!reason.empty() && (reason.back() == '\n' || reason.back() == ' ')) reason.pop_back();
  throw InputError(
      fmt::format("{} cannot be read (the file is damaged or not one of Exodus II; its library says '{}', code {})",
                  what, reason, code));
}

/// Positive codes are warnings of the library, about things that are allowed to be missing.
void check(int code, const std::string& what) {
  if (code < 0) refuse_damaged(what);
}

std::size_t size_of(std::int64_t count) { return static_cast<std::size_t>(count); }

std::vector<std::int64_t> read_ids(int file, ex_entity_type kind, std::int64_t count, const char* what) {
  std::vector<std::int64_t> ids(size_of(count));
  if (count > 0) check(ex_get_ids(file, kind, ids.data()), what);
  return ids;
}

/// Names of all entities of a kind in the order of their ids' list; empty where the file gives none.
std::vector<std::string> read_names(int file, ex_entity_type kind, std::int64_t count, const char* what) {
  const std::int64_t used = ex_inquire_int(file, EX_INQ_DB_MAX_USED_NAME_LENGTH);
  const int width =
      std::clamp<int>(static_cast<int>(std::clamp<std::int64_t>(used, 0, longest_name)), MAX_NAME_LENGTH, longest_name);
  check(ex_set_max_name_length(file, width), what);
  std::vector<std::string> names(size_of(count));
  for (std::size_t i = 0; i < names.size(); ++i) names[i].assign(static_cast<std::size_t>(width) + 2, '\0');
  std::vector<char*> pointers;
  pointers.reserve(names.size());
  for (std::string& name : names) pointers.push_back(name.data());
  if (count > 0) check(ex_get_names(file, kind, pointers.data()), what);
  for (std::string& name : names) {
    name.resize(std::char_traits<char>::length(name.c_str()));
    // A line of the report is a block or a set, so a name must not contain a line end.
    std::replace_if(
        name.begin(), name.end(), [](char c) { return c == '\n' || c == '\t'; }, ' ');
    name.erase(name.find_last_not_of(' ') + 1);
  }
  return names;
}

std::vector<FileSet> read_sets(int file, ex_entity_type kind, std::int64_t count, const char* what,
                               const char* prefix) {
  const std::vector<std::int64_t> ids = read_ids(file, kind, count, what);
  const std::vector<std::string> names = read_names(file, kind, count, what);
  std::map<std::string, int> uses;
  for (const std::string& name : names) ++uses[name];
  std::vector<FileSet> sets;
  for (std::size_t i = 0; i < ids.size(); ++i) {
    std::int64_t entries = 0, factors = 0;
    check(ex_get_set_param(file, kind, ids[i], &entries, &factors), what);
    const bool usable = !names[i].empty() && uses[names[i]] == 1;
    sets.push_back({ids[i], usable ? names[i] : fmt::format("{}_{}", prefix, ids[i]), entries});
  }
  return sets;
}

/// Whether the name of a block's kind begins so, in capitals or not.
bool is_called_kind(std::string_view block, std::string_view kind) {
  return !kind.empty() && block.size() >= kind.size() &&
         std::equal(kind.begin(), kind.end(), block.begin(),
                    [](char a, char b) { return a == std::toupper(static_cast<unsigned char>(b)); });
}

/// None: elements of this kind cannot be run.
std::optional<TopologyKind> find_kind(std::string_view block, std::int64_t nodes_per_element) {
  for (std::size_t kind = 0; kind < topology_count; ++kind) {
    const Topology& topology = topologies[kind];
    const auto& names = topology.exodus_names;
    const bool is_called =
        std::any_of(names.begin(), names.end(), [&](std::string_view name) { return is_called_kind(block, name); });
    const bool is_cut = topology.family == ElementFamily::tetrahedra && nodes_per_element == std::int64_t{tet10_nodes};
    if (is_called && (nodes_per_element == topology.corner_count || is_cut)) return static_cast<TopologyKind>(kind);
  }
  return {};
}

}  // namespace

ExodusFile::ExodusFile(const std::string& path) : container_(inspect_exodus_container(path)) {
  if (container_.is_hdf5)
    hdf5::check_structure(path, hdf5::ExternalFiles::allow);  // app/external_files.hpp refuses them
  ex_opts(EX_DEFAULT);                                        // the library prints nothing; its messages go into ours
  int word_in_memory = sizeof(double), word_in_file = 0;
  float version = 0;
  file_ = ex_open(path.c_str(), EX_READ | EX_ALL_INT64_API, &word_in_memory, &word_in_file, &version);
  if (file_ < 0) refuse_damaged("the file");
  try {
    read_counts();
    read_blocks();
    node_sets_ =
        read_sets(file_, EX_NODE_SET, static_cast<std::int64_t>(node_sets_.size()), "the list of node sets", "nodes");
    side_sets_ =
        read_sets(file_, EX_SIDE_SET, static_cast<std::int64_t>(side_sets_.size()), "the list of side sets", "sides");
    element_sets_ = read_sets(file_, EX_ELEM_SET, static_cast<std::int64_t>(element_sets_.size()),
                              "the list of element sets", "elements");
  } catch (...) {
    ex_close(file_);
    throw;
  }
}

ExodusFile::~ExodusFile() { ex_close(file_); }

void ExodusFile::require_room(std::int64_t count, std::int64_t bytes_each, const char* what) const {
  const double bytes = static_cast<double>(count) * static_cast<double>(bytes_each);
  if (count >= 0 && bytes <= static_cast<double>(container_.most_payload)) return;
  throw InputError(
      fmt::format("the file is damaged (it claims {} {}, which its {} bytes cannot hold): write or copy it again",
                  count, what, container_.bytes));
}

void ExodusFile::read_counts() {
  ex_init_params counts{};
  check(ex_get_init_ext(file_, &counts), "the counts of nodes and elements");
  dimensions_ = static_cast<int>(std::clamp<std::int64_t>(counts.num_dim, 0, 99));
  nodes_ = counts.num_nodes;
  elements_ = counts.num_elem;
  block_count_ = counts.num_elem_blk;
  require_room(nodes_, dimensions_ * least_bytes, "nodes");
  require_room(elements_, least_bytes, "elements");
  require_room(block_count_, least_bytes, "element blocks");
  require_room(counts.num_node_sets, least_bytes, "node sets");
  require_room(counts.num_side_sets, least_bytes, "side sets");
  require_room(counts.num_elem_sets, least_bytes, "element sets");
  node_sets_.resize(size_of(counts.num_node_sets));
  side_sets_.resize(size_of(counts.num_side_sets));
  element_sets_.resize(size_of(counts.num_elem_sets));
}

void ExodusFile::read_blocks() {
  const char* what = "the list of element blocks";
  const std::vector<std::int64_t> ids = read_ids(file_, EX_ELEM_BLOCK, block_count_, what);
  const std::vector<std::string> names = read_names(file_, EX_ELEM_BLOCK, block_count_, what);
  std::int64_t next = 1;
  for (std::size_t i = 0; i < ids.size(); ++i) {
    ex_block block{};
    block.id = ids[i];
    block.type = EX_ELEM_BLOCK;
    check(ex_get_block_param(file_, &block), what);
    block.topology[MAX_STR_LENGTH] = '\0';
    require_room(block.num_entry, std::max<std::int64_t>(block.num_nodes_per_entry, 1) * least_bytes,
                 "elements in a block");
    blocks_.push_back({ids[i], names[i].empty() ? fmt::format("block_{}", ids[i]) : names[i], block.topology,
                       block.num_entry, block.num_nodes_per_entry, next,
                       find_kind(block.topology, block.num_nodes_per_entry), block.num_attribute});
    next += block.num_entry;
  }
  if (next - 1 == elements_) return;
  throw InputError(fmt::format("the file is damaged (it claims {} elements, its blocks have {})", elements_, next - 1));
}

std::vector<Vec3> ExodusFile::read_coordinates() const {
  return read_exodus_coordinates(file_, std::min(dimensions_, 3), nodes_);
}

std::vector<std::int64_t> ExodusFile::read_connectivity(const FileBlock& block) const {
  std::vector<std::int64_t> corners(size_of(block.elements * block.nodes_per_element));
  if (corners.empty()) return corners;
  check(ex_get_conn(file_, EX_ELEM_BLOCK, block.id, corners.data(), nullptr, nullptr),
        fmt::format("the connectivity of block '{}'", block.name));
  return corners;
}

std::vector<double> ExodusFile::read_thicknesses(const FileBlock& block) const {
  const bool has_them = block.topology && find_topology(*block.topology).is_surface() && block.attributes > 0;
  if (!has_them) return {};
  require_room(block.elements, least_bytes, "attributes of a block");
  std::vector<double> thicknesses(size_of(block.elements));
  if (thicknesses.empty()) return thicknesses;
  check(ex_get_one_attr(file_, EX_ELEM_BLOCK, block.id, 1, thicknesses.data()),
        fmt::format("the attributes of block '{}'", block.name));
  return thicknesses;
}

std::vector<std::int64_t> ExodusFile::read_node_ids() const {
  std::vector<std::int64_t> ids(size_of(nodes_));
  check(ex_get_id_map(file_, EX_NODE_MAP, ids.data()), "the node number map");
  return ids;
}

std::vector<std::int64_t> ExodusFile::read_element_ids() const {
  std::vector<std::int64_t> ids(size_of(elements_));
  check(ex_get_id_map(file_, EX_ELEM_MAP, ids.data()), "the element number map");
  return ids;
}

std::vector<std::int64_t> ExodusFile::read_set(int kind, const FileSet& set, const char* what) const {
  require_room(set.entries, least_bytes, "members of a set");
  std::vector<std::int64_t> members(size_of(set.entries));
  if (members.empty()) return members;
  check(ex_get_set(file_, static_cast<ex_entity_type>(kind), set.id, members.data(), nullptr),
        fmt::format("{} set '{}'", what, set.name));
  return members;
}

std::vector<std::int64_t> ExodusFile::read_node_set(const FileSet& set) const {
  return read_set(EX_NODE_SET, set, "node");
}

std::vector<std::int64_t> ExodusFile::read_element_set(const FileSet& set) const {
  return read_set(EX_ELEM_SET, set, "element");
}

int ExodusFile::find_face(const Topology& topology, std::int64_t side) const {
  if (side < 1 || side > topology.face_count) return -1;
  return topology.exodus_sides[static_cast<std::size_t>(side - 1)];
}

std::string ExodusFile::list_kinds() const {
  std::string list;
  for (const Topology& topology : topologies) {
    for (const std::string_view name : topology.exodus_names)
      if (!name.empty()) list += fmt::format("{}{}{}", list.empty() ? "" : ", ", name, topology.corner_count);
  }
  return list + ", TETRA10";
}

std::vector<FileSide> ExodusFile::read_side_set(const FileSet& set) const {
  require_room(set.entries, 2 * least_bytes, "sides in a set");
  std::vector<std::int64_t> elements(size_of(set.entries)), sides(elements.size());
  std::vector<FileSide> faces;
  if (elements.empty()) return faces;
  check(ex_get_set(file_, EX_SIDE_SET, set.id, elements.data(), sides.data()), fmt::format("side set '{}'", set.name));
  for (std::size_t i = 0; i < elements.size(); ++i) faces.emplace_back(elements[i], sides[i]);
  return faces;
}

}  // namespace percuss
