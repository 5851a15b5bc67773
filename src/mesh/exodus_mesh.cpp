#include "src/mesh/exodus_mesh.hpp"
#include "src/error.hpp"
namespace percuss {
PartMesh read_exodus_mesh(const ExodusMesh& source) {
  throw SystemError(source.file + ": Exodus II files cannot be read yet");
}
}  // namespace percuss
