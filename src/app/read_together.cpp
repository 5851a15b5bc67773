#include "src/app/read_together.hpp"

#include <fmt/format.h>

#include <cmath>
#include <filesystem>
#include <string>
#include <vector>

#include "comm/agreement.hpp"
#include "src/app/process/external_files.hpp"
#include "src/app/process/memory_check.hpp"
#include "src/deck/laws/material_properties.hpp"
#include "src/deck/laws/user_code.hpp"
#include "src/deck/laws/user_lengths.hpp"
#include "src/deck/laws/user_tables.hpp"
#include "src/deck/reading/read_deck.hpp"
#include "src/deck/text/deck_text.hpp"
#include "src/error.hpp"
#include "src/fail_together.hpp"

namespace percuss {
namespace {

/// Throws InputError if the first yield stress of the code, for a law that asks it for one, is not positive.
void check_first_yield(const Deck& deck, const MaterialDeck& material, const std::string& library) {
  const std::vector<double> yields = find_yields_of_code(material);
  if (yields.empty() || (yields[0] > 0 && std::isfinite(yields[0]) && std::isfinite(yields[1]))) return;
  throw InputError(fmt::format(
      "{}: error: material '{}' has the code of {}, which is no yield stress (at time 0 and the temperature "
      "at the start it answers with {:.3g} at a plastic strain and a rate of 0, with {:.3g} at 1e-3 and 1): "
      "correct the code, its constants, state_variables or start_temperature",
      deck.where(material.law.place), material.name, library, yields[0], yields[1]));
}

/// Throws InputError if the code does not answer to a small strain as a solid does.
void check_answer(const Deck& deck, const MaterialDeck& material, const std::string& library) {
  const LameConstants c = find_moduli(material);
  check_first_yield(deck, material, library);
  const bool is_solid = std::isfinite(c.lambda) && std::isfinite(c.mu) && c.mu > 0 && c.lambda + 2.0 / 3.0 * c.mu > 0;
  if (is_solid && !has_written_outside(library)) return;
  const std::string why = has_written_outside(library)
                              ? "it writes outside its arrays"
                              : fmt::format(
                                    "to a strain of 1e-6 at time 0 it answers with a bulk modulus of {:.3g} and a "
                                    "shear modulus of {:.3g}",
                                    c.lambda + 2.0 / 3.0 * c.mu, c.mu);
  throw InputError(
      fmt::format("{}: error: material '{}' has the code of {}, which is no law of a solid ({}): correct the "
                  "code, its constants or state_variables",
                  deck.where(material.law.place), material.name, library, why));
}

/// Throws InputError with the place of the first library that the command line has not named; loads the others, of
/// which one that is no law is reported here, before the mesh is read.
void load_user_laws(const Deck& deck, const Command& command) {
  permit_user_code(command.allowed_libraries);
  forget_user_tables();
  for (const MaterialDeck& material : deck.materials) {
    const std::string library = find_code_file(material.law);
    if (library.empty()) continue;
    if (!is_user_code_permitted(library))
      throw InputError(
          fmt::format("{}: error: material '{}' has code of a user (library {} would run with your "
                      "rights): add --allow-library {} if you trust it",
                      deck.where(material.law.place), material.name, library, library));
#ifdef PERCUSS_ON_DEVICE
    throw InputError(
        fmt::format("{}: error: material '{}' has code of a user (the back end is a device, which cannot call "
                    "it): use a build for OpenMP or Serial",
                    deck.where(material.law.place), material.name));
#endif
    try {
      if (const auto tables = material.law.texts.find("parameter_tables"); tables != material.law.texts.end())
        read_user_tables(tables->second);
      require_user_entries(material.law);
      check_answer(deck, material, library);
    } catch (const InputError& error) {
      const std::string text = error.what(), place = deck.where(material.law.place);
      throw InputError(text.starts_with(place) ? text : fmt::format("{}: {}", place, text));
    }
  }
}

}  // namespace

UserRun describe_run(const std::string& deck, const std::string& folder, const Communicator& ranks) {
  namespace fs = std::filesystem;
  UserRun run;
  run.job = fs::path(deck).stem().string();
  run.folder = fs::absolute(folder.empty() ? "." : folder).lexically_normal().string();
  run.rank = ranks.rank();
  run.ranks = ranks.size();
  if (ranks.size() > 1) run.communicator = static_cast<int>(MPI_Comm_c2f(ranks.handle()));
  run.end = [ranks] { ranks.abort(static_cast<int>(ExitCode::run_failed)); };
  return run;
}

Deck read_deck_together(const Command& command, const Communicator& ranks) {
  // One rank reads, so that all have the same deck, also while it is edited or where each machine has its own.
  std::string text;
  fail_together(ranks, [&] {
    if (ranks.rank() == 0) text = load_deck_text(command.file);
  });
  text = broadcast_text(ranks, text, 0);
  const double memory = sum_machine_memory(ranks);
  Deck deck;
  fail_together(ranks, [&] {
    deck = parse_deck(text, command.file, command.settings);
    set_user_run(describe_run(command.file, "", ranks));
    load_user_laws(deck, command);
    check_memory(deck, memory);
    if (ranks.rank() == 0 && !command.allow_external) refuse_external_meshes(deck);
  });
  return deck;
}

}  // namespace percuss
