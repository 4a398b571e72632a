// SPDX-License-Identifier: GPL-3.0-or-later
#include "case/namedSchemes.hpp"

#include <algorithm>

namespace slosh
{

namespace
{

const std::string kernel = "constant/kernelProperties", fluid = "constant/fluidProperties",
                  schemes = "system/sphSchemes", control = "system/controlDict", blocks = "system/blockParticlesDict";

} // namespace

const std::vector<NamedScheme>& namedSchemes()
{
    static const std::vector<NamedScheme> all = {
        {"recommended",
         "for breaking waves and impacts; the default",
         {{kernel, "kernel", "improvedGaussian"},
          {fluid, "viscosity/type", "artificial"},
          {fluid, "viscosity/alpha", "0.02", {{fluid, "viscosity/type", "artificial"}}},
          {fluid, "viscosity/walls", "slip"},
          {schemes, "timeIntegration", "positionVerlet"},
          {schemes, "densityDiffusion/type", "Fourtakas"},
          {schemes, "densityDiffusion/delta", "0.1", {{schemes, "densityDiffusion/type", "Fourtakas"}}},
          {schemes, "densityReinitialisation/type", "none"},
          {schemes, "soundDamping/type", "coarse"},
          {schemes, "soundDamping/coefficient", "1", {{schemes, "soundDamping/type", "coarse"}}},
          {schemes, "wall/suction", "no"},
          {control, "maxCo", "0.8", {{schemes, "timeIntegration", "positionVerlet"}}},
          {blocks, "abruptStart", "potentialFlow"}}},
        {"smallWaves",
         "for non-breaking waves: the least damping that is stable",
         {{kernel, "kernel", "taperedGaussian"},
          {kernel, "hOverDx", "1.3", {{kernel, "kernel", "taperedGaussian"}}},
          {fluid, "viscosity/type", "none"},
          {fluid, "viscosity/walls", "slip"},
          {schemes, "timeIntegration", "positionVerlet"},
          {schemes, "densityDiffusion/type", "Fourtakas"},
          {schemes, "densityDiffusion/delta", "0.02", {{schemes, "densityDiffusion/type", "Fourtakas"}}},
          {schemes, "densityReinitialisation/type", "none"},
          {schemes, "soundDamping/type", "none"},
          {schemes, "wall/suction", "yes"},
          {control, "maxCo", "1.4", {{schemes, "timeIntegration", "positionVerlet"}}},
          {blocks, "settle/time", "1"},
          {blocks, "abruptStart", "potentialFlow"}}},
        {"cao2014",
         "the scheme of Cao, Ming & Zhang (2014), as printed in Eq. 1, without suction at walls",
         {{kernel, "kernel", "improvedGaussian"},
          {fluid, "viscosity/type", "artificial"},
          {fluid, "viscosity/alpha", "0.03", {{fluid, "viscosity/type", "artificial"}}},
          {fluid, "viscosity/walls", "noSlip"},
          {schemes, "timeIntegration", "predictorCorrector"},
          {schemes, "densityDiffusion/type", "none"},
          {schemes, "densityReinitialisation/type", "MLS"},
          {schemes, "densityReinitialisation/interval", "20", {{schemes, "densityReinitialisation/type", "MLS"}}},
          {schemes, "soundDamping/type", "none"},
          {schemes, "wall/suction", "no"},
          {control, "maxCo", "0.25"},
          {blocks, "abruptStart", "sound"}}}};
    return all;
}

Key schemeKey()
{
    return {
        .name = "scheme",
        .otherwise = "recommended",
        .sentence = "defaults of kernel, viscosity, walls, diffusion, integrator and time step for entries omitted in "
                    "the files of the case; the log of sloshSPHFoam lists them and where each is set",
        .options = []
        {
            Options options;
            for (const NamedScheme& scheme : namedSchemes())
            {
                options.push_back({scheme.name, scheme.sentence});
            }
            return options;
        }};
}

const NamedScheme& schemeNamedIn(const Dictionary& sphSchemes)
{
    const std::string name = sphSchemes.choice(schemeKey(), "scheme");
    return *std::find_if(
        namedSchemes().begin(), namedSchemes().end(), [&](const NamedScheme& scheme) { return scheme.name == name; }
    );
}

} // namespace slosh
