#pragma once
// What a run tells its user besides its results: before the loop what its input and its ranks ask attention for, after
// it what the results must be read with. Words only; who says them is the run's business (run.cpp).

#include <string>
#include <vector>

#include "src/mesh/decompose.hpp"
#include "src/output/summary.hpp"
#include "src/step/model.hpp"

namespace percuss {

/// Steps whose contact enforcement did not converge.
struct UnconvergedSteps {
  long count = 0;
  long first = -1;  // number of the first such step
};

/// Doubts about the mesh, masses added by mass scaling, ranks without elements.
std::vector<std::string> find_start_notes(const ChunkedMesh& chunked, const Model& model, int rank_count);

/// Contact that was not enforced to its tolerance or gave energy, and hourglass modes that hold more than a tenth of
/// the internal energy. `summary` is that of the run's end.
std::vector<std::string> find_end_notes(const Summary& summary, const UnconvergedSteps& unconverged);

}  // namespace percuss
