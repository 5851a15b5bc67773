#pragma once
// Where search and detailed check run: a contact surface in local numbers, its motion, and their memory.

#include <array>
#include <cstdint>
#include <vector>

#include "kernels/contact/check/detailed_check.hpp"
#include "kernels/contact/check/penetration.hpp"
#include "kernels/contact/search/capture_boxes.hpp"
#include "kernels/contact/search/near_pairs.hpp"
#include "src/contact/check/near_list.hpp"
#include "src/contact/surface/surface_share.hpp"

namespace percuss {

/// Lists from which a ContactSurface is made. Nodes and faces are in the order of their global numbers.
struct SurfaceLists {
  std::vector<int> nodes;                          // [nodes] row of the motion
  std::vector<int> node_class;                     // [nodes]
  std::vector<std::array<int, 4>> corners, backs;  // [faces] indexes of nodes, rows of the motion; -1: not here
  std::vector<int> face_class, face_body;          // [faces]
  std::vector<int> searched_nodes, searched_faces;
  std::vector<double> face_offset;  // [faces] FaceTopology::offset; empty: nothing is checked
  std::vector<double> node_radius;  // [nodes] OwnedContactNodes::radii; empty: no beams touch
};

ContactSurface make_contact_surface(const SurfaceLists& lists, const SurfaceShare& share);

/// Pairs that the next checks may leave out, by a bound on the travel of all nodes, those behind faces included.
struct NearWay {
  double near = 0;           // until the near pairs are listed again [length]; 0: none are listed
  double search = 0;         // until the next search [length], for a first list that is to be made now; 0: none is
  bool keeps_first = false;  // the first list of before still holds; otherwise it is dropped
};

/// The candidate pairs that are near enough to be checked, where there are many others: of those of a search the ones
/// that can come near before the next, and of these, more often, the ones that can soon.
class NearPairs {
 public:
  /// The candidate pairs are others now, and all of them are checked.
  void forget() {
    reachable_.forget();
    near_.forget();
  }

  /// Requests lists at the next check, or none.
  void ask(const NearWay& way);
  bool is_asked() const { return reachable_.is_due() || near_.is_due(); }

  /// Lists them; inputs: of read_pairs().
  void make(const CheckInputs& inputs, const CandidateList& all);

  /// Pairs that can come near before the next search, where these are listed.
  const CandidateList& reachable_pairs(const CandidateList& all) const { return reachable_.choose(all); }

  /// The pairs to check, once what is requested is listed, and those of which that needs faces and history.
  const CandidateList& checked_pairs(const CandidateList& all) const { return near_.choose(reachable_pairs(all)); }
  const CandidateList& read_pairs(const CandidateList& all) const {
    return is_asked() ? reachable_pairs(all) : checked_pairs(all);
  }

 private:
  static constexpr int pause = 7;

  void fill(const CheckInputs& inputs, const CandidateList& of, double travel, NearList<CandidateList>& part);

  NearWay way_;
  NearList<CandidateList> reachable_{pause}, near_{pause};
  NearScratch scratch_;
};

/// Candidate pairs of all steps so far, and how many of these were on no list of near pairs or lay still.
struct PairCounts {
  std::int64_t candidates = 0, left_out = 0;
};

/// A surface with the candidate pairs of the last search and the memory of checking them.
struct CheckSpace {
  ContactSurface surface;
  Array<const std::int64_t> face_numbers;  // [faces] ascending
  CandidateList candidates;
  NearPairs near;
  PairCounts counts;
  FaceState faces;
  StillFaces still;
  bool keeps_still = true;  // what the last check found of nodes that are at rest, with all around them
  TouchTable touches;
  Array<int> history_face;  // [3 nodes] faces that pushed in the last step, -1: none, or not here

  const CandidateList& reachable_pairs() const { return near.reachable_pairs(candidates); }
  const CandidateList& checked_pairs() const { return near.checked_pairs(candidates); }
  const CandidateList& read_pairs() const { return near.read_pairs(candidates); }

  /// Whether all that the last check found was found by the one before it as well, and is at rest.
  bool has_found_nothing_new() const { return touches.num_new == 0; }

  CheckInputs make_inputs(const SurfaceMotion& motion) const { return {{surface, motion, faces}, history_face}; }
};

/// Takes a surface into use: memory for its faces and nodes.
void set_surface(const ContactSurface& surface, const Array<const std::int64_t>& face_numbers, CheckSpace& check);
void set_surface(const ContactSurface& surface, const std::vector<std::int64_t>& face_numbers, CheckSpace& check);

/// No pair was checked in this step: nothing is found, and the next check has none before it to compare with.
inline void forget_touches(CheckSpace& check) {
  check.touches.count = check.touches.num_new = 0;
  check.still.forget();
}

/// Index of a face by its number; -1 if it is not here.
KOKKOS_INLINE_FUNCTION int find_face(const Array<const std::int64_t>& numbers, std::int64_t number) {
  int first = 0, last = static_cast<int>(numbers.extent(0));
  while (first < last) {
    const int middle = first + (last - first) / 2;
    if (numbers(middle) < number)
      first = middle + 1;
    else
      last = middle;
  }
  return first < static_cast<int>(numbers.extent(0)) && numbers(first) == number ? first : -1;
}

/// Index of the face that a node remembers; -1 if it is not here. known: the index of the face that it remembered in
/// the last check, most likely the same one.
KOKKOS_INLINE_FUNCTION int find_remembered_face(const Array<const std::int64_t>& numbers, std::int64_t number,
                                                int known) {
  if (number < 0) return -1;
  const bool is_known = known >= 0 && known < static_cast<int>(numbers.extent(0)) && numbers(known) == number;
  return is_known ? known : find_face(numbers, number);
}

/// The detailed check of the candidate pairs that are near (the paper's section 4.2).
void check_candidates(const SurfaceMotion& motion, CheckSpace& check);

/// Measures the faces of all candidate pairs at the positions of a motion with dt = 0.
void measure_all_faces(const SurfaceMotion& motion, CheckSpace& check);

/// A contact node inside another body.
struct Penetration {
  int node = 0;            // place in OwnedContactNodes
  std::int64_t face = -1;  // number of the face that it is behind
  double depth = 0;        // [length]
  double ratio = 0;        // depth / shortest edge of the face
  double size = 0;         // h of the face
  int part = 0;            // of the face
  double limit = 0;        // depth up to which contact can hold it [length]
};

/// How deep contact nodes are inside other bodies at the positions of a motion with dt = 0.
PenetrationTable measure_candidates(const SurfaceMotion& motion, CheckSpace& check);

/// The gap between two parts, or two bodies of one part: from a contact node to the closest face.
struct PartGap {
  int part = 0, other = 0;  // part <= other
  double gap = 0;           // [length]; 0: they touch
};

/// Adds to gaps, by (part, other), of which the smallest of each two parts is kept.
void add_gap(const PartGap& more, std::vector<PartGap>& gaps);

/// The smallest gaps of the candidate pairs, by (part, other). face_part: [faces]. motion: with dt = 0.
std::vector<PartGap> measure_gaps(const SurfaceMotion& motion, CheckSpace& check, const std::vector<int>& face_part);

}  // namespace percuss
