#pragma once
// The lengths and angles at which contact decides, each relative to the size of the face concerned.
//
// The size h of a face is its shortest edge or, where that is less, the thickness of the element behind it, so that
// the far side of a thin part is never taken for its near side. docs/theory_contact.md says what each value guards.

namespace percuss::contact_limits {

/// A node beside a face by no more than this still hits it: wider than round-off, far below what a user would see.
inline constexpr double new_band = 1e-3;
/// As new_band, for a node that has been pushed by this face or a neighbour: it may not fall off a curved edge.
inline constexpr double history_band = 1e-2;
/// A node behind a face by more than this, at the start of a step and without history, did not come through it.
inline constexpr double new_depth = 0.02;
/// A node that slipped in just below an edge is lifted over it up to this depth, beyond it is caught by the face that
/// it came through.
inline constexpr double lift_depth = 5e-3;
/// new_depth with history: beyond it the contact is lost rather than pushed out violently.
inline constexpr double history_depth = 0.25;
/// A face that the node does not reach in the step still gets a row up to this distance: it may be pushed there.
inline constexpr double row_gap = 0.02;
/// ... plus this many times the relative displacement of the step.
inline constexpr double row_gap_ways = 2;
/// As row_gap, for a face that pushed the node in the last step. The predicted motion continues that of the last step,
/// and may be wrong.
inline constexpr double history_row_gap = 0.25;
/// No accepted pair is farther apart than this; capture boxes are widened by it.
inline constexpr double capture = 0.27;
/// Penetration of an earlier step is recovered by at most this a step; more would throw bodies apart.
inline constexpr double recovery = 1e-4;
/// Sides push each other from this depth on, a share of the largest coordinate of the mesh at the start: some 45 times
/// the round-off of places. What flies farther than that out of the scene has round-off that is larger.
inline constexpr double depth_tolerance = 1e-14;
/// Depths below this are round-off of a mesh that touches, not an overlap.
inline constexpr double overlap = 1e-6;

/// Springs of contact (penalty) give way by this share of h: below what history keeps (history_depth), far above what
/// slow impacts need.
inline constexpr double spring_cushion = 0.05;

/// A node can hit a face only if the normal of one of the node's own faces opposes it: the cosine is at most this.
inline constexpr double opposing = -0.2;
/// Faces of one smooth surface: within this cosine vertex normals are averaged ...
inline constexpr double smooth = 0.9;
/// ... and history passes from a face to a neighbour within this one.
inline constexpr double inherited = 0.7;
/// Two accepted normals of a node are further apart than this cosine.
inline constexpr double independent = 0.95;

/// Edges where faces meet convexly with less than this cosine between their normals can cross others: above 30 degrees
/// by more than round-off, which would choose among the edges of a cylinder of twelve sides.
inline constexpr double feature = 0.866025403;
/// Edges with a cosine below this one (20 degrees) hold what has crossed them by blunt_depth.
inline constexpr double blunt = 0.939692620;
/// Shells are curved where faces meet with less than this one (half a degree: flat meshes have round-off). Faces of
/// solids that meet less concavely than this sine, of the same angle, are flat or convex.
inline constexpr double curved = 0.999961923, concave_sine = 8.72654e-3;
/// A feature edge this many times as long as a mesh line of a solid of another part may pass between the nodes of that
/// ...
inline constexpr double passing_edges = 1.5;
/// ... and this many times as long between those of a curved shell, whose nodes keep half a thickness.
inline constexpr double passing_edges_of_shells = 3;
/// Edges that cross at a lesser angle than with this sine are nearly parallel: their nodes meet faces.
inline constexpr double least_sine = 0.05;
/// Share of an edge at each end that is left to nodes and faces.
inline constexpr double end_band = 1e-3;
/// A contact with history is kept past an end by this share of the edge: in a concave corner of bent edges neither pair
/// may be released before the other is active ...
inline constexpr double history_end_band = 3e-2;
/// ... and by this share of the predicted depth. Where edges of one line of elements have bent into a valley, the place
/// of a body that presses into it leaves both; the tangent of half the bend is what it leaves them by.
inline constexpr double history_bend = 0.5;
/// A plane parts two wedges if no face reaches through it by more than this sine ...
inline constexpr double reach_through = 0.1;
/// ... or, with history, by this one.
inline constexpr double history_reach_through = 0.3;

/// Held directions leave a row at least this share of its freedom (the square of the sine between the push and the
/// directions that are held), or it is held as a whole.
inline constexpr double least_freedom = 1e-6;

/// Independent pushes a node may obey at once.
inline constexpr int max_touches = 3;
/// Friction of a tie's row, which holds its three directions both ways.
inline constexpr double no_friction_limit = 1e300;
/// Quanta of the keys that order the faces of a node: share of the step, of h.
inline constexpr double time_quantum = 1.0 / 1024;
inline constexpr double depth_quantum = 1e-3;
inline constexpr double off_quantum = 1e-4;

}  // namespace percuss::contact_limits
