// SPDX-License-Identifier: GPL-3.0-or-later
#include "dictionary/Dictionary.hpp"

#include "base/CaseError.hpp"
#include "base/writeFile.hpp"
#include "dictionary/expression.hpp"

#include <gtest/gtest.h>

#include <cstdlib>
#include <stdexcept>
#include <unistd.h>

namespace slosh
{
namespace
{

namespace fs = std::filesystem;

Dictionary parsed(const std::string& text)
{
    return Dictionary::parse(text, "constant/fluidProperties");
}

/// What the error says, "" where there is none.
template <class F>
std::string messageOf(const F& f)
{
    try
    {
        f();
    }
    catch (const CaseError& error)
    {
        return error.what();
    }
    return "";
}

void expectIn(const std::string& text, const std::string& part)
{
    EXPECT_NE(text.find(part), std::string::npos) << "'" << part << "' is not in: " << text;
}

TEST(Dictionary, ReadsWhatOpenFOAMWrites)
{
    const Dictionary d = parsed("FoamFile { version 2.0; class dictionary; }\n"
                                "// a comment\n"
                                "rho0 [1 -3 0 0 0 0 0] 998; /* another\n one */ nu nu [0 2 -1 0 0 0 0] 1e-6;\n"
                                "name \"with blanks; and a semicolon\";\n"
                                "flagged on;\n"
                                "origin (0 -1.5e-1 .31);\n"
                                "points 2((0 0 1) (0 0 2));\n"
                                "more ((1 2 3));\n"
                                "weights nonuniform List<scalar> 3(1 2 3);\n"
                                "fields (p U);\n"
                                "inner { deeper { value 7; } }\n"
                                "samples gauges / 0 / height.dat;\n"
                                "\"system/fvSchemes\" { a 1; }\n"
                                "\"system/fvSchemes\" { b 2; }\n"
                                "\"system/fvSolution\" 3;\n");
    EXPECT_EQ(d.scalar("rho0", unit::density, positive), 998);
    EXPECT_EQ(d.scalar("nu", unit::kinematicViscosity), 1e-6);
    EXPECT_EQ(d.word("name"), "with blanks; and a semicolon");
    EXPECT_TRUE(d.flag("flagged"));
    EXPECT_EQ(d.vector("origin", unit::metre), Vec(0, -0.15, 0.31));
    EXPECT_EQ(d.vectors("points", unit::metre), (std::vector<Vec>{Vec(0, 0, 1), Vec(0, 0, 2)}));
    EXPECT_EQ(d.vectors("more", unit::metre), (std::vector<Vec>{Vec(1, 2, 3)}));
    EXPECT_EQ(d.words("fields"), (std::vector<std::string>{"p", "U"}));
    EXPECT_EQ(d.dict("inner").dict("deeper").label("value"), 7);
    EXPECT_EQ(d.word("samples"), "gauges/0/height.dat");
    EXPECT_EQ(d.dict("system").keys(), (std::vector<std::string>{"fvSchemes", "fvSolution"}));
    EXPECT_EQ(d.dict("system").dict("fvSchemes").label("a"), 1);
    EXPECT_EQ(d.dict("system").dict("fvSchemes").label("b"), 2);
    EXPECT_EQ(d.dict("system").label("fvSolution"), 3);
    EXPECT_EQ(d.keys().front(), "rho0") << "FoamFile is no entry";
}

TEST(Dictionary, NamesFileLineValueAndRangeOfAWrongEntry)
{
    const Dictionary d = parsed("\n\nrho0 -998;\ngamma seven;\nnu [0 1 -1 0 0 0 0] 1;\nn 1.5;\nx (1 2);\nnan nan;\n");
    expectIn(
        messageOf([&] { d.scalar("rho0", unit::density, positive); }),
        "'rho0' is -998 in constant/fluidProperties at line 3; it must be a number > 0, in kg/m^3"
    );
    expectIn(messageOf([&] { d.scalar("gamma", unit::none); }), "line 4");
    expectIn(messageOf([&] { d.scalar("nu", unit::kinematicViscosity); }), "line 5");
    expectIn(messageOf([&] { d.label("n"); }), "line 6");
    expectIn(messageOf([&] { d.vector("x", unit::metre); }), "line 7");
    expectIn(messageOf([&] { d.scalar("nan", unit::metre); }), "line 8");
    expectIn(messageOf([&] { d.word("speed"); }), "Entry 'speed' not found in dictionary \"constant/fluidProperties\"");
}

TEST(Dictionary, RefusesAnUnknownKeyAndNamesTheNearest)
{
    const Dictionary d = parsed("kernel wendlandC2;\nhOverDX 1.23;\n");
    d.word("kernel");
    d.scalarOr("hOverDx", 1.5, unit::none);
    const std::string message = messageOf([&] { d.refuseUnknown(); });
    expectIn(message, "hOverDX");
    expectIn(message, "line 2");
    expectIn(message, "'hOverDx'");
}

TEST(Dictionary, ListsEntriesThatWereAllowedButNotRead)
{
    const Dictionary d = parsed("maxCo 0.2;\ndeltaT 1;\n");
    d.allow({"maxCo"});
    d.scalar("deltaT", unit::second);
    EXPECT_NO_THROW(d.refuseUnknown());
    EXPECT_EQ(d.unusedEntries(), std::vector<std::string>{"'maxCo' in constant/fluidProperties at line 1"});
}

TEST(Dictionary, ExpandsMacrosWhereverTheyStand)
{
    const Dictionary d = parsed("D 0.155; a { b 3; c $b; up $..D; abs $:D; whole (0 0 ${D}); }\n"
                                "e { $a; c 4; }\n copied $a.b; scoped $:e.c;\n");
    EXPECT_EQ(d.dict("a").label("c"), 3);
    EXPECT_EQ(d.dict("a").scalar("up", unit::metre), 0.155);
    EXPECT_EQ(d.dict("a").scalar("abs", unit::metre), 0.155);
    EXPECT_EQ(d.dict("a").vector("whole", unit::metre), Vec(0, 0, 0.155));
    EXPECT_EQ(d.dict("e").label("b"), 3);
    EXPECT_EQ(d.dict("e").label("c"), 4);
    EXPECT_EQ(d.label("copied"), 3);
    EXPECT_EQ(d.label("scoped"), 4);
    expectIn(messageOf([] { parsed("\na $missing;\n"); }), "line 2");
}

TEST(Dictionary, CalculatesWhereAskedTo)
{
    const Dictionary d =
        parsed("L 0.92; k #calc \"3.14159265358979312/$L\"; w #eval{ sqrt(9.81*$k*tanh($k*0.155)) };\n");
    EXPECT_NEAR(d.scalar("w", unit::radianPerSecond), 4.03008, 1e-5); // first frequency of Cao et al.'s tank
    expectIn(messageOf([] { parsed("x #eval{ 1 + };\n"); }), "line 1");
}

TEST(Expression, FollowsTheRulesOfArithmetic)
{
    const auto value = [](const char* text)
    { return evaluateExpression(text, [](const std::string& name) { return name == "x" ? 2.0 : 0.0; }); };
    EXPECT_EQ(value("1 + 2*3^2 - 4/2"), 17);
    EXPECT_EQ(value("-(2 - 5)*${x}"), 6);
    EXPECT_EQ(value("2^3^2"), 512);
    EXPECT_EQ(value("-2^2"), -4);
    EXPECT_DOUBLE_EQ(value("degToRad(180) - pi()"), 0);
    EXPECT_EQ(value("min(3, max($x, 1)) + 7 % 4"), 5);
    for (const char* wrong : {"", "1 +", "(1", "1)", "foo(1)", "1 2", "pow(1)"})
    {
        EXPECT_THROW(value(wrong), std::invalid_argument) << wrong;
    }
}

TEST(Dictionary, MergesOverwritesOrProtectsAsInputModeSays)
{
    const std::string twice = "a { x 1; y 2; } s 1;\n";
    const Dictionary merged = parsed(twice + "a { x 3; } s 2;");
    EXPECT_EQ(merged.dict("a").label("x"), 3);
    EXPECT_EQ(merged.dict("a").label("y"), 2);
    EXPECT_EQ(merged.label("s"), 2);
    const Dictionary overwritten = parsed(twice + "#inputMode overwrite\na { x 3; } s 2;");
    EXPECT_FALSE(overwritten.dict("a").has("y"));
    const Dictionary kept = parsed(twice + "#inputMode protect\na { x 3; z 4; } s 2; t 5;");
    EXPECT_EQ(kept.label("s"), 1);
    EXPECT_EQ(kept.label("t"), 5);
}

TEST(Dictionary, TakesALiteralKeyBeforeAPatternAndTheLastPatternFirst)
{
    const Dictionary d = parsed("\"p.*\" 1; \"pr.*\" 2; probe 3;");
    EXPECT_EQ(d.label("probe"), 3);
    EXPECT_EQ(d.label("pressure"), 2);
    EXPECT_EQ(d.label("patch"), 1);
    EXPECT_FALSE(d.has("x"));
}

TEST(Dictionary, IncludesFilesAndNamesTheIncludedFileInErrors)
{
    const fs::path folder = fs::temp_directory_path() / ("slosh.include." + std::to_string(::getpid()));
    writeFile(folder / "system/controlDict", "a 1;\n#include \"more\"\n#includeIfPresent \"none\"\nc $b;\n");
    writeFile(folder / "system/more", "\nb two;\n");
    const Dictionary d = Dictionary::read(folder / "system/controlDict", "system/controlDict");
    EXPECT_EQ(d.word("c"), "two");
    const std::string message = messageOf([&] { d.label("b"); });
    expectIn(message, "more");
    expectIn(message, "line 2");
    writeFile(folder / "system/bad", "\n#include \"none\"\n");
    expectIn(messageOf([&] { Dictionary::read(folder / "system/bad", "system/bad"); }), "none");
    writeFile(folder / "system/loop", "#include \"loop\"\n");
    EXPECT_NE(messageOf([&] { Dictionary::read(folder / "system/loop", "system/loop"); }), "");
    fs::remove_all(folder);
}

TEST(Dictionary, StopsAtBrokenSyntaxWithTheLine)
{
    for (const char* wrong : {"a 1", "a { b 1;", "\na 1; }", "a (1 2;", "/* a", "a \"b;\n", "1 2;", "a 1 2 };"})
    {
        const std::string message = messageOf([&] { parsed(wrong); });
        expectIn(message, "line ");
    }
}

TEST(Dictionary, ReadsBackWhatItWroteToTheLastBit)
{
    Dictionary inner("inner");
    inner.set("centre", Vec(1.0 / 3, -1e-300, 6.02214076e23));
    inner.set("count", 123456789L);
    Dictionary d("uniform/time");
    d.set("value", 0.1 + 0.2);
    d.set("name", "\"0.3 of it\"");
    d.set("inner", inner);
    const Dictionary back = Dictionary::parse(d.text(), "back");
    EXPECT_EQ(back.scalar("value", unit::second), 0.1 + 0.2);
    EXPECT_EQ(back.word("name"), "0.3 of it");
    EXPECT_EQ(back.dict("inner").vector("centre", unit::none), Vec(1.0 / 3, -1e-300, 6.02214076e23));
    EXPECT_EQ(back.dict("inner").label("count"), 123456789);
    EXPECT_EQ(back.text(), d.text());
}

TEST(Dictionary, SaysAgainWhatItsTextRemovesSoThatItCanBePutBehindAnother)
{
    const std::string edits = parsed("#remove (alpha \"beta\")\nalpha 2;\ninner { #remove gamma\n delta 4; }").text();
    const Dictionary d = parsed("alpha 1; beta 1; inner { gamma 1; delta 1; epsilon 1; }\n#inputMode merge\n" + edits);
    EXPECT_EQ(d.keys(), (std::vector<std::string>{"inner", "alpha"}));
    EXPECT_EQ(d.label("alpha"), 2);
    EXPECT_EQ(d.dict("inner").keys(), (std::vector<std::string>{"delta", "epsilon"}));
    EXPECT_EQ(d.dict("inner").label("delta"), 4);
}

TEST(DictionaryFile, ThatIsCompressedIsReadWhereThePlainOneIsAbsent)
{
    const fs::path folder = fs::temp_directory_path() / ("slosh.gz." + std::to_string(::getpid()));
    writeFile(folder / "tank", "// " + std::string(200000, 'x') + "\ndepth 0.3;\n");
    ASSERT_EQ(std::system(("gzip '" + (folder / "tank").string() + "'").c_str()), 0);
    EXPECT_EQ(Dictionary::read(folder / "tank", "tank").scalar("depth", unit::metre), 0.3);

    const auto whole = fs::file_size(folder / "tank.gz");
    fs::resize_file(folder / "tank.gz", whole - 12);
    EXPECT_EQ(messageOf([&] { Dictionary::read(folder / "tank", "tank"); }), "cannot read file \"tank.gz\"");

    writeFile(folder / "tank", "depth 0.2;\n");
    EXPECT_EQ(Dictionary::read(folder / "tank", "tank").scalar("depth", unit::metre), 0.2);
    fs::remove_all(folder);
}

} // namespace
} // namespace slosh
