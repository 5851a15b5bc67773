#pragma once
// The rows of history.csv: energies, momentum, step, contact, and the nodes and elements that the deck chose.

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "src/output/history_file.hpp"
#include "src/step/audit/block_energies.hpp"
#include "src/step/audit/part_energies.hpp"
#include "src/step/audit/part_motions.hpp"
#include "src/step/model/followed_points.hpp"
#include "src/step/results/history_table.hpp"

namespace percuss {

/// Data from which the columns follow.
struct HistoryScene {
  const Deck& deck;
  const ChunkedMesh& chunked;
  const Stepper& stepper;
};

class History {
 public:
  /// Makes rows, without a directory only in memory. Else creates history.csv and columns.json in the directory, or
  /// continues with the history.csv of an earlier run behind its first `bytes`: rank 0 writes. Collective. Throws
  /// SystemError, InputError, the same on all ranks.
  History(const std::string& directory, const HistoryScene& scene, std::optional<std::int64_t> bytes = std::nullopt);

  /// Throws on all ranks what that would throw, and changes nothing. Collective.
  static void check(const std::string& directory, const HistoryScene& scene, std::int64_t bytes);

  /// Throws InputError, on all ranks, for a point of the deck that the mesh does not have. Collective.
  static void check_points(const Deck& deck, const ChunkedMesh& chunked, const Model& model);

  /// Collective.
  static std::vector<HistoryColumn> list_columns(const HistoryScene& scene);

  /// The last row, on rank 0.
  const std::vector<double>& row() const { return row_; }

  /// Collective. Throws SystemError on all ranks if rank 0 cannot write.
  void write(const Model& model, const HistorySources& sources);
  /// Collective; throws likewise.
  void flush();
  /// Hands all rows to the system and returns the length of the file [byte]. Collective; throws likewise.
  std::int64_t find_length();
  /// Waits until the disk has all rows. Collective; throws likewise.
  void sync();
  /// Writes as above, and closes the file. Collective; throws likewise.
  void close();
  /// Whether the file still has its name: not if somebody removed or replaced it. Collective.
  bool is_in_place() const;

 private:
  void gather_points(const Model& model, const State& state, std::vector<double>& row) const;

  Communicator ranks_;
  HistoryTable table_;
  std::vector<FollowedPoint> points_;
  PartEnergies parts_;
  PartMotions motions_;
  BlockEnergies blocks_;
  bool has_sections_ = false;           // whether followed elements have the columns of beams
  std::vector<HistoryScalar> scalars_;  // columns of followed elements that only some materials fill
  int states_;                          // state variables of users' laws, likewise
  std::vector<double> row_;
  std::optional<HistoryFile> file_;  // of rank 0, if it has a directory
};

}  // namespace percuss
