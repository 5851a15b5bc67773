// Impulses of the pushes of a step on the nodes, for fields of contact pressure.

#include "kernels/core/host_copy.hpp"
#include "kernels/core/view_copy.hpp"
#include "src/contact/enforcement/enforcer.hpp"
#include "src/index.hpp"

namespace percuss {

Rows3<double> Enforcer::find_pushes() {
  if (restored_pushes_.extent(0) > 0) return restored_pushes_;
  const Rows3<double> pushes("contact::node_pushes", node_numbers_.extent(0));
  if (!has_solved_) return pushes;
  Array<RowSides> marks("contact::push_marks", 0);
  Array<NormalPush> sent("contact::sent_pushes", 0), remote("contact::remote_pushes", 0);
  const ExecSpace space;
  mark_pushes(space, system_, marks);
  list_sent_pushes(space, system_, marks, sent);
  space.fence();
  exchange_.send_pushes(sent, system_, remote);
  sum_pushes(space, {system_, marks, remote}, pushes);
  space.fence();
  return pushes;
}

/// Only the contact_pressure of a frame that a restart writes before its first step needs these pushes.
void Enforcer::archive_pushes(CheckpointArchive& archive, const ChunkedMesh& chunked, const OwnedContactNodes& nodes) {
  bool is_written = true;
  if (!archive.has_number("contact/has_pushes")) return;
  archive.integer("contact/has_pushes", is_written);
  const bool is_loading = archive.is_loading();
  const Rows3<double> pushes =
      is_loading ? Rows3<double>("contact::restored_pushes", chunked.mesh.nodes.size()) : find_pushes();
  const auto host = to_host(pushes);
  std::vector<double> rows;
  for (const int n : nodes.mesh_nodes) {
    for (std::size_t k = 0; k < 3; ++k) rows.push_back(host(at(n), k));
  }
  archive.rows("contact/nodes/push", find_rows_of_nodes(chunked, nodes.numbers), 3, std::span<double>(rows));
  if (!is_loading) return;
  for (std::size_t i = 0; i < nodes.mesh_nodes.size(); ++i) {
    for (std::size_t k = 0; k < 3; ++k) host(at(nodes.mesh_nodes[i]), k) = rows[3 * i + k];
  }
  copy_values(pushes, host);
  restored_pushes_ = pushes;
}

}  // namespace percuss
