#include "src/output/ranks_file.hpp"

#include "src/output/files/atomic_file.hpp"
#include "src/output/history_file.hpp"

namespace percuss {
namespace {

// The columns in their order: the one place that names them.
template <class Visitor>
void visit_columns(const RankRow& row, const Visitor& visit) {
  const PhaseSeconds& spent = row.compute;
  visit("rank", static_cast<double>(row.rank));
  visit("elements", static_cast<double>(row.elements));
  visit("nodes", static_cast<double>(row.nodes));
  visit("contact_nodes", static_cast<double>(row.contact_nodes));
  visit("contact_faces", static_cast<double>(row.contact_faces));
  visit("compute_internal_force", spent.internal_force);
  visit("compute_halo", spent.halo);
  visit("compute_integrate", spent.integrate);
  visit("compute_contact_rcb", spent.contact_rcb);
  visit("compute_contact_search", spent.contact_search);
  visit("compute_contact_check", spent.contact_check);
  visit("compute_contact_enforce", spent.contact_enforce);
  visit("compute_reduce", spent.reduce);
  visit("compute_estimate", spent.estimate);
  visit("compute_output", spent.output);
  visit("compute_loop", row.compute_loop);
  visit("halo_messages", row.halo_messages);
  visit("halo_bytes", row.halo_bytes);
  visit("contact_messages", row.contact_messages);
  visit("contact_bytes", row.contact_bytes);
}

void end_row(std::string& text) { text.back() = '\n'; }  // in place of the last comma

}  // namespace

void write_ranks(const std::string& path, std::span<const RankRow> rows) {
  std::string text;
  visit_columns({}, [&](const char* name, double) { text += std::string(name) + ','; });
  end_row(text);
  for (const RankRow& row : rows) {
    visit_columns(row, [&](const char*, double value) { text += format_number(value) + ','; });
    end_row(text);
  }
  write_file_atomically(path, text, Durability::disk);
}

}  // namespace percuss
