#pragma once
// How far apart are contact nodes and the faces of other bodies in front of them? For the report at the start.

#include "kernels/contact/check/detailed_check.hpp"

namespace percuss {

/// Distance of the node from the face for each candidate pair [pairs]; 0 where they touch, negative where the node is
/// behind the face or of the same body. motion: with dt = 0, at the places to be looked at; faces: of update_faces().
template <class Space>
void find_gaps(const Space& space, const ContactSurface& surface, const SurfaceMotion& motion,
               const CandidateList& candidates, const FaceState& faces, Array<double>& gaps);

}  // namespace percuss
