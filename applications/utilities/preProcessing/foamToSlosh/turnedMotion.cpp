// SPDX-License-Identifier: GPL-3.0-or-later
#include "turnedMotion.hpp"

#include "turnedFunction1.hpp"

#include "base/numberText.hpp"
#include "base/pointText.hpp"
#include "dictionary/readText.hpp"
#include "dictionary/tokenize.hpp"
#include "motion/MotionFunction.hpp"
#include "motion/motionTables.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>

namespace slosh
{

namespace
{

using Tokens = std::vector<Token>;

/// The dictionary of one motion, to be filled.
struct Written
{
    Written(const Dictionary& motion, const std::string& name) : from(motion), function(name), coeffs(name + "Coeffs")
    {
        if (motion.has(coeffs.name()))
        {
            from = motion.dict(coeffs.name());
        }
    }

    /// A scalar of theirs, a number or a Function1 in any form.
    void copy(const std::string& key)
    {
        for (const std::string& entry : {key, key + "Coeffs"})
        {
            if (from.isDict(entry))
            {
                coeffs.set(entry, from.dict(entry));
            }
            else if (from.has(entry))
            {
                coeffs.set(entry, textOf(from.tokens(entry)));
            }
        }
    }

    /// A vector, or a Function1 of vectors.
    void multiply(const std::string& key, const Mat& M)
    {
        if (from.has(key))
        {
            setTurned(from, key, M, coeffs);
        }
    }

    Dictionary whole() const
    {
        Dictionary dict("motion");
        dict.set("solidBodyMotionFunction", function);
        dict.set(coeffs.name(), coeffs);
        return dict;
    }

    Dictionary from; ///< their coefficients
    std::string function;
    Dictionary coeffs;
};

/// R_x(a) R_y(b) R_z(c) of theirs is a product of rotations about our axes, which has factors R_x R_y R_z: each a
/// matrix from (a b c) to the angles of one factor.
std::vector<Mat> factorsOf(const Mat& R, const std::array<bool, 3>& isZero)
{
    std::vector<Mat> factors;
    int last = 3;
    for (int theirs = 0; theirs < 3; ++theirs)
    {
        if (isZero[theirs])
        {
            continue;
        }
        int ours = 0;
        R.col(theirs).cwiseAbs().maxCoeff(&ours);
        if (factors.empty() || ours < last)
        {
            factors.emplace_back(Mat::Zero());
        }
        last = ours;
        factors.back()(ours, theirs) = R(ours, theirs);
    }
    return factors.empty() ? std::vector<Mat>{Mat::Zero()} : factors;
}

class Turning
{
public:
    Turning(const Mat& R, std::string caseFolder) : R_(R), case_(std::move(caseFolder)) {}

    /// Motions whose product, the last applied first, is the turned one.
    std::vector<Dictionary> partsOf(const Dictionary& motion)
    {
        const std::string name = motion.word("solidBodyMotionFunction");
        const Written written(motion, name);
        if (name == "multiMotion")
        {
            std::vector<Dictionary> parts;
            for (const auto& key : written.from.keys())
            {
                if (written.from.isDict(key))
                {
                    const auto more = partsOf(written.from.dict(key));
                    parts.insert(parts.end(), more.begin(), more.end());
                }
            }
            return parts;
        }
        if (name == "oscillatingRotatingMotion")
        {
            return turnedOscillation(written);
        }
        if (name == "tabulated6DoFMotion")
        {
            return turnedTable(written);
        }
        return {turnedVectors(motion, name)};
    }

    std::map<std::string, std::string> tables;

private:
    /// The motion with its vectors turned. That is the turned motion unless its formula has axes: it is compared.
    Dictionary turnedVectors(const Dictionary& motion, const std::string& name) const
    {
        const auto times = [&](const Mat& M)
        {
            Written written(motion, name);
            for (const Key& key : entriesOf(name))
            {
                const std::string entry(key.name);
                if (isVector(key))
                {
                    written.multiply(entry, M);
                }
                else if (key.entries == nullptr) // the dictionary of a Function1 goes with its entry
                {
                    written.copy(entry);
                }
            }
            return written.whole();
        };
        const Dictionary turned = times(R_);
        if (!isTurned(times(Mat::Identity()), turned))
        {
            throw motion.errorAt(
                "solidBodyMotionFunction",
                "is " + name +
                    ", whose formula has fixed axes, and cannot be turned so that gravity is "
                    "along -z; expected another motion, or a case with gravity along -z"
            );
        }
        return turned;
    }

    static Keys entriesOf(const std::string& name)
    {
        const auto& choices = MotionFunction::choices();
        const auto choice = std::find_if(
            choices.begin(), choices.end(), [&](const MotionFunction::Choice& one) { return one.name == name; }
        );
        return choice->entries().front().entries();
    }

    /// Points, directions and displacements are declared with three components.
    static bool isVector(const Key& key)
    {
        return (key.example.empty() ? key.otherwise : key.example).starts_with('(');
    }

    /// Whether the second motion is R T R^-1 of the first, at 0 and at times from 1 ms to 10^4 s.
    bool isTurned(const Dictionary& first, const Dictionary& second) const
    {
        constexpr double tolerance = 1e-6;
        const auto a = SolidBodyMotion::read(first, case_), b = SolidBodyMotion::read(second, case_);
        const double last = std::min(a->lastTime(), b->lastTime());
        for (double t = 0; t <= std::min(last, 1e4); t = std::max(1e-3, 1.5 * t))
        {
            const RigidState theirs = a->at(t), ours = b->at(t);
            if (!theirs.c.allFinite() || !theirs.R.allFinite())
            {
                break; // SDA's period has become 0
            }
            if (!((R_ * theirs.c - ours.c).norm() <= tolerance * (1 + theirs.c.norm())) ||
                !((R_ * theirs.R * R_.transpose() - ours.R).norm() <= tolerance))
            {
                return false;
            }
        }
        return true;
    }

    std::vector<Dictionary> turnedOscillation(const Written& theirs) const
    {
        std::array<bool, 3> isZero{};
        if (!theirs.from.isDict("amplitude") && theirs.from.tokens("amplitude").size() == 5)
        {
            const Vec amplitude = theirs.from.vector("amplitude", {{}, "deg"});
            isZero = {amplitude[0] == 0, amplitude[1] == 0, amplitude[2] == 0};
        }
        std::vector<Dictionary> parts;
        for (const Mat& factor : factorsOf(R_, isZero))
        {
            Written part = theirs;
            part.coeffs = Dictionary(theirs.coeffs.name());
            part.multiply("origin", R_);
            part.multiply("amplitude", factor);
            part.copy("omega");
            parts.push_back(part.whole());
        }
        return parts;
    }

    std::vector<Dictionary> turnedTable(const Written& theirs)
    {
        const std::string file = theirs.from.word("timeDataFileName");
        Tokens tokens = tokenize(readText(tablePath(file, case_), file), file);
        std::vector<double> numbers;
        for (const Token& token : tokens)
        {
            if (token.kind == Token::Kind::number)
            {
                numbers.push_back(token.number);
            }
        }
        // t x y z a b c, behind the number of rows where it is given.
        constexpr std::size_t width = 7;
        numbers.erase(numbers.begin(), numbers.begin() + static_cast<std::ptrdiff_t>(numbers.size() % width));
        std::array<bool, 3> isZero{true, true, true};
        for (std::size_t k = 0; k < numbers.size(); k += width)
        {
            for (std::size_t d = 0; d < 3; ++d)
            {
                isZero[d] = isZero[d] && numbers[k + 4 + d] == 0;
            }
        }
        std::vector<Dictionary> parts;
        for (const Mat& factor : factorsOf(R_, isZero))
        {
            const Mat ofTranslation = parts.empty() ? R_ : Mat::Zero();
            std::string text = std::to_string(numbers.size() / width) + "\n(\n";
            for (std::size_t k = 0; k < numbers.size(); k += width)
            {
                const Vec moved(numbers[k + 1], numbers[k + 2], numbers[k + 3]);
                const Vec turned(numbers[k + 4], numbers[k + 5], numbers[k + 6]);
                text += "(" + numberText(numbers[k]) + " (" + exactText(ofTranslation * moved + Vec::Zero()) + " " +
                        exactText(factor * turned + Vec::Zero()) + "))\n";
            }
            const std::string name = freeName(std::filesystem::path(file).filename());
            tables[name] = text + ")\n";
            Written part = theirs;
            part.coeffs = Dictionary(theirs.coeffs.name());
            part.multiply("CofG", R_);
            part.coeffs.set("timeDataFileName", "\"" + name + "\"");
            parts.push_back(part.whole());
        }
        return parts;
    }

    std::string freeName(const std::filesystem::path& file) const
    {
        std::string name = "constant/" + file.string();
        for (int n = 2; tables.count(name) > 0; ++n)
        {
            name = "constant/" + file.stem().string() + "_" + std::to_string(n) + file.extension().string();
        }
        return name;
    }

    Mat R_;
    std::string case_;
};

} // namespace

TurnedMotion turnedMotion(const Dictionary& motion, const Turn& turn, const std::string& caseFolder)
{
    Turning turning(turn.R, caseFolder);
    const std::vector<Dictionary> parts = turning.partsOf(motion);
    TurnedMotion turned{Dictionary("constant/dynamicMeshDict"), {}};
    turned.dynamicMeshDict.set("dynamicFvMesh", "dynamicMotionSolverFvMesh");
    turned.dynamicMeshDict.set("motionSolver", "solidBody");
    if (parts.size() == 1)
    {
        for (const auto& key : parts[0].keys())
        {
            parts[0].isDict(key) ? turned.dynamicMeshDict.set(key, parts[0].dict(key))
                                 : turned.dynamicMeshDict.set(key, parts[0].word(key));
        }
    }
    else
    {
        Dictionary all("multiMotionCoeffs");
        for (std::size_t k = 0; k < parts.size(); ++k)
        {
            all.set("motion" + std::to_string(k + 1), parts[k]);
        }
        turned.dynamicMeshDict.set("solidBodyMotionFunction", "multiMotion");
        turned.dynamicMeshDict.set(all.name(), all);
    }
    turned.tables = turning.tables;
    return turned;
}

} // namespace slosh
