#include "src/mesh/thicknesses.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "comm/all_reduce.hpp"
#include "src/error.hpp"
#include "src/index.hpp"

namespace percuss {
namespace {

constexpr std::int64_t none = std::numeric_limits<std::int64_t>::max();

/// Thicknesses of each part on all ranks, once reduced.
struct Thicknesses {
  std::vector<std::int64_t> missing, wrong;  // least id of an element without thickness, or with one that cannot be
  std::vector<double> minus_least, largest;

  explicit Thicknesses(std::size_t parts)
      : missing(parts, none),
        wrong(parts, none),
        minus_least(parts, -std::numeric_limits<double>::infinity()),
        largest(parts, 0) {}

  void reduce(const Communicator& ranks) {
    all_reduce(ranks, Reduce::least, missing);
    all_reduce(ranks, Reduce::least, wrong);
    all_reduce(ranks, Reduce::largest, minus_least);
    all_reduce(ranks, Reduce::largest, largest);
  }
};

Vec3 find_mean_corner(const Mesh& mesh, std::size_t element) {
  Vec3 mean{};
  const std::span<const int> corners = mesh.corners(element);
  for (const int n : corners)
    for (std::size_t k = 0; k < 3; ++k) mean[k] += mesh.nodes[at(n)][k];
  for (double& x : mean) x /= static_cast<double>(corners.size());
  return mean;
}

/// 0: nothing gives one. given: by the file.
double find_thickness(const PartDeck& part, const Mesh& mesh, std::size_t element, double given) {
  if (part.thickness_by_place) return (*part.thickness_by_place)(find_mean_corner(mesh, element));
  if (part.thickness_of_file && given != 0) return given;
  return part.thickness.value_or(0);
}

void check_thicknesses(const Deck& deck, const Thicknesses& found) {
  for (std::size_t p = 0; p < deck.parts.size(); ++p) {
    const PartDeck& part = deck.parts[p];
    const std::string where = deck.where(deck.places.find("parts." + part.name + ".thickness"));
    if (found.wrong[p] != none)
      throw InputError(fmt::format("{}: error: the thickness of element {} of part '{}' is not positive and finite",
                                   where, found.wrong[p], part.name));
    if (found.missing[p] != none)
      throw InputError(
          fmt::format("{}: error: the file has no thickness for element {} of part '{}': give thickness.otherwise, "
                      "the value for such shells",
                      where, found.missing[p], part.name));
  }
}

}  // namespace

void set_thicknesses(const Deck& deck, const Communicator& ranks, Mesh& mesh) {
  std::vector<double>& own = mesh.elements.own_thickness;
  const std::vector<double> given = std::exchange(own, {});
  const auto varies = [](const PartDeck& part) { return part.varies_in_thickness(); };
  if (std::none_of(deck.parts.begin(), deck.parts.end(), varies)) return;
  Thicknesses found(deck.parts.size());
  std::vector<double> of_blocks(mesh.elements.blocks.size(), 0);
  own.assign(mesh.elements.size(), 0);
  for (std::size_t e = 0; e < own.size(); ++e) {
    if (!mesh.topology_of(e).is_surface()) continue;
    const std::size_t p = at(mesh.part_of(e));
    const double t = own[e] = find_thickness(deck.parts[p], mesh, e, given[e]);
    const bool is_good = t > 0 && std::isfinite(t);
    if (!is_good) {
      const bool is_missing = deck.parts[p].thickness_of_file && t == 0;
      std::int64_t& first = (is_missing ? found.missing : found.wrong)[p];
      first = std::min(first, mesh.element_ids[e]);
      continue;
    }
    found.minus_least[p] = std::max(found.minus_least[p], -t);
    found.largest[p] = std::max(found.largest[p], t);
    double& of_block = of_blocks[at(mesh.elements.block_index(e))];
    of_block = std::max(of_block, t);
  }
  found.reduce(ranks);
  all_reduce(ranks, Reduce::largest, of_blocks);
  check_thicknesses(deck, found);
  for (std::size_t b = 0; b < of_blocks.size(); ++b) mesh.elements.blocks[b].section.thickness = of_blocks[b];
  for (std::size_t p = 0; p < deck.parts.size(); ++p) {
    if (!deck.parts[p].varies_in_thickness()) continue;
    mesh.notes.push_back(fmt::format("part '{}': shells {:.4g} to {:.4g} thick", deck.parts[p].name,
                                     -found.minus_least[p], found.largest[p]));
  }
}

}  // namespace percuss
