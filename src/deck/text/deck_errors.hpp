#pragma once
// All that is wrong with a deck, gathered so that the user sees every message at once.

#include <compare>
#include <string>
#include <vector>

#include "src/warning.hpp"

namespace percuss {

/// A place in the deck, both counted from 1; 0 if there is none (a default). A value of --set has line -1 for the first
/// of them, -2 for the second.
struct Place {
  int line = 0;
  int column = 0;
};

/// Where a message points: a place in the deck, or the --set argument (its number, from 0) that brought the value.
struct Spot {
  Place place;
  int override = -1;
};

class DeckErrors {
 public:
  /// `file` names the deck; `override_paths` are the left sides of the --set arguments, for messages.
  DeckErrors(std::string file, std::vector<std::string> override_paths);

  /// Adds an error. Throws InputError at once when there are more than any reader could want (most_errors).
  void add(Spot spot, std::string message);

  /// Adds a warning of a rule: the deck is accepted, the message is shown.
  void warn(Spot spot, std::string rule, std::string message);

  /// Throws InputError with every message, one a line, sorted by place, repeats collapsed; returns if there is none.
  void throw_if_any() const;

  bool empty() const { return errors_.empty(); }

  /// Sorted by place, repeats collapsed: after a few of them one stands for the others, with their number.
  std::vector<Warning> warnings() const;

 private:
  struct Message {
    Spot spot;
    std::string rule, text;
  };
  struct Collapsed {
    std::vector<Warning> shown, others;  // others: each stands for further places of a text
  };
  Collapsed collapse(std::vector<Message> messages) const;
  std::string name(Spot spot) const;

  std::string file_;
  std::vector<std::string> override_paths_;
  std::vector<Message> errors_, warnings_;
};

}  // namespace percuss
