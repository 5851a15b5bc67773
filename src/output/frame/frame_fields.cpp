#include "src/output/frame/frame_fields.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>
#include <stdexcept>

namespace percuss {
namespace {

const std::string displacement_name = "displacement";

}  // namespace

std::vector<int> find_owned_nodes(const ChunkedMesh& chunked, const Communicator& ranks) {
  std::vector<int> owned;
  if (ranks.size() == 1) return owned;
  const auto& numbers = chunked.mesh.node_numbers;
  for (std::size_t n = 0; n < numbers.size(); ++n) {
    if (chunked.numbering.find_node_owner(numbers[n]) == ranks.rank()) owned.push_back(static_cast<int>(n));
  }
  return owned;
}

std::vector<int> count_up(std::size_t count) {
  std::vector<int> items(count);
  std::iota(items.begin(), items.end(), 0);
  return items;
}

std::vector<FieldData> FrameFields::complete(std::span<const double> positions, std::span<const FieldData> given) {
  std::vector<FieldData> fields(given.begin(), given.end());
  const auto is_displacement = [](const FieldData& field) { return field.name == displacement_name; };
  if (std::none_of(fields.begin(), fields.end(), is_displacement)) {
    displacement_.resize(positions.size());
    for (std::size_t i = 0; i < positions.size(); ++i) displacement_[i] = positions[i] - initial_[i / 3][i % 3];
    fields.insert(fields.begin(), {displacement_name, FieldPlace::node, 3, displacement_});
  }
  check(fields);
  return fields;
}

void FrameFields::check(std::span<const FieldData> fields) {
  for (const auto& field : fields) {
    const std::size_t items = field.place == FieldPlace::node ? initial_.size() : elements_;
    if (field.values.size() != items * static_cast<std::size_t>(field.components))
      throw std::logic_error(fmt::format("field {} has {} values (it has {} components on {} items)", field.name,
                                         field.values.size(), field.components, items));
  }
  const bool same =
      std::equal(fields.begin(), fields.end(), known_.begin(), known_.end(), [](const FieldData& a, const Known& b) {
        return a.name == b.name && a.place == b.place && a.components == b.components;
      });
  if (!known_.empty() && !same)
    throw std::logic_error("a frame has other fields than the first one (every frame must have the same)");
  known_.clear();
  for (const FieldData& field : fields) known_.push_back({field.name, field.place, field.components});
}

}  // namespace percuss
