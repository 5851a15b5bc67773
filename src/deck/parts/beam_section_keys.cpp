#include "src/deck/parts/beam_section_keys.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <variant>

namespace percuss {
namespace {

const Keys<TrussSection>& truss_section_keys() {
  static const Keys<TrussSection> keys = {need("area", &TrussSection::area, NumberValue{positive})};
  return keys;
}

const Keys<RoundSection>& round_section_keys() {
  static const Keys<RoundSection> keys = {need("radius", &RoundSection::radius, NumberValue{positive})};
  return keys;
}

const Keys<TubeSection>& tube_section_keys() {
  static const Keys<TubeSection> keys = {
      need("outer_radius", &TubeSection::outer_radius, NumberValue{positive}),
      need("inner_radius", &TubeSection::inner_radius, NumberValue{positive}),
  };
  return keys;
}

bool check_tube_section(const Reader& reader, const Node& node, TubeSection& tube) {
  if (tube.inner_radius < tube.outer_radius) return true;
  reader.error(node.find("inner_radius")->spot,
               fmt::format("{} is {}{} (must be smaller than outer_radius, {})", reader.name_of("inner_radius"),
                           tube.inner_radius, reader.in(), tube.outer_radius));
  return false;
}

const Keys<RectangleSection>& rectangle_section_keys() {
  static const Keys<RectangleSection> keys = {
      need("size", &RectangleSection::size, TupleValue<NumberValue, 2>{{positive}})};
  return keys;
}

const Keys<BoxSection>& box_section_keys() {
  static const Keys<BoxSection> keys = {
      need("size", &BoxSection::size, TupleValue<NumberValue, 2>{{positive}}),
      need("wall", &BoxSection::wall, NumberValue{positive}),
  };
  return keys;
}

bool check_box_section(const Reader& reader, const Node& node, BoxSection& box) {
  const double narrow = std::min(box.size[0], box.size[1]);
  if (2 * box.wall < narrow) return true;
  reader.error(node.find("wall")->spot,
               fmt::format("{} is {}{} (must be less than half of the width {}): use rectangle for a solid section",
                           reader.name_of("wall"), box.wall, reader.in(), narrow));
  return false;
}

const Keys<IShapeSection>& i_shape_section_keys() {
  static const Keys<IShapeSection> keys = {
      need("size", &IShapeSection::size, TupleValue<NumberValue, 2>{{positive}}),
      need("flange", &IShapeSection::flange, NumberValue{positive}),
      need("web", &IShapeSection::web, NumberValue{positive}),
  };
  return keys;
}

bool check_i_shape_section(const Reader& reader, const Node& node, IShapeSection& section) {
  const bool is_high = 2 * section.flange >= section.size[1];
  if (!is_high && section.web < section.size[0]) return true;
  const char* const key = is_high ? "flange" : "web";
  reader.error(node.find(key)->spot,
               fmt::format("{} is {}{} (must be less than {} {}): use rectangle for a solid section",
                           reader.name_of(key), is_high ? section.flange : section.web, reader.in(),
                           is_high ? "half of the depth" : "the width", section.size[is_high ? 1 : 0]));
  return false;
}

const Keys<BeamSection>& general_section_keys() {
  static const Keys<BeamSection> keys = {
      need("area", &BeamSection::area, NumberValue{positive}),
      need("inertia_y", &BeamSection::inertia_y, NumberValue{positive}),
      need("inertia_z", &BeamSection::inertia_z, NumberValue{positive}),
      need("torsion", &BeamSection::torsion, NumberValue{positive}),
      need("shear_area_y", &BeamSection::shear_area_y, NumberValue{positive}),
      need("shear_area_z", &BeamSection::shear_area_z, NumberValue{positive}),
      may("polar_inertia", &BeamSection::polar_inertia, NumberValue{positive}),
  };
  return keys;
}

template <class S>
Key<BeamSectionDeck> beam_section_key(const char* name, const Keys<S>& (*keys)(),
                                      bool (*check)(const Reader&, const Node&, S&) = nullptr) {
  return make_key<BeamSectionDeck>(
      name, false, MapValue<S>{keys, check},
      [](const auto& value, const Reader& reader, const std::string& full, const Node& node, BeamSectionDeck& section) {
        S read{};
        const bool good = value.read(reader, full, node, read);
        section = read;
        return good;
      });
}

const Keys<BeamSectionDeck>& beam_section_keys() {
  static const Keys<BeamSectionDeck> keys = {
      beam_section_key<TrussSection>("truss", truss_section_keys),
      beam_section_key<RoundSection>("round", round_section_keys),
      beam_section_key<TubeSection>("tube", tube_section_keys, check_tube_section),
      beam_section_key<RectangleSection>("rectangle", rectangle_section_keys),
      beam_section_key<BoxSection>("box", box_section_keys, check_box_section),
      beam_section_key<IShapeSection>("i_shape", i_shape_section_keys, check_i_shape_section),
      beam_section_key<BeamSection>("general", general_section_keys),
  };
  return keys;
}

}  // namespace

bool BeamSectionValue::read(const Reader& reader, const std::string& name, const Node& node,
                            BeamSectionDeck& out) const {
  if (!reader.expect(node, Node::Kind::map, name, takes())) return false;
  const bool good = read_keys(reader.inside(name), node, beam_section_keys(), out);
  if (node.entries.size() == 1 || !good) return good;
  std::vector<std::string> known;
  for (const AnyKey& key : beam_section_keys()) known.push_back(key.name);
  reader.error(node.spot, fmt::format("{} has {} kinds{} (must be one of {})", name, node.entries.size(), reader.in(),
                                      fmt::join(known, ", ")));
  return false;
}

Form BeamSectionValue::form() const {
  Form form = form_of(beam_section_keys());
  for (const AnyKey& key : beam_section_keys()) form.exactly_one.push_back(key.name);
  return form;
}

bool check_beam_section(const Reader& reader, const Node& node, const PartDeck& part) {
  const bool is_line = std::holds_alternative<LineShape>(part.shape);
  const bool may_have = is_line || std::holds_alternative<FileMesh>(part.shape);
  const Node *section = node.find("section"), *toward = node.find("toward");
  for (const char* key : {"section", "toward", "contact_radius"}) {
    const Node* const given = node.find(key);
    if (may_have || given == nullptr) continue;
    reader.error(given->key,
                 fmt::format("{} has no effect{} (only beams have a cross section)", reader.name_of(key), reader.in()));
    return false;
  }
  if (is_line && section == nullptr) {
    reader.error(node.key, fmt::format("{} has no section (its beams need one)", reader.self()));
    return false;
  }
  for (const char* key : {"toward", "contact_radius"}) {
    const Node* const given = node.find(key);
    if (section != nullptr || given == nullptr) continue;
    reader.error(given->key, fmt::format("{} has no effect{} (it applies only with a section, and none is given)",
                                         reader.name_of(key), reader.in()));
    return false;
  }
  if (section == nullptr) return true;
  if (!part.section || (toward != nullptr && !part.toward)) return false;  // reported already
  if (toward != nullptr && !bends(*part.section)) {
    reader.error(toward->key,
                 fmt::format("{} has no effect{} (a truss does not bend)", reader.name_of("toward"), reader.in()));
    return false;
  }
  if (toward != nullptr || !has_axes(*part.section)) return true;
  reader.error(section->key, fmt::format("{} needs toward (the section is not round): give the direction of its y axis",
                                         reader.self()));
  return false;
}

}  // namespace percuss
