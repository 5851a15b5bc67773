#pragma once
// What elements do with energy.

namespace percuss {

/// Kinds of work that elements are given. Launchers add them up by chunk; the audit, the books of eroded elements,
/// checkpoints and the summary take all of them, by name.
struct WorkKind {
  enum : int { internal, hourglass, viscous, folding, count };
  static constexpr const char* names[count] = {"internal", "hourglass", "viscous", "folding"};
};
inline constexpr int work_kinds = WorkKind::count;

}  // namespace percuss
