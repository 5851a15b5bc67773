#include "src/app/process/compute_session.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <set>

#include "src/app/process/threads.hpp"
#include "src/deck/mesh_size.hpp"
#include "src/fail_together.hpp"

namespace percuss {
namespace {

/// Bytes of a mesh file for an element: a line of a node and one of an element, as text. Binary files have fewer, but
/// not by far.
constexpr double bytes_of_element = 100;

/// Waits for each launch: on a device the host reads views between kernels (views.hpp).
void wait_for_launches() {
#ifdef PERCUSS_BACKEND_CUDA
  setenv("CUDA_LAUNCH_BLOCKING", "1", 1);
#endif
}

std::string choose_by_scene(const Communicator& ranks, const Deck& deck) {
  wait_for_launches();
  const double elements = estimate_elements(deck);
  std::string note;
  choose_threads(OwnedCommunicator::of_machine(ranks)->size(), [&](int available) {
    const int chosen = choose_thread_count(elements, ranks.size(), available);
    if (chosen < available)
      note = fmt::format(
          "threads: {} of {} cores{} (about {:.3g} elements, one thread for each {}; OMP_NUM_THREADS sets another "
          "number)",
          chosen, available, ranks.size() > 1 ? " a rank" : "", elements, elements_of_thread);
    return chosen;
  });
  fail_together(ranks, check_threads);
  return note;
}

}  // namespace

double estimate_elements(const Deck& deck) {
  double elements = 0;
  std::set<std::string> files;
  for (const PartDeck& part : deck.parts) {
    elements += count_cells(part).elements;
    const auto* mesh = std::get_if<FileMesh>(&part.shape);
    if (mesh == nullptr || !files.insert(mesh->file).second) continue;
    std::error_code unknown;  // whoever reads the mesh says so
    const auto bytes = std::filesystem::file_size(mesh->file, unknown);
    if (!unknown) elements += static_cast<double>(bytes) / bytes_of_element;
  }
  return elements;
}

int choose_thread_count(double elements, int ranks, int available) {
  const double wanted = std::ceil(elements / (elements_of_thread * ranks));
  return static_cast<int>(std::clamp(wanted, 1.0, static_cast<double>(std::max(1, available))));
}

ComputeSession::ComputeSession(const Communicator& ranks, const Deck& deck) : note_(choose_by_scene(ranks, deck)) {}

}  // namespace percuss
