#pragma once
// Contact nodes that lie inside another body (or another part of their own), and how far apart are contact nodes and
// the faces of other bodies in front of them? For the start of a run and for audits.
//
// From places alone: a node is inside a body by its least depth behind the faces of that body that it projects on.
// Deeper than half the size of a face it is no longer said to be behind that face, but out on the far side; of a shell,
// beyond the mid-surface. A node on the mid-surface counts with the side of the lower number.

#include "kernels/contact/check/detailed_check.hpp"

namespace percuss {

/// Penetration by contact node; depth 0 and face -1 where the node is outside.
struct PenetrationTable {
  Array<double> depth = Array<double>("contact::depth", 0);        // [length]
  Array<double> ratio = Array<double>("contact::depth_ratio", 0);  // depth / shortest edge of the face
  Array<double> limit = Array<double>("contact::depth_limit", 0);  // up to which contact can hold it [length]
  Array<int> face = Array<int>("contact::depth_face", 0);
};

/// Fills the table for the candidate pairs. motion: with dt = 0, at the places to be looked at.
void find_penetrations(const WorkSpace& space, const ContactSurface& surface, const SurfaceMotion& motion,
                       const CandidateList& candidates, const FaceState& faces, PenetrationTable& table);

/// Distance of the node from the face for each candidate pair [pairs]; 0 where they touch, negative where the node is
/// behind the face or of the same body. motion: with dt = 0, at the places to be looked at; faces: of update_faces().
void find_gaps(const WorkSpace& space, const ContactSurface& surface, const SurfaceMotion& motion,
               const CandidateList& candidates, const FaceState& faces, Array<double>& gaps);

}  // namespace percuss
