#pragma once
// The detailed check in the contact decomposition, in every step: its input comes from the FE owners, its result goes
// back to them.
//
// After a search the rank requests from the FE owners the motion and the contact history that the check of the
// candidate pairs reads. Until the next request, a step sends only these and the touches that go back. Nodes and faces
// far from any contact are not sent at all. Where near pairs are listed, only theirs are sent.

#include "src/contact/check/check_space.hpp"
#include "src/contact/ranks/motion_copy.hpp"
#include "src/contact/surface/number_map.hpp"

namespace percuss {

/// The surface that a rank knows in the contact decomposition, in numbers of its own.
struct KnownSurface {
  std::vector<std::int64_t> nodes;  // numbers, ascending
  std::vector<FaceTopology> faces;  // ascending
  std::vector<int> searched_nodes;  // places in `nodes`, ascending
};

/// All calls but space(), narrow() and the counts are collective.
class RankedCheck {
 public:
  /// Size of a touch on its way to the FE owner of its node.
  static constexpr int touch_bytes = 192;

  /// The share and the exchange outlive this.
  RankedCheck(const ContactRanks& ranks, const SurfaceShare& share, DataExchange& data, bool keeps_still);

  /// Takes a surface into use and names its nodes to their FE owners. Throws MpiError.
  void take_surface(KnownSurface known, const ContactSurface& surface, UnstructuredExchange& exchange);

  /// A search has listed other candidate pairs, so many on all ranks: requests the input of their check from the FE
  /// owners.
  void begin_pairs(std::int64_t total_pairs);

  /// ContactFinder::narrow().
  void narrow(const NearWay& way);

  /// Checks the candidate pairs here: of nodes that this rank owns in the contact decomposition.
  void check(const SurfaceMotion& motion, const ContactHistory& history);

  /// Sends the touches of the last check to the FE owners. Returns the touches of the contact nodes that this rank owns
  /// there, by (node, face). Corners that other ranks own are numbered as foreign nodes.
  std::vector<RowTouch> send_results_to_fe_owners();

  /// ContactFinder::request_near_pairs().
  void request_near_pairs();

  std::vector<Penetration> find_penetrations(const SurfaceMotion& motion);
  std::vector<PartGap> find_gaps(const SurfaceMotion& motion);

  /// The surface with its candidate pairs, which a search fills in.
  CheckSpace& space() { return space_; }
  const CheckSpace& space() const { return space_; }

  /// Index of a contact node that this rank owns in the FE decomposition, by its number; -1: of another.
  int find_contact_node(std::int64_t number) const { return contact_nodes_.find(number); }

  Traffic traffic() const { return history_data_.traffic(); }

 private:
  /// A touch on its way to the FE owner of its node.
  struct TouchRecord;

  /// Data of the check of a list of pairs.
  struct CheckPart {
    MotionPart motion;
    ItemPart history;                                 // of searched nodes
    Array<int> history_rows;                          // in messages: nodes of the surface
    Array<int> own_history_rows, own_history_places;  // of this rank itself: nodes, and contact nodes of the share
    Array<int> published_history;                     // contact nodes of the share
  };

  CheckPart select(const CandidateList& pairs, const CheckPart* among);
  SurfaceMotion receive(const SurfaceMotion& motion, const ContactHistory& history);
  std::vector<TouchRecord> list_touches() const;
  template <class Record>
  std::vector<Record> send_to_fe_owners(const CheckPart& part, std::vector<Record> records);
  std::vector<RowTouch> make_row_touches(std::vector<TouchRecord> records) const;

  ContactRanks ranks_;
  const SurfaceShare& share_;
  const NumberMap contact_nodes_;  // contact nodes that this rank owns in the FE decomposition
  DataExchange& data_;
  DataExchange history_data_;
  CheckSpace space_;
  KnownSurface known_;
  MotionCopy motion_;
  RemoteItems history_;           // of searched nodes, from their FE owners
  std::int64_t total_pairs_ = 0;  // of all ranks

  // Requests to other ranks: for all pairs, for those that can come near before the next search, for the near ones.
  CheckPart of_all_, of_reachable_, of_near_;
  const CheckPart *base_ = &of_all_, *read_ = &of_all_;  // where no near pairs are listed, and in the next check
  NearWay asked_;                                        // of lists that the next check makes
  Array<int> wanted_ = Array<int>("contact::wanted_nodes", 0);
};

}  // namespace percuss
