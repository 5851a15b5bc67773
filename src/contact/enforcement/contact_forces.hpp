#pragma once
// Forces of contact and of walls that the deck asks for, booked step by step until they are taken.

#include <vector>

#include "kernels/contact/enforcement/force_sums.hpp"
#include "src/deck/deck.hpp"
#include "src/mesh/ordering.hpp"
#include "src/output/checkpoint/checkpoint_archive.hpp"

namespace percuss {

/// What one side got since the force was last taken.
struct ContactImpulse {
  Vec3 impulse{}, moment{};           // [force x time], [force x length x time]
  double normal = 0, tangential = 0;  // magnitudes of pushes and of friction, added up [force x time]
};

class ContactForces {
 public:
  /// Collective over `ranks`, which hold the mesh together. A node that parts share belongs to the part of the lowest
  /// chunk that uses it.
  ContactForces(const Deck& deck, const ChunkedMesh& chunked, const Communicator& ranks);

  bool is_empty() const { return sums_.empty(); }

  /// Adds the impulses of this rank's rows, which are solved. node_numbers: [mesh nodes].
  template <class Space>
  void book(const Space& space, const RowSystem& system, const Array<const std::int64_t>& node_numbers);

  /// A force that the checkpoint does not have begins with nothing.
  void archive(CheckpointArchive& archive);

  /// The forces of contact and walls in the order of the deck; they begin anew. Collective.
  std::vector<ContactImpulse> take();

 private:
  Communicator ranks_;
  ForceSides sides_;
  std::vector<std::string> names_;  // identify() of each force
  std::vector<Point3> about_;       // likewise
  std::vector<ForceSums> sums_;     // likewise; this rank's share
  Array<RowSides> marks_ = Array<RowSides>("contact::row_sides", 0);
  Array<ForceSums> partial_ = Array<ForceSums>("contact::force_sums", 0);
};

}  // namespace percuss
