#pragma once
// VEXTERNALDB: what code of a user does at moments of the run, if its library has the subroutine.

#include <cstdint>
#include <string>
#include <vector>

#include "src/deck/deck.hpp"

namespace percuss {

/// Moments by the numbers of Abaqus.
enum class RunMoment {
  start_of_analysis,
  start_of_step,
  setup_of_increment,
  start_of_increment,
  end_of_increment,
  end_of_step,
  end_of_analysis
};

/// The state that the code gets.
struct RunState {
  std::int64_t nodes = 0, elements = 0;  // of the whole mesh
  std::int64_t increment = 0;
  double time = 0, dt = 0;
};

/// The subroutines of the libraries of a deck.
class UserDatabases {
 public:
  explicit UserDatabases(const Deck& deck);

  bool any() const { return !all_.empty(); }

  /// Calls all; returns the library of the first that requests the end of the run, or an empty text.
  std::string call(RunMoment moment, const RunState& state) const;

 private:
  struct Entry {
    std::string file;
    void* place;
    std::vector<double> step_starts;
  };
  std::vector<Entry> all_;
};

}  // namespace percuss
