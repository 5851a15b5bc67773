#pragma once
// Forces of contact and of walls that the deck requests, booked step by step until they are taken.

#include <optional>
#include <vector>

#include "kernels/contact/enforcement/force_sums.hpp"
#include "src/contact/enforcement/force_surfaces.hpp"
#include "src/contact/enforcement/node_areas.hpp"
#include "src/contact/enforcement/row_exchange.hpp"
#include "src/deck/deck.hpp"
#include "src/mesh/ordering.hpp"
#include "src/output/checkpoint/checkpoint_archive.hpp"

namespace percuss {

/// Impulse on one side since the force was last taken.
struct ContactImpulse {
  Vec3 impulse{}, moment{};           // [force x time], [force x length x time]
  double normal = 0, tangential = 0;  // magnitudes of pushes and of friction, added up [force x time]
  double area = 0;   // of the nodes of the side, each for the time in which it was pushed [area x time]
  double press = 0;  // largest impulse of pushes on a node over its area [stress x time]
};

/// Rows of a step that are solved.
struct SolvedRows {
  const RowSystem& system;
  const Array<const std::int64_t>& node_numbers;  // [mesh nodes]
  RowExchange& exchange;
  const Rows3<const double> x;  // [mesh nodes] at n
  double dt;
};

class ContactForces {
 public:
  /// Collective over `ranks`, which hold the mesh together. A node that parts share belongs to the part of the lowest
  /// chunk that uses it.
  /// Both outlive this.
  ContactForces(const Deck& deck, const ChunkedMesh& chunked, const Communicator& ranks);

  /// The contact surface, before the first step and whenever it is redefined. Throws InputError, on all ranks, for
  /// unknown surfaces. Collective.
  void set_surface(const ContactRanks& ranks, const SurfaceShare& share);

  bool is_empty() const { return sums_.empty(); }

  /// Adds the impulses of this rank's rows. Collective.
  void book(const WorkSpace& space, const SolvedRows& solved);

  /// A force that the checkpoint does not have begins with nothing.
  void archive(CheckpointArchive& archive);

  /// The forces of contact and walls in the order of the deck; they begin anew. Collective.
  std::vector<ContactImpulse> take(const AreaNodes& nodes);

 private:
  void lay_out(const std::vector<std::uint32_t>& one);
  bool names_surfaces() const;
  void archive_books(CheckpointArchive& archive, std::size_t force);
  void sum_areas(const AreaNodes& nodes, std::vector<ContactImpulse>& taken);

  const Deck& deck_;
  const ChunkedMesh& chunked_;
  Communicator ranks_;
  ForceSides sides_;
  std::vector<ForceDeck> forces_;
  std::vector<std::uint32_t> one_;         // [chunks of the whole mesh] ForceSides::one
  std::vector<int> part_of_chunk_;         // likewise
  std::optional<ForceSurfaces> surfaces_;  // none: no force names a surface
  std::vector<std::string> names_;         // identify() of each force
  std::vector<Point3> about_;              // likewise
  std::vector<ForceSums> sums_;            // likewise; this rank's share
  Array<RowSides> marks_ = Array<RowSides>("contact::row_sides", 0);
  PushBooks books_;
  std::vector<ChunkRows> book_rows_;  // [forces] of the books
  Array<NormalPush> sent_ = Array<NormalPush>("contact::sent_pushes", 0);
  Array<NormalPush> remote_ = Array<NormalPush>("contact::remote_pushes", 0);
  Array<AreaSums> area_partial_ = Array<AreaSums>("contact::area_sums", 0);
  Array<ForceSums> partial_ = Array<ForceSums>("contact::force_sums", 0);
};

}  // namespace percuss
