#pragma once
// Areas of the contact surface by node, at any positions: of faces around the owned contact nodes, on whatever ranks.

#include <utility>
#include <vector>

#include "comm/exchange/data_exchange.hpp"
#include "kernels/contact/enforcement/force_sums.hpp"
#include "src/contact/ranks/remote_items.hpp"
#include "src/contact/surface/contact_ranks.hpp"
#include "src/contact/surface/surface_share.hpp"

namespace percuss {

class NodeAreas {
 public:
  /// Areas of a surface until it is redefined. share outlives this. Collective, as is update(). Throws MpiError.
  NodeAreas(const ContactRanks& ranks, const SurfaceShare& share);

  /// Computes the areas at positions x: [mesh nodes].
  void update(const Rows3<const double>& x);

  /// Values of all faces around the owned nodes. of_own: [faces of the share] of this rank's. Returns [faces of the
  /// share, foreign faces]; particles have T{}. Collective.
  template <class T>
  std::vector<T> extend_to_foreign(std::vector<T> of_own) {
    std::vector<T> all = std::move(of_own), sent;
    all.resize(areas_.extent(0));
    if (!has_many_ranks_) return all;
    for (const int face : foreign_.all().published) sent.push_back(all[static_cast<std::size_t>(face)]);
    const std::vector<T> received = data_.exchange(reverse(foreign_.all().request), sent);
    for (std::size_t k = 0; k < received.size(); ++k) {
      const auto asked = static_cast<std::size_t>(foreign_.all().asked[k]);
      all[static_cast<std::size_t>(places_[asked])] = received[k];
    }
    return all;
  }

  /// [owned contact nodes] as updated last.
  const AreaNodes& nodes() const { return nodes_; }

 private:
  void receive_areas();

  bool has_many_ranks_;
  DataExchange data_;
  RemoteItems foreign_;
  std::vector<int> places_;  // [requested faces] in areas_
  int num_own_ = 0;
  Rows4<int> corners_ = Rows4<int>("contact::area_corners", 0);
  Rows3<double> areas_ = Rows3<double>("contact::corner_areas", 0);  // own faces, then those that other ranks have sent
  AreaNodes nodes_;
};

}  // namespace percuss
