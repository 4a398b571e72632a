// SPDX-License-Identifier: GPL-3.0-or-later
// Converts a case of interFoam.
#include "ConvertedCase.hpp"
#include "common/Program.hpp"

#include "dictionary/tokenize.hpp"

#include <iostream>

using namespace slosh;

namespace
{

double spacingOf(const std::string& text)
{
    double dx = 0;
    if (!isNumber(text, dx) || !positive.contains(dx))
    {
        throw CaseError("-spacing is " + text + "; expected a number > 0 [m]");
    }
    return dx;
}

void print(const ConvertedCase& made)
{
    for (const auto& fact : made.facts)
    {
        std::cout << fact << "\n";
    }
    for (const auto& warning : made.warnings)
    {
        std::cout << "--> FOAM Warning: " << warning << "\n";
    }
}

void foamToSlosh(const Program& program)
{
    const Case from(program.caseFolder());
    if (!program.has("to"))
    {
        throw CaseError("-to is missing; expected -to <dir>, the folder of the new case");
    }
    std::optional<double> spacing;
    if (program.has("spacing"))
    {
        spacing = spacingOf(program.value("spacing"));
    }
    ConvertedCase made;
    try
    {
        made.convert(from, spacing);
    }
    catch (...)
    {
        print(made);
        throw;
    }
    print(made);
    made.write(from, program.value("to"));
    std::cout << "\nWrote " << program.value("to") << "; next: cd " << program.value("to")
              << " && blockParticles && sloshSPHFoam\n";
}

} // namespace

int main(int argc, char** argv)
{
    Program program(
        "foamToSlosh", "Converts an interFoam case whose tank is a polygonal prism.",
        "foamToSlosh -case tutorials/workPrecision/interFoam -to myTank"
    );
    program.addOption("to", "dir", "folder of the new case, new or empty");
    program.addOption(
        "spacing", "dx", "particle spacing, [m]; default: that of 5000 liquid particles in 2D, 50000 in 3D"
    );
    program.addFile("system/", "of the case, read: blockMeshDict, setFieldsDict, controlDict, functions");
    program.addFile(
        "constant/",
        "of the case, read: g, transportProperties or phaseProperties, dynamicMeshDict; 0/U for open patches"
    );
    program.addFile(
        "<dir>/constant, <dir>/system", "written: all dictionaries that blockParticles and sloshSPHFoam need"
    );
    return program.run(argc, argv, [&] { foamToSlosh(program); });
}
