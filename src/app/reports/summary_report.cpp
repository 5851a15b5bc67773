#include "src/app/reports/summary_report.hpp"

#include <fmt/format.h>

#include <utility>

#include "src/app/reports/report_lines.hpp"
#include "src/output/warning_log.hpp"

namespace percuss {
namespace {

// The phases that took time, as shares of the loop.
std::string format_phases(const Summary& summary) {
  const PhaseSeconds& p = summary.phases_s;
  const std::pair<const char*, double> phases[] = {{"internal force", p.internal_force},
                                                   {"halo", p.halo},
                                                   {"integrate", p.integrate},
                                                   {"contact rcb", p.contact_rcb},
                                                   {"contact search", p.contact_search},
                                                   {"contact check", p.contact_check},
                                                   {"contact enforce", p.contact_enforce},
                                                   {"reduce", p.reduce},
                                                   {"estimate", p.estimate},
                                                   {"output", p.output}};
  std::string text;
  for (const auto& [name, seconds] : phases) {
    if (seconds <= 0 || summary.loop_s <= 0) continue;
    text += fmt::format("{}{} {:.1f} %", text.empty() ? "" : ", ", name, 100 * seconds / summary.loop_s);
  }
  return text.empty() ? "" : format_line("phases", text);
}

std::string format_warnings(const Summary& s) {
  std::string text;
  for (const Warning& warning : s.warnings) text += format_warning(warning) + "\n";
  return s.warnings.empty() ? text : text + count_warnings(s.warnings) + "\n";
}

}  // namespace

std::string format_eroded(const Summary& s) {
  if (s.eroded.elements == 0) return "";
  std::string text = fmt::format("{} of {} elements failed and were eroded, mass {:.4g}, energy {:.4g}",
                                 s.eroded.elements, s.elements, s.eroded.mass, s.eroded.energy);
  if (s.eroded.vanished_mass > 0)
    text += fmt::format("; free nodes with mass {:.4g} were removed", s.eroded.vanished_mass);
  return text;
}

std::string format_contact_loss(const Summary& s) {
  constexpr double noted_share = 0.05;
  const double share = s.energy.largest > 0 ? s.energy.contact_taken / s.energy.largest : 0;
  if (!(share > noted_share)) return "";
  return fmt::format(
      "normal contact took {:.4g}, {:.3g} % of the largest energy (a node that meets a face stops, and a rigid body "
      "keeps what contact.restitution says): use smaller elements where bodies that deform meet, or "
      "contact.enforcement: penalty, and check contact.restitution of rigid ones",
      s.energy.contact_taken, 100 * share);
}

std::string format_added_mass(const Summary& s) {
  std::string text =
      fmt::format("mass scaling added {:.4g}, {:.2g} % of the original mass", s.mass.added, 100 * s.mass.share);
  if (s.mass.in_run > 0)
    text += fmt::format("; {:.4g} of it during the run, with a kinetic energy of {:.4g}", s.mass.in_run, s.mass.energy);
  return text;
}

std::string format_summary(const Summary& s) {
  const std::string limit = describe_step_limit(s);
  std::string text =
      format_line("status", s.status + (s.error.empty() ? "" : ": " + s.error) + (limit.empty() ? "" : ", " + limit));
  text += format_line("program",
                      fmt::format("percuss {}, {} back end, {} precision, {} rank{}, {} thread{}", s.version, s.backend,
                                  s.precision, s.ranks, s.ranks == 1 ? "" : "s", s.threads, s.threads == 1 ? "" : "s"));
  text += format_line("scene", fmt::format("{} elements, {} nodes; {} contact nodes, {} contact faces", s.elements,
                                           s.nodes, s.contact_nodes, s.contact_faces));
  if (s.status == "running") return text + format_warnings(s);  // the rest comes at its end
  const std::string controller = !s.dt.approach.empty() ? s.dt.approach
                                 : s.dt.spring.empty()  ? fmt::format("element {}", s.dt.element)
                                                        : fmt::format("spring '{}'", s.dt.spring);
  text += format_line("time", fmt::format("{:.6g} in {} steps; step {:.4g} to {:.4g}, last {:.4g} ({})", s.time,
                                          s.steps, s.dt.min, s.dt.max, s.dt.last, controller));
  for (const SensorSummary& sensor : s.sensors)
    text += format_line(
        "sensor", fmt::format("'{}': event at t = {:.6g}, value {:.6g}", sensor.sensor, sensor.time, sensor.value));
  if (s.dt.estimates > 0) {
    text += format_line(
        "", fmt::format("{:.4g} times the element bound, from {} estimates of the largest eigenvalue of the mesh",
                        s.dt.gain, s.dt.estimates));
  }
  text += format_line("took",
                      fmt::format("set-up {:.3g} s, loop {:.3g} s, {:.4g} ns per element and step; {:.4g} MB at most",
                                  s.setup_s, s.loop_s, s.grind_ns, static_cast<double>(s.peak_bytes) / 1e6));
  text += format_phases(s);
  const EnergySummary& e = s.energy;
  std::string of_elements;
  for (std::size_t k = 0; k < work_kinds; ++k) of_elements += fmt::format(", {} {:.6g}", WorkKind::names[k], e.work[k]);
  text += format_line("energy", fmt::format("initial {:.6g}, kinetic {:.6g}{}", e.initial, e.kinetic, of_elements));
  text += format_line("", fmt::format("contact {:.6g}, friction {:.6g}, damping {:.6g}, external {:.6g}; error {:.2g}",
                                      e.contact, e.friction, e.damping, e.external, e.error));
  if (const std::string loss = format_contact_loss(s); !loss.empty()) text += format_line("", loss);
  text += format_line("momentum", fmt::format("linear ({:.6g}, {:.6g}, {:.6g}), error {:.2g}; angular error {:.2g}",
                                              s.momentum.linear[0], s.momentum.linear[1], s.momentum.linear[2],
                                              s.momentum.linear_error, s.momentum.angular_error));
  if (s.mass.added > 0) text += format_line("mass", format_added_mass(s));
  if (s.eroded.elements > 0) text += format_line("eroded", format_eroded(s));
  return text + format_line("state", "hash " + s.state_hash) + format_warnings(s);
}

}  // namespace percuss
