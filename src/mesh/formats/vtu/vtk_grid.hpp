#pragma once
// A mesh from the points, cells and arrays of a VTK unstructured grid, in whatever form a file has them: cells of one
// number in an array of blocks are a block.

#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <set>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "src/mesh/files/file_results.hpp"
#include "src/mesh/files/text_mesh.hpp"
#include "src/mesh/files/text_source.hpp"

namespace percuss {

/// An array of cells or points, which is read only where somebody requests it.
struct VtkArray {
  std::string name;
  std::int64_t components = 1;
  bool has_integers = false;
  // So many numbers. They throw InputError if the array has more or fewer, or others.
  std::function<std::vector<std::int64_t>(std::size_t)> read_integers;
  std::function<std::vector<double>(std::size_t)> read_reals;
};

/// Content of a file. Points count from 0.
struct VtkGrid {
  TextPlace place;  // of its cells, which errors name
  std::vector<Vec3> points;
  std::vector<std::int64_t> connectivity, types;
  std::vector<std::int64_t> ends;  // [cells] place in the connectivity behind the last point of each, ascending
  std::vector<VtkArray> of_points, of_cells;

  std::size_t cell_count() const { return types.size(); }
};

/// Makes the mesh of a grid. Throws InputError with the place of the grid, as the arrays do.
class VtkGridMesh {
 public:
  /// names and grid outlive this.
  VtkGridMesh(const TextNames& names, const VtkGrid& grid);

  std::unique_ptr<MeshFile> take_mesh();
  FileResults take_results(const ResultsWish& wish);

 private:
  struct Block {
    FileBlock head;
    std::vector<std::int64_t> nodes, ids;
    std::vector<double> thicknesses;
    std::vector<std::size_t> cells;  // of the grid
  };

  /// An array of results with the places of its rows, in the order of the mesh.
  struct ArrayRows {
    const VtkArray& array;
    std::size_t count;
    const std::vector<std::size_t>& rows;
    const std::vector<std::string>& wish;
  };

  void take_array(const ArrayRows& of, std::vector<std::string>& names, std::map<std::string, ResultsColumn>& columns);
  template <class Names>
  std::vector<std::int64_t> read_ids(const std::vector<VtkArray>& arrays, const Names& names, std::size_t count);
  std::vector<std::int64_t> number_points() const;
  int find_block(std::int64_t id, std::int64_t type, std::size_t nodes);
  void add_cell(std::size_t cell, std::int64_t block_id, std::span<const std::int64_t> points);
  void read();
  void finish_blocks();
  void note_arrays(std::size_t skipped);

  const TextNames& names_;
  const VtkGrid& grid_;
  std::set<std::string> known_;                                         // names of arrays that are read
  std::map<std::pair<std::int64_t, std::int64_t>, int> block_numbers_;  // by id and type of cells
  std::vector<Block> blocks_;
  TextContents to_;
};

}  // namespace percuss
