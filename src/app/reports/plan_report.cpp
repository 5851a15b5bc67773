#include "src/app/reports/plan_report.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "src/checks/rules.hpp"
#include "src/deck/asked_for.hpp"
#include "src/output/progress.hpp"
#include "src/output/warning_log.hpp"

namespace percuss {
namespace {

/// Below so many contact nodes and faces a rank, messages outweigh what is computed between them.
constexpr double few_points = 100;
/// Imbalance of the elements that is worth a word.
constexpr double uneven = 1.1;

using Cells = std::vector<std::string>;

/// Rows of a label and a cell for each plan, in columns.
class Table {
 public:
  void add(const std::string& label, Cells cells) { rows_.push_back({label, std::move(cells)}); }
  std::string format() const;

 private:
  struct Row {
    std::string label;
    Cells cells;
  };
  std::vector<Row> rows_;
};

std::string Table::format() const {
  std::size_t label_width = 0, width = 0;
  for (const Row& row : rows_) {
    label_width = std::max(label_width, row.label.size());
    for (const std::string& cell : row.cells) width = std::max(width, cell.size());
  }
  std::string text;
  for (const Row& row : rows_) {
    text += fmt::format("{:<{}}", row.label, label_width);
    for (const std::string& cell : row.cells) text += fmt::format("  {:>{}}", cell, width);
    text += "\n";
  }
  return text;
}

struct Column {
  const RanksPlan& plan;
  RankSpreads spreads;
  StepEstimate step;
};

/// The table of some columns, row by row.
class PlanTable {
 public:
  explicit PlanTable(std::vector<Column> columns) : columns_(std::move(columns)) {}

  template <class Find>
  void add(const std::string& label, const char* format, const Find& find) {
    Cells cells;
    for (const Column& column : columns_) cells.push_back(fmt::format(fmt::runtime(format), find(column)));
    table_.add(label, std::move(cells));
  }
  void add_mean_and_most(const std::string& label, Spread RankSpreads::*spread) {
    add(label + ", mean", "{:.1f}", [spread](const Column& c) { return (c.spreads.*spread).mean; });
    add(label + ", most", "{:.0f}", [spread](const Column& c) { return (c.spreads.*spread).most; });
  }
  void add_most_over_mean(Spread RankSpreads::*spread) {
    add("  most over mean", "{:.3f}", [spread](const Column& c) { return (c.spreads.*spread).imbalance(); });
  }
  void add_microseconds(const std::string& label, double StepEstimate::*time) {
    add(label, "{:.1f}", [time](const Column& c) { return 1e6 * (c.step.*time); });
  }

  std::string format() const { return table_.format(); }

 private:
  std::vector<Column> columns_;
  Table table_;
};

void add_mesh_rows(PlanTable& table) {
  table.add("chunks per rank, fewest", "{:.0f}", [](const Column& c) { return c.spreads.chunks.least; });
  table.add("elements per rank, fewest", "{:.0f}", [](const Column& c) { return c.spreads.elements.least; });
  table.add_mean_and_most("elements per rank", &RankSpreads::elements);
  table.add_mean_and_most("element work per rank", &RankSpreads::work);
  table.add_most_over_mean(&RankSpreads::work);
  table.add_mean_and_most("shared nodes per rank", &RankSpreads::shared_nodes);
  table.add_mean_and_most("neighbours per rank", &RankSpreads::neighbours);
  table.add_mean_and_most("halo messages per step", &RankSpreads::halo_messages);
  table.add_mean_and_most("halo bytes per step", &RankSpreads::halo_bytes);
}

void add_contact_rows(PlanTable& table, const StepPattern& pattern) {
  if (pattern.has_pairs) {
    table.add_mean_and_most("contact points per rank", &RankSpreads::contact_points);
    table.add_most_over_mean(&RankSpreads::contact_points);
  }
  if (pattern.has_contacts) {
    table.add_mean_and_most("contacts per rank", &RankSpreads::contacts);
    table.add_most_over_mean(&RankSpreads::contacts);
  }
  if (pattern.has_pairs)
    table.add("ghost faces, all ranks", "{}", [](const Column& c) { return c.plan.contact.ghost_faces; });
  table.add_mean_and_most("contact messages per step", &RankSpreads::contact_messages);
  table.add_mean_and_most("contact bytes per step", &RankSpreads::contact_bytes);
}

void add_time_rows(PlanTable& table, double reductions) {
  table.add("memory per rank [MB], most", "{:.0f}", [](const Column& c) { return 1e-6 * c.spreads.memory.most; });
  table.add("reductions per step", "{:.1f}", [&](const Column& c) { return c.plan.ranks > 1 ? reductions : 0; });
  table.add_microseconds("computing [us]", &StepEstimate::computing);
  table.add_microseconds("halo [us]", &StepEstimate::halo);
  table.add_microseconds("contact exchange [us]", &StepEstimate::contact);
  table.add_microseconds("reductions [us]", &StepEstimate::reductions);
  table.add("step [us]", "{:.1f}", [](const Column& c) { return 1e6 * c.step.step(); });
  table.add("parallel efficiency [%]", "{:.1f}", [](const Column& c) { return 100 * c.step.efficiency; });
}

std::string format_run_time(double seconds) { return seconds < 1 ? "< 1 s" : format_duration(seconds); }

std::string format_core_hours(double hours) {
  if (hours < 0.01) return "< 0.01";
  return hours < 100 ? fmt::format("{:.2f}", hours) : fmt::format("{:.0f}", hours);
}

void add_run_rows(PlanTable& table, double steps) {
  table.add("run time", "{}", [=](const Column& c) { return format_run_time(steps * c.step.step()); });
  table.add("core hours", "{}",
            [=](const Column& c) { return format_core_hours(c.plan.ranks * steps * c.step.step() / 3600); });
}

/// Names the contacts that the messages are planned for.
std::string format_contacts(const PlannedScene& scene, const PlanFigures& figures) {
  if (!scene.pattern.has_pairs && !scene.pattern.has_walls) return "";
  const std::string text = fmt::format("\ncontacts {}", scene.contacts);
  if (figures.all_touch) return text + ": every node near a face touches one (--all-touch)";
  return text + ", those of the start, for the whole run" +
         (scene.pattern.has_pairs ? "; bodies that meet later send more (--all-touch)" : "");
}

std::string format_head(const PlannedScene& scene, const PlanFigures& figures) {
  const Deck& deck = scene.deck;
  std::string text = fmt::format("deck     {}{}\n", deck.file, deck.title.empty() ? "" : ": " + deck.title);
  text += fmt::format("mesh     {} elements in {} chunks, {} nodes", scene.elements, scene.chunks, scene.nodes);
  if (scene.pattern.has_pairs) {
    text += fmt::format("; {} contact nodes, {} contact faces", scene.contact_nodes, scene.contact_faces);
  }
  text += format_contacts(scene, figures);
  text += fmt::format("\ntime     0 to {:g}; first step {:.4g}, {:.0f} steps of this length", deck.time.end,
                      scene.first_step, count_steps(deck.time, scene.first_step));
  text += fmt::format("\nassumed  {:g} ns per element, latency {:g} s, bandwidth {:g} byte/s", figures.element_ns,
                      figures.latency, figures.bandwidth);
  if (scene.pattern.has_pairs || scene.pattern.has_walls) {
    text += fmt::format("; {:g} iterations per step", figures.iterations);
  }
  if (scene.pattern.has_pairs) {
    text += fmt::format(", {:g} ns per contact node or face, {:g} steps per search", figures.contact_node_ns,
                        scene.pattern.reuses_search ? figures.steps_per_search : 1);
  }
  return text + "\n\n";
}

Warning warn(const char* rule, const std::string& text) { return {rule, text, "", 0, 1}; }

void warn_of_column(const PlannedScene& scene, const Column& column, WarningLog& log) {
  const int ranks = column.plan.ranks, empty = column.plan.mesh.partition.empty_parts;
  const RankSpreads& spreads = column.spreads;
  if (empty > 0) {
    log.add(warn("idle_ranks", fmt::format("{} of {} ranks would have no elements (the mesh has {} chunks, and a chunk "
                                           "is never split): take fewer ranks or a finer mesh",
                                           empty, ranks, scene.chunks)));
  } else if (ranks > 1 && spreads.work.imbalance() > uneven) {
    log.add(warn("uneven_ranks", fmt::format("on {} ranks the heaviest has {:.2f} times the mean work of elements "
                                             "({:.1f} chunks per rank, and a chunk is never split): take fewer ranks "
                                             "or a finer mesh",
                                             ranks, spreads.work.imbalance(), spreads.chunks.mean)));
  }
  if (ranks > 1 && scene.pattern.has_pairs && spreads.contact_points.mean < few_points) {
    log.add(warn("few_contact_points",
                 fmt::format("on {} ranks each has only {:.0f} contact nodes and faces (below {:.0f} messages outweigh "
                             "the search): take fewer ranks or a finer mesh",
                             ranks, spreads.contact_points.mean, few_points)));
  }
}

/// Warnings of the deck and of the plan, a line each; a run adds those of its mesh.
std::string format_warnings(const PlannedScene& scene, const std::vector<Column>& columns) {
  WarningLog log(scene.deck.silenced);
  log.add(scene.deck.warnings);
  log.add(check_input({scene.deck, nullptr, nullptr, 0}));
  if (scene.pattern.has_pairs && can_fail(scene.deck)) {
    log.add(warn("plan_without_erosion",
                 "elements can fail (the plan does not include the rebuild of contact surfaces, which ranks hardly "
                 "divide): measure a short run in which elements erode"));
  }
  for (const Column& column : columns) warn_of_column(scene, column, log);
  std::string text;
  for (const Warning& warning : log.list()) text += format_warning(warning) + "\n";
  return text;
}

}  // namespace

std::string format_plan(const PlannedScene& scene, const PlanFigures& figures, const std::vector<RanksPlan>& plans) {
  std::vector<Column> columns;
  columns.reserve(plans.size());
  for (const RanksPlan& plan : plans) {
    columns.push_back({plan, find_spreads(plan, scene.pattern, figures), estimate_step(plan, scene.pattern, figures)});
  }
  PlanTable table(columns);
  table.add("ranks", "{}", [](const Column& c) { return c.plan.ranks; });
  add_mesh_rows(table);
  if (scene.pattern.has_pairs || scene.pattern.has_walls) add_contact_rows(table, scene.pattern);
  add_time_rows(table, count_reductions(scene.pattern, figures));
  add_run_rows(table, count_steps(scene.deck.time, scene.first_step));
  std::string text = format_head(scene, figures) + table.format();
  const std::string warnings = format_warnings(scene, columns);
  return warnings.empty() ? text : text + "\n" + warnings;
}

}  // namespace percuss
