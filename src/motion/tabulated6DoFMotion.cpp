// SPDX-License-Identifier: GPL-3.0-or-later
#include "motion/MotionFunction.hpp"

#include "dictionary/readText.hpp"
#include "dictionary/tokenize.hpp"
#include "motion/motionTables.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace slosh
{

namespace
{

namespace tabulated6DoFMotionCoeffs
{

constexpr Key CofG{.name = "CofG", .example = "(0 0 0)", .unit = unit::metre, .sentence = "centre of rotation"};
constexpr Key timeDataFileName{
    .name = "timeDataFileName",
    .example = "\"constant/6DoF.dat\"",
    .sentence = "file of the table, relative to the case; also \"<case>/...\", \"<constant>/...\" or \"<system>/...\"; "
                "or with .gz appended"};
constexpr Key dictionary{
    .name = "tabulated6DoFMotionCoeffs",
    .sentence = "a table N ( (t ((x y z) (a b c))) ... ): t [s], translation [m], Euler angles [deg], R = Rx Ry Rz; it "
                "must reach endTime",
    .entries = [] {
        return Keys{CofG, timeDataFileName};
    }};

} // namespace tabulated6DoFMotionCoeffs

/// One row: time, translation (m) and rotation (deg).
struct Row
{
    double t = 0;
    std::array<double, 6> x{};
};

/// N ( (t ((x y z) (a b c))) ... ), OpenFOAM's List<Tuple2<scalar, Vector2D<vector>>>.
std::vector<Row> readTable(const std::string& file, const std::string& name)
{
    std::string text;
    try
    {
        text = readText(file, name);
    }
    catch (const CaseError&)
    {
        throw errorIn(name, "cannot read the motion table");
    }
    const std::vector<Token> tokens = tokenize(text, name);
    const auto fail = [&](const std::string& what, std::size_t at)
    {
        const int line = tokens.empty() ? 0 : tokens[std::min(at, tokens.size() - 1)].line;
        return errorIn(
            placeIn(name, line),
            "the motion table " + what + "; expected rows (t ((x y z) (a b c))) [s, m, deg] with increasing t"
        );
    };
    std::size_t at = 0;
    const bool counted = !tokens.empty() && tokens[0].kind == Token::Kind::number;
    const double count = counted ? tokens[at++].number : -1;
    const auto expect = [&](char c)
    {
        if (at >= tokens.size() || !tokens[at].is(c))
        {
            throw fail(std::string("lacks a '") + c + "'", at);
        }
        ++at;
    };
    const auto number = [&]
    {
        if (at >= tokens.size() || tokens[at].kind != Token::Kind::number || !std::isfinite(tokens[at].number))
        {
            throw fail("lacks a number", at);
        }
        return tokens[at++].number;
    };
    std::vector<Row> rows;
    expect('(');
    while (at < tokens.size() && !tokens[at].is(')'))
    {
        const std::size_t begin = at;
        Row row;
        expect('(');
        row.t = number();
        expect('(');
        for (std::size_t k = 0; k < 6; ++k)
        {
            if (k % 3 == 0)
            {
                expect('(');
            }
            row.x[k] = number();
            if (k % 3 == 2)
            {
                expect(')');
            }
        }
        expect(')');
        expect(')');
        if (!rows.empty() && !(row.t > rows.back().t))
        {
            throw fail("does not increase in time", begin);
        }
        rows.push_back(row);
    }
    expect(')');
    if (rows.size() < 2)
    {
        throw fail("has fewer than two rows", 0);
    }
    if (counted && count != static_cast<double>(rows.size()))
    {
        throw fail("declares " + tokens[0].text + " rows and has " + std::to_string(rows.size()), 0);
    }
    return rows;
}

/// Translation and Euler angles (X Y Z, deg) about CofG, out of a table by OpenFOAM's interpolateSplineXY: a cubic
/// through the four rows around, linear continuation beyond the ends,
///   y = y1 + mu/2 ((y2 - y0) + mu ((2 y0 - 5 y1 + 4 y2 - y3) + mu (-y0 + 3 y1 - 3 y2 + y3))).
class Tabulated6DoFMotion final : public MotionFunction
{
public:
    Tabulated6DoFMotion(const Vec& CofG, std::vector<Row> rows, std::string file)
        : CofG_(CofG), rows_(std::move(rows)), file_(std::move(file))
    {
    }

    double lastTime() const override { return rows_.back().t; }

    Transform transform(double time) const override
    {
        // A stage may ask a rounding beyond the last row.
        const double slack = 1e-9 * (rows_.back().t - rows_.front().t);
        if (time < rows_.front().t - slack || time > rows_.back().t + slack)
        {
            std::ostringstream message;
            message << file_ << ": the motion table covers " << rows_.front().t << " to " << rows_.back().t
                    << " s; the tank's position is needed at " << time << " s";
            throw CaseError(message.str(), CaseError::Kind::input);
        }
        const auto above = std::upper_bound(
            rows_.begin() + 1, rows_.end() - 1, time, [](double t, const Row& row) { return t < row.t; }
        );
        const Row& y1 = *(above - 1);
        const Row& y2 = *above;
        const Jet mu = (Jet::time(time) - y1.t) / Jet(y2.t - y1.t);
        std::array<Jet, 6> x;
        for (std::size_t k = 0; k < 6; ++k)
        {
            const double a = y1.x[k], b = y2.x[k];
            const double before = above - 1 == rows_.begin() ? 2 * a - b : (above - 2)->x[k];
            const double after = above + 1 == rows_.end() ? 2 * b - a : (above + 1)->x[k];
            x[k] = a + mu / 2 *
                           ((b - before) +
                            mu * ((2 * before - 5 * a + 4 * b - after) + mu * (-before + 3 * a - 3 * b + after)));
        }
        const Jet toRad = std::numbers::pi / 180;
        return Transform::rotationAbout(
            CofG_, Transform::eulerXYZ({x[3] * toRad, x[4] * toRad, x[5] * toRad}), {x[0], x[1], x[2]}
        );
    }

    std::string description() const override
    {
        std::ostringstream out;
        out << "tabulated6DoFMotion: CofG " << text(CofG_) << ", " << rows_.size() << " rows from " << rows_.front().t
            << " to " << rows_.back().t << " s from " << file_;
        return out.str();
    }

private:
    Vec CofG_;
    std::vector<Row> rows_;
    std::string file_;
};

std::unique_ptr<MotionFunction> readTabulated6DoFMotion(const MotionSetting& setting)
{
    using namespace tabulated6DoFMotionCoeffs;
    const std::string name = setting.coeffs.word(timeDataFileName);
    if (name.empty())
    {
        throw setting.coeffs.errorAt(timeDataFileName, "is empty; expected the name of a file");
    }
    return std::make_unique<Tabulated6DoFMotion>(
        setting.coeffs.vector(CofG), readTable(tablePath(name, setting.caseFolder), name), name
    );
}

} // namespace

namespace choices
{
extern const MotionFunction::Choice tabulated6DoFMotion = {
    "tabulated6DoFMotion", "Translation and rotation from a table of time", readTabulated6DoFMotion,
    [] { return Keys{tabulated6DoFMotionCoeffs::dictionary}; }};
}

} // namespace slosh
