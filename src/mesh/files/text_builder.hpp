#pragma once
// Collects a mesh by the ids of a text file, in whatever order the file has it, and looks the ids up at the end.

#include <array>
#include <cstdint>
#include <map>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "src/mesh/files/text_mesh.hpp"
#include "src/mesh/files/text_source.hpp"

namespace percuss {

/// Where an id of an element counts: in some formats a solid and a shell may have the same.
enum class IdSpace : std::uint8_t { elements, shells, beams };

/// Properties that the elements of a block share.
struct TextKind {
  std::string name;                      // as the format calls it
  std::optional<TopologyKind> topology;  // none: they cannot be run, and are added without nodes
  std::int64_t nodes = 0;                // of an element of this kind
  IdSpace ids = IdSpace::elements;
};

/// Where an element is named: its own line, or that of a set.
struct ElementId {
  std::int64_t id = 0;
  IdSpace ids = IdSpace::elements;
};

/// A side of an element as a face of its topology, for each topology that has faces, from 0.
struct TextSide {
  static constexpr int missing = -1, left_out = -2;  // an error; all faces of a set are named one by one
  int of_hexahedron = missing, of_shell = missing, of_tetrahedron = missing, of_wedge = missing, of_pyramid = missing;

  int find(const Topology& topology) const {
    switch (topology.family) {
      case ElementFamily::hexahedra:
        return of_hexahedron;
      case ElementFamily::shells:
        return of_shell;
      case ElementFamily::tetrahedra:
        return of_tetrahedron;
      case ElementFamily::wedges:
        return of_wedge;
      case ElementFamily::pyramids:
        return of_pyramid;
      case ElementFamily::beams:
        break;
    }
    return left_out;
  }
};

class TextBuilder {
 public:
  TextNames names;

  void add_node(std::int64_t id, const Vec3& x, TextPlace place);

  /// The block of this name and kind; made when it is first requested.
  int find_block(const std::string& name, std::int64_t id, const TextKind& kind);
  void rename_blocks(std::int64_t id, const std::string& name);

  /// nodes: ids, as many as the kind of the block has; none if it cannot be run.
  void add_element(int block, std::int64_t id, std::span<const std::int64_t> nodes, TextPlace place);

  /// Sets the thickness of the last element of a block [length].
  void set_thickness(int block, double thickness);
  /// Sets the thickness of an element by its place in the block.
  void set_thickness(int block, std::size_t element, double thickness);
  /// Sets the thickness of the shells of all blocks with this id that have none yet [length].
  void fill_thickness(std::int64_t id, double thickness);
  /// Sets the thickness at a node, or at all nodes of a set; a later one counts.
  void add_node_thickness(std::int64_t node, double thickness, TextPlace place);
  void add_node_thickness_of(const std::string& set, double thickness, TextPlace place);
  /// The elements of a set, or of the blocks of that name, have the mean thickness of their nodes.
  void average_thickness_of(const std::string& set, TextPlace place);

  /// An element of a named surface, of three or four nodes. Where all of a surface lie on faces of solids they are a
  /// side set, else a block of shells.
  void add_surface_element(const std::string& surface, const TextKind& kind, ElementId id,
                           std::span<const std::int64_t> nodes, TextPlace place);
  void name_surface(const std::string& surface, std::int64_t id) { surfaces_[surface].id = id; }

  // Members of sets, which exist from the first on; step: of a range of ids, of which only those that exist count.
  void add_set_node(const std::string& set, std::int64_t node, TextPlace place);
  void add_set_nodes(const std::string& set, std::int64_t first, std::int64_t last, std::int64_t step);
  void add_set_element(const std::string& set, ElementId element, TextPlace place);
  void add_set_elements(const std::string& set, ElementId first, std::int64_t last, std::int64_t step);
  /// All elements of the blocks with this id.
  void add_set_block(const std::string& set, std::int64_t block, TextPlace place);
  /// All members of another set of elements (nodes), or of the blocks of that name.
  void add_set_elements_of(const std::string& set, const std::string& other, TextPlace place);
  void add_set_nodes_of(const std::string& set, const std::string& other, TextPlace place);
  void add_set_side(const std::string& set, ElementId element, TextSide face, TextPlace place);
  /// Adds a side of all elements of a set, or of the blocks of that name.
  void add_set_sides_of(const std::string& set, const std::string& elements, TextSide face, TextPlace place);
  /// A face of three or four nodes.
  void add_set_face(const std::string& set, std::span<const std::int64_t> nodes, TextPlace place);
  void number_set(const std::string& set, std::int64_t id) { set_ids_[set] = id; }

  void add_note(std::string note) { notes_.push_back(std::move(note)); }

  /// Looks all ids up. kinds: names of the elements that can be run. Throws InputError with the first problems, each
  /// with its line.
  TextContents finish(std::string kinds);

 private:
  friend class TextLookup;

  struct Block {
    FileBlock head;
    TextKind kind;
    std::vector<std::int64_t> nodes, ids;
    std::vector<double> thicknesses;  // [elements] 0: none; empty, or shorter: none of the rest
    std::vector<TextPlace> places;
  };
  struct SurfaceElement {
    TextKind kind;
    ElementId id;
    std::array<std::int64_t, 4> nodes{};
    std::size_t count = 0;
    TextPlace place;
  };
  struct Surface {
    std::int64_t id = 0;
    std::vector<SurfaceElement> elements;
  };
  /// Member of a set: one id, a range of them, a block or another set.
  struct Member {
    enum class What : std::uint8_t { one, range, block, set };
    What what = What::one;
    std::int64_t id = 0, last = 0, step = 1;
    IdSpace ids = IdSpace::elements;
    std::string set;
    TextPlace place;
  };
  /// Side of a side set: a face of an element, of all elements of a set, or one by its nodes.
  struct Side {
    ElementId element;
    TextSide face;
    std::string set;
    std::array<std::int64_t, 4> nodes{};
    std::size_t count = 0;  // of nodes
    TextPlace place;
  };

  struct NodeThickness {
    std::vector<Member> nodes;
    double thickness = 0;
  };

  std::vector<Vec3> nodes_;
  std::vector<NodeThickness> node_thicknesses_;
  std::vector<Member> averaged_;  // elements that have those of their nodes
  std::vector<std::int64_t> node_ids_;
  std::vector<TextPlace> node_places_;
  std::vector<Block> blocks_;
  std::map<std::pair<std::string, std::string>, int> block_places_;  // by name and kind
  std::map<std::string, Surface> surfaces_;
  std::map<std::string, std::vector<Member>> node_sets_, element_sets_;
  std::map<std::string, std::vector<Side>> side_sets_;
  std::map<std::string, std::int64_t> set_ids_;
  std::vector<std::string> notes_;
};

}  // namespace percuss
