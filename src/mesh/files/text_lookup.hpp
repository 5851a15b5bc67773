#pragma once
// From the ids that a text file names to places: nodes of elements, members of sets, faces by their nodes.

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "src/mesh/files/text_builder.hpp"

namespace percuss {

class TextLookup {
 public:
  TextLookup(TextBuilder& from, std::string kinds) : from_(from) { to_.kinds = std::move(kinds); }

  /// Takes what the builder has. Throws InputError.
  TextContents look_up();

 private:
  using Member = TextBuilder::Member;

  struct IdPlace {
    std::int64_t id = 0;
    IdSpace ids = IdSpace::elements;
    std::int64_t number = 0;  // from 1
    friend auto operator<=>(const IdPlace&, const IdPlace&) = default;
  };
  struct FacePlace {
    std::array<std::int64_t, 4> key{};  // numbers of its nodes, ascending; of a triangle the first is 0
    std::int64_t element = 0;           // number, from 1
    int face = 0;
    friend auto operator<=>(const FacePlace&, const FacePlace&) = default;
  };

  void number_nodes();
  std::int64_t find_node(std::int64_t id) const;  // from 1; 0: none
  std::int64_t find_element(ElementId id) const;
  /// Numbers for ids; what is unknown is a problem at the place. Returns whether all are known.
  bool find_nodes(std::span<std::int64_t> nodes, TextPlace place);
  void add_problem(TextPlace place, const std::string& text);
  void stop_at_problems() const;

  void sort_surfaces();
  void fill_blocks();
  void number_elements();
  std::size_t find_block(std::int64_t element) const;
  const Topology* topology_of(std::int64_t element) const;
  std::span<const std::int64_t> corners_of(std::int64_t element) const;
  void list_faces(const std::vector<char>& on_faces);
  void list_triangles(std::int64_t element, const std::vector<char>& on_faces);
  std::vector<char> mark_nodes_of_faces() const;
  FileSide find_face(
      const std::array<std::int64_t, 4>& nodes) const;  // numbers, of a triangle the last is 0; {0, 0}: none
  static std::array<std::int64_t, 4> make_key(std::array<std::int64_t, 4> nodes);

  void average_thicknesses();
  bool has_other_kinds() const;
  void fill_node_sets();
  void fill_element_sets();
  void fill_side_sets();
  void add_members(const std::string& set, const std::vector<Member>& members, bool of_nodes, int depth,
                   std::vector<std::int64_t>& numbers);
  /// Adds the elements of blocks of this name; returns whether there are such.
  bool add_blocks(const std::string& name, std::vector<std::int64_t>& numbers) const;
  void add_sides(const TextBuilder::Side& side, std::vector<FileSide>& sides);
  FileSet describe_set(const std::string& name, std::size_t entries) const;

  TextBuilder& from_;
  TextContents to_;
  std::vector<IdPlace> node_numbers_, element_numbers_;  // ascending
  std::vector<FacePlace> faces_;                         // ascending, of nodes that are requested
  std::vector<std::string> problems_;
  std::size_t problem_count_ = 0, lost_faces_ = 0;
};

}  // namespace percuss
