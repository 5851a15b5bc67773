#include "src/mesh/parts/shared_meshes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <map>
#include <string>
#include <utility>

#include "src/mesh/id_allotment.hpp"

namespace percuss {
namespace {

bool are_same(const Rotation& a, const Rotation& b) {
  return a.axis == b.axis && a.degrees == b.degrees && a.center == b.center;
}

/// Whether each entry of `place` moves both or none.
bool move_alike(const Deck& deck, const PartDeck& a, const PartDeck& b) {
  return std::all_of(deck.placements.begin(), deck.placements.end(), [&](const PlaceDeck& place) {
    const auto has = [&](const PartDeck& part) {
      return std::find(place.parts.begin(), place.parts.end(), part.name) != place.parts.end();
    };
    return has(a) == has(b);
  });
}

bool stand_alike(const PartDeck& a, const PartDeck& b) {
  const auto& [x, y] = std::pair(std::get<FileMesh>(a.shape), std::get<FileMesh>(b.shape));
  if (x.scale != y.scale || a.at != b.at || a.images != b.images || a.array.has_value() != b.array.has_value())
    return false;
  if (a.array &&
      (a.array->count != b.array->count || a.array->pitch != b.array->pitch || a.array->stagger != b.array->stagger))
    return false;
  return std::equal(a.rotate.begin(), a.rotate.end(), b.rotate.begin(), b.rotate.end(), are_same);
}

/// Parts that share a mesh, as indexes; most are alone.
using Sharers = std::vector<std::vector<std::size_t>>;

Sharers list_sharers(const Deck& deck) {
  const std::vector<std::size_t> first = find_first_sharers(deck);
  Sharers sharers(first.size());
  for (std::size_t p = 0; p < first.size(); ++p) sharers[first[p]].push_back(p);
  std::erase_if(sharers, [](const auto& parts) { return parts.empty(); });
  return sharers;
}

using Ids = std::vector<std::int64_t>;

/// Copies of an array have their ids above all of the mesh, each copy as much, so that parts agree on them.
void raise_copies(const std::vector<Ids*>& lists, std::size_t copies) {
  if (copies <= 1) return;
  std::int64_t highest = 0;
  for (const Ids* ids : lists) {
    for (std::size_t i = 0; i < ids->size() / copies; ++i) highest = std::max(highest, (*ids)[i]);
  }
  if (highest > std::numeric_limits<std::int64_t>::max() / 4 / static_cast<std::int64_t>(copies)) return;
  for (Ids* ids : lists) {
    const std::size_t own = ids->size() / copies;
    for (std::size_t i = own; i < ids->size(); ++i)
      (*ids)[i] = (*ids)[i % own] + static_cast<std::int64_t>(i / own) * highest;
  }
}

/// Ascending, each once. repeated: the first that several lists have, if any.
Ids merge(const std::vector<Ids*>& lists, std::int64_t& repeated) {
  Ids all;
  for (const Ids* ids : lists) all.insert(all.end(), ids->begin(), ids->end());
  std::sort(all.begin(), all.end());
  const auto twice = std::adjacent_find(all.begin(), all.end());
  repeated = twice == all.end() ? 0 : *twice;
  all.erase(std::unique(all.begin(), all.end()), all.end());
  return all;
}

/// Ids of the nodes or of the elements of all parts of files, as they come and then as they stay.
class IdsOfKind {
 public:
  IdsOfKind(SceneParts& scene, Ids PartMesh::*ids, std::int64_t ScenePart::*count, std::int64_t ScenePart::*first)
      : scene_(scene), ids_(ids), count_(count), first_(first) {}

  /// Returns the first id that several of the parts have; 0: none.
  std::int64_t add(const Deck& deck, const std::vector<std::size_t>& parts) {
    std::int64_t repeated = 0;
    if (parts.size() == 1) {
      const ScenePart& part = scene_.parts[parts[0]];
      allotment_.add(part.file ? std::move(part.file->mesh.*ids_) : Ids{}, part.*count_);
      return 0;
    }
    std::vector<Ids*> lists;
    for (const std::size_t p : parts) {
      if (scene_.parts[p].file) lists.push_back(&(scene_.parts[p].file->mesh.*ids_));
    }
    const auto& array = deck.parts[parts[0]].array;
    if (array) {
      std::size_t copies = 1;
      for (const int count : array->count) copies *= static_cast<std::size_t>(count);
      raise_copies(lists, copies);
    }
    Ids all = merge(lists, repeated);
    lowest_ = all.empty() ? 0 : all.front();
    const auto count = static_cast<std::int64_t>(all.size());
    allotment_.add(std::move(all), count);
    return repeated;
  }

  void assign() { allotment_.assign(); }

  /// Gives the parts at this place what add() took; lowest: id of their mesh, before they are raised.
  void give(const std::vector<std::size_t>& parts, std::size_t place, std::int64_t lowest) {
    for (const std::size_t p : parts) scene_.parts[p].*first_ = allotment_.first_id(place);
    if (parts.size() == 1) {
      if (scene_.parts[parts[0]].file) scene_.parts[parts[0]].file->mesh.*ids_ = allotment_.ids(place);
      return;
    }
    if (!allotment_.raised(place)) return;
    const std::int64_t raise = allotment_.ids(place).front() - lowest;
    for (const std::size_t p : parts) {
      if (!scene_.parts[p].file) continue;
      for (std::int64_t& id : scene_.parts[p].file->mesh.*ids_) id += raise;
    }
  }

  std::int64_t lowest() const { return lowest_; }
  bool raised(std::size_t place) const { return allotment_.raised(place); }

 private:
  SceneParts& scene_;
  Ids PartMesh::*ids_;
  std::int64_t ScenePart::*count_;
  std::int64_t ScenePart::*first_;
  IdAllotment allotment_;
  std::int64_t lowest_ = 0;
};

void refuse_repeated(const std::vector<std::size_t>& parts, std::int64_t element, SceneParts& scene) {
  ScenePart& last = scene.parts[parts.back()];
  last.error = fmt::format(
      "element {} of the file is in another part as well (parts of one mesh have different blocks): name the blocks of "
      "each part",
      element);
}

}  // namespace

std::vector<std::size_t> find_first_sharers(const Deck& deck) {
  std::vector<std::size_t> first(deck.parts.size());
  std::map<std::string, std::vector<std::size_t>> by_file;
  for (std::size_t p = 0; p < first.size(); ++p) {
    first[p] = p;
    const auto* mesh = std::get_if<FileMesh>(&deck.parts[p].shape);
    if (mesh == nullptr || mesh->is_exodus) continue;
    std::vector<std::size_t>& others = by_file[mesh->file];
    const auto alike = std::find_if(others.begin(), others.end(), [&](std::size_t other) {
      return stand_alike(deck.parts[other], deck.parts[p]) && move_alike(deck, deck.parts[other], deck.parts[p]);
    });
    if (alike == others.end()) {
      others.push_back(p);
    } else {
      first[p] = *alike;
    }
  }
  return first;
}

void assign_ids(const Deck& deck, SceneParts& scene) {
  const Sharers sharers = list_sharers(deck);
  IdsOfKind nodes(scene, &PartMesh::node_ids, &ScenePart::nodes, &ScenePart::first_node_id);
  IdsOfKind elements(scene, &PartMesh::element_ids, &ScenePart::elements, &ScenePart::first_element_id);
  std::vector<std::pair<std::int64_t, std::int64_t>> lowest;
  for (const std::vector<std::size_t>& parts : sharers) {
    nodes.add(deck, parts);
    if (const std::int64_t element = elements.add(deck, parts); element != 0) refuse_repeated(parts, element, scene);
    lowest.emplace_back(nodes.lowest(), elements.lowest());
  }
  nodes.assign();
  elements.assign();
  for (std::size_t place = 0; place < sharers.size(); ++place) {
    nodes.give(sharers[place], place, lowest[place].first);
    elements.give(sharers[place], place, lowest[place].second);
    if (!nodes.raised(place) && !elements.raised(place)) continue;
    if (!deck.parts[sharers[place][0]].images.empty()) continue;  // raised ids of a copy are expected
    scene.warnings.push_back(
        {"raised_ids",
         fmt::format("the file's {} ids are already used by an earlier part (percuss adds an offset to them)",
                     !nodes.raised(place)      ? "element"
                     : !elements.raised(place) ? "node"
                                               : "node and element"),
         "part '" + scene.parts[sharers[place][0]].name + "'", 0, 1});
  }
}

}  // namespace percuss
