#include "src/step/run/run_warnings.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "comm/agreement.hpp"
#include "src/error.hpp"
#include "src/step/run/run_notes.hpp"

namespace percuss {

RunWarnings::RunWarnings(const std::set<std::string>& silenced, const Communicator& ranks)
    : ranks_(ranks), log_(silenced, [this](const Warning& warning) { tell(warning); }) {}

/// Also of a quiet run: warnings are never hidden.
void RunWarnings::tell(const Warning& warning) const {
  if (ranks_.rank() != 0) return;
  if (progress_ != nullptr) progress_->clear();
  print_quietly(stderr, "{}\n", format_warning(warning));
}

void RunWarnings::renew(const std::vector<Warning>& warnings) {
  for (const Warning& warning : warnings) log_.renew(warning);
}

void RunWarnings::note_step(const ContactReport& report, double time,
                            const std::function<std::string()>& name_deepest) {
  if (accepted_depth_ < 0) accepted_depth_ = report.deepest;
  log_.add(warn_of_residual(report, time));
  if (is_deep(report, accepted_depth_) && !log_.is_silenced(deep_penetration)) note_depth(time, name_deepest);
}

/// The text is that of the first such step, so that later ones count with it.
void RunWarnings::note_depth(double time, const std::function<std::string()>& name_deepest) {
  const auto& listed = log_.list();
  const auto first =
      std::find_if(listed.begin(), listed.end(), [](const Warning& w) { return w.rule == deep_penetration; });
  Warning warning = warn_of_depth(time, first == listed.end() ? name_deepest() : "");
  if (first != listed.end()) warning.text = first->text;
  log_.add(warning);
}

void RunWarnings::add_gain(double given, const EnergyScales& scales, const std::string& units) {
  has_warned_gain_ = true;
  log_.add(warn_of_gain(given, scales, gain_, units));
}

void RunWarnings::renew_gain(double given, const EnergyScales& scales, const std::string& units) {
  if (!has_warned_gain_) return;
  Warning warning = warn_of_gain(given, scales, gain_, units);
  warning.count = 0;
  log_.renew(warning);
}

void RunWarnings::archive(CheckpointArchive& archive) {
  archive.number("warnings/pushed_square", pushed_square_);
  archive.number("warnings/accepted_depth", accepted_depth_);
  archive.number("warnings/gain_step", gain_.step);
  archive.number("warnings/gain_node", gain_.node);
  archive.numbers("warnings/gain_place", gain_.place);
  archive.number("warnings/gain_time", gain_.time);
  archive.integer("warnings/has_told_gain", has_warned_gain_);
}

std::string RunWarnings::write() const {
  const auto first = log_.list().begin() + static_cast<std::ptrdiff_t>(input_count_);
  return broadcast_text(ranks_, write_warnings({first, log_.list().end()}), 0);
}

void RunWarnings::restore(const CheckpointHeader& header, const std::string& path) {
  try {
    log_.restore(read_warnings(header.warnings));
  } catch (const InputError& error) {
    throw InputError(fmt::format("{}: error: the warnings in it cannot be read ({})", path, error.what()));
  }
}

}  // namespace percuss
