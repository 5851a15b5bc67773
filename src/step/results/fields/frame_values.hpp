#pragma once
// The fields of a frame by their names: where each is from.

#include <string>
#include <vector>

#include "src/contact/contact_stage.hpp"
#include "src/output/frame/field_region.hpp"
#include "src/output/frame/frame_fields.hpp"
#include "src/step/model/model.hpp"
#include "src/step/model/state.hpp"
#include "src/step/results/fields/element_fields.hpp"

namespace percuss {

/// Data from which the fields of a frame are made.
struct FrameSource {
  const Model& model;
  const State& state;
  const ContactStage& contact;
  const FieldRegion* region;  // none: the whole mesh
  const std::vector<double>&body, &chunk;
  std::vector<double> stresses{};  // where a field requests them

  ElementChoice elements() const { return region == nullptr ? ElementChoice() : ElementChoice(region->elements); }
  const std::vector<int>* nodes() const { return region == nullptr ? nullptr : &region->nodes; }
  std::size_t element_count() const {
    return region == nullptr ? static_cast<std::size_t>(model.element_count) : region->elements.size();
  }
  /// Values of the nodes in the output region. values: one per node of this rank.
  std::vector<double> choose_nodes(std::vector<double> values) const;
};

/// Rows of nodes: of all, or of some in their order.
std::vector<double> list_rows(const Rows3<double>& rows, const std::vector<int>* nodes);

/// Finds the values of a field. field: out, without them.
std::vector<double> find_field(const std::string& name, const FrameSource& of, FieldData& field);

}  // namespace percuss
