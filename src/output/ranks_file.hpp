#pragma once
// ranks.csv: what each rank held, worked and sent, a row a rank (docs/output.md).

#include <cstdint>
#include <span>
#include <string>

#include "src/output/summary.hpp"

namespace percuss {

/// Row of a rank in ranks.csv.
struct RankRow {
  int rank = 0;
  std::int64_t elements = 0, nodes = 0;               // of the FE decomposition; copies of nodes included
  std::int64_t contact_nodes = 0, contact_faces = 0;  // of the contact decomposition, at the last search
  PhaseSeconds compute;                               // CPU seconds of the loop without waits for other ranks
  double compute_loop = 0;                            // CPU seconds of the whole loop, between phases too
  double halo_messages = 0, halo_bytes = 0;           // sent to other ranks, per step
  double contact_messages = 0, contact_bytes = 0;
};

/// Replaces the file at `path` by a heading and these rows. Throws SystemError.
void write_ranks(const std::string& path, std::span<const RankRow> rows);

}  // namespace percuss
