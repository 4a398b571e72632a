// SPDX-License-Identifier: GPL-3.0-or-later
// What a user can get wrong in system/workPrecisionDict.
#include "WorkPrecisionCase.hpp"

namespace slosh
{
namespace
{

namespace fs = std::filesystem;

using BadWorkPrecision = WorkPrecision;

TEST_F(BadWorkPrecision, RefusesWordsItDoesNotKnowBeforeAnythingIsRun)
{
    const std::string stated = "type stated; value 1;";
    write("dx { fil \"system/blockParticlesDict\"; entry particleSpacing; values (0.02); }", stated);
    expectRefused({"'file' not found", "did you mean 'fil'", "workPrecisionDict:1"});
    write("dx { file \"system/blockParticleDict\"; entry particleSpacing; values (0.02); }", stated);
    expectRefused({"unknown file of the case 'system/blockParticleDict'", "did you mean 'system/blockParticlesDict'?"});
    write("dx { file \"system/blockParticlesDict\"; entry particleSpacing; values (0.02); colour 3; }", stated);
    expectRefused({"colour"});
    write("dx { file \"system/blockParticlesDict\"; entry particleSpacing; values (0.02 0.02); }", stated);
    expectRefused({"has '0.02' twice"});
    write("dx { file \"system/blockParticlesDict\"; entry particleSpacing; values ((1 2)); }", stated);
    expectRefused({"cannot be part of a folder's name", "settings"});
    write("s { settings { a { \"system/sphSheme\" { frame tank; } } } }", stated);
    expectRefused({"did you mean 'system/sphSchemes'?"});
    write(spacings_, stated, "vary oneAtTime;");
    expectRefused({"unknown way to vary 'oneAtTime'", "did you mean 'oneAtATime'?"});
    write(spacings_, stated, "vary oneAtATime; base { particleSpacing 0.03; }");
    expectRefused({"unknown value of the axis particleSpacing '0.03'"});
    write(spacings_, stated, "vary oneAtATime; base { particleSpacin 0.02; }");
    expectRefused({"particleSpacin"});
    write(spacings_, stated, "target (0.1);");
    expectRefused({"target", "did you mean 'targets'?"});
    write(spacings_, stated, "targets (0.1 -1);");
    expectRefused({"targets", "> 0"});
    write(spacings_, stated, "threads 0;");
    expectRefused({"threads"});
    write(spacings_ + alphas_, stated, "ensemble (alhpa);");
    expectRefused({"unknown axis 'alhpa'", "did you mean 'alpha'?", "workPrecisionDict:3"});
    write(spacings_ + alphas_, stated, "ensemble (particleSpacing);");
    expectRefused({"ensemble is particleSpacing, the spacing; expected other axes"});
    write(spacings_, stated, "formalOrder 0.5;");
    expectRefused({"formalOrder is 0.5; expected"});
    write("", stated);
    expectRefused({"axes is empty"});
    write(spacings_, stated, "outside { other { folder (a); } }");
    expectRefused({"'folders' not found", "did you mean 'folder'"});
    write(spacings_, stated, "outside { other { folders (a/20 b/20); } }");
    expectRefused({"names two runs 'other_20'"});
    write(spacings_, "type run; run particleSpacing=0.021;");
    expectRefused({"unknown run", "did you mean 'particleSpacing=0.01'?"});
    write(spacings_, "type finest; runn 3;");
    expectRefused({"runn"});
    case_.edit("system/workPrecisionDict", "quantity value", "quantity difference");
    case_.edit("system/workPrecisionDict", "type finest; runn 3;", "type richardson;");
    expectRefused({"richardson, which extrapolates a single figure", "expected finest"});
}

TEST_F(BadWorkPrecision, StopsAfterTheFirstRunWhereTheComparisonsAreWrong)
{
    write(spacings_, "type stated; value 1;");
    case_.edit("system/workPrecisionDict", "quantity value", "quantity valeu");
    const Ended ended = case_.run("workPrecision");
    EXPECT_EQ(ended.status, 1);
    EXPECT_NE(ended.err.find("did you mean 'value'"), std::string::npos) << ended.err;
    EXPECT_FALSE(fs::exists(case_.path() / folder / "runs/particleSpacing=0.01"));
    case_.edit("system/workPrecisionDict", "quantity valeu", "quantity value");
    EXPECT_EQ(count(case_.succeed("workPrecision"), "(finished earlier)"), 1u);
}

} // namespace
} // namespace slosh
