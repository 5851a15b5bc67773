#include "src/step/results/fields/frame_scene.hpp"

#include <algorithm>

#include "src/mesh/surface_nodes.hpp"

namespace percuss {
namespace {

/// Faces of all selectors, each once.
std::vector<ElementFace> select_all_faces(const Mesh& mesh, const Deck& deck, const std::vector<Selector>& selectors) {
  std::vector<ElementFace> faces;
  const std::vector<ElementFace> exterior = find_exterior_faces(mesh);
  for (const Selector& selector : selectors) {
    const std::vector<ElementFace> selected = select_faces(mesh, deck, selector, exterior);
    faces.insert(faces.end(), selected.begin(), selected.end());
  }
  std::sort(faces.begin(), faces.end());
  faces.erase(std::unique(faces.begin(), faces.end()), faces.end());
  return faces;
}

}  // namespace

std::unique_ptr<FieldRegion> find_field_region(const Deck& deck, const FieldsDeck& fields, const ChunkedMesh& chunked,
                                               const Communicator& ranks) {
  const Mesh& mesh = chunked.mesh;
  if (!fields.is_of_region()) return nullptr;
  if (!fields.elements.empty())
    return make_field_region(chunked, list_marked_cells(mesh, mark_elements(mesh, deck, fields.elements)), ranks);
  return make_field_region(chunked, list_face_cells(mesh, select_all_faces(mesh, deck, fields.faces)), ranks);
}

}  // namespace percuss
