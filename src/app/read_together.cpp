#include "src/app/read_together.hpp"

#include "src/app/memory_check.hpp"
#include "src/deck/read_deck.hpp"
#include "src/fail_together.hpp"

namespace percuss {

Deck read_deck_together(const Command& command, const Communicator& ranks) {
  Deck deck;
  fail_together(ranks, [&] {
    deck = read_deck(command.file, command.settings);
    check_memory(deck);
  });
  return deck;
}

}  // namespace percuss
