#include "src/step/forces/force_books.hpp"

#include <fmt/format.h>

#include "comm/exact_reduction.hpp"

namespace percuss {
namespace {

using Kind = ForceDeck::Kind;

std::string describe(const ForceDeck& force) {
  switch (force.kind) {
    case Kind::contact:
      return fmt::format("on {} from {}", fmt::join(force.on, " and "),
                         force.from.empty() ? "all others" : fmt::format("{}", fmt::join(force.from, " and ")));
    case Kind::wall:
      return fmt::format("from wall '{}' on the bodies", force.wall);
    case Kind::support:
      return fmt::format("from the conditions on {}", force.where.name.empty() ? "all nodes" : force.where.name);
    case Kind::section:
      break;
  }
  return fmt::format("on the material behind the section of {} from that ahead",
                     force.part.empty() ? "all parts" : force.part);
}

void append_mean(const ContactImpulse& since, double per_time, bool is_contact, std::vector<double>& row) {
  for (const double j : since.impulse) row.push_back(j * per_time);
  for (const double m : since.moment) row.push_back(m * per_time);
  if (!is_contact) return;
  row.push_back(since.normal * per_time);
  row.push_back(since.tangential * per_time);
}

}  // namespace

std::vector<HistoryColumn> list_force_columns(const Deck& deck) {
  std::vector<HistoryColumn> columns;
  for (const ForceDeck& force : deck.output.forces) {
    const std::string which = describe(force);
    const auto add = [&](const std::string& name, const std::string& meaning, HistoryColumn::Kind kind) {
      const bool is_moment = kind == HistoryColumn::Kind::moment;
      columns.push_back({name + ":" + force.name, is_moment ? dimensions::energy : dimensions::force,
                         fmt::format("{} {}", meaning, which), kind});
    };
    const auto force_kind = HistoryColumn::Kind::by_dimension, moment_kind = HistoryColumn::Kind::moment;
    for (const char* axis : {"x", "y", "z"})
      add(fmt::format("f{}", axis), fmt::format("force in {}", axis), force_kind);
    for (const char* axis : {"x", "y", "z"})
      add(fmt::format("m{}", axis), fmt::format("moment about {} of the force", axis), moment_kind);
    if (!force.is_of_contact()) continue;
    add("normal", "sum of the magnitudes of the normal forces", force_kind);
    add("tangential", "sum of the magnitudes of the friction forces", force_kind);
  }
  return columns;
}

ForceBooks::ForceBooks(const Deck& deck, const ChunkedMesh& chunked, const Model& model, ContactStage& contact)
    : deck_(deck), ranks_(model.ranks), contact_(contact) {
  for (const ForceDeck& force : deck.output.forces) {
    if (force.kind == Kind::support) supports_.emplace_back(deck, force, chunked, model);
    if (force.kind == Kind::section) sections_.emplace_back(deck, force, chunked, model);
  }
  sums_.resize(supports_.size() + sections_.size());
}

void ForceBooks::book(const Model& model, const State& state, double dt_mean) {
  auto sums = sums_.begin();
  const auto add = [&](const std::array<ExactSum, 6>& step) {
    for (std::size_t k = 0; k < step.size(); ++k) {
      (*sums)[k].merge(step[k]);
      (*sums)[k].normalize();
    }
    ++sums;
  };
  for (SupportForce& support : supports_) add(support.find_impulse(model, state, dt_mean));
  for (SectionForce& section : sections_) add(section.find_impulse(state, dt_mean));
}

void ForceBooks::archive(CheckpointArchive& archive) {
  if (deck_.output.forces.empty()) return;
  archive.number("forces/last_time", last_time_);
  for (std::size_t f = 0; f < sums_.size(); ++f) archive.sums(fmt::format("forces/{}", f), sums_[f]);
}

std::vector<double> ForceBooks::take(double time) {
  std::vector<double> row;
  if (deck_.output.forces.empty()) return row;
  const double per_time = time > last_time_ ? 1 / (time - last_time_) : 0;
  last_time_ = time;
  const std::vector<ContactImpulse> of_contact = contact_.take_forces();
  std::vector<ContactImpulse> others;
  for (std::array<ExactSum, 6>& sums : sums_) {
    sum_over_ranks(ranks_, sums);
    others.push_back(
        {{sums[0].round(), sums[1].round(), sums[2].round()}, {sums[3].round(), sums[4].round(), sums[5].round()}});
    sums = {};
  }
  auto contact = of_contact.begin();
  auto support = others.begin(), section = others.begin() + static_cast<std::ptrdiff_t>(supports_.size());
  for (const ForceDeck& force : deck_.output.forces) {
    if (force.is_of_contact())
      append_mean(*contact++, per_time, true, row);
    else
      append_mean(*(force.kind == Kind::support ? support++ : section++), per_time, false, row);
  }
  return row;
}

}  // namespace percuss
