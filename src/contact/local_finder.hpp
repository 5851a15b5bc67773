#pragma once
// One rank has the whole surface: search and check run on the arrays of the mesh, and nothing is sent.

#include "src/contact/check_space.hpp"
#include "src/contact/contact_finder.hpp"

namespace percuss {

/// The contact surface in the numbers of the mesh, of which the share is all.
ContactSurface make_whole_surface(const SurfaceShare& share);

class LocalFinder : public ContactFinder {
 public:
  explicit LocalFinder(const SurfaceShare& share);

  std::int64_t search(const SurfaceMotion& motion, double margin) override;
  int check(const SurfaceMotion& motion, const ContactHistory& history, Array<RowTouch>& touches) override;
  std::vector<Penetration> find_penetrations(const SurfaceMotion& motion) override;
  std::vector<int> node_ranks() const override;
  DecompositionReport report() const override { return {}; }
  SearchLoad load() const override;
  PhaseClock decomposition_clock() const override { return {}; }
  Traffic traffic() const override { return {}; }

 private:
  const SurfaceShare& share_;
  CheckSpace check_;
  Array<const std::int64_t> node_numbers_;  // [contact nodes]
  Boxes boxes_;
  SearchScratch scratch_;
};

}  // namespace percuss
