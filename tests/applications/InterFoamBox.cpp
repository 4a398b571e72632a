// SPDX-License-Identifier: GPL-3.0-or-later
#include "InterFoamBox.hpp"

#include <gtest/gtest.h>

namespace slosh
{

namespace fs = std::filesystem;

InterFoamBox::InterFoamBox()
{
    fs::remove_all(path());
    write("system/blockMeshDict", R"(scale 1;
vertices ((-1 -0.5 0) (1 -0.5 0) (1 0.5 0) (-1 0.5 0) (-1 -0.5 1) (1 -0.5 1) (1 0.5 1) (-1 0.5 1));
blocks (hex (0 1 2 3 4 5 6 7) (20 10 10) simpleGrading (1 1 1));
edges ();
boundary
(
    walls { type wall; faces ((0 3 2 1) (4 5 6 7) (0 1 5 4) (1 2 6 5) (2 3 7 6) (3 0 4 7)); }
);
mergePatchPairs ();
)");
    write("system/setFieldsDict", R"(defaultFieldValues (volScalarFieldValue alpha.water 0);
regions (boxToCell { box (-9 -9 -9) (9 9 0.5); fieldValues (volScalarFieldValue alpha.water 1); });
)");
    write("system/controlDict", R"(application interFoam;
startFrom startTime; startTime 0; stopAt endTime; endTime 1; deltaT 0.001;
writeControl adjustable; writeInterval 0.1; adjustTimeStep yes; maxCo 0.5;
)");
    write("constant/transportProperties", R"(phases (water air);
water { transportModel Newtonian; nu 1e-06; rho 1000; }
air { transportModel Newtonian; nu 1.48e-05; rho 1; }
sigma 0;
)");
    write("constant/g", "dimensions [0 1 -2 0 0 0 0]; value (0 0 -9.81);\n");
}

std::string InterFoamBox::converted() const
{
    fs::remove_all(path() / "ours");
    return succeed("foamToSlosh -to ours -spacing 0.1");
}

Ended InterFoamBox::refused() const
{
    fs::remove_all(path() / "ours");
    const auto before = tree();
    Ended ended = run("foamToSlosh -to ours -spacing 0.1");
    EXPECT_EQ(ended.status, 1) << ended.out;
    EXPECT_EQ(tree(), before);
    return ended;
}

void expectHas(const std::string& text, const std::vector<std::string>& words)
{
    for (const std::string& word : words)
    {
        EXPECT_NE(text.find(word), std::string::npos) << word << "\n" << text;
    }
}

} // namespace slosh
