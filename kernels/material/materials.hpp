#pragma once
// The list of materials. A new material is its own header and one entry here; CONTRIBUTING.md shows one.

#include "kernels/material/combined_hardening.hpp"
#include "kernels/material/elastic.hpp"
#include "kernels/material/fluid.hpp"
#include "kernels/material/honeycomb.hpp"
#include "kernels/material/j2_plasticity.hpp"
#include "kernels/material/johnson_cook.hpp"
#include "kernels/material/low_density_foam.hpp"
#include "kernels/material/mooney_rivlin.hpp"
#include "kernels/material/neo_hookean.hpp"
#include "kernels/material/power_law_plasticity.hpp"
#include "kernels/material/soil_and_foam.hpp"
#include "kernels/material/tabulated_plasticity.hpp"
#include "kernels/material/type_list.hpp"
#include "kernels/material/viscoelastic.hpp"
#include "kernels/material/voce_plasticity.hpp"

namespace percuss {

using Materials =
    TypeList<Elastic, J2Plasticity, PowerLawPlasticity, VocePlasticity, TabulatedPlasticity, CombinedHardening,
             JohnsonCook, NeoHookean, MooneyRivlin, Viscoelastic, SoilAndFoam, Honeycomb, LowDensityFoam, Fluid>;

}  // namespace percuss
