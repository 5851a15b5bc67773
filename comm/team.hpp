#pragma once
// Ranks that work together for a while, among others that do not, and their communicator.
//
// A communicator costs some collective operations to make. It is therefore kept as long as its ranks contain those that
// have work, and made anew only for a rank that joins. From time to time ranks that had none since leave it.

#include <vector>

#include "comm/communicator.hpp"

namespace percuss {

class Team {
 public:
  /// Ranks leave after so many meetings without work.
  static constexpr int patience = 64;

  /// Nobody at first. `ranks` outlives this.
  explicit Team(const Communicator& ranks) : ranks_(ranks), is_in_(count(), 0), has_worked_(count(), 0) {}
  ~Team() { leave(); }
  Team(const Team&) = delete;
  Team& operator=(const Team&) = delete;

  /// has_work: [ranks of all], the same on every rank. Afterwards the team contains these, and perhaps others, who have
  /// to join in what it does collectively. Every rank calls it; collective over the ranks of a new team. Throws
  /// MpiError.
  void meet(const std::vector<char>& has_work);

  /// Whether a rank is in the team, and how many are.
  bool contains(int rank) const { return is_in_[static_cast<std::size_t>(rank)] != 0; }
  bool contains_this() const { return contains(ranks_.rank()); }
  int size() const { return size_; }

  /// The ranks of the team; on one of them only.
  Communicator ranks() const { return size_ == ranks_.size() ? ranks_ : Communicator(handle_); }

  /// How many communicators were made.
  int formations() const { return formations_; }

 private:
  std::size_t count() const { return static_cast<std::size_t>(ranks_.size()); }
  void form(const std::vector<char>& members);
  void leave();

  const Communicator ranks_;
  std::vector<char> is_in_;       // [ranks]
  std::vector<char> has_worked_;  // [ranks] since the last check of who has
  int size_ = 0;
  int meetings_ = 0;  // since that look
  int formations_ = 0;
  MPI_Comm handle_ = MPI_COMM_NULL;  // of a team that is not everybody
};

}  // namespace percuss
