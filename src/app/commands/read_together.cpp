#include "src/app/commands/read_together.hpp"

#include "comm/agreement.hpp"
#include "src/app/process/external_files.hpp"
#include "src/app/process/memory_check.hpp"
#include "src/deck/reading/read_deck.hpp"
#include "src/deck/text/deck_text.hpp"
#include "src/fail_together.hpp"

namespace percuss {

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
    check_memory(deck, memory);
    if (ranks.rank() == 0 && !command.allow_external) refuse_external_meshes(deck);
  });
  return deck;
}

}  // namespace percuss
