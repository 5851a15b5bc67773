#pragma once
// A skin: shells without any stress, which have mass, touch and take pressure for the nodes of others.
//
// They are not computed, like rigid elements: they cost no time and do not limit the step.

#include <array>

#include "kernels/material/elastic.hpp"
#include "kernels/material/material_key.hpp"

namespace percuss {

/// The law as a deck gives it. Only shells have it.
struct Skin {
  static constexpr const char* name = "skin";
  using Constants = Skin;
  double contact_modulus = 0;

  static constexpr auto keys() {
    return std::array{
        may("contact_modulus", &Skin::contact_modulus, KeyRange::not_negative, "pressure",
            "Bulk modulus by which contact of `enforcement: penalty` takes its stiffness; it needs one.")};
  }

  static Skin make(const Constants& c) { return c; }

  /// For contact alone.
  LameConstants moduli() const { return {contact_modulus, 0}; }
};

}  // namespace percuss
