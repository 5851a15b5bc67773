#pragma once
// What elements do with energy, and what else they leave of a step.

namespace percuss {

/// Kinds of work that elements are given. Launchers add them up by chunk; the audit, the books of eroded elements,
/// checkpoints and the summary take all of them, by name.
struct WorkKind {
  enum : int { internal, hourglass, viscous, folding, count };
  static constexpr const char* names[count] = {"internal", "hourglass", "viscous", "folding"};
};
inline constexpr int work_kinds = WorkKind::count;

/// What an element, or a pack of them, leaves of a step besides forces.
template <class Work, class T>
struct ElementResult {
  Work work;      // put into the element [energy]
  T stable_step;  // bound for the next step, without the deck's scale
  T size;         // volume, area or length at n+1; not positive: the element is inverted
};

}  // namespace percuss
