#include "src/contact/search/contact_finder.hpp"

#include "src/contact/search/local_finder.hpp"
#include "src/contact/search/ranked_finder.hpp"

namespace percuss {

// Figure 5 of the paper: dynamic decomposition for parallel contacts. Where the candidate pairs of an earlier search
// are used again, a step begins with the check of (5.6).
FoundContacts ContactFinder::find_contacts(const FinderTask& task, Array<RowTouch>* touches) {
  FoundContacts found;
  if (task.searches) {
    send_contact_data_to_previous_owners(task.motion);             // (5.1)
    rebalance();                                                   // (5.2)
    share_cuts();                                                  // (5.3)
    find_reached_ranks(task.motion, task.margin);                  // (5.4)
    send_overlapping_faces(task.motion, task.margin);              // (5.5)
    found.candidates = find_candidates(task.motion, task.margin);  // (5.6) points in boxes
  }
  if (task.history == nullptr) return found;
  check_candidates_here(task.motion, *task.history);          // (5.6) detailed check
  found.touches = send_results_to_fe_owners(task, *touches);  // (5.7)
  return found;
}

std::unique_ptr<ContactFinder> make_contact_finder(const ContactRanks& ranks, const SurfaceShare& share,
                                                   const ContactDeck& deck) {
  if (ranks.ranks.size() == 1) return std::make_unique<LocalFinder>(share, deck);
  return std::make_unique<RankedFinder>(ranks, share, deck);
}

}  // namespace percuss
