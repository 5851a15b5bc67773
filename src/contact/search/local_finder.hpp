#pragma once
// One rank has the whole surface: search and check run on the arrays of the mesh. The steps of
// ContactFinder::search() and check() that send do nothing.

#include "kernels/contact/search/near_cells.hpp"
#include "src/contact/check/cell_list.hpp"
#include "src/contact/check/check_space.hpp"
#include "src/contact/search/contact_finder.hpp"
#include "src/contact/search/local_edges.hpp"

namespace percuss {

/// The contact surface in the numbers of the mesh, of which the share is all.
ContactSurface make_whole_surface(const SurfaceShare& share);

class LocalFinder : public ContactFinder {
 public:
  LocalFinder(const SurfaceShare& share, const ContactDeck& deck);
  /// make_look_finder()
  LocalFinder(const LocalFinder& of_run, const LookedAt& at);

  void narrow(const NearWay& way) override {
    if (!lists_near_) check_.near.ask(way);
    edges_.narrow(way);
  }
  bool has_found_nothing_new() const override {
    return check_.has_found_nothing_new() && edges_.has_found_nothing_new();
  }
  std::vector<Penetration> find_penetrations(const SurfaceMotion& motion) override;
  std::vector<EdgePenetration> find_edge_penetrations(const SurfaceMotion& motion) override;
  std::vector<PartGap> find_gaps(const SurfaceMotion& motion) override;
  std::vector<int> node_ranks() const override;
  DecompositionReport report() const override { return {}; }
  SearchLoad load() const override;
  PairCounts pair_counts() const override { return check_.counts; }
  void take_over(const ContactFinder& before) override;
  PhaseClock decomposition_clock() const override { return {}; }
  Traffic traffic() const override { return {}; }

  // Results of the last search and check.
  CheckSpace& faces() { return check_; }
  const Boxes& boxes() const { return boxes_; }  // [searched faces]
  LocalEdges& edges() { return edges_; }

  // Kernels of its own: nvcc takes none in a private function.
  int check_faces(const SurfaceMotion& motion, const ContactHistory& history);

 private:
  std::int64_t find_candidates(const SurfaceMotion& motion, double margin) override;
  void check_pairs(const SurfaceMotion& motion, const ContactHistory& history) override;
  int send_results_to_fe_owners(const ContactHistory& history, Array<RowTouch>& touches) override;

  std::int64_t search_faces(const SurfaceMotion& motion, double margin);

  const SurfaceShare& share_;
  CheckSpace check_;
  bool lists_near_ = false;  // with shells: of the pairs of a search cells say which are near enough to be checked
  CandidateList all_;        // of the last search
  CellList<NearCells, CandidateList> cells_;
  Array<const std::int64_t> node_numbers_;  // [contact nodes]
  int of_faces_ = 0, found_ = 0;            // touches of the last check: of nodes and faces, of all
  int found_before_ = 0;                    // by the check before it; -1: its touches may have been written over
  Boxes boxes_;
  SearchScratch scratch_;
  LocalEdges edges_;
};

}  // namespace percuss
