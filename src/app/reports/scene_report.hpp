#pragma once
// What a scene is, in words: the answer of `percuss check`.

#include <cstdint>
#include <string>
#include <vector>

#include "src/deck/deck.hpp"
#include "src/mesh/ordering.hpp"
#include "src/output/history_columns.hpp"

namespace percuss {

/// A part, of all ranks together.
struct PartReport {
  std::string name, material;
  std::int64_t elements = 0, nodes = 0;
  double mass = 0;  // exact volume of its elements times density
};

/// An entry of output.field_outputs, of all ranks together.
struct FieldOutputSize {
  std::string name;
  std::int64_t elements = 0, nodes = 0;
};

struct SceneReport {
  const Deck& deck;
  std::vector<PartReport> parts = {};
  std::int64_t elements = 0, nodes = 0, bodies = 0;
  double total_mass = 0;                 // with masses that the deck adds, or gives to rigid bodies [mass]
  Vec3 low{}, high{};                    // box of all nodes [length]
  std::vector<Warning> warnings = {};    // of everything; on rank 0
  double first_step = 0;                 // time unit of the deck
  std::string controlling_element = {};  // that limits it, in words; a spring where that does
  double undamped_step = 0;              // first step without stiffness_damping, which makes it shorter; 0: it does not
  std::int64_t contact_nodes = 0, contact_faces = 0;
  std::vector<std::string> spring_notes = {};
  std::vector<std::string> mesh_notes = {};     // imperfections and added masses
  std::vector<std::string> contact_notes = {};  // what contact says of the start
  std::vector<std::string> joints = {};         // parts that share nodes, in words
  std::vector<FieldOutputSize> field_outputs = {};
  std::vector<HistoryColumn> columns = {};  // of history.csv; empty: the deck requests none
};

/// Report of the mesh: parts, counts and extent, of all ranks together. Collective. Throws MpiError.
SceneReport describe_scene(const Deck& deck, const ChunkedMesh& chunked);

/// "element 7 of part 'bar'"; number: in the whole mesh. Collective. Throws MpiError.
std::string describe_element(const ChunkedMesh& chunked, std::int64_t number);

/// Several lines: parts with elements, nodes and mass, bodies, contact, loads, output, the first time step, warnings.
std::string format_scene(const SceneReport& scene);

}  // namespace percuss
