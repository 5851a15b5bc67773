#include "src/app/process/command_line.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cctype>
#include <cmath>
#include <limits>
#include <memory>
#include <optional>
#include <sstream>
#include <utility>

#include "src/app/process/help_texts.hpp"
#include "src/app/process/tools.hpp"
#include "src/app/process/version.hpp"
#include "src/deck/text/nearest_name.hpp"

namespace percuss {
namespace {

/// More ranks than any machine has; beyond, a plan only fills memory.
constexpr int most_ranks = 1'000'000;

/// The whole numbers of ranks in "1,8,64". Throws CLI::ValidationError for anything else.
std::vector<int> read_rank_counts(const std::string& text) {
  std::vector<int> counts;
  for (std::size_t first = 0; first <= text.size();) {
    const std::size_t end = std::min(text.find(',', first), text.size());
    const std::string word = text.substr(first, end - first);
    int value = 0;
    if (!CLI::detail::lexical_cast(word, value) || value < 1 || value > most_ranks) {
      throw CLI::ValidationError("--ranks",
                                 fmt::format("'{}' (must be a whole number from 1 to {})", word, most_ranks));
    }
    counts.push_back(value);
    first = end + 1;
  }
  return counts;
}

/// Accepts finite numbers that are at least `least`, which `words` say.
CLI::Validator at_least(double least, const std::string& words) {
  const auto check = [=](const std::string& text) -> std::string {
    double value = 0;
    if (CLI::detail::lexical_cast(text, value) && std::isfinite(value) && value >= least) return "";
    return fmt::format("'{}' (must be a number, {})", text, words);
  };
  return CLI::Validator(check, "");
}

/// The text in lines of at most `width` letters.
std::string wrap(const std::string& text, std::size_t width) {
  std::string lines;
  std::size_t length = 0;  // of the last line
  std::istringstream words(text);
  for (std::string word; words >> word;) {
    const bool fits = length + 1 + word.size() <= width;
    if (length > 0) lines += fits ? ' ' : '\n';
    length = length > 0 && fits ? length + 1 + word.size() : word.size();
    lines += word;
  }
  return lines;
}

/// Lists options and commands within 80 columns.
class HelpFormatter : public CLI::Formatter {
 public:
  HelpFormatter() {
    column_width(name_columns);
    label("SUBCOMMAND", "COMMAND");
  }
  std::string make_option_desc(const CLI::Option* option) const override {
    return wrap(option->get_description(), columns - name_columns);
  }

 private:
  static constexpr std::size_t columns = 80, name_columns = 26;
};

struct Parser {
  CLI::App app{help_texts::about, "percuss"};
  CLI::App *run = nullptr, *check = nullptr, *plan = nullptr, *info = nullptr, *schema = nullptr;
  Command command;
  bool version = false, page = false;

  Parser() {
    app.footer(help_texts::general);
    app.formatter(std::make_shared<HelpFormatter>());  // before the commands, which take it over
    app.set_help_flag("-h,--help", "Print this help");
    app.add_flag("--version", version, "Print the version");
    run = add("run", "Run a deck", help_texts::run);
    check = add("check", "Check a deck and its meshes without running them", help_texts::check);
    plan = add("plan", "Predict how a deck would run on many ranks", help_texts::plan);
    info = add("info", "Describe a results file or a mesh", help_texts::info);
    schema = add("schema", "Print a JSON Schema of the deck, for editors", help_texts::schema);
    add_tool("import", "Convert an LS-DYNA or Abaqus model to a deck", "Commands");
    add_tool("sweep", "Run a deck with many values, and compare the results", "Commands");
    add_tool("build-law", "Compile a material law of your own as a library", "Commands");
    const char* of_results = "Results";
    add_tool("plot", "Plot columns of history.csv for one or more runs", of_results);
    add_tool("report", "Write one page about a run, or a comparison of runs", of_results);
    add_tool("watch", "Follow a run in the terminal", of_results);
    add_tool("stop", "Stop an active run, or request a frame or a checkpoint", of_results);
    add_tool("render", "Draw pictures and an animation of the fields", of_results);
    add_tool("view", "Write the surface over time as an interactive page", of_results);
    add_tool("export", "Write fields in formats of other programs", of_results);
    add_deck(run);
    add_deck(check);
    add_deck(plan);
    add_plan_options();
    add_check_options();
    run->add_option("-o,--out", command.out_dir, "Folder for the results (default: out/SCENE)")->type_name("DIR");
    run->add_option("-r,--restart", command.restart,
                    "Continue from a checkpoint of this deck's run, or the one in a folder")
        ->type_name("FILE|DIR");
    run->add_flag("-f,--force", command.force, "Overwrite the results of an earlier run in that folder");
    run->add_flag("-q,--quiet", command.quiet, "Print no progress and no report; warnings are still printed");
    info->add_option("FILE", command.file, "The file or folder")->required()->type_name("");
    add_external(info);
    add_info_options();
    // Fallthrough and extras: wrong words come back to us, so that we can hint at the right ones.
    app.allow_extras();
  }

  using Choice = std::pair<CLI::App*, Command::Kind>;

  /// The command that was given, if any.
  std::optional<Choice> find_parsed() const {
    using Kind = Command::Kind;
    for (const Choice& choice : {Choice{run, Kind::run}, Choice{check, Kind::check}, Choice{plan, Kind::plan},
                                 Choice{info, Kind::info}, Choice{schema, Kind::schema}}) {
      if (choice.first->parsed()) return choice;
    }
    return std::nullopt;
  }

  CLI::App* add(const char* name, const char* description, const char* help) {
    CLI::App* sub = app.add_subcommand(name, description);
    sub->footer(help);
    sub->group("Commands");
    sub->set_help_flag("-h,--help", "Print this help");
    sub->allow_extras();
    return sub;
  }

  /// A program of its own (tools.hpp), here for its line of help.
  void add_tool(const char* name, const char* description, const char* group) {
    add(name, description, "")->group(group);
    app.get_subcommand(name)->footer(fmt::format("\npercuss {} --help lists its options.", name));
  }

  void add_plan_options() {
    // Not the library's own list of values, which leaves out empty ones.
    plan->add_option_function<std::string>(
            "-n,--ranks", [this](const std::string& text) { command.rank_counts = read_rank_counts(text); },
            "Numbers of ranks, with commas between them")
        ->required()
        ->type_name("N,...");
    const CLI::Validator zero_or_more = at_least(0, "zero or more"), one_or_more = at_least(1, "at least 1");
    const CLI::Validator above_zero = at_least(std::numeric_limits<double>::min(), "above zero");
    const auto figure = [&](const char* name, double& value, const CLI::Validator& valid, const char* unit,
                            const char* what) {
      plan->add_option(name, value, fmt::format("{} (default: {:g})", what, value))
          ->type_name(unit)
          ->allow_extra_args(false)
          ->check(valid);
    };
    PlanFigures& f = command.figures;
    figure("--latency", f.latency, zero_or_more, "SECONDS", "Time per message, whatever its size");
    figure("--bandwidth", f.bandwidth, above_zero, "BYTE/S", "Bytes that a rank sends in a second");
    figure("--element-ns", f.element_ns, above_zero, "NS", "Core time per element and step");
    figure("--contact-node-ns", f.contact_node_ns, zero_or_more, "NS", "Core time per contact node or face, and step");
    figure("--iterations", f.iterations, zero_or_more, "COUNT", "Iterations of the contact enforcement in a step");
    figure("--steps-per-search", f.steps_per_search, one_or_more, "COUNT", "Steps between two contact searches");
    plan->add_flag("--all-touch", f.all_touch,
                   "Every node near a face touches it (default: those that do at the start)");
  }

  /// --report and --out are those of the program that writes the page (tools.hpp), here for their lines of help.
  void add_check_options() {
    check->add_flag("--json", command.json, "Print the result as JSON, for programs");
    check->add_flag("--report", page, "Write a page about the scene and a short run of it");
    check->add_option("-o,--out", command.out_dir, "With --report: the page (default: SCENE_check.html)")
        ->type_name("FILE");
    check->add_flag("-f,--force", command.force, "With --report: write over a file that percuss check has not written");
  }

  /// Options of the program that prints the tables (tools.hpp), here for their lines of help.
  void add_info_options() {
    info->add_flag("--energies", page, "Print energies of the history: first, last and extreme values");
    info->add_flag("--forces", page, "Print forces of the history: peak with its time, impulse, mean");
    info->add_option_function<std::string>(
            "--units",
            [](const std::string&) {
              throw CLI::ValidationError("--units", "has no effect without --energies or --forces");
            },
            "With these two: convert to a system of units, such as 'mm, kg, ms'")
        ->type_name("SYSTEM");
  }

  void add_deck(CLI::App* sub) {
    sub->add_option("DECK", command.file, "The deck (YAML); docs/deck.md describes it")->required()->type_name("");
    sub->add_option("-s,--set", command.settings,
                    "Override a value of the deck; list items count from 0; may be repeated")
        ->type_name("KEY=VALUE")
        ->allow_extra_args(false);
    sub->add_option(
           "--allow-library", command.allowed_libraries,
           "Load this library with a law of yours (model: user or library), which the deck names; may be repeated")
        ->type_name("FILE")
        ->allow_extra_args(false);
    add_external(sub);
  }

  void add_external(CLI::App* sub) {
    sub->add_flag("--allow-external", command.allow_external,
                  "Allow HDF5 meshes and checkpoints that link to other files");
  }
};

Answer wrong(const std::string& problem, const std::string& help_for = "") {
  const std::string help = help_for.empty() ? "percuss --help" : "percuss " + help_for + " --help";
  return {fmt::format("percuss: error: {}\nTry '{}'.\n", problem, help), ExitCode::wrong_input};
}

std::vector<std::string> option_names(const CLI::App& app) {
  std::vector<std::string> names;
  for (const CLI::Option* option : app.get_options()) {
    for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
  }
  return names;
}

constexpr const char* how_many =
    " (threads of a rank: OMP_NUM_THREADS=N percuss run DECK; ranks: mpirun -n N percuss run DECK)";

/// Whether a word gives a number of threads or ranks, as other programs take it: -n, --threads, ncpu=4.
bool asks_for_threads(const std::string& word) {
  std::string name = word.substr(std::min(word.find_first_not_of('-'), word.size()));
  name = name.substr(0, name.find('='));
  std::transform(name.begin(), name.end(), name.begin(), [](unsigned char c) { return std::tolower(c); });
  const bool is_word = word.starts_with("--") || word.find('=') != std::string::npos;
  for (const char* known : {"threads", "num-threads", "ranks", "np", "ncpu", "ncpus", "cpu", "cpus", "cores", "jobs"})
    if (is_word && name == known) return true;
  return word == "-n" || word == "-np" || word == "-t" || word == "-j" || word == "-c";
}

/// Words that are no command; `words`: the first of them, and what follows.
Answer refuse_command(const std::vector<std::string>& words) {
  const std::string& word = words.front();
  const std::string next = words.size() > 1 ? words[1] : "DIR";
  if (word == "restart" || word == "resume" || word == "continue")
    return wrong(fmt::format("unknown command '{}' (to continue a run: percuss run DECK --restart {})", word, next),
                 "run");
  if (word.ends_with(".yaml") || word.ends_with(".yml"))
    return wrong(fmt::format("unknown command '{0}' (to run a deck: percuss run {0})", word));
  std::vector<std::string> commands = {"run", "check", "plan", "info", "schema"};
  commands.insert(commands.end(), tool_names().begin(), tool_names().end());
  commands.insert(commands.end(), {"help", "version"});
  return wrong(fmt::format("unknown command '{}'{}", word, name_hint(word, commands)));
}

/// `extras`: the words that were not understood, at least one.
Answer refuse_extras(const std::vector<std::string>& extras, const CLI::App& app, const std::string& command) {
  const std::string& extra = extras.front();
  if (!command.empty() && command != "plan" && asks_for_threads(extra)) {
    const std::string kind = extra.starts_with('-') ? "unknown option" : "unknown argument";
    return wrong(fmt::format("{} '{}'{}", kind, extra, how_many), command);
  }
  if (extra.starts_with('-') && extra.size() > 1) {
    const std::string name = extra.substr(0, extra.find('='));
    const auto known = option_names(app);
    if (std::find(known.begin(), known.end(), name) != known.end()) {
      return wrong(fmt::format("option '{}' stands before the command (it belongs after percuss {})", name, command),
                   command);
    }
    return wrong(fmt::format("unknown option '{}'{}", name, name_hint(name, known)), command);
  }
  if (command.empty()) return refuse_command(extras);
  const char* takes = command == "schema" ? "none" : "one file";
  return wrong(fmt::format("'{}' is one argument too many (percuss {} takes {})", extra, command, takes), command);
}

// CLI11's own reasons, in the words of this program.
Answer explain(const CLI::ParseError& error, Parser& parser) {
  const auto chosen = parser.find_parsed();
  if (!chosen) return wrong(error.what());
  const CLI::App& sub = *chosen->first;
  const std::string name = sub.get_name();
  if (!sub.remaining().empty()) return refuse_extras(sub.remaining(), sub, name);
  if (dynamic_cast<const CLI::ArgumentMismatch*>(&error) != nullptr) {  // "--out: 1 required DIR missing"
    const std::string reason = error.what(), option = reason.substr(0, reason.find(':'));
    const CLI::Option* known = sub.get_option_no_throw(option);
    return wrong(known == nullptr ? reason : fmt::format("{} needs a value: {}", option, known->get_type_name()), name);
  }
  if (dynamic_cast<const CLI::RequiredError*>(&error) != nullptr) {
    const bool lacks_ranks = chosen->second == Command::Kind::plan && sub.get_option("DECK")->count() > 0;
    const std::string needed = lacks_ranks                             ? "--ranks, the numbers of ranks to plan for"
                               : chosen->second == Command::Kind::info ? "a file"
                                                                       : "a deck";
    return wrong(fmt::format("percuss {} needs {}", name, needed), name);
  }
  return wrong(error.what(), name);
}

constexpr const char* why_empty = "the shell variable that it was taken from is probably not set";

// Before the library parses: it takes the word after "--out=" for the value, and what a value means is not its
// business.
std::optional<Answer> refuse_empty_argument(int argc, const char* const* argv) {
  for (int i = 1; i < argc; ++i) {
    const std::string word = argv[i], before = argv[i - 1];
    const bool is_open = word.starts_with("--") && word.find('=') + 1 == word.size();
    if (!word.empty() && !is_open) continue;
    const bool is_flag = before == "-q" || before == "--quiet" || before == "-f" || before == "--force";
    const bool follows_option = word.empty() && i > 1 && before.size() > 1 && before.starts_with('-') && !is_flag;
    if (!is_open && !follows_option)
      return wrong(fmt::format("an argument is empty ({}): give the name of a file or folder", why_empty));
    const std::string option = is_open ? word.substr(0, word.size() - 1) : before;
    return wrong(fmt::format("option '{}' has an empty value ({}): give it a value, or leave the option out", option,
                             why_empty));
  }
  return std::nullopt;
}

/// --set time.end 1e-4
std::optional<Answer> refuse_split_setting(const std::vector<std::string>& words, const std::string& command) {
  for (std::size_t i = 0; i + 2 < words.size(); ++i) {
    const std::string &path = words[i + 1], &value = words[i + 2];
    if ((words[i] != "--set" && words[i] != "-s") || path.find('=') != std::string::npos || value.starts_with("--"))
      continue;
    return wrong(fmt::format("'--set {0} {1}' has a space for the '=': --set {0}={1}", path, value), command);
  }
  return std::nullopt;
}

std::optional<Answer> refuse_empty_setting(const Command& command) {
  for (const std::string& setting : command.settings) {
    if (setting.find('=') + 1 != setting.size()) continue;
    return wrong(fmt::format("'--set {}' gives no value ({}): write the value after the '='", setting, why_empty));
  }
  return std::nullopt;
}

/// Answers `help`, `help COMMAND` and `version`, which stand for options; nothing for other words. They are no commands
/// of the library, which would then take a deck of such a name for one.
std::optional<Answer> answer_word(const std::vector<std::string>& words, const Parser& parser) {
  if (words.empty() || (words[0] != "help" && words[0] != "version")) return std::nullopt;
  const bool is_help = words[0] == "help";
  if (words.size() > (is_help ? 2 : 1)) {
    return wrong(fmt::format("'{}' is one argument too many (percuss {})", words.back(),
                             is_help ? "help takes one command" : "version takes none"));
  }
  if (!is_help) return Answer{describe_version(), ExitCode::done};
  if (words.size() == 1 || words[1] == "help" || words[1] == "version" || words[1].starts_with('-')) {
    return Answer{parser.app.help(), ExitCode::done};
  }
  const auto named =
      parser.app.get_subcommands([&](const CLI::App* command) { return command->get_name() == words[1]; });
  if (named.empty()) return refuse_extras({words[1]}, parser.app, "");
  return Answer{named.front()->help("percuss"), ExitCode::done};
}

}  // namespace

std::variant<Command, Answer> parse_command_line(int argc, const char* const* argv) {
  if (const auto refusal = refuse_empty_argument(argc, argv)) return *refusal;
  Parser parser;
  if (auto answer = answer_word({argv + std::min(argc, 1), argv + argc}, parser)) return *std::move(answer);
  try {
    parser.app.parse(argc, argv);
  } catch (const CLI::CallForHelp&) {
    if (const auto chosen = parser.find_parsed()) return Answer{chosen->first->help("percuss"), ExitCode::done};
    return Answer{parser.app.help(), ExitCode::done};
  } catch (const CLI::ParseError& error) {
    return explain(error, parser);
  }
  if (parser.version) return Answer{describe_version(), ExitCode::done};
  const auto chosen = parser.find_parsed();
  if (!chosen) {
    const auto extras = parser.app.remaining();
    if (!extras.empty()) return refuse_extras(extras, parser.app, "");
    return Answer{parser.app.help(), ExitCode::wrong_input};
  }
  const auto extras = parser.app.remaining(true);
  if (!extras.empty()) {
    if (auto answer = refuse_split_setting({argv + 1, argv + argc}, chosen->first->get_name()))
      return *std::move(answer);
    return refuse_extras(extras, *chosen->first, chosen->first->get_name());
  }
  parser.command.kind = chosen->second;
  if (parser.command.kind == Command::Kind::check && (!parser.command.out_dir.empty() || parser.command.force))
    return wrong("percuss check writes a file with --report only (--out names it)", "check");
  if (const auto refusal = refuse_empty_setting(parser.command)) return *refusal;
  return parser.command;
}

}  // namespace percuss
