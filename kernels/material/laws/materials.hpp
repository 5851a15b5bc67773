#pragma once
// The list of materials. A new material is its own header and one entry here; CONTRIBUTING.md shows one.

#include "kernels/material/elastic.hpp"
#include "kernels/material/laws/anisotropic_plasticity.hpp"
#include "kernels/material/laws/arruda_boyce.hpp"
#include "kernels/material/laws/chaboche.hpp"
#include "kernels/material/laws/combined_hardening.hpp"
#include "kernels/material/laws/fluid.hpp"
#include "kernels/material/laws/gurson.hpp"
#include "kernels/material/laws/honeycomb.hpp"
#include "kernels/material/laws/hyperfoam.hpp"
#include "kernels/material/laws/j2_plasticity.hpp"
#include "kernels/material/laws/johnson_cook.hpp"
#include "kernels/material/laws/low_density_foam.hpp"
#include "kernels/material/laws/mooney_rivlin.hpp"
#include "kernels/material/laws/neo_hookean.hpp"
#include "kernels/material/laws/ogden.hpp"
#include "kernels/material/laws/orthotropic.hpp"
#include "kernels/material/laws/power_law_plasticity.hpp"
#include "kernels/material/laws/rate_table_foam.hpp"
#include "kernels/material/laws/rate_table_plasticity.hpp"
#include "kernels/material/laws/soil_and_foam.hpp"
#include "kernels/material/laws/tabulated_plasticity.hpp"
#include "kernels/material/laws/tabulated_rubber.hpp"
#include "kernels/material/laws/viscoelastic.hpp"
#include "kernels/material/laws/voce_plasticity.hpp"
#include "kernels/material/laws/yeoh.hpp"
#include "kernels/material/type_list.hpp"
#include "kernels/material/user/library_law.hpp"
#include "kernels/material/user/user_hardening.hpp"
#include "kernels/material/user/user_law.hpp"

namespace percuss {

using Materials =
    TypeList<Elastic, J2Plasticity, PowerLawPlasticity, VocePlasticity, TabulatedPlasticity, RateTablePlasticity,
             CombinedHardening, Chaboche, Gurson, JohnsonCook, NeoHookean, MooneyRivlin, Yeoh, ArrudaBoyce, Ogden,
             TabulatedRubber, Viscoelastic, SoilAndFoam, Honeycomb, Orthotropic, AnisotropicPlasticity, LowDensityFoam,
             RateTableFoam, Hyperfoam, Fluid, UserLaw, LibraryLaw, UserHardening>;

}  // namespace percuss
