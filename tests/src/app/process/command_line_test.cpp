// Meaning of the arguments, and answers to wrong ones.

#include "src/app/process/command_line.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <vector>

namespace percuss {
namespace {

using testing::HasSubstr;

std::variant<Command, Answer> parse(std::vector<const char*> arguments) {
  arguments.insert(arguments.begin(), "percuss");
  return parse_command_line(static_cast<int>(arguments.size()), arguments.data());
}

Command command(const std::vector<const char*>& arguments) { return std::get<Command>(parse(arguments)); }
Answer answer(const std::vector<const char*>& arguments) { return std::get<Answer>(parse(arguments)); }

TEST(CommandLine, ReadsARun) {
  const Command run =
      command({"run", "--set", "a.b=1", "deck.yaml", "-s", "c=[1, 0, 0]", "--out", "dir", "--force", "-q"});
  EXPECT_EQ(run.kind, Command::Kind::run);
  EXPECT_EQ(run.file, "deck.yaml");
  EXPECT_THAT(run.settings, testing::ElementsAre("a.b=1", "c=[1, 0, 0]"));
  EXPECT_EQ(run.out_dir, "dir");
  EXPECT_TRUE(run.force);
  EXPECT_TRUE(run.quiet);
  EXPECT_FALSE(run.allow_external);
}

TEST(CommandLine, LetsFilesTakeDataFromOthersOnDemand) {
  EXPECT_TRUE(command({"run", "d", "--allow-external"}).allow_external);
  EXPECT_TRUE(command({"check", "d", "--allow-external"}).allow_external);
  EXPECT_TRUE(command({"check", "d", "--json"}).json);
  EXPECT_FALSE(command({"check", "d"}).json);
  EXPECT_TRUE(command({"plan", "d", "--ranks", "2", "--allow-external"}).allow_external);
  EXPECT_TRUE(command({"info", "mesh.e", "--allow-external"}).allow_external);
}

TEST(CommandLine, ReadsCheckInfoAndSchema) {
  EXPECT_EQ(command({"check", "deck.yaml"}).kind, Command::Kind::check);
  EXPECT_THAT(command({"check", "d", "--set=time.end=1"}).settings, testing::ElementsAre("time.end=1"));
  EXPECT_EQ(command({"info", "out"}).kind, Command::Kind::info);
  EXPECT_EQ(command({"info", "out"}).file, "out");
  EXPECT_EQ(command({"schema"}).kind, Command::Kind::schema);
}

TEST(CommandLine, ReadsAPlan) {
  const Command plan =
      command({"plan", "deck.yaml", "--ranks", "1,8,64", "-s", "a=1", "--latency", "1e-5", "--bandwidth=2e9",
               "--element-ns", "50", "--contact-node-ns", "0", "--iterations", "12.5", "--steps-per-search", "3"});
  EXPECT_EQ(plan.kind, Command::Kind::plan);
  EXPECT_EQ(plan.file, "deck.yaml");
  EXPECT_THAT(plan.rank_counts, testing::ElementsAre(1, 8, 64));
  EXPECT_THAT(plan.settings, testing::ElementsAre("a=1"));
  EXPECT_EQ(plan.figures.latency, 1e-5);
  EXPECT_EQ(plan.figures.bandwidth, 2e9);
  EXPECT_EQ(plan.figures.element_ns, 50);
  EXPECT_EQ(plan.figures.contact_node_ns, 0);
  EXPECT_EQ(plan.figures.iterations, 12.5);
  EXPECT_EQ(plan.figures.steps_per_search, 3);
  EXPECT_THAT(command({"plan", "-n", "4", "deck.yaml"}).rank_counts, testing::ElementsAre(4));
}

TEST(CommandLine, RefusesFiguresThatMakeNoSense) {
  EXPECT_THAT(answer({"plan", "d"}).text, HasSubstr("percuss plan needs --ranks"));
  EXPECT_THAT(answer({"plan", "-n", "4"}).text, HasSubstr("percuss plan needs a deck"));
  for (const char* ranks : {"0", "-2", "2.5", "1,x", "1,,2", "1,", "1e3", "2000000", "nan"}) {
    EXPECT_THAT(answer({"plan", "d", "--ranks", ranks}).text, HasSubstr("(must be a whole number from 1 to 1000000)"))
        << ranks;
  }
  EXPECT_THAT(answer({"plan", "d", "-n", "1", "--latency", "-1"}).text,
              HasSubstr("--latency: '-1' (must be a number, zero or more)"));
  for (const char* wrong : {"0", "-1", "inf", "fast"}) {
    EXPECT_THAT(answer({"plan", "d", "-n", "1", "--bandwidth", wrong}).text, HasSubstr("must be a number, above zero"));
  }
  EXPECT_THAT(answer({"plan", "d", "-n", "1", "--steps-per-search", "0"}).text,
              HasSubstr("must be a number, at least 1"));
}

TEST(CommandLine, HelpsOnDemand) {
  for (const char* flag : {"-h", "--help"}) {
    const Answer help = answer({flag});
    EXPECT_EQ(help.exit_code, ExitCode::done);
    for (const char* part : {"run", "check", "plan", "info", "schema", "Examples", "Exit codes", "OMP_NUM_THREADS"}) {
      EXPECT_THAT(help.text, HasSubstr(part));
    }
  }
  EXPECT_THAT(answer({"run", "--help"}).text, HasSubstr("Usage: percuss run"));
  EXPECT_THAT(answer({"check", "--help"}).text, HasSubstr("Usage: percuss check"));
  EXPECT_THAT(answer({"plan", "--help"}).text, HasSubstr("Usage: percuss plan"));
  EXPECT_THAT(answer({"info", "-h"}).text, HasSubstr("Usage: percuss info"));
  EXPECT_THAT(answer({"schema", "-h"}).text, HasSubstr("Usage: percuss schema"));
}

TEST(CommandLine, HelpsWithin80Columns) {
  for (const std::string name : {"", "run", "check", "plan", "info", "schema"}) {
    const Answer help = name.empty() ? answer({"--help"}) : answer({name.c_str(), "--help"});
    EXPECT_THAT(help.text, testing::Not(testing::ContainsRegex("[^\n]{81}"))) << name;
  }
}

TEST(CommandLine, TellsItsVersion) {
  EXPECT_EQ(answer({"--version"}).exit_code, ExitCode::done);
  EXPECT_THAT(answer({"--version"}).text, HasSubstr("percuss " PERCUSS_VERSION));
  EXPECT_THAT(answer({"--version"}).text, testing::ContainsRegex("\nbuilt     [A-Z].*\nlibraries .*HDF5 [0-9.]+\n"));
}

TEST(CommandLine, HelpsAndTellsItsVersionByWordsToo) {
  EXPECT_EQ(answer({"help"}).exit_code, ExitCode::done);
  EXPECT_EQ(answer({"help"}).text, answer({"--help"}).text);
  EXPECT_EQ(answer({"version"}).exit_code, ExitCode::done);
  EXPECT_EQ(answer({"version"}).text, answer({"--version"}).text);
  for (const char* name : {"run", "check", "plan", "info", "schema"}) {
    EXPECT_EQ(answer({"help", name}).exit_code, ExitCode::done) << name;
    EXPECT_EQ(answer({"help", name}).text, answer({name, "--help"}).text) << name;
  }
  for (const char* word : {"help", "version", "--help"}) {
    EXPECT_EQ(answer({"help", word}).text, answer({"--help"}).text) << word;
  }
  EXPECT_THAT(answer({"help"}).text, HasSubstr("`percuss help COMMAND`"));
}

TEST(CommandLine, RefusesHelpOfWhatIsNoCommand) {
  EXPECT_EQ(answer({"help", "rnu"}).exit_code, ExitCode::wrong_input);
  EXPECT_THAT(answer({"help", "rnu"}).text, HasSubstr("unknown command 'rnu' (did you mean 'run'?)"));
  EXPECT_THAT(answer({"hlep"}).text, HasSubstr("unknown command 'hlep' (did you mean 'help'?)"));
  EXPECT_THAT(answer({"help", "run", "deck.yaml"}).text,
              HasSubstr("'deck.yaml' is one argument too many (percuss help takes one command)"));
  EXPECT_THAT(answer({"version", "2"}).text, HasSubstr("'2' is one argument too many (percuss version takes none)"));
  EXPECT_EQ(answer({"version", "2"}).exit_code, ExitCode::wrong_input);
  EXPECT_EQ(command({"run", "help"}).file, "help") << "a deck may have any name";
}

TEST(CommandLine, HelpsWhenNothingIsAsked) {
  EXPECT_EQ(answer({}).exit_code, ExitCode::wrong_input);
  EXPECT_THAT(answer({}).text, HasSubstr("Usage: percuss"));
}

TEST(CommandLine, HintsAtWhatWasMeant) {
  EXPECT_THAT(answer({"rnu", "deck.yaml"}).text, HasSubstr("unknown command 'rnu' (did you mean 'run'?)"));
  EXPECT_THAT(
      answer({"simulate"}).text,
      HasSubstr("(known: run, check, plan, info, schema, import, plot, report, watch, stop, render, view, ...)"));
  EXPECT_THAT(answer({"run", "d", "--ouT", "x"}).text, HasSubstr("unknown option '--ouT' (did you mean '--out'?)"));
  EXPECT_THAT(answer({"--hepl"}).text, HasSubstr("unknown option '--hepl' (did you mean '--help'?)"));
  EXPECT_THAT(answer({"run"}).text, HasSubstr("percuss run needs a deck"));
  EXPECT_THAT(answer({"info"}).text, HasSubstr("percuss info needs a file"));
  EXPECT_THAT(answer({"check", "a", "b"}).text, HasSubstr("'b' is one argument too many"));
  EXPECT_THAT(answer({"schema", "deck.yaml"}).text,
              HasSubstr("'deck.yaml' is one argument too many (percuss schema takes none)"));
  EXPECT_THAT(answer({"--force", "run", "d"}).text, HasSubstr("option '--force' stands before the command"));
  EXPECT_THAT(answer({"ball.yaml"}).text,
              HasSubstr("unknown command 'ball.yaml' (to run a deck: percuss run ball.yaml)"));
  EXPECT_THAT(answer({"restart", "w"}).text,
              HasSubstr("unknown command 'restart' (to continue a run: percuss run DECK --restart w)"));
  EXPECT_THAT(answer({"resume"}).text, HasSubstr("percuss run DECK --restart DIR)"));
}

TEST(CommandLine, TellsWhatAnOptionAtTheEndNeeds) {
  EXPECT_THAT(answer({"run", "d", "--set"}).text, HasSubstr("--set needs a value: KEY=VALUE"));
  EXPECT_THAT(answer({"run", "d", "--out"}).text, HasSubstr("--out needs a value: DIR"));
  EXPECT_THAT(answer({"run", "d", "-r"}).text, HasSubstr("--restart needs a value: FILE|DIR"));
}

TEST(CommandLine, TellsHowThreadsAndRanksAreGiven) {
  const std::vector<std::vector<const char*>> wishes = {{"run", "d", "-n", "4"},     {"run", "d", "--threads", "4"},
                                                        {"run", "d", "--threads=4"}, {"run", "d", "ncpu=4"},
                                                        {"run", "d", "NCPU=4"},      {"check", "d", "-np", "2"}};
  for (const auto& arguments : wishes)
    EXPECT_THAT(
        answer(arguments).text,
        HasSubstr("' (threads of a rank: OMP_NUM_THREADS=N percuss run DECK; ranks: mpirun -n N percuss run DECK)"))
        << arguments[2];
}

TEST(CommandLine, TellsThatASettingHasAnEqualsSign) {
  EXPECT_THAT(answer({"run", "d", "--set", "time.end", "1e-4"}).text,
              HasSubstr("'--set time.end 1e-4' has a space for the '=': --set time.end=1e-4"));
  EXPECT_THAT(answer({"check", "-s", "time.end", "1e-4", "d"}).text, HasSubstr("--set time.end=1e-4"));
}

TEST(CommandLine, RefusesEmptyValuesSinceAShellVariableMayNotBeSet) {
  const std::vector<std::pair<std::vector<const char*>, const char*>> empty = {
      {{"run", "d", "--restart", "", "--force"}, "option '--restart' has an empty value"},
      {{"run", "d", "--restart="}, "option '--restart' has an empty value"},
      {{"run", "--out=", "d"}, "option '--out' has an empty value"},
      {{"run", "d", "-r", ""}, "option '-r' has an empty value"},
      {{"run", "d", "-o", ""}, "option '-o' has an empty value"},
      {{"run", "d", "--set", ""}, "option '--set' has an empty value"},
      {{"run", "d", "--set", "time.end="}, "'--set time.end=' gives no value"},
      {{"check", "d", "--set=time.end="}, "'--set time.end=' gives no value"},
      {{"plan", "d", "--ranks", ""}, "option '--ranks' has an empty value"},
      {{"plan", "d", "--ranks", "2", "--latency", ""}, "option '--latency' has an empty value"},
      {{"run", ""}, "an argument is empty"},
      {{"run", "--force", ""}, "an argument is empty"},
      {{"info", ""}, "an argument is empty"}};
  for (const auto& [arguments, text] : empty) {
    const auto parsed = parse(arguments);
    ASSERT_TRUE(std::holds_alternative<Answer>(parsed)) << text;
    EXPECT_EQ(std::get<Answer>(parsed).exit_code, ExitCode::wrong_input);
    EXPECT_THAT(std::get<Answer>(parsed).text, HasSubstr(text));
    EXPECT_THAT(std::get<Answer>(parsed).text, HasSubstr("shell variable"));
  }
  EXPECT_THAT(command({"run", "d", "--set", "a=b="}).settings, testing::ElementsAre("a=b="));
}

TEST(CommandLine, AnswersEveryMistakeWithExitCodeTwo) {
  const std::vector<std::vector<const char*>> mistakes = {{"rnu"},
                                                          {"run"},
                                                          {"run", "a", "b"},
                                                          {"run", "a", "-x"},
                                                          {"--bad"},
                                                          {"check", "a", "--out", "b"},
                                                          {"plan", "a", "--ranks", "0"},
                                                          {"schema", "a"},
                                                          {"schema", "--set", "a=1"},
                                                          {"run", "a", "--set"}};
  for (const auto& arguments : mistakes) {
    EXPECT_EQ(answer(arguments).exit_code, ExitCode::wrong_input) << arguments.front();
    EXPECT_THAT(answer(arguments).text, testing::StartsWith("percuss: error: "));
  }
}

}  // namespace
}  // namespace percuss
