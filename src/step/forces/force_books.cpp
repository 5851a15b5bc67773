#include "src/step/forces/force_books.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "comm/exact_reduction.hpp"

namespace percuss {
namespace {

using Kind = ForceDeck::Kind;

constexpr double not_begun = -1;  // of a force that the checkpoint does not have

std::string describe_side(const std::vector<Selector>& side) {
  std::vector<std::string> names;
  for (const Selector& where : side) {
    const std::string name = where.name.empty() ? "the surface" : where.name;
    names.push_back(where.inside ? name + " inside a box" : name);
  }
  return fmt::format("{}", fmt::join(names, " and "));
}

std::string describe(const ForceDeck& force) {
  switch (force.kind) {
    case Kind::contact:
      return fmt::format("on {} from {}", describe_side(force.on),
                         force.from.empty() ? "all others" : describe_side(force.from));
    case Kind::wall:
      return fmt::format("from wall '{}' on the bodies", force.wall);
    case Kind::support:
      return fmt::format("from the conditions on {}", force.where.name.empty() ? "all nodes" : force.where.name);
    case Kind::section:
      break;
  }
  if (force.nodes)
    return fmt::format("on nodes of {} from elements of {}", describe_side({*force.nodes}),
                       describe_side(force.elements));
  return fmt::format("on the material behind the section of {} from that ahead",
                     force.part.empty() ? "all parts" : force.part);
}

void append_mean(const ContactImpulse& since, double per_time, bool is_contact, std::vector<double>& row) {
  for (const double j : since.impulse) row.push_back(j * per_time);
  for (const double m : since.moment) row.push_back(m * per_time);
  if (!is_contact) return;
  row.push_back(since.normal * per_time);
  row.push_back(since.tangential * per_time);
  row.push_back(since.area * per_time);
  row.push_back(since.press * per_time);
}

}  // namespace

ForceBooks::ForceBooks(const Deck& deck, const ChunkedMesh& chunked, const Model& model, ContactStage& contact,
                       const std::vector<Wrench>& reactions)
    : deck_(deck), ranks_(model.ranks), contact_(contact), reactions_(reactions) {
  for (const ForceDeck& force : deck.output.forces) {
    if (force.kind == Kind::support) supports_.emplace_back(deck, force, chunked, model);
    if (force.kind == Kind::section) sections_.emplace_back(deck, force, chunked, model);
  }
  sums_.resize(supports_.size() + sections_.size());
  since_.resize(deck.output.forces.size());
  has_acted_.resize(since_.size(), 0);
}

void ForceBooks::renew_supports(const State& state) {
  for (SupportForce& support : supports_) support.renew(state);
}

void ForceBooks::book_motion(State& state, const StepTimes& times) {
  auto sums = sums_.begin();
  const auto add = [&](const std::array<ExactSum, 6>& step) {
    for (std::size_t k = 0; k < step.size(); ++k) {
      (*sums)[k].merge(step[k]);
      (*sums)[k].normalize();
    }
    ++sums;
  };
  for (SupportForce& support : supports_) add(support.find_impulse(state, times.dt_mean, reactions_));
  for (SectionForce& section : sections_) add(section.find_impulse(state, times.dt_mean));
}

/// The sums of a force that is no contact: those of the supports stand before those of the sections.
std::array<ExactSum, 6>& ForceBooks::find_sums(std::size_t force) {
  std::size_t place = deck_.output.forces[force].kind == Kind::section ? supports_.size() : 0;
  for (std::size_t f = 0; f < force; ++f)
    place += deck_.output.forces[f].kind == deck_.output.forces[force].kind ? 1 : 0;
  return sums_[place];
}

/// Takes the sums of all ranks, which begin anew.
ContactImpulse ForceBooks::take_sums(std::size_t force) {
  std::array<ExactSum, 6>& sums = find_sums(force);
  sum_over_ranks(ranks_, sums);
  const ContactImpulse since{{sums[0].round(), sums[1].round(), sums[2].round()},
                             {sums[3].round(), sums[4].round(), sums[5].round()}};
  sums = {};
  return since;
}

void ForceBooks::archive(CheckpointArchive& archive, State& /*state*/) {
  for (std::size_t f = 0; f < since_.size(); ++f) {
    const ForceDeck& force = deck_.output.forces[f];
    const std::string name = "forces/" + identify(force);
    if (!archive.has_number(name + "/since")) {
      since_[f] = not_begun;
      continue;
    }
    archive.number(name + "/since", since_[f]);
    archive.integer(name + "/has_acted", has_acted_[f]);
    if (!force.is_of_contact()) archive.sums(name, find_sums(f));
  }
}

void ForceBooks::resume(const State& state) { std::replace(since_.begin(), since_.end(), not_begun, state.time); }

std::vector<HistoryColumn> ForceBooks::list_columns() const {
  std::vector<HistoryColumn> columns;
  for (const ForceDeck& force : deck_.output.forces) {
    const std::string which = describe(force);
    const auto add = [&](const std::string& name, const Dimension& dimension, const std::string& meaning) {
      const bool is_moment = dimension == dimensions::energy;
      columns.push_back({name + ":" + force.name, dimension, fmt::format("{} of '{}', {}", meaning, force.name, which),
                         is_moment ? HistoryColumn::Kind::moment : HistoryColumn::Kind::by_dimension});
    };
    for (const char* axis : {"x", "y", "z"})
      add(fmt::format("f{}", axis), dimensions::force, fmt::format("force in {}", axis));
    for (const char* axis : {"x", "y", "z"})
      add(fmt::format("m{}", axis), dimensions::energy, fmt::format("moment about {}", axis));
    if (!force.is_of_contact()) continue;
    add("normal", dimensions::force, "normal force");
    add("tangential", dimensions::force, "friction force");
    add("area", dimensions::area, "area of contact");
    add("pressure", dimensions::stress, "largest contact pressure");
  }
  return columns;
}

void ForceBooks::append_values(const State& state, std::vector<double>& row) {
  if (since_.empty()) return;
  const double time = state.time;
  const std::vector<ContactImpulse> of_contact = contact_.take_forces(state.x);
  auto contact = of_contact.begin();
  for (std::size_t f = 0; f < since_.size(); ++f) {
    const double passed = time - since_[f] - (since_[f] == 0 ? 0.5 * state.dt : 0);  // velocities begin at time 0
    const double per_time = time > since_[f] ? 1 / passed : 0;
    const auto first = static_cast<std::ptrdiff_t>(row.size());
    since_[f] = time;
    if (deck_.output.forces[f].is_of_contact())
      append_mean(*contact++, per_time, true, row);
    else
      append_mean(take_sums(f), per_time, false, row);
    const bool acts = std::any_of(row.begin() + first, row.end(), [](double value) { return value != 0; });
    has_acted_[f] = static_cast<unsigned char>(has_acted_[f] != 0 || acts);
  }
}

}  // namespace percuss
