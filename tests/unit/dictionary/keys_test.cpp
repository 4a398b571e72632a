// SPDX-License-Identifier: GPL-3.0-or-later
// Entries declared as data: how they are read, which are valid, and the annotated dictionary that is made of them.
#include "dictionary/AnnotatedDictionary.hpp"
#include "dictionary/Dictionary.hpp"

#include <gtest/gtest.h>

#include <functional>
#include <stdexcept>

namespace slosh
{
namespace
{

constexpr Key radius{
    .name = "radius", .example = "0.5", .unit = unit::metre, .range = positive, .sentence = "of the disc"};
constexpr Key side{.name = "side", .example = "2", .unit = unit::metre, .range = positive};
constexpr Key depth{
    .name = "depth", .otherwise = "-1", .unit = unit::metre, .range = notNegative, .sentence = "-1: full"};
constexpr Key shape{
    .name = "shape",
    .otherwise = "square",
    .example = "disc",
    .options = []
    {
        return Options{
            {"square", "all sides alike",
             [] {
                 return Keys{depth, side};
             }},
            {"disc", "round", [] {
                 return Keys{depth, radius};
             }}};
    }};
constexpr Key origin{.name = "origin", .otherwise = "(0 0 1)", .unit = unit::metre, .alternative = true};
constexpr Key part{
    .name = "lid", .leftOut = "none", .sentence = "covers", .entries = [] { return Keys{origin}; }, .anyName = true};

Keys keys()
{
    return joined({shape, {.name = "name", .example = "\"a tank\""}, part}, withoutEffect({"libs"}));
}

Dictionary parsed(const std::string& text)
{
    return Dictionary::parse(text, "constant/tank");
}

std::string messageOf(const std::function<void()>& f)
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

TEST(Key, GivesItsDefaultWhereTheEntryIsLeftOut)
{
    const Dictionary empty = parsed("");
    EXPECT_EQ(empty.scalar(depth), -1); // outside its range: no user can give it
    EXPECT_EQ(empty.choice(shape, "shape"), "square");
    EXPECT_EQ(empty.vector(origin), Vec(0, 0, 1));
    EXPECT_EQ(empty.label(Key{.name = "n", .otherwise = "20"}), 20);
    EXPECT_TRUE(empty.flag(Key{.name = "on", .otherwise = "yes"}));
    EXPECT_EQ(empty.words(Key{.name = "w", .otherwise = "(a b)"}), (std::vector<std::string>{"a", "b"}));
    EXPECT_EQ(empty.scalars(Key{.name = "x", .otherwise = "(1 2)"}), (std::vector<double>{1, 2}));
    EXPECT_NE(messageOf([&] { empty.scalar(radius); }).find("'radius' not found"), std::string::npos);
}

TEST(Key, IsReadInItsUnitAndRange)
{
    EXPECT_EQ(parsed("radius [0 1 0 0 0 0 0] 3;").scalar(radius), 3);
    EXPECT_NE(
        messageOf([] { parsed("radius [0 2 0 0 0 0 0] 3;").scalar(radius); }).find("dimensions"), std::string::npos
    );
    EXPECT_NE(messageOf([] { parsed("radius -3;").scalar(radius); }).find("a number > 0 [m]"), std::string::npos);
    EXPECT_NE(messageOf([] { parsed("depth -1;").scalar(depth); }).find(">= 0"), std::string::npos);
    const std::string wrong = messageOf([] { parsed("shape dics;").choice(shape, "shape"); });
    EXPECT_NE(wrong.find("did you mean 'disc'?"), std::string::npos) << wrong;
}

TEST(Keys, AreValidWithThoseOfAllOptionsAndNoOthers)
{
    const Dictionary known = parsed("shape disc; radius 1; side 2; depth 3; libs 1; lid { } other { }");
    known.scalar(radius);
    known.dict("lid"); // a name of the user's
    EXPECT_NO_THROW(known.refuseUnknown(joined(keys(), {{.name = "other"}})));
    // What was not read is told, not refused.
    EXPECT_EQ(known.unusedEntries().size(), 5u);
    const std::string unknown = messageOf([] { parsed("shape disc; radios 1;").refuseUnknown(keys()); });
    EXPECT_NE(unknown.find("did you mean 'radius'?"), std::string::npos) << unknown;
}

TEST(Keys, OfOptionsThatAreNotTakenAreIdle)
{
    const auto refused = [](const std::string& text) { return messageOf([&] { parsed(text).refuseIdle(keys()); }); };
    EXPECT_EQ(refused("shape disc; radius 1; depth 3; libs 1;"), "");
    EXPECT_NE(refused("shape disc; radius 1; side 2;").find("unknown keyword 'side'"), std::string::npos);
    EXPECT_EQ(refused("side 2;"), ""); // of the default
    EXPECT_NE(refused("radius 1;").find("unknown keyword 'radius'"), std::string::npos);
    const Dictionary dict = parsed("");
    dict.has("height");
    EXPECT_THROW(dict.refuseIdle({shape}), std::logic_error);
}

TEST(Keys, MustDeclareWhatIsRead)
{
    const Dictionary dict = parsed("");
    dict.has("height");
    EXPECT_THROW(dict.refuseUnknown({shape}), std::logic_error);
    EXPECT_NO_THROW(dict.refuseUnknown({shape, {.name = "height"}}));
}

TEST(AnnotatedDictionary, HasEachEntryWithUnitRangeAndDefault)
{
    const std::string text = AnnotatedDictionary{"constant/tank", "A tank.", keys}.file();
    EXPECT_EQ(
        text.substr(text.find("// A tank")),
        "// A tank.\n\nshape           disc;               // default square\n                                    // "
        "square: all sides alike\n                                    // disc: round\ndepth           -1;              "
        "   // [m], >= 0, default -1: -1: full\nradius          0.5;                // [m], > 0: of the disc\n// side  "
        "       2;                  // (square) [m], > 0\nname            \"a tank\";\n\nlid                           "
        "      // default none: covers; any name\n{\n    // origin       (0 0 1);        // [m], default (0 0 "
        "1)\n}\n// Accepted without effect: libs\n"
    );
}

TEST(AnnotatedDictionary, IsReadByItsOwnKeys)
{
    const Dictionary dict = parsed(AnnotatedDictionary{"constant/tank", "", keys}.file());
    EXPECT_EQ(dict.choice(shape, "shape"), "disc");
    EXPECT_EQ(dict.scalar(radius), 0.5);
    EXPECT_FALSE(dict.has("side"));
    EXPECT_TRUE(dict.isDict("lid"));
}

TEST(AnnotatedDictionary, HasABlockForEachOption)
{
    static constexpr Key type{
        .name = "type", .options = [] {
            return Options{{"probes", "pressure", [] { return Keys{radius}; }}, {"forces", "on walls"}};
        }};
    static const auto entries = []
    {
        return Keys{
            type,
            {.name = "control",
             .otherwise = "step",
             .example = "time",
             .options =
                 [] {
                     return Options{{"step"}, {"time", "", [] { return Keys{side}; }}};
                 }},
            origin};
    };
    const AnnotatedDictionary functions{
        "system/functions", "", [] {
            return Keys{{.name = "pressure", .entries = [] { return entries(); }, .anyName = true, .eachOption = true}};
        }};
    const Dictionary dict = parsed(functions.file());
    EXPECT_EQ(dict.keys(), (std::vector<std::string>{"pressure", "forces"}));
    EXPECT_EQ(dict.dict("pressure").keys(), (std::vector<std::string>{"type", "radius", "control", "side"}));
    EXPECT_EQ(dict.dict("forces").keys(), (std::vector<std::string>{"type", "control", "side"}));
    EXPECT_EQ(dict.dict("forces").word("control"), "time");
}

} // namespace
} // namespace slosh
