#pragma once
// The families of elements: what one launcher computes.

#include <cstdint>

namespace percuss {

enum class ElementFamily : std::uint8_t { hexahedra, shells, tetrahedra, beams, wedges, pyramids };

}  // namespace percuss
