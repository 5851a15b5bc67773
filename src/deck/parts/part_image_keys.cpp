#include "src/deck/parts/part_image_keys.hpp"

#include <algorithm>
#include <cmath>

#include "src/deck/part_images.hpp"
#include "src/deck/text/nearest_name.hpp"

namespace percuss {
namespace {

const Keys<MirrorDeck>& mirror_keys() {
  static const Keys<MirrorDeck> keys = {
      need("parts", &MirrorDeck::parts, ListValue<NameValue>{}),
      need("normal", &MirrorDeck::normal, DirectionValue{}),
      may("point", &MirrorDeck::point, vector3()),
      may("suffix", &MirrorDeck::suffix, TextValue{}),
  };
  return keys;
}

bool note_mirror_place(const Reader&, const Node& node, MirrorDeck& mirror) {
  mirror.place = node.spot.place;
  return true;
}

const Keys<PatternDeck::Linear>& linear_keys() {
  using Linear = PatternDeck::Linear;
  static const Keys<Linear> keys = {
      need("count", &Linear::count, IntegerValue{2, 1000}),
      need("step", &Linear::step, vector3()),
  };
  return keys;
}

const Keys<PatternDeck::Circular>& circular_keys() {
  using Circular = PatternDeck::Circular;
  static const Keys<Circular> keys = {
      need("count", &Circular::count, IntegerValue{2, 1000}),
      need("axis", &Circular::axis, DirectionValue{}),
      may("center", &Circular::center, vector3()),
      may("step", &Circular::step, NumberValue{}),
  };
  return keys;
}

bool check_linear(const Reader& reader, const Node& node, PatternDeck::Linear& linear) {
  if (linear.step != Vec3{}) return true;
  reader.error(node.find("step")->spot,
               fmt::format("{} is zero (the copies would coincide): give a step", reader.name_of("step")));
  return false;
}

bool check_circular(const Reader& reader, const Node& node, PatternDeck::Circular& circular) {
  if (!circular.step) circular.step = 360.0 / circular.count;
  for (int copy = 1; copy < circular.count; ++copy) {
    if (std::remainder(copy * *circular.step, 360.0) != 0) continue;
    reader.error(node.spot, fmt::format("{} turns copy {} by a multiple of 360 degrees (it would coincide with the "
                                        "original): give another step or count",
                                        reader.self(), copy + 1));
    return false;
  }
  return true;
}

const Keys<PatternDeck>& pattern_keys() {
  static const Keys<PatternDeck> keys = {
      need("parts", &PatternDeck::parts, ListValue<NameValue>{}),
      may("linear", &PatternDeck::linear, MapValue<PatternDeck::Linear>{linear_keys, check_linear}),
      may("circular", &PatternDeck::circular, MapValue<PatternDeck::Circular>{circular_keys, check_circular}),
  };
  return keys;
}

bool check_pattern(const Reader& reader, const Node& node, PatternDeck& pattern) {
  pattern.place = node.spot.place;
  const bool is_line = node.find("linear") != nullptr, is_circle = node.find("circular") != nullptr;
  if (is_line != is_circle) return true;
  reader.error(node.spot, fmt::format("{} has {} (must have one of linear and circular)", reader.self(),
                                      is_line ? "both linear and circular" : "neither linear nor circular"));
  return false;
}

/// Makes parts of parts, and tells what cannot be one.
class PartCopier {
 public:
  PartCopier(Deck& deck, Reading& reading) : deck_(deck), reading_(reading) {}

  /// image: of copy 1, 2 and so on.
  template <class MakeImage>
  void copy(const std::string& key, Place place, const std::vector<std::string>& parts,
            const std::vector<std::string>& suffixes, const MakeImage& make_image) {
    key_ = key;
    place_ = place;
    if (parts.empty()) return refuse("names no part (there is nothing to copy): name parts");
    for (std::size_t i = 0; i < suffixes.size(); ++i) {
      for (const std::string& name : parts) add(name, suffixes[i], make_image(static_cast<int>(i) + 1));
    }
  }

 private:
  void refuse(const std::string& what) { reading_.errors.add({place_, -1}, fmt::format("{} {}", key_, what)); }

  std::vector<std::string> list_names() const {
    std::vector<std::string> names;
    for (const PartDeck& part : deck_.parts) names.push_back(part.name);
    return names;
  }

  void add(const std::string& name, const std::string& suffix, const PartImage& image) {
    const std::vector<std::string> names = list_names();
    const auto from = std::find(names.begin(), names.end(), name);
    if (from == names.end())
      return refuse(fmt::format("names part '{}', which is unknown{}", name, name_hint(name, names)));
    PartDeck part = deck_.parts[static_cast<std::size_t>(from - names.begin())];
    part.name += suffix;
    part.place = place_;
    if (!is_name(part.name) || part.name == name)
      return refuse(
          fmt::format("would call a part '{}' (names have letters, digits, _ and -): give another suffix", part.name));
    if (std::find(names.begin(), names.end(), part.name) != names.end())
      return refuse(fmt::format(
          "would make a part '{}' (the deck has one already): rename that, or list each part once", part.name));
    if (const std::string why = find_obstacle(part, image); !why.empty())
      return refuse(fmt::format("copies part '{}', which has {}: write the copy as a part of its own", name, why));
    if (part.rigid && !part.rigid->body.empty()) part.rigid->body += suffix;
    if (part.toward && image.kind != PartImage::Kind::shift) part.toward = transform(find_matrix(image), *part.toward);
    part.images.push_back(image);
    deck_.parts.push_back(std::move(part));
  }

  /// Key of the part that gives a place or directions in space that the image would not follow.
  std::string find_obstacle(const PartDeck& part, const PartImage& image) const {
    if (part.rigid && (part.rigid->center || part.rigid->inertia))
      return "rigid.center or rigid.inertia (of one place)";
    if (part.thickness_by_place) return "thickness.expression (of one place)";
    const auto material = std::find_if(deck_.materials.begin(), deck_.materials.end(),
                                       [&](const MaterialDeck& m) { return m.name == part.material; });
    if (image.kind != PartImage::Kind::shift && material != deck_.materials.end() && !material->law.vectors.empty())
      return "a material with directions, which would not turn";
    return "";
  }

  Deck& deck_;
  Reading& reading_;
  std::string key_;
  Place place_{};
};

}  // namespace

MapValue<MirrorDeck> mirror_value() { return {mirror_keys, note_mirror_place}; }
MapValue<PatternDeck> pattern_value() { return {pattern_keys, check_pattern}; }

void add_part_images(Deck& deck, Reading& reading) {
  using Kind = PartImage::Kind;
  PartCopier copier(deck, reading);
  for (std::size_t m = 0; m < deck.mirrors.size(); ++m) {
    const MirrorDeck& mirror = deck.mirrors[m];
    copier.copy(fmt::format("mirror.{}", m), mirror.place, mirror.parts, {mirror.suffix}, [&](int) {
      return PartImage{Kind::mirror, mirror.normal, mirror.point};
    });
  }
  for (std::size_t p = 0; p < deck.patterns.size(); ++p) {
    const PatternDeck& pattern = deck.patterns[p];
    if (pattern.linear.has_value() == pattern.circular.has_value()) continue;  // reported already
    std::vector<std::string> suffixes;
    const int count = pattern.linear ? pattern.linear->count : pattern.circular->count;
    for (int copy = 2; copy <= count; ++copy) suffixes.push_back(fmt::format("_{}", copy));
    copier.copy(fmt::format("pattern.{}", p), pattern.place, pattern.parts, suffixes, [&](int i) {
      if (pattern.circular)
        return PartImage{Kind::turn, pattern.circular->axis, pattern.circular->center, i * *pattern.circular->step};
      const Vec3& step = pattern.linear->step;
      return PartImage{Kind::shift, {i * step[0], i * step[1], i * step[2]}};
    });
  }
}

}  // namespace percuss
