#include "src/mesh/files/text_builder.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "src/mesh/files/text_lookup.hpp"

namespace percuss {

void TextBuilder::add_node(std::int64_t id, const Vec3& x, TextPlace place) {
  node_ids_.push_back(id);
  nodes_.push_back(x);
  node_places_.push_back(place);
}

int TextBuilder::find_block(const std::string& name, std::int64_t id, const TextKind& kind) {
  const auto [found, is_new] = block_places_.emplace(std::pair(name, kind.name), static_cast<int>(blocks_.size()));
  if (is_new) {
    Block& block = blocks_.emplace_back();
    block.head.id = id;
    block.head.name = name;
    block.head.kind = kind.name;
    block.head.nodes_per_element = kind.nodes;
    block.head.topology = kind.topology;
    block.kind = kind;
  }
  return found->second;
}

void TextBuilder::rename_blocks(std::int64_t id, const std::string& name) {
  for (Block& block : blocks_) {
    if (block.head.id == id) block.head.name = name;
  }
}

void TextBuilder::add_element(int block, std::int64_t id, std::span<const std::int64_t> nodes, TextPlace place) {
  Block& to = blocks_[static_cast<std::size_t>(block)];
  to.ids.push_back(id);
  to.nodes.insert(to.nodes.end(), nodes.begin(), nodes.end());
  to.places.push_back(place);
}

void TextBuilder::set_thickness(int block, double thickness) {
  Block& of = blocks_[static_cast<std::size_t>(block)];
  of.thicknesses.resize(of.ids.size(), 0);
  of.thicknesses.back() = thickness;
}

void TextBuilder::set_thickness(int block, std::size_t element, double thickness) {
  Block& of = blocks_[static_cast<std::size_t>(block)];
  of.thicknesses.resize(of.ids.size(), 0);
  of.thicknesses[element] = thickness;
}

void TextBuilder::fill_thickness(std::int64_t id, double thickness) {
  for (Block& block : blocks_) {
    if (block.head.id != id || !block.head.topology || !find_topology(*block.head.topology).is_surface()) continue;
    block.thicknesses.resize(block.ids.size(), 0);
    std::replace(block.thicknesses.begin(), block.thicknesses.end(), 0.0, thickness);
  }
}

void TextBuilder::add_node_thickness(std::int64_t node, double thickness, TextPlace place) {
  node_thicknesses_.push_back({{{Member::What::one, node, 0, 1, {}, {}, place}}, thickness});
}

void TextBuilder::add_node_thickness_of(const std::string& set, double thickness, TextPlace place) {
  node_thicknesses_.push_back({{{Member::What::set, 0, 0, 1, {}, set, place}}, thickness});
}

void TextBuilder::average_thickness_of(const std::string& set, TextPlace place) {
  averaged_.push_back({Member::What::set, 0, 0, 1, {}, set, place});
}

void TextBuilder::add_surface_element(const std::string& surface, const TextKind& kind, ElementId id,
                                      std::span<const std::int64_t> nodes, TextPlace place) {
  SurfaceElement element{kind, id, {}, nodes.size(), place};
  std::copy(nodes.begin(), nodes.end(), element.nodes.begin());
  surfaces_[surface].elements.push_back(std::move(element));
}

void TextBuilder::add_set_node(const std::string& set, std::int64_t node, TextPlace place) {
  node_sets_[set].push_back({Member::What::one, node, 0, 1, {}, {}, place});
}

void TextBuilder::add_set_nodes(const std::string& set, std::int64_t first, std::int64_t last, std::int64_t step) {
  node_sets_[set].push_back({Member::What::range, first, last, step, {}, {}, {}});
}

void TextBuilder::add_set_nodes_of(const std::string& set, const std::string& other, TextPlace place) {
  node_sets_[set].push_back({Member::What::set, 0, 0, 1, {}, other, place});
}

void TextBuilder::add_set_element(const std::string& set, ElementId element, TextPlace place) {
  element_sets_[set].push_back({Member::What::one, element.id, 0, 1, element.ids, {}, place});
}

void TextBuilder::add_set_elements(const std::string& set, ElementId first, std::int64_t last, std::int64_t step) {
  element_sets_[set].push_back({Member::What::range, first.id, last, step, first.ids, {}, {}});
}

void TextBuilder::add_set_block(const std::string& set, std::int64_t block, TextPlace place) {
  element_sets_[set].push_back({Member::What::block, block, 0, 1, {}, {}, place});
}

void TextBuilder::add_set_elements_of(const std::string& set, const std::string& other, TextPlace place) {
  element_sets_[set].push_back({Member::What::set, 0, 0, 1, {}, other, place});
}

void TextBuilder::add_set_side(const std::string& set, ElementId element, TextSide face, TextPlace place) {
  side_sets_[set].push_back({element, face, {}, {}, 0, place});
}

void TextBuilder::add_set_sides_of(const std::string& set, const std::string& elements, TextSide face,
                                   TextPlace place) {
  side_sets_[set].push_back({{}, face, elements, {}, 0, place});
}

void TextBuilder::add_set_face(const std::string& set, std::span<const std::int64_t> nodes, TextPlace place) {
  Side side{{}, {}, {}, {}, nodes.size(), place};
  std::copy(nodes.begin(), nodes.end(), side.nodes.begin());
  side_sets_[set].push_back(side);
}

TextContents TextBuilder::finish(std::string kinds) { return TextLookup(*this, std::move(kinds)).look_up(); }

}  // namespace percuss
