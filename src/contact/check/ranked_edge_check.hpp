#pragma once
// The check of edge pairs in the contact decomposition, in every step: motion and history come from homes, touches go
// back. The home of an edge A, where its first face is, stores its contact history and has its rows.

#include "src/contact/check/edge_space.hpp"
#include "src/contact/ranks/motion_copy.hpp"

namespace percuss {

/// All calls but space() are collective.
class RankedEdgeCheck {
 public:
  /// The share outlives this.
  RankedEdgeCheck(const ContactRanks& ranks, const SurfaceShare& share, bool keeps_still);

  /// A search has listed other pairs among `edges`, those of space(), so many on all ranks: keeps the edges of pairs,
  /// and requests the motion of their nodes and their contact history. Throws MpiError.
  void take_pairs(const std::vector<EdgeTopology>& edges, std::int64_t total_pairs, UnstructuredExchange& exchange,
                  DataExchange& data);

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

  std::vector<std::int64_t> keep_paired_edges(const std::vector<EdgeTopology>& edges);
  void name_history(UnstructuredExchange& exchange, DataExchange& data);
  EdgeHistory receive_history(const EdgeHistory& history, DataExchange& data);
  template <class Record>
  std::vector<Record> send_results_to_homes(DataExchange& data, std::vector<Record> records) const;
  std::vector<TouchRecord> list_touches() const;
  RowTouch make_row_touch(const TouchRecord& record, int& foreign) const;

  ContactRanks ranks_;
  const SurfaceShare& share_;
  EdgeSpace space_;
  std::vector<EdgeTopology> edges_;  // in pairs, ascending in number
  std::int64_t total_pairs_ = 0;     // of all ranks
  MotionCopy motion_;
  MotionPart read_;
  RemoteItems history_;  // records of the paired edges
};

}  // namespace percuss
