// SPDX-License-Identifier: GPL-3.0-or-later
#include "dictionary/Dictionary.hpp"

#include "base/CaseError.hpp"
#include "base/writeFile.hpp"
#include "dictionary/expression.hpp"

#include <gtest/gtest.h>

#include <numbers>

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
        "constant/fluidProperties:3: rho0 is -998; expected a number > 0 [kg/m^3]"
    );
    expectIn(messageOf([&] { d.scalar("gamma", unit::none); }), ":4: ");
    expectIn(messageOf([&] { d.scalar("nu", unit::kinematicViscosity); }), ":5: ");
    expectIn(messageOf([&] { d.label("n"); }), ":6: ");
    expectIn(messageOf([&] { d.vector("x", unit::metre); }), ":7: ");
    expectIn(messageOf([&] { d.scalar("nan", unit::metre); }), ":8: ");
    expectIn(messageOf([&] { d.word("speed"); }), "entry 'speed' not found in dictionary \"constant/fluidProperties\"");
}

TEST(Dictionary, RefusesAnUnknownKeyAndNamesTheNearest)
{
    const Dictionary d = parsed("kernel wendlandC2;\nhOverDX 1.23;\n");
    d.word("kernel");
    d.scalarOr("hOverDx", 1.5, unit::none);
    const std::string message = messageOf([&] { d.refuseUnknown(); });
    expectIn(message, "hOverDX");
    expectIn(message, ":2: ");
    expectIn(message, "'hOverDx'");
}

TEST(Dictionary, ListsEntriesThatWereAllowedButNotRead)
{
    const Dictionary d = parsed("maxCo 0.2;\ndeltaT 1;\n");
    d.allow({"maxCo"});
    d.scalar("deltaT", unit::second);
    EXPECT_NO_THROW(d.refuseUnknown());
    EXPECT_EQ(d.unusedEntries(), std::vector<std::string>{"constant/fluidProperties:1: maxCo"});
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
    expectIn(messageOf([] { parsed("\na $missing;\n"); }), ":2: ");
}

TEST(Dictionary, ExpandsMacrosWithASignAndExpressionsInBraces)
{
    const Dictionary d = parsed("h 0.0125; a (-$h 0 ${{ 2*$h }}); w ${{ 2*pi() }}; n -${{ 1 + 2 }}; m -${h};\n");
    EXPECT_EQ(d.vector("a", unit::metre), Vec(-0.0125, 0, 0.025));
    EXPECT_EQ(d.scalar("w", unit::radianPerSecond), 2 * std::numbers::pi);
    EXPECT_EQ(d.label("n"), -3);
    EXPECT_EQ(d.scalar("m", unit::metre), -0.0125);
    expectIn(messageOf([] { parsed("h water;\nb -$h;\n"); }), ":2: the macro -$h is not a number");
    expectIn(messageOf([] { parsed("b ${{ 1 };\n"); }), ":1: ");
}

TEST(Dictionary, DoesNotCallUnknownWhatAMacroStandsFor)
{
    const Dictionary d = parsed("L 2; k 4; w #eval{ 3*$k }; x $L;");
    d.scalar("x", unit::metre);
    d.scalar("w", unit::metre);
    EXPECT_NO_THROW(d.refuseUnknown());
    EXPECT_EQ(d.unusedEntries(), std::vector<std::string>{});
    EXPECT_NE(messageOf([] { parsed("L 2; M 3; x $L;").refuseUnknown(); }), "");
}

TEST(Dictionary, TakesDimensionsBySymbolsAndByExponents)
{
    const Dictionary d =
        parsed("a [m s^-2] 9.81; b [kg/m^3] 998; c rho [ kg m^-3 ] 998; d [mm] (1 2 3); e [N m^-2] 5;\n"
               "f [(m s^-1)^2] 7; g [cm] 3(1 2 3); h [m*m] 2; i [m] 1; j [M] 1;\n"
               "dimensions [m s^-2]; wrong [mm s^-2];\n");
    EXPECT_EQ(d.scalar("a", unit::acceleration), 9.81);
    EXPECT_EQ(d.scalar("b", unit::density), 998);
    EXPECT_EQ(d.scalar("c", unit::density), 998);
    EXPECT_EQ(d.vector("d", unit::metre), Vec(0.001, 0.002, 0.003));
    EXPECT_EQ(d.scalar("e", unit::pressure), 5);
    EXPECT_EQ(d.scalar("f", {{0, 2, -2}, "m^2/s^2"}), 7);
    EXPECT_EQ(d.scalars("g", unit::metre), (std::vector{0.01, 0.02, 0.03}));
    EXPECT_EQ(d.scalar("h", unit::squareMetre), 2);
    expectIn(messageOf([&] { d.scalar("i", unit::second); }), "dimensions [0 1 0 0 0 0 0]");
    expectIn(messageOf([&] { d.scalar("j", unit::metre); }), "dimensions [M]");
    EXPECT_NO_THROW(d.requireDimensions("dimensions", unit::acceleration));
    EXPECT_NE(messageOf([&] { d.requireDimensions("wrong", unit::acceleration); }), "");
}

TEST(Dictionary, CalculatesWhereAskedTo)
{
    const Dictionary d =
        parsed("L 0.92; k #calc \"3.14159265358979312/$L\"; w #eval{ sqrt(9.81*$k*tanh($k*0.155)) };\n");
    EXPECT_NEAR(d.scalar("w", unit::radianPerSecond), 4.03008, 1e-5); // first frequency of Cao et al.'s tank
    EXPECT_NEAR(parsed("D #calc \"0.1*cos(M_PI/4.0)\";").scalar("D", unit::metre), 0.0707106781186548, 1e-15);
    EXPECT_NEAR(
        parsed("D #calc \"std::sqrt(M_E)*constant::mathematical::pi\";").scalar("D", unit::metre), 5.17961, 1e-5
    );
    expectIn(messageOf([] { parsed("D #calc \"M_PY\";"); }), "'M_PY'");
    expectIn(messageOf([] { parsed("x #eval{ 1 + };\n"); }), ":1: ");
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
    expectIn(message, ":2: ");
    writeFile(folder / "system/bad", "\n#include \"none\"\n");
    expectIn(messageOf([&] { Dictionary::read(folder / "system/bad", "system/bad"); }), "none");
    writeFile(folder / "system/loop", "#include \"loop\"\n");
    EXPECT_NE(messageOf([&] { Dictionary::read(folder / "system/loop", "system/loop"); }), "");
    fs::remove_all(folder);
}

TEST(Dictionary, KnowsTheCaseWhereverTheIncludingFileLies)
{
    const fs::path folder = fs::temp_directory_path() / ("slosh.case." + std::to_string(::getpid()));
    writeFile(
        folder / "case/system/controlDict", "#include \"$FOAM_CASE/simControls\"\n#include \"<constant>/deep/more\"\n"
    );
    writeFile(folder / "case/simControls", "#include \"${FOAM_CASE}/controls/writing\"\n");
    writeFile(folder / "case/controls/writing", "writeInterval 0.05;\n");
    writeFile(folder / "controls/writing", "writeInterval 0.001;\n"); // beside the case: not meant
    writeFile(folder / "case/constant/deep/more", "#include \"beside\"\n#include \"<system>/last\"\n");
    writeFile(folder / "case/constant/deep/beside", "a 1;\n");
    writeFile(folder / "case/system/last", "b 2;\n");
    const Dictionary d = Dictionary::read(folder / "case/system/controlDict", "system/controlDict");
    EXPECT_EQ(d.scalar("writeInterval", unit::second), 0.05);
    EXPECT_EQ(d.label("a"), 1);
    EXPECT_EQ(d.label("b"), 2);
    expectIn(messageOf([&] { d.dict("writeInterval"); }), "controls/writing:1: writeInterval");
    fs::remove_all(folder);
}

TEST(Dictionary, IncludesFunctionsOfTheCaseAndNamesOthers)
{
    const fs::path folder = fs::temp_directory_path() / ("slosh.function." + std::to_string(::getpid()));
    writeFile(
        folder / "system/controlDict", "functions\n{\n    #includeFunc residuals\n    #includeFunc gauge(p, U, "
                                       "interval=0.5)\n    after { type forces; }\n}\n"
    );
    writeFile(folder / "system/gauge", "FoamFile { version 2.0; }\ntype probes;\nfields (T);\ninterval 1;\nplace 3;\n");
    const Dictionary functions =
        Dictionary::read(folder / "system/controlDict", "system/controlDict").dict("functions");
    EXPECT_EQ(functions.keys(), (std::vector<std::string>{"residuals", "gauge", "after"}));
    EXPECT_EQ(functions.dict("residuals").word("type"), "residuals");
    const Dictionary gauge = functions.dict("gauge");
    EXPECT_EQ(gauge.word("type"), "probes");
    EXPECT_EQ(gauge.words("fields"), (std::vector<std::string>{"p", "U"}));
    EXPECT_EQ(gauge.scalar("interval", unit::second), 0.5);
    EXPECT_EQ(gauge.label("place"), 3);
    expectIn(messageOf([&] { gauge.dict("place"); }), "system/gauge:5: place");
    fs::remove_all(folder);
}

TEST(Dictionary, StopsAtBrokenSyntaxWithTheLine)
{
    for (const char* wrong : {"a 1", "a { b 1;", "\na 1; }", "a (1 2;", "/* a", "a \"b;\n", "1 2;", "a 1 2 };"})
    {
        const std::string message = messageOf([&] { parsed(wrong); });
        expectIn(message, "constant/fluidProperties:");
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
    EXPECT_EQ(messageOf([&] { Dictionary::read(folder / "tank", "tank"); }), "tank.gz: cannot read the file");

    writeFile(folder / "tank", "depth 0.2;\n");
    EXPECT_EQ(Dictionary::read(folder / "tank", "tank").scalar("depth", unit::metre), 0.2);
    fs::remove_all(folder);
}

} // namespace
} // namespace slosh
