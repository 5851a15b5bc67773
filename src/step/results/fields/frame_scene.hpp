#pragma once
// The scene of the frames, where they go, and the part of the mesh that an output of fields shows.

#include <memory>
#include <string>

#include "src/contact/contact_stage.hpp"
#include "src/output/frame/field_region.hpp"
#include "src/step/model/model.hpp"

namespace percuss {

struct FrameScene {
  const Deck& deck;
  const ChunkedMesh& chunked;
  const Model& model;
  const ContactStage& contact;
  const std::string& directory;
};

/// The region that an output of fields shows; none: the whole mesh. Of a mesh from which nothing has eroded. Throws
/// InputError, with the place in the deck, for a name that is unknown or that means nothing. Collective.
std::unique_ptr<FieldRegion> find_field_region(const Deck& deck, const FieldsDeck& fields, const ChunkedMesh& chunked,
                                               const Communicator& ranks);

/// The mesh of its files.
inline const ChunkedMesh& find_shown(const FrameScene& scene, const FieldRegion* region) {
  return region == nullptr ? scene.chunked : region->chunked;
}

}  // namespace percuss
