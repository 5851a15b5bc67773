#pragma once
// The check of edge pairs in the contact decomposition, in every step: motion and history come from homes, touches go
// back. The home of an edge A, where its first face is, stores its contact history and has its rows.

#include "src/contact/check/check_space.hpp"
#include "src/contact/check/edge_space.hpp"
#include "src/contact/ranks/motion_copy.hpp"

namespace percuss {

/// All calls but space() and narrow() are collective.
class RankedEdgeCheck {
 public:
  /// Size of a touch on its way to the home of its edge A, and of a contact that is remembered on its way from there.
  static constexpr int touch_bytes = 64 + sizeof(EdgeTouch), history_bytes = 40;

  /// The share outlives this.
  RankedEdgeCheck(const ContactRanks& ranks, const SurfaceShare& share, bool keeps_still);

  /// A search has listed other pairs among `edges`, those of space(), so many on all ranks: keeps the edges of pairs,
  /// and requests the motion of their nodes and their contact history. Throws MpiError.
  void take_pairs(const std::vector<EdgeTopology>& edges, std::int64_t total_pairs, UnstructuredExchange& exchange,
                  DataExchange& data);

  /// The next check lists the pairs that are near; from the one after it on only what these read is requested.
  void narrow(const NearWay& way);
  /// Requests what the near pairs read, after that check.
  void request_near_pairs(DataExchange& data);

  /// The detailed check of the pairs.
  void check(const SurfaceMotion& motion, const EdgeHistory& history, DataExchange& data);

  /// Results to the homes of edges: appends the touches of edges A whose home this rank is, by (A, B), to those of
  /// faces.
  void append_touches(const EdgeHistory& history, DataExchange& data, std::vector<RowTouch>& touches);

  std::vector<EdgePenetration> find_penetrations(const SurfaceMotion& motion, DataExchange& data);

  /// The edges with their pairs, which a search fills in.
  EdgeSpace& space() { return space_; }
  const EdgeSpace& space() const { return space_; }

 private:
  struct TouchRecord;

  /// Data of the check of a list of pairs.
  struct EdgePart {
    MotionPart motion;
    ItemPart history;  // of the edges A
  };

  std::vector<std::int64_t> keep_paired_edges(const std::vector<EdgeTopology>& edges);
  void name_history(UnstructuredExchange& exchange, DataExchange& data);
  EdgePart select(DataExchange& data) const;
  EdgeHistory receive_history(const EdgeHistory& history, DataExchange& data);
  template <class Record>
  std::vector<Record> send_results_to_homes(const EdgePart& part, DataExchange& data,
                                            std::vector<Record> records) const;
  std::vector<TouchRecord> list_touches() const;
  RowTouch make_row_touch(const TouchRecord& record, int& foreign) const;

  ContactRanks ranks_;
  const SurfaceShare& share_;
  EdgeSpace space_;
  std::vector<EdgeTopology> edges_;  // in pairs, ascending in number
  std::int64_t total_pairs_ = 0;     // of all ranks
  MotionCopy motion_;
  std::size_t num_nodes_ = 0;  // of these edges, rows of the motion
  RemoteItems history_;        // records of the paired edges
  EdgePart of_all_, of_near_;
  const EdgePart* read_ = &of_all_;  // in the next check
  bool asked_ = false;               // for a list that the next check makes
};

}  // namespace percuss
