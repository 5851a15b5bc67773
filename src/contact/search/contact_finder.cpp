#include "src/contact/search/contact_finder.hpp"

#include "src/contact/search/local_finder.hpp"
#include "src/contact/search/ranked_finder.hpp"

namespace percuss {

std::unique_ptr<ContactFinder> make_contact_finder(const ContactRanks& ranks, const SurfaceShare& share,
                                                   const ContactDeck& deck) {
  if (ranks.ranks.size() == 1) return std::make_unique<LocalFinder>(share, deck);
  return std::make_unique<RankedFinder>(ranks, share, deck);
}

}  // namespace percuss
