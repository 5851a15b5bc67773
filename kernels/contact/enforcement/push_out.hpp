#pragma once
// Overlap at the start that is pushed out (contact.overlap: push_out): how much of it a row releases after a step.
//
// A row is held at its reference, as accepted overlap is, and the reference shrinks a step by a thousandth of the
// overlap, by contact_limits::recovery of h at most. Bodies at rest keep the energy of this speed u, so a small overlap
// goes slowly. Against a load that would do work: in an impact at v some 2 m u v. So a row waits while its sides come
// together faster than u, and while it pushes more than what has been pushed out can press: the push of bodies at the
// speed u, and that of a spring of the stiffness 1 / (D dt^2).

#include "kernels/contact/rows/contact_row.hpp"

namespace percuss {

/// Steps that a small overlap takes.
inline constexpr double push_out_steps = 1000;
/// Way P D dt of a push that moves bodies apart at the speed u, in ways of u.
inline constexpr double push_out_ways = 0.25;
/// Stiffness of bodies under what has been pushed out of them, in units of 1 / (D dt^2). Those that are one element
/// thick and held behind it are the stiffest.
inline constexpr double push_out_stiffness = 1.5;

/// Part of its overlap that the row releases after the step, at whose end its gap is `gap`. What opens faster by itself
/// is not pushed.
KOKKOS_INLINE_FUNCTION double find_release(const ContactRow& row, double gap, double dt) {
  if (!(row.to_push > 0 && row.reference > 0)) return 0;
  const double fastest = contact_limits::recovery * row.size, calm = row.to_push / push_out_steps;
  const double way = calm < fastest ? calm : fastest, opened = gap - row.gap_start;
  if (opened < -way) return 0;
  const double load = row.impulse.normal * row.stiffness * dt;
  if (load > push_out_ways * way + push_out_stiffness * (row.to_push - row.reference)) return 0;
  const double wanted = opened > way ? 2 * way - opened : way;
  return wanted < 0 ? 0 : (wanted < row.reference ? wanted : row.reference);
}

}  // namespace percuss
