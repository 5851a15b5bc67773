#pragma once
// What a run tells its user besides its results: before the loop what its input and its ranks ask attention for, after
// it what the results must be read with. Words only; who says them is the run's business (run.cpp).

#include <vector>

#include "src/mesh/decompose.hpp"
#include "src/output/summary.hpp"
#include "src/warning.hpp"

namespace percuss {

/// Doubts about the mesh, ranks without elements.
std::vector<Warning> find_start_warnings(const ChunkedMesh& chunked, int rank_count);

/// Of a step whose contact enforcement did not converge.
Warning describe_unconverged(double time);

/// Contact that gave energy, and hourglass modes that hold more than a tenth of the internal energy. `summary` is that
/// of the run's end.
std::vector<Warning> find_end_warnings(const Summary& summary);

}  // namespace percuss
