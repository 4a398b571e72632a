// SPDX-License-Identifier: GPL-3.0-or-later
// What sloshSweep refuses.
#include "SloshSweepTest.hpp"

namespace slosh
{
namespace
{

TEST_F(SloshSweep, RefusesWhatIsWrongInItsDictionary)
{
    const auto refuse = [&](const std::string& axes, const std::string& results, const std::vector<std::string>& what)
    {
        case_.writeSweep(axes, results);
        expectRefused(case_, "sloshSweep", what);
    };
    refuse("", "", {"axes is empty; expected at least one entry to vary"});
    refuse(
        "a { file \"constant/tankPropertis\"; entry fillDepth; values (1); }", "",
        {"did you mean 'constant/tankProperties'?"}
    );
    refuse(
        "a { file \"constant/tankProperties\"; entry filDepth; values (1); }", "",
        {"'filDepth'", "did you mean 'fillDepth'?", "the case a=1"}
    );
    refuse(
        "a { file \"constant/tankProperties\"; entry fillDepth; values (0.1); values2 (1); }", "",
        {"values2", "system/sweepDict"}
    );
    refuse("a { file \"constant/tankProperties\"; entry fillDepth; values (0.1 0.1); }", "", {"has '0.1' twice"});
    refuse(
        "a { file \"constant/tankProperties\"; entry fillDepth; range (0.1 0.05); count 3; }", "",
        {"range is not a range; expected (from to), from < to"}
    );
    refuse("a { file \"constant/tankProperties\"; entry fillDepth; range (0.05 0.1); }", "", {"'count'"});
    refuse(
        "a { file \"constant/tankProperties\"; entry fillDepth; direction (1 0 0); values (deep); }", "",
        {"values has 'deep'; expected numbers"}
    );
    refuse(
        "a { file \"constant/dynamicMeshDict\"; entry oscillatingRotatingMotionCoeffs.omega; naturalFrequency 1; "
        "values (-1); }",
        "", {"values has '-1'; expected numbers > 0"}
    );
    refuse(angle, "peak { samples \"pressure/p\"; column 1; quantity maximun; }", {"did you mean 'maximum'?"});
    refuse(
        angle, "peak { samples \"pressure/p\"; column 1; quantity rms; lastPeriods 5; }",
        {"the last 5 periods of 0.785398 s; the run ends at 0.01 s", "the case angle=2"}
    );
    refuse(angle, "peak { samples \"pressure/p\"; column 1; quantity difference; }", {"needs a reference"});
    refuse(
        angle, "peak { samples \"pressure/p\"; column 1; quantity rms; lastPeriod 5; }",
        {"lastPeriod", "did you mean 'lastPeriods'?"}
    );
    case_.writeSweep(angle, peak);
    expectRefused(case_, "sloshSweep -jobs 0", {"-jobs is 0; expected a whole number from 1"});
    expectRefused(case_, "sloshSweep -only 3", {"-only is 3; expected a case from 1 to 2"});
    expectRefused(case_, "sloshSweep -dict system/swepDict", {"system/swepDict"});
}

TEST_F(SloshSweep, RefusesNaturalFrequenciesWhereThereAreNone)
{
    case_.edit("constant/g", "(0 0 -9.81)", "(0 0 0)");
    case_.write(
        "constant/fluidProperties",
        case_.text("constant/fluidProperties") + "equationOfState { type Tait; gamma 7; speedOfSound 10; }\n"
    );
    case_.writeSweep(frequency, "");
    expectRefused(case_, "sloshSweep", {"natural frequencies need liquid that extends from wall to wall"});
}

} // namespace
} // namespace slosh
