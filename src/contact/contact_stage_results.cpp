#include <array>
#include <vector>

#include "comm/exact_reduction.hpp"
#include "kernels/core/host_copy.hpp"
#include "src/contact/contact_stage_impl.hpp"
#include "src/index.hpp"

namespace percuss {

/// Areas of the owned contact nodes at positions x.
const AreaNodes& ContactStage::Impl::find_areas(const Rows3<const double>& x) {
  if (!areas) areas.emplace(contact_ranks(), share);
  areas->update(x);
  return areas->nodes();
}

std::vector<double> ContactStage::sum_pair_work() const {
  std::vector<double> work;
  for (const PairWork& pair : impl_->enforcer.pair_work()) {
    std::array<ExactSum, 2> sums{pair.normal, pair.friction};
    sum_over_ranks(impl_->ranks, sums);
    for (const ExactSum& sum : sums) work.push_back(sum.round());
  }
  return work;
}

std::vector<double> ContactStage::list_wall_motions() const {
  std::vector<double> values;
  for (const WallMotion& motion : impl_->enforcer.walls().motions()) {
    values.push_back(motion.displacement);
    values.push_back(motion.speed);
  }
  return values;
}

double ContactStage::find_wall_energy() const { return impl_->enforcer.walls().find_kinetic_energy(); }

std::vector<ContactImpulse> ContactStage::take_forces(Rows3<const double> x) {
  if (impl_->forces.is_empty()) return {};
  return impl_->forces.take(impl_->find_areas(x));
}

std::vector<double> ContactStage::find_pressures(Rows3<const double> x, double dt) const {
  Impl& stage = *impl_;
  std::vector<double> pressures(stage.mesh.nodes.size(), 0);
  if (!(dt > 0)) return pressures;
  const auto pushes = to_host(stage.enforcer.find_pushes());
  const AreaNodes& nodes = stage.find_areas(x);
  const HostNodeFaces around{to_host(nodes.around.first), to_host(nodes.around.faces), to_host(nodes.around.areas)};
  for (int i = 0; i < stage.share.nodes.count(); ++i) {
    const auto n = static_cast<std::size_t>(stage.share.nodes.mesh_nodes[static_cast<std::size_t>(i)]);
    double area = 0;
    pressures[n] = find_press(around, i, {pushes(n, 0), pushes(n, 1), pushes(n, 2)}, area) / dt;
  }
  return pressures;
}

std::int64_t ContactStage::contact_nodes() const { return impl_->share.total_nodes; }
std::int64_t ContactStage::contact_faces() const { return impl_->share.total_faces; }
long ContactStage::searches() const { return impl_->searches; }
long ContactStage::enforcements() const { return impl_->enforcements; }
ContactClocks ContactStage::clocks() const {
  ContactClocks clocks = impl_->clocks;
  clocks.decomposition = impl_->finder->decomposition_clock();
  clocks.decomposition -= impl_->decomposed_at_start;
  clocks.search -= clocks.decomposition;
  return clocks;
}

Traffic ContactStage::traffic() const {
  Traffic sum = impl_->finder->traffic();
  sum.messages += impl_->enforcer.traffic().messages;
  sum.bytes += impl_->enforcer.traffic().bytes;
  sum.messages -= impl_->sent_at_start.messages;
  sum.bytes -= impl_->sent_at_start.bytes;
  return sum;
}

DecompositionReport ContactStage::decomposition() const {
  DecompositionReport report = impl_->finder->report();
  report.rebalances -= impl_->rebalances_at_start;
  return report;
}
SearchLoad ContactStage::load() const { return impl_->finder->load(); }
PairCounts ContactStage::pair_counts() const { return impl_->finder->pair_counts(); }
WallCounts ContactStage::wall_counts() const { return impl_->enforcer.wall_counts(); }

std::vector<double> ContactStage::contact_ranks() const {
  const Impl& stage = *impl_;
  std::vector<double> ranks(stage.mesh.nodes.size(), -1);
  const std::vector<int> owners = stage.finder->node_ranks();
  std::size_t next = 0;
  for (std::size_t n = 0; n < stage.share.nodes.mesh_nodes.size(); ++n) {
    if (stage.share.nodes.searched[n] == 0) continue;
    ranks[static_cast<std::size_t>(stage.share.nodes.mesh_nodes[n])] = owners[next++];
  }
  return ranks;
}

double ContactStage::measure_penetration(Rows3<const double> x) const {
  const auto finder = impl_->make_look({});
  return find_deepest_penetration(impl_->look_for_overlap(*finder), {x, x, 0});
}

}  // namespace percuss
