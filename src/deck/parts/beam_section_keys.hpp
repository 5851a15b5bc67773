#pragma once
// Keys of `parts.NAME.section`: cross sections of beams.

#include "src/deck/deck.hpp"
#include "src/deck/keys/keys.hpp"

namespace percuss {

/// A map with one kind of cross section.
struct BeamSectionValue {
  bool read(const Reader& reader, const std::string& name, const Node& node, BeamSectionDeck& out) const;
  std::string takes() const { return "a map with one kind of section"; }
  Form form() const;
};

/// Beams need a section, and a direction for one that is not the same all around. What a file holds is seen when it is
/// read.
bool check_beam_section(const Reader& reader, const Node& node, const PartDeck& part);

}  // namespace percuss
