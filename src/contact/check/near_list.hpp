#pragma once
// A list of the pairs that are near enough to be checked, made where it leaves out enough.

namespace percuss {

/// List: of pairs, with their number as num_pairs.
template <class List>
class NearList {
 public:
  /// pause: where a list is not worth it, the next is made after so many turns without one.
  explicit NearList(int pause) : pause_(pause) {}

  /// The pairs are others now, and all of them are checked.
  void forget() { is_used_ = is_due_ = false; }

  /// wanted: whether it is to be made at the next check; keeps: whether that of before still holds until then.
  void ask(bool wanted, bool keeps) {
    is_used_ = is_used_ && keeps;
    is_due_ = wanted && turns_to_pass_ == 0;
    if (wanted && turns_to_pass_ > 0) --turns_to_pass_;
  }
  bool is_due() const { return is_due_; }

  /// Makes it, if it is due. fill(most_pairs, list): whether there are at most so many, which are then listed.
  template <class Fill>
  void make(const List& all, const Fill& fill) {
    constexpr double worth_it = 0.7;  // share of the pairs above which a list of its own saves nothing
    if (!is_due_) return;
    is_due_ = false;
    is_used_ = fill(worth_it * all.num_pairs, list_);
    if (!is_used_) turns_to_pass_ = pause_;
  }

  /// The near pairs, or all where they are not listed.
  const List& choose(const List& all) const { return is_used_ ? list_ : all; }

 private:
  List list_;
  int pause_;
  bool is_used_ = false, is_due_ = false;
  int turns_to_pass_ = 0;
};

}  // namespace percuss
