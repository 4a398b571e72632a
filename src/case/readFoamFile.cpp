// SPDX-License-Identifier: GPL-3.0-or-later
#include "case/foamFile.hpp"

#include "dictionary/readText.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <cstring>

namespace slosh
{

namespace
{

/// One file: its header taken off, its values read one after the other.
class FieldFile
{
public:
    FieldFile(const std::filesystem::path& root, const std::string& file, const std::string& className)
        : FieldFile(root, file)
    {
        if (!isFoamFile())
        {
            throw CaseError(file_ + ": no FoamFile header found", CaseError::Kind::input);
        }
        if (className_ != className)
        {
            throw CaseError(file_ + ": class is " + className_ + "; expected " + className, CaseError::Kind::input);
        }
    }

    FieldFile(const std::filesystem::path& root, const std::string& file)
        : file_(file), text_(readText(root / file, file))
    {
        const auto begin = text_.find("FoamFile");
        const auto open = begin == std::string::npos ? begin : text_.find('{', begin);
        const auto close = open == std::string::npos ? open : text_.find('}', open);
        if (close == std::string::npos)
        {
            return;
        }
        const Dictionary header = Dictionary::parse(text_.substr(open + 1, close - open - 1), file_);
        binary_ = header.choice("format", {"ascii", "binary"}, "format") == "binary";
        className_ = header.word("class");
        const std::string arch = header.wordOr("arch", "LSB;label=32;scalar=64");
        if (binary_ && (arch.rfind("LSB;label=32", 0) != 0))
        {
            throw CaseError(
                file_ + ": arch is \"" + arch + "\"; expected \"LSB;label=32;scalar=64\" or scalar=32",
                CaseError::Kind::input
            );
        }
        singlePrecision_ = arch.find("scalar=32") != std::string::npos;
        at_ = close + 1;
    }

    bool isFoamFile() const { return !className_.empty(); }
    const std::string& className() const { return className_; }
    bool binary() const { return binary_; }
    const std::string& file() const { return file_; }

    /// N and the bracket after it; `uniform` where that is a brace. The file must be able to hold N values.
    std::size_t begin(bool& uniform, std::size_t leastBytesPerValue)
    {
        skipBlanks();
        std::size_t n = 0;
        const auto [end, error] = std::from_chars(text_.data() + at_, text_.data() + text_.size(), n);
        if (error != std::errc())
        {
            throw broken("the number of values");
        }
        at_ = static_cast<std::size_t>(end - text_.data());
        skipBlanks();
        uniform = at_ < text_.size() && text_[at_] == '{';
        if (!uniform && (at_ >= text_.size() || text_[at_] != '('))
        {
            throw broken("'(' after the number of values");
        }
        ++at_;
        if (!uniform && n > 0 && (text_.size() - at_) / n < leastBytesPerValue)
        {
            throw CaseError(
                file_ + ": the file is truncated; expected " + std::to_string(n) + " values", CaseError::Kind::input
            );
        }
        return n;
    }

    void expect(char c)
    {
        skipBlanks();
        if (at_ >= text_.size() || text_[at_] != c)
        {
            throw broken(std::string("'") + c + "'");
        }
        ++at_;
    }

    double scalar(bool raw, std::size_t index)
    {
        double x = 0;
        if (raw)
        {
            float single = 0;
            copyRaw(singlePrecision_ ? static_cast<void*>(&single) : &x, singlePrecision_ ? 4 : 8);
            x = singlePrecision_ ? static_cast<double>(single) : x;
        }
        else
        {
            skipBlanks();
            const auto [end, error] = std::from_chars(text_.data() + at_, text_.data() + text_.size(), x);
            if (error != std::errc())
            {
                throw broken("value number " + std::to_string(index));
            }
            at_ = static_cast<std::size_t>(end - text_.data());
        }
        if (!std::isfinite(x))
        {
            throw errorIn(
                placeIn(file_, raw ? 0 : line()), "value number " + std::to_string(index) + " (from 0) is not a number"
            );
        }
        return x;
    }

    int label(bool raw, std::size_t index)
    {
        std::int32_t x = 0;
        if (raw)
        {
            copyRaw(&x, sizeof x);
            return x;
        }
        skipBlanks();
        const auto [end, error] = std::from_chars(text_.data() + at_, text_.data() + text_.size(), x);
        if (error != std::errc())
        {
            throw broken("value number " + std::to_string(index));
        }
        at_ = static_cast<std::size_t>(end - text_.data());
        return x;
    }

private:
    int line() const
    {
        return 1 + static_cast<int>(std::count(text_.begin(), text_.begin() + static_cast<std::ptrdiff_t>(at_), '\n'));
    }

    CaseError broken(const std::string& wanted) const
    {
        const bool atEnd = at_ >= text_.size();
        return CaseError(
            placeIn(file_, binary_ || atEnd ? 0 : line()) +
                (atEnd ? ": the file is truncated; expected " : ": expected ") + wanted,
            CaseError::Kind::input
        );
    }

    void copyRaw(void* to, std::size_t bytes)
    {
        if (at_ + bytes > text_.size())
        {
            at_ = text_.size();
            throw broken("a value");
        }
        std::memcpy(to, text_.data() + at_, bytes);
        at_ += bytes;
    }

    void skipBlanks()
    {
        while (at_ < text_.size() && (text_[at_] == ' ' || text_[at_] == '\n' || text_[at_] == '\t' ||
                                      text_[at_] == '\r' || text_.compare(at_, 2, "//") == 0))
        {
            at_ = text_[at_] == '/' ? std::min(text_.find('\n', at_), text_.size()) : at_ + 1;
        }
    }

    std::string file_;
    std::string text_;
    std::string className_; ///< none: no FoamFile
    bool binary_ = false;
    bool singlePrecision_ = false;
    std::size_t at_ = 0;
};

template <class T, class ReadOne>
std::vector<T> readList(FieldFile& in, long expected, std::size_t leastBytes, const ReadOne& readOne)
{
    bool uniform = false;
    const std::size_t n = in.begin(uniform, leastBytes);
    if (expected >= 0 && n != static_cast<std::size_t>(expected))
    {
        throw CaseError(
            in.file() + ": " + std::to_string(n) + " values found; expected " + std::to_string(expected) +
                ", one for each position",
            CaseError::Kind::input
        );
    }
    std::vector<T> values;
    if (uniform)
    {
        values.assign(n, readOne(0, false));
        in.expect('}');
        return values;
    }
    values.reserve(n);
    for (std::size_t i = 0; i < n; ++i)
    {
        values.push_back(readOne(i, in.binary()));
    }
    in.expect(')');
    return values;
}

Vec readVec(FieldFile& in, std::size_t i, bool raw)
{
    if (!raw)
    {
        in.expect('(');
    }
    Vec x;
    for (Eigen::Index d = 0; d < 3; ++d)
    {
        x[d] = in.scalar(raw, i);
    }
    if (!raw)
    {
        in.expect(')');
    }
    return x;
}

std::vector<double> readScalars(FieldFile& in, long expected)
{
    return readList<double>(
        in, expected, in.binary() ? 4 : 2, [&](std::size_t i, bool raw) { return in.scalar(raw, i); }
    );
}

std::vector<Vec> readVectors(FieldFile& in, long expected)
{
    return readList<Vec>(
        in, expected, in.binary() ? 12 : 8, [&](std::size_t i, bool raw) { return readVec(in, i, raw); }
    );
}

std::vector<int> readLabels(FieldFile& in, long expected)
{
    return readList<int>(in, expected, in.binary() ? 4 : 2, [&](std::size_t i, bool raw) { return in.label(raw, i); });
}

} // namespace

std::vector<double> readScalarField(const std::filesystem::path& root, const std::string& file, long expected)
{
    FieldFile in(root, file, "scalarField");
    return readScalars(in, expected);
}

std::vector<Vec> readVectorField(const std::filesystem::path& root, const std::string& file, long expected)
{
    FieldFile in(root, file, "vectorField");
    return readVectors(in, expected);
}

std::vector<int> readLabelField(const std::filesystem::path& root, const std::string& file, long expected)
{
    FieldFile in(root, file, "labelField");
    return readLabels(in, expected);
}

std::optional<FieldValues> readFieldIfOne(const std::filesystem::path& root, const std::string& file, long expected)
{
    FieldFile in(root, file);
    if (in.className() == "scalarField")
    {
        return readScalars(in, expected);
    }
    if (in.className() == "vectorField")
    {
        return readVectors(in, expected);
    }
    if (in.className() == "labelField")
    {
        return readLabels(in, expected);
    }
    return std::nullopt;
}

std::vector<Vec> readPositions(const std::filesystem::path& root, const std::string& file)
{
    FieldFile in(root, file, "Cloud<passiveParticle>");
    return readList<Vec>(
        in, -1, in.binary() ? 18 : 10,
        [&](std::size_t i, bool raw)
        {
            // Binary: ( 3 scalars and the cell's label ); ascii: (x y z) label.
            if (raw)
            {
                in.expect('(');
            }
            const Vec x = readVec(in, i, raw);
            in.label(raw, i);
            if (raw)
            {
                in.expect(')');
            }
            return x;
        }
    );
}

} // namespace slosh
