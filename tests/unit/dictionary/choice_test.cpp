// SPDX-License-Identifier: GPL-3.0-or-later
#include "dictionary/Choice.hpp"

#include "base/CaseError.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace slosh
{
namespace
{

using Root = Choice<double (*)(double)>;

const std::vector<Root>& roots()
{
    static const std::vector<Root> table = {
        {"square", "The square root", [](double x) { return std::sqrt(x); }},
        {"cubic", "The cubic root", [](double x) { return std::cbrt(x); }}};
    return table;
}

double rootOf64(const std::string& entries)
{
    return choose(Dictionary::parse(entries, "system/rootDict"), "root", roots(), "root").read(64);
}

TEST(Choice, IsTheOneThatTheDictionaryNames)
{
    EXPECT_EQ(rootOf64("root square;"), 8);
    EXPECT_EQ(rootOf64("root cubic;"), 4);
    EXPECT_EQ(namesOf(roots()), (std::vector<std::string>{"square", "cubic"}));
    EXPECT_EQ(choiceNamed(roots(), "cubic").sentence, "The cubic root");
}

TEST(Choice, OfAnUnknownNameSaysTheNearestAndAllNamesOfTheTable)
{
    try
    {
        rootOf64("\nroot cubik;");
        FAIL();
    }
    catch (const CaseError& error)
    {
        EXPECT_EQ(
            error.what(), std::string("system/rootDict:2: unknown root 'cubik'; did you mean 'cubic'?\n"
                                      "Valid roots: cubic square")
        );
    }
    EXPECT_THROW(rootOf64("square 1;"), CaseError);
    EXPECT_THROW(choiceNamed(roots(), "cubik"), std::out_of_range);
}

} // namespace
} // namespace slosh
