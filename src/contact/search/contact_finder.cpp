#include "src/contact/search/contact_finder.hpp"

#include "src/contact/search/local_finder.hpp"
#include "src/contact/search/ranked_finder.hpp"

namespace percuss {

// Figure 5 of the paper: dynamic decomposition for parallel contacts, in two calls. A step that uses the candidate
// pairs of an earlier search again begins with the second.

std::int64_t ContactFinder::search(const SurfaceMotion& motion, double margin) {
  send_contact_data_to_previous_owners(motion);  // (5.1)
  rebalance();                                   // (5.2)
  share_cuts();                                  // (5.3)
  send_points_to_owners(motion);                 // in the paper, (5.2) moves them with their data
  find_reached_ranks(motion, margin);            // (5.4)
  send_overlapping_faces(motion);                // (5.5)
  return find_candidates(motion, margin);        // (5.6) points in boxes
}

int ContactFinder::check(const SurfaceMotion& motion, const ContactHistory& history, Array<RowTouch>& touches) {
  check_pairs(motion, history);  // (5.1) again, motion and history to the ranks that check; (5.6) detailed check
  const int count = send_results_to_fe_owners(history, touches);  // (5.7)
  request_near_pairs();                                           // for the next check
  return count;
}

std::unique_ptr<ContactFinder> make_contact_finder(const ContactRanks& ranks, const SurfaceShare& share,
                                                   const ContactDeck& deck) {
  if (ranks.ranks.size() == 1) return std::make_unique<LocalFinder>(share, deck);
  return std::make_unique<RankedFinder>(ranks, share, deck);
}

std::unique_ptr<ContactFinder> make_look_finder(const ContactFinder& of_run, const ContactRanks& ranks,
                                                const SurfaceShare& share, const ContactDeck& deck,
                                                const LookedAt& at) {
  if (const auto* local = dynamic_cast<const LocalFinder*>(&of_run)) return std::make_unique<LocalFinder>(*local, at);
  ContactDeck once = deck;
  once.rebalance = ContactDeck::Rebalance::never;
  return make_contact_finder(ranks, share, once);
}

}  // namespace percuss
