#pragma once
// The accelerometers that a deck names in output.history.accelerometers: the acceleration of a node along axes that
// move with three nodes.
//
// A step from n to n+1 changes the velocity from n-1/2 to n+1/2 by the acceleration at n. This change is turned into
// the axes of the positions at n and added up, step by step: no acceleration between rows is lost, and none is turned
// by axes of another time. A row tells the sum, and its change since the last row over the time between the velocities.

#include <array>
#include <vector>

#include "src/mesh/ordering.hpp"
#include "src/output/checkpoint/checkpoint_archive.hpp"
#include "src/step/model/action.hpp"

namespace percuss {

/// Unit vectors along x, y and z.
using LocalAxes = std::array<Vec3, 3>;

/// x from the first place to the second, z across it and the third; is_given: whether the places are not on a line.
struct FoundAxes {
  LocalAxes axes{};
  bool is_given = false;
};
FoundAxes find_local_axes(const Vec3& origin, const Vec3& along_x, const Vec3& in_plane);

class Accelerometers : public Action {
 public:
  /// Collective. Throws InputError with the deck's place, the same on all ranks, for nodes on a line. deck outlives
  /// this.
  Accelerometers(const Deck& deck, const ChunkedMesh& chunked, const Model& model);

  bool comes_between() const override { return false; }

  /// Notes places at n and velocities at n-1/2.
  void begin_step(const State& state, const StepTimes& times) override;

  /// Adds the change of the velocities; one message a step.
  void move(State& state, const StepTimes& times) override;

  /// One that the checkpoint does not have begins with nothing at resume().
  void archive(CheckpointArchive& archive, State& state) override;
  void resume(const State& state) override;

  std::vector<HistoryColumn> list_columns() const override;
  /// Appends the same values on every rank.
  void append_values(const State& state, std::vector<double>& row) override;

 private:
  struct Nodes {
    std::array<int, 3> nodes{-1, -1, -1};  // of this rank, -1: of another
    bool removes_gravity = false;
  };
  struct Sums {
    LocalAxes axes{};              // of the last step; kept where the nodes are on a line
    Vec3 change{}, at_last_row{};  // of the velocity, along the axes, since the start
    double last_row = 0;           // time of the velocity there
    bool is_new = false;           // the checkpoint does not have it
  };
  static constexpr std::size_t values_each = 12;  // three places, and the change of the first velocity

  void note_places(const Rows3<double>& x);
  void share_values();
  Vec3 value(std::size_t accelerometer, std::size_t which) const;

  const Deck& deck_;
  Communicator ranks_;
  std::vector<Nodes> nodes_;
  std::vector<Sums> sums_;
  std::vector<double> values_;  // [accelerometers][values_each] of this rank, zeros of others; then of all
};

}  // namespace percuss
