#include "tests/src/mesh/exodus_writer.hpp"

#include <exodusII.h>
#include <unistd.h>

#include <fstream>
#include <iterator>
#include <stdexcept>

#include <gtest/gtest.h>

namespace percuss::testing_mesh {
namespace {

void check(int code) {
  if (code < 0) throw std::runtime_error("the test cannot write its Exodus file");
}

int find_mode(Container container) {
  constexpr int common = EX_CLOBBER | EX_ALL_INT64_API;
  switch (container) {
    case Container::classic:
      return common | EX_NORMAL_MODEL;
    case Container::offset64:
      return common | EX_LARGE_MODEL;
    case Container::netcdf4:
      return common | EX_NETCDF4;
    default:
      return common | EX_NETCDF4 | EX_ALL_INT64_DB;
  }
}

std::string make_path(const std::string& name) {
  return testing::TempDir() + "percuss_" + std::to_string(getpid()) + "_" + name;
}

void write_blocks(int file, const WrittenMesh& mesh) {
  for (const WrittenBlock& block : mesh.blocks) {
    const auto count = static_cast<std::int64_t>(block.corners.size()) / block.nodes_per_element;
    check(ex_put_block(file, EX_ELEM_BLOCK, block.id, block.topology.c_str(), count, block.nodes_per_element, 0, 0,
                       block.attribute.empty() ? 0 : 1));
    if (count > 0) check(ex_put_conn(file, EX_ELEM_BLOCK, block.id, block.corners.data(), nullptr, nullptr));
    if (!block.attribute.empty()) check(ex_put_one_attr(file, EX_ELEM_BLOCK, block.id, 1, block.attribute.data()));
    if (!block.name.empty()) check(ex_put_name(file, EX_ELEM_BLOCK, block.id, block.name.c_str()));
  }
}

void write_sets(int file, ex_entity_type kind, const std::vector<WrittenSet>& sets) {
  for (const WrittenSet& set : sets) {
    check(ex_put_set_param(file, kind, set.id, static_cast<std::int64_t>(set.entries.size()), 0));
    if (!set.entries.empty())
      check(ex_put_set(file, kind, set.id, set.entries.data(), set.sides.empty() ? nullptr : set.sides.data()));
    if (!set.name.empty()) check(ex_put_name(file, kind, set.id, set.name.c_str()));
  }
}

void write_coordinates(int file, const WrittenMesh& mesh) {
  std::array<std::vector<double>, 3> x;
  for (const Vec3& node : mesh.nodes) {
    for (std::size_t d = 0; d < 3; ++d) x[d].push_back(node[d]);
  }
  check(ex_put_coord(file, x[0].data(), x[1].data(), x[2].data()));
}

}  // namespace

WrittenMesh make_two_cubes() {
  WrittenMesh mesh;
  for (int i = 0; i < 3; ++i) {
    for (const auto& [y, z] : {std::pair{0, 0}, {1, 0}, {1, 1}, {0, 1}})
      mesh.nodes.push_back({double(i), double(y), double(z)});
  }
  // Corners 1 to 4 at the lower x: nodes run around +x there, so the element's own third direction is x.
  mesh.blocks.push_back({10, "left", "HEX8", 8, {1, 2, 3, 4, 5, 6, 7, 8}});
  mesh.blocks.push_back({20, "", "hex", 8, {5, 6, 7, 8, 9, 10, 11, 12}});
  mesh.node_sets.push_back({5, "corner", {1}, {}});
  mesh.side_sets.push_back({6, "", {2, 1}, {6, 5}});
  mesh.element_ids = {101, 102};
  for (int n = 1; n <= 12; ++n) mesh.node_ids.push_back(1000 + n);
  return mesh;
}

std::string write_exodus(const WrittenMesh& mesh, const std::string& name, Container container) {
  const std::string path = make_path(name);
  int word_in_memory = sizeof(double), word_in_file = mesh.single_precision ? 4 : 8;
  const int file = ex_create(path.c_str(), find_mode(container), &word_in_memory, &word_in_file);
  check(file);
  std::int64_t elements = 0;
  for (const WrittenBlock& block : mesh.blocks)
    elements += static_cast<std::int64_t>(block.corners.size()) / block.nodes_per_element;
  check(ex_put_init(file, "test", mesh.dimensions, static_cast<std::int64_t>(mesh.nodes.size()), elements,
                    static_cast<std::int64_t>(mesh.blocks.size()), static_cast<std::int64_t>(mesh.node_sets.size()),
                    static_cast<std::int64_t>(mesh.side_sets.size())));
  if (!mesh.nodes.empty()) write_coordinates(file, mesh);
  write_blocks(file, mesh);
  write_sets(file, EX_NODE_SET, mesh.node_sets);
  write_sets(file, EX_SIDE_SET, mesh.side_sets);
  if (!mesh.node_ids.empty()) check(ex_put_id_map(file, EX_NODE_MAP, mesh.node_ids.data()));
  if (!mesh.element_ids.empty()) check(ex_put_id_map(file, EX_ELEM_MAP, mesh.element_ids.data()));
  check(ex_close(file));
  return path;
}

std::string write_bytes(const std::string& bytes, const std::string& name) {
  const std::string path = make_path(name);
  std::ofstream(path, std::ios::binary) << bytes;
  return path;
}

std::string read_bytes(const std::string& path) {
  std::ifstream stream(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

std::string lengthen_status(std::string bytes) {
  const std::string name = "int64_status";
  const std::size_t count = bytes.find(name) + name.size() + 4;  // after the name and the type; before the value
  bytes.replace(count, 4, std::string("\x00\x00\x00\xff", 4));
  return bytes.insert(count + 8, 254 * 4, '\x7f');
}

}  // namespace percuss::testing_mesh
