// SPDX-License-Identifier: GPL-3.0-or-later
// table, tableFile, csvFile
#include "dictionary/readText.hpp"
#include "dictionary/tokenize.hpp"
#include "motion/function1Rows.hpp"
#include "motion/motionTables.hpp"

#include <algorithm>
#include <sstream>

namespace slosh
{

namespace
{

enum class OutOfBounds
{
    clamp, ///< the nearest row's value
    repeat,
    error
};

/// Linear between the rows. Its derivative jumps at them.
class Table final : public Function1
{
public:
    Table(std::vector<Function1Row> rows, OutOfBounds outOfBounds, std::string what)
        : rows_(std::move(rows)), untilRow_(rows_.size(), 0.0), outOfBounds_(outOfBounds), what_(std::move(what))
    {
        for (std::size_t k = 1; k < rows_.size(); ++k)
        {
            const Function1Row &a = rows_[k - 1], &b = rows_[k];
            untilRow_[k] = untilRow_[k - 1] + (b.argument - a.argument) * (a.value[0] + b.value[0]) / 2;
        }
    }

    Value at(double t) const override
    {
        if (outOfBounds_ == OutOfBounds::error && (t < begin() - slack() || t > end() + slack()))
        {
            std::ostringstream message;
            message << "the " << description() << " has no value at " << t << " s (outOfBounds error)";
            throw CaseError(message.str(), CaseError::Kind::input);
        }
        if (outOfBounds_ == OutOfBounds::repeat)
        {
            t -= turns(t) * (end() - begin());
        }
        const std::size_t above = rowAbove(t);
        Value value;
        if (above == 0 || above == rows_.size())
        {
            const auto& x = rows_[above == 0 ? 0 : above - 1].value;
            std::copy(x.begin(), x.end(), value.begin());
            return value;
        }
        const Function1Row &a = rows_[above - 1], &b = rows_[above];
        for (std::size_t k = 0; k < value.size(); ++k)
        {
            const double slope = (b.value[k] - a.value[k]) / (b.argument - a.argument);
            value[k] = {a.value[k] + slope * (t - a.argument), slope, 0};
        }
        return value;
    }

    std::optional<double> integral(double t) const override { return sinceBegin(t) - sinceBegin(0); }
    double lastTime() const override
    {
        return outOfBounds_ == OutOfBounds::error ? end() : std::numeric_limits<double>::infinity();
    }
    std::string description() const override
    {
        std::ostringstream out;
        out << what_ << " of " << rows_.size() << (rows_.size() == 1 ? " row" : " rows") << " from " << begin()
            << " to " << end() << " s";
        return out.str();
    }

private:
    double begin() const { return rows_.front().argument; }
    double end() const { return rows_.back().argument; }
    double slack() const { return 1e-9 * (end() - begin()); }
    double turns(double t) const { return end() > begin() ? std::floor((t - begin()) / (end() - begin())) : 0; }

    /// The number of rows at or before t.
    std::size_t rowAbove(double t) const
    {
        const auto above = std::upper_bound(
            rows_.begin(), rows_.end(), t, [](double x, const Function1Row& row) { return x < row.argument; }
        );
        return static_cast<std::size_t>(above - rows_.begin());
    }

    /// The integral from the first row's time to t.
    double sinceBegin(double t) const
    {
        double sum = 0;
        if (outOfBounds_ == OutOfBounds::repeat)
        {
            const double n = turns(t);
            t -= n * (end() - begin());
            sum = n * withinRows(end());
        }
        return sum + withinRows(t);
    }
    double withinRows(double t) const
    {
        const std::size_t above = rowAbove(t);
        if (above == 0)
        {
            return rows_.front().value[0] * (t - begin());
        }
        const Function1Row &a = rows_[above - 1], &b = rows_[std::min(above, rows_.size() - 1)];
        const double since = t - a.argument;
        const double slope = above < rows_.size() ? (b.value[0] - a.value[0]) / (b.argument - a.argument) : 0;
        return untilRow_[above - 1] + since * (a.value[0] + since * slope / 2);
    }

    std::vector<Function1Row> rows_;
    std::vector<double> untilRow_; ///< integral from the first row to each
    OutOfBounds outOfBounds_;
    std::string what_;
};

std::unique_ptr<Function1>
tableOf(const Function1Setting& setting, std::vector<Function1Row> rows, const std::string& what)
{
    const auto falls = std::adjacent_find(
        rows.begin(), rows.end(),
        [](const Function1Row& a, const Function1Row& b) { return !(b.argument > a.argument); }
    );
    if (rows.empty() || falls != rows.end())
    {
        throw setting.error(rows.empty() ? "is a table without rows" : "is a table whose times do not increase");
    }
    OutOfBounds outOfBounds = OutOfBounds::clamp;
    if (setting.value.empty() && setting.dict.has("outOfBounds"))
    {
        const std::string word = setting.dict.choice("outOfBounds", {"clamp", "repeat", "error"}, "outOfBounds");
        outOfBounds = word == "clamp"    ? OutOfBounds::clamp
                      : word == "repeat" ? OutOfBounds::repeat
                                         : OutOfBounds::error;
    }
    return std::make_unique<Table>(std::move(rows), outOfBounds, what);
}

/// ((t x) ...), or ((t (x y z)) ...), with or without a count before it.
std::vector<Function1Row> rowsOf(const Function1Setting& setting, std::span<const Token> tokens)
{
    const auto pairs = function1Pairs(tokens, false, setting.isVector);
    if (!pairs)
    {
        throw setting.error(std::string("is not a table ") + (setting.isVector ? "((t (x y z)) ...)" : "((t x) ...)"));
    }
    std::vector<Function1Row> rows;
    for (const auto& [t, x] : *pairs)
    {
        rows.push_back({t[0], x});
    }
    return rows;
}

std::unique_ptr<Function1> readInlineTable(const Function1Setting& setting)
{
    const std::span<const Token> tokens = setting.value.empty() ? setting.dict.tokens("values") : setting.value;
    return tableOf(setting, rowsOf(setting, tokens), "table");
}

std::unique_ptr<Function1> readTableFile(const Function1Setting& setting)
{
    const std::string name = setting.dict.word("file");
    const std::vector<Token> tokens = tokenize(readText(tablePath(name, setting.caseFolder), name), name);
    return tableOf(setting, rowsOf(setting, tokens), "table " + name);
}

/// The numbers of a line that `separator` divides; "" stands for what is not one.
std::vector<std::string> cellsOf(const std::string& line, char separator, bool mergeSeparators)
{
    std::vector<std::string> cells;
    std::istringstream text(line);
    for (std::string cell; std::getline(text, cell, separator);)
    {
        if (!cell.empty() || !mergeSeparators)
        {
            cell.erase(0, std::min(cell.find_first_not_of(" \t\r\""), cell.size()));
            cell.erase(cell.find_last_not_of(" \t\r\"") + 1);
            cells.push_back(cell);
        }
    }
    return cells;
}

std::unique_ptr<Function1> readCsvFile(const Function1Setting& setting)
{
    const Dictionary& dict = setting.dict;
    const std::string name = dict.word("file");
    const long header = dict.labelOr("nHeaderLine", 0, notNegative),
               reference = dict.labelOr("refColumn", 0, notNegative);
    const std::vector<double> columns = dict.scalars("componentColumns", unit::none, notNegative);
    const std::string separator = dict.wordOr("separator", ",");
    const bool merge = dict.has("mergeSeparators") && dict.flag("mergeSeparators");
    const std::size_t components = setting.isVector ? 3 : 1;
    if (columns.size() != components || separator.size() != 1)
    {
        throw dict.errorAt(
            separator.size() != 1 ? "separator" : "componentColumns",
            separator.size() != 1
                ? "is not one character"
                : "has another number of columns; expected " + std::to_string(components) + " (0 is the first)"
        );
    }
    std::istringstream lines(readText(tablePath(name, setting.caseFolder), name));
    std::vector<Function1Row> rows;
    long number = 0;
    for (std::string line; std::getline(lines, line);)
    {
        if (++number <= header || line.find_first_not_of(" \t\r") == std::string::npos)
        {
            continue;
        }
        const std::vector<std::string> cells = cellsOf(line, separator[0], merge);
        const auto cell = [&](double column)
        {
            double x = 0;
            const auto k = static_cast<std::size_t>(column);
            if (k >= cells.size() || !isNumber(cells[k], x))
            {
                throw errorIn(
                    placeIn(name, static_cast<int>(number)), "column " + std::to_string(k) + " is not a number"
                );
            }
            return x;
        };
        Function1Row row;
        row.argument = cell(static_cast<double>(reference));
        for (std::size_t k = 0; k < components; ++k)
        {
            row.value[k] = cell(columns[k]);
        }
        rows.push_back(row);
    }
    return tableOf(setting, std::move(rows), "table " + name);
}

} // namespace

namespace choices
{
extern const Function1::Choice table = {
    "table", "((t x) ...): linear between the rows; outOfBounds clamp, repeat or error", readInlineTable};
extern const Function1::Choice tableFile = {"tableFile", "As table, read from `file`", readTableFile};
extern const Function1::Choice csvFile = {
    "csvFile", "Columns of `file`: nHeaderLine, refColumn, componentColumns, separator, mergeSeparators", readCsvFile};
} // namespace choices

} // namespace slosh
