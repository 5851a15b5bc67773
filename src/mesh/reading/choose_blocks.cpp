#include "src/mesh/reading/choose_blocks.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "src/deck/text/nearest_name.hpp"
#include "src/error.hpp"

namespace percuss {
namespace {

bool is_called(const FileBlock& block, const std::string& name) {
  return block.name == name || fmt::format("block_{}", block.id) == name;
}

/// Marks the elements of sets whose names are chosen.
std::vector<char> mark_elements(const MeshFile& file, const std::vector<std::string>& wanted) {
  std::vector<char> marks;
  for (const FileSet& set : file.element_sets()) {
    if (std::find(wanted.begin(), wanted.end(), set.name) == wanted.end()) continue;
    marks.resize(static_cast<std::size_t>(file.element_count()), 0);
    for (const std::int64_t element : file.read_element_set(set)) {
      if (element >= 1 && element <= file.element_count()) marks[static_cast<std::size_t>(element - 1)] = 1;
    }
  }
  return marks;
}

}  // namespace

Choice choose_blocks(const MeshFile& file, const std::vector<std::string>& wanted) {
  std::vector<std::string> known;
  for (const FileBlock& block : file.blocks()) known.push_back(block.name);
  for (const FileSet& set : file.element_sets()) known.push_back(set.name);
  for (const std::string& name : wanted) {
    const auto called = [&](const FileBlock& block) { return is_called(block, name); };
    if (std::none_of(file.blocks().begin(), file.blocks().end(), called) &&
        std::find(known.begin(), known.end(), name) == known.end()) {
      throw InputError(fmt::format("the file has no block '{}'{}", name, name_hint(name, known)));
    }
  }
  Choice choice;
  choice.elements = mark_elements(file, wanted);
  for (const FileBlock& block : file.blocks()) {
    const auto calls = [&](const std::string& name) { return is_called(block, name); };
    const auto first = static_cast<std::size_t>(block.first_element - 1),
               last = first + static_cast<std::size_t>(block.elements);
    const bool is_whole = wanted.empty() || std::any_of(wanted.begin(), wanted.end(), calls);
    if (is_whole && !choice.elements.empty()) std::fill(&choice.elements[0] + first, &choice.elements[0] + last, 1);
    const bool is_wanted =
        is_whole || (!choice.elements.empty() && std::find(&choice.elements[0] + first, &choice.elements[0] + last,
                                                           1) != &choice.elements[0] + last);
    if (is_wanted && block.elements > 0) choice.blocks.push_back(block);
  }
  return choice;
}

void check_kinds(const MeshFile& file, const std::vector<FileBlock>& chosen) {
  std::string problems, others;
  for (const FileBlock& block : chosen) {
    if (block.topology) continue;
    problems += fmt::format("{}block '{}' has {} elements of kind {} with {} nodes (only {} can be run)",
                            problems.empty() ? "" : "\n", block.name, block.elements, block.kind,
                            block.nodes_per_element, file.list_kinds());
  }
  if (problems.empty()) return;
  for (const FileBlock& block : file.blocks()) {
    if (block.topology && block.elements > 0) others += (others.empty() ? "" : ", ") + block.name;
  }
  if (!others.empty()) problems += fmt::format("; choose with blocks: [{}]", others);
  throw InputError(problems);
}

}  // namespace percuss
