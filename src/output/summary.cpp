#include "src/output/summary.hpp"

#include <fmt/format.h>

#include <array>
#include <cerrno>
#include <cstdio>
#include <limits>
#include <memory>
#include <nlohmann/json.hpp>
#include <type_traits>

#include "src/error.hpp"
#include "src/output/files/atomic_file.hpp"
#include "src/output/warning_json.hpp"

namespace percuss {
namespace {

using Json = nlohmann::ordered_json;

// The keys of summary.json, in their order: the one place that names them. `visit` gets key and member; `group` gets a
// key and a function that visits the members of that object.
template <class S, class Visitor>
void visit_seconds(S& phases, Visitor&& v) {
  visit_phases(phases, [&](const char* key, auto& seconds) { v.value(key, seconds); });
}

template <class S, class Visitor>
void visit_earlier(S& s, Visitor&& v) {
  v.value("runs", s.runs);
  v.value("steps", s.steps);
  v.value("setup_s", s.setup_s);
  v.value("loop_s", s.loop_s);
  v.group("phases_s", [&] { visit_seconds(s.phases_s, v); });
}

template <class S, class Visitor>
void visit_energy(S& s, Visitor&& v) {
  v.value("initial", s.initial);
  v.value("kinetic", s.kinetic);
  for (std::size_t k = 0; k < work_kinds; ++k) v.value(WorkKind::names[k], s.work[k]);
  v.value("contact", s.contact);
  v.value("friction", s.friction);
  v.value("damping", s.damping);
  v.value("external", s.external);
  v.value("error", s.error);
  v.later_value("contact_taken", s.contact_taken);
  v.later_value("largest", s.largest);
}

template <class S, class Visitor>
void visit_head(S& s, Visitor&& v) {
  v.value("status", s.status);
  v.value("error", s.error);
  v.later_value("warnings", s.warnings);
  v.value("version", s.version);
  v.value("backend", s.backend);
  v.value("precision", s.precision);
  v.value("ranks", s.ranks);
  v.value("threads", s.threads);
  v.value("elements", s.elements);
  v.value("nodes", s.nodes);
  v.value("contact_nodes", s.contact_nodes);
  v.value("contact_faces", s.contact_faces);
  v.value("steps", s.steps);
  v.value("time", s.time);
  v.later_value("end_time", s.end_time);
  v.later_value("ended_by", s.ended_by);
  v.later_value("restart_changes", s.restart_changes);
  v.later_value("sensors", s.sensors);
}

template <class S, class Visitor>
void visit_summary(S& s, Visitor&& v) {
  visit_head(s, v);
  v.group("dt", [&] {
    v.value("min", s.dt.min);
    v.value("max", s.dt.max);
    v.value("last", s.dt.last);
    v.value("element", s.dt.element);
    v.value("spring", s.dt.spring);
    v.value("estimate", s.dt.estimate);
    v.value("estimates", s.dt.estimates);
    v.value("gain", s.dt.gain);
    v.later_value("approach", s.dt.approach);
  });
  v.group("mass", [&] {
    v.value("added", s.mass.added);
    v.value("share", s.mass.share);
    v.value("in_run", s.mass.in_run);
    v.value("energy", s.mass.energy);
  });
  v.group("relaxation", [&] {
    v.value("state", s.relaxation.state);
    v.value("damped_steps", s.relaxation.steps);
    v.value("kinetic_ratio", s.relaxation.kinetic_ratio);
    v.value("scale", s.relaxation.scale);
    v.value("frequency", s.relaxation.frequency);
    v.value("energy", s.relaxation.energy);
    v.value("preload_error", s.relaxation.preload_error);
    v.value("contact_stored", s.relaxation.contact_stored);
  });
  v.value("setup_s", s.setup_s);
  v.value("loop_s", s.loop_s);
  v.value("grind_ns", s.grind_ns);
  v.group("phases_s", [&] { visit_seconds(s.phases_s, v); });
  v.later_group("earlier", [&] { visit_earlier(s.earlier, v); });
  v.group("skipped", [&] {
    v.value("chunk_updates", s.skipped.chunk_updates);
    v.value("searches", s.skipped.searches);
    v.value("pair_checks", s.skipped.pair_checks);
    v.value("wall_looks", s.skipped.wall_looks);
    v.value("enforcements", s.skipped.enforcements);
    v.value("rebalances", s.skipped.rebalances);
  });
  v.group("energy", [&] { visit_energy(s.energy, v); });
  v.group("momentum", [&] {
    v.value("linear", s.momentum.linear);
    v.value("angular", s.momentum.angular);
    v.value("linear_error", s.momentum.linear_error);
    v.value("angular_error", s.momentum.angular_error);
  });
  v.group("eroded", [&] {
    v.value("elements", s.eroded.elements);
    v.value("mass", s.eroded.mass);
    v.value("energy", s.eroded.energy);
    v.value("vanished_mass", s.eroded.vanished_mass);
  });
  v.group("balance", [&] {
    v.value("elements", s.balance.elements);
    v.value("contact", s.balance.contact);
  });
  v.group("messages", [&] {
    v.value("count", s.messages.count);
    v.value("bytes", s.messages.bytes);
  });
  v.group("decomposition", [&] {
    v.value("rebalances", s.decomposition.rebalances);
    v.value("worst_imbalance", s.decomposition.worst_imbalance);
    v.value("rounds_per_cut", s.decomposition.rounds_per_cut);
    v.value("ghost_faces", s.decomposition.ghost_faces);
  });
  v.value("peak_bytes", s.peak_bytes);
  v.value("state_hash", s.state_hash);
  v.later_group("deck", [&] {
    v.value("file", s.deck.file);
    v.value("settings", s.deck.settings);
    v.json("values", s.deck.values);
  });
}

class Writer {
 public:
  Json take() { return std::move(root_); }

  template <class T>
  void value(const char* key, const T& member) {
    if constexpr (std::is_same_v<T, std::vector<Warning>>) {
      (*object_)[key] = to_json(member);
    } else if constexpr (std::is_same_v<T, std::vector<SensorSummary>>) {
      Json& list = (*object_)[key] = Json::array();
      for (const SensorSummary& s : member)
        list.push_back({{"sensor", s.sensor}, {"time", s.time}, {"value", s.value}});
    } else {
      (*object_)[key] = member;
    }
  }

  template <class T>
  void later_value(const char* key, const T& member) {
    value(key, member);
  }

  /// A text that is JSON itself; empty: null.
  void json(const char* key, const std::string& text) { (*object_)[key] = text.empty() ? Json() : Json::parse(text); }

  template <class Visit>
  void group(const char* key, Visit&& visit) {
    Json* const outer = object_;
    object_ = &((*outer)[key] = Json::object());
    visit();
    object_ = outer;
  }
  template <class Visit>
  void later_group(const char* key, Visit&& visit) {
    group(key, visit);
  }

 private:
  Json root_ = Json::object();
  Json* object_ = &root_;
};

class Reader {
 public:
  Reader(const Json& root, const std::string& path) : object_(&root), path_(path) {}

  /// Reads a key that summaries of older versions lack.
  template <class T>
  void later_value(const char* key, T& member) {
    if (object_->contains(key)) value(key, member);
  }

  template <class T>
  void value(const char* key, T& member) {
    const Json& found = find(key);
    if constexpr (std::is_array_v<T>) {
      if (!found.is_array() || found.size() != std::extent_v<T>) fail(key, "is not a list of three numbers");
      for (std::size_t i = 0; i < std::extent_v<T>; ++i) read(key, found[i], member[i]);
    } else {
      read(key, found, member);
    }
  }

  template <class Visit>
  void group(const char* key, Visit&& visit) {
    const Json* const outer = object_;
    const std::string outer_prefix = prefix_;
    object_ = &find(key);
    if (!object_->is_object()) fail(key, "is not an object");
    prefix_ += fmt::format("{}.", key);
    visit();
    object_ = outer;
    prefix_ = outer_prefix;
  }
  template <class Visit>
  void later_group(const char* key, Visit&& visit) {
    if (object_->contains(key)) group(key, visit);
  }

  void json(const char* key, std::string& text) {
    const Json& found = find(key);
    if (!found.is_object() && !found.is_null()) fail(key, "is not an object");
    text = found.is_null() ? "" : found.dump(-1, ' ', false, Json::error_handler_t::replace);
  }

 private:
  const Json& find(const char* key) const {
    const auto found = object_->find(key);
    if (found == object_->end()) fail(key, "is missing");
    return *found;
  }

  // JSON has no NaN or infinity: they are written as null.
  void read(const char* key, const Json& found, double& member) const {
    if (!found.is_number() && !found.is_null()) fail(key, "is not a number");
    member = found.is_null() ? std::numeric_limits<double>::quiet_NaN() : found.get<double>();
  }
  template <class Int>
  requires std::is_integral_v<Int>
  void read(const char* key, const Json& found, Int& member) const {
    if (!found.is_number_integer()) fail(key, "is not a whole number");
    member = found.get<Int>();
  }
  void read(const char* key, const Json& found, std::string& member) const {
    if (!found.is_string()) fail(key, "is not a text");
    member = found.get<std::string>();
  }
  void read(const char* key, const Json& found, std::vector<std::string>& member) const {
    if (!found.is_array()) fail(key, "is not a list of texts");
    for (const Json& item : found) read(key, item, member.emplace_back());
  }
  void read(const char* key, const Json& found, std::vector<SensorSummary>& member) const {
    if (!found.is_array()) fail(key, "is not a list of sensors");
    for (const Json& item : found) {
      if (!item.is_object() || !item.contains("sensor") || !item.contains("time") || !item.contains("value"))
        fail(key, "is not a list of sensors");
      SensorSummary& sensor = member.emplace_back();
      read(key, item["sensor"], sensor.sensor);
      read(key, item["time"], sensor.time);
      read(key, item["value"], sensor.value);
    }
  }
  void read(const char* key, const Json& found, std::vector<Warning>& member) const {
    auto warnings = from_json(found);
    if (!warnings) fail(key, "is not a list of warnings");
    member = *std::move(warnings);
  }

  [[noreturn]] void fail(const char* key, const char* problem) const {
    throw InputError(fmt::format("{}: error: '{}{}' {} (every key of a percuss summary has one type)", path_, prefix_,
                                 key, problem));
  }

  const Json* object_;
  const std::string& path_;
  std::string prefix_;
};

std::string read_text(const std::string& path) {
  const std::unique_ptr<std::FILE, int (*)(std::FILE*)> file(std::fopen(path.c_str(), "rbe"), std::fclose);
  if (!file) throw make_io_error("read", path, errno);
  std::string text;
  std::array<char, 4096> part;
  while (const std::size_t count = std::fread(part.data(), 1, part.size(), file.get())) text.append(part.data(), count);
  if (std::ferror(file.get()) != 0) throw make_io_error("read", path, errno);
  return text;
}

// nlohmann counts bytes; users count lines and columns.
std::string find_place(const std::string& text, std::size_t byte) {
  std::size_t line = 1, column = 1;
  for (std::size_t i = 0; i + 1 < byte && i < text.size(); ++i) {
    column = text[i] == '\n' ? 1 : column + 1;
    line += text[i] == '\n' ? 1 : 0;
  }
  return fmt::format("{}:{}", line, column);
}

}  // namespace

void write_summary(const std::string& path, const Summary& summary) {
  Writer writer;
  visit_summary(summary, writer);
  // An error text with bytes that are not UTF-8 (a file name) must not keep the summary from being written.
  const std::string text = writer.take().dump(2, ' ', false, Json::error_handler_t::replace) + '\n';
  write_file_atomically(path, text, Durability::disk);
}

std::string describe_step_limit(const Summary& summary) {
  const bool is_short = summary.time < summary.end_time * (1 - 1e-9);  // a run may end a rounding error early
  if (summary.status != "completed" || !is_short) return "";
  if (!summary.ended_by.empty())
    return fmt::format("ended by sensor '{}' at t = {:.6g}, {:.2g} % of time.end", summary.ended_by, summary.time,
                       100 * summary.time / summary.end_time);
  return fmt::format("stopped by time.max_steps at {:.2g} % of time.end", 100 * summary.time / summary.end_time);
}

std::string describe_warnings(const Summary& summary, const std::string& directory) {
  const std::size_t count = summary.warnings.size();
  return count == 0 ? "" : fmt::format("{} warning{}: see {}/summary.json", count, count == 1 ? "" : "s", directory);
}

std::string write_earlier(const EarlierSummary& earlier) {
  Writer writer;
  visit_earlier(earlier, writer);
  return writer.take().dump();
}

EarlierSummary read_earlier(const std::string& text, const std::string& path) {
  const Json json = Json::parse(text, nullptr, false);
  if (!json.is_object()) throw InputError(fmt::format("{}: error: the cost of the runs before it is not JSON", path));
  EarlierSummary earlier;
  Reader reader(json, path);
  visit_earlier(earlier, reader);
  return earlier;
}

Summary read_summary(const std::string& path) {
  const std::string text = read_text(path);
  Json json;
  try {
    json = Json::parse(text);
  } catch (const Json::parse_error& error) {
    throw InputError(fmt::format("{}:{}: error: this is not JSON (a summary.json of percuss is expected)", path,
                                 find_place(text, error.byte)));
  }
  if (!json.is_object())
    throw InputError(
        fmt::format("{}:1:1: error: this is not a JSON object (a summary.json of percuss is expected)", path));
  Summary summary;
  Reader reader(json, path);
  visit_summary(summary, reader);
  return summary;
}

}  // namespace percuss
