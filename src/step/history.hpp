#pragma once
// The rows of history.csv: energies, momentum, step, contact, and the nodes and elements that the deck chose.

#include <string>
#include <vector>

#include "src/output/history_file.hpp"
#include "src/step/audit.hpp"
#include "src/step/step.hpp"

namespace percuss {

/// A node or element that the deck follows.
struct FollowedPoint {
  std::string name;
  bool is_element = false;
  int index = 0;  // node or element of the mesh
};

/// Finds the deck's history points: the nearest node or element centre, lowest index among equals, or the one with the
/// id. Throws InputError with the deck's place.
std::vector<FollowedPoint> find_history_points(const Deck& deck, const Mesh& mesh);

class History {
 public:
  /// Creates history.csv in the directory. Throws SystemError, InputError.
  History(const std::string& directory, const Deck& deck, const Mesh& mesh);

  void write(const Model& model, const State& state, const AuditResult& audit, const ContactReport& contact,
             const Vec3& wall_force);
  void flush() { file_.flush(); }

 private:
  const Mesh& mesh_;
  bool has_walls_;
  std::vector<FollowedPoint> points_;
  HistoryFile file_;
};

}  // namespace percuss
