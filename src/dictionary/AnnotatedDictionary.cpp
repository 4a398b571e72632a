// SPDX-License-Identifier: GPL-3.0-or-later
#include "dictionary/AnnotatedDictionary.hpp"

#include "dictionary/rangeText.hpp"

#include <algorithm>
#include <sstream>
#include <vector>

namespace slosh
{

namespace
{

constexpr std::size_t valueColumn = 16, commentColumn = 36, width = 120;

/// `text` in lines of at most `most` characters, the first one of at most `first`.
std::vector<std::string> wrapped(const std::string& text, std::size_t most, std::size_t first)
{
    std::vector<std::string> lines(1);
    std::istringstream words(text);
    for (std::string word; words >> word;)
    {
        if (!lines.back().empty() && lines.back().size() + 1 + word.size() > (lines.size() == 1 ? first : most))
        {
            lines.emplace_back();
        }
        lines.back() += (lines.back().empty() ? "" : " ") + word;
    }
    return lines;
}

std::string padded(std::string text, std::size_t column)
{
    text.resize(std::max(column, text.size() + 1), ' ');
    return text;
}

/// Writes entries; what lies inside a comment begins with "// ".
class Layout
{
public:
    void writeAll(const Keys& keys)
    {
        std::string unread;
        for (const Key& key : keys)
        {
            if (key.noEffect)
            {
                unread += (unread.empty() ? "" : ", ") + std::string(key.name);
            }
            else
            {
                write(key, "");
            }
        }
        if (!unread.empty())
        {
            const std::size_t most = width - beginning().size() - 3;
            for (const auto& line : wrapped("Accepted without effect: " + unread, most, most))
            {
                put(beginning() + "// " + line);
            }
        }
    }

    std::string text() const { return out_.str(); }

private:
    /// `of`: the options that the entry goes with, where the example takes another one.
    void write(const Key& key, const std::string& of)
    {
        const bool inside = inComment_;
        if (!inside)
        {
            inComment_ = key.alternative || !of.empty();
            commentIndent_ = indent_;
        }
        if (key.entries != nullptr)
        {
            writeDictionary(key, of);
        }
        else
        {
            writeEntry(key, of);
        }
        inComment_ = inside;
    }

    void writeEntry(const Key& key, const std::string& of)
    {
        const std::string value(valueOf(key));
        const Options options = key.options();
        // Words that are all explained need not be listed before.
        const bool explained =
            std::none_of(options.begin(), options.end(), [](const Option& option) { return option.sentence.empty(); });
        Key shown = key;
        shown.options = explained ? noOptions : key.options;
        std::vector<std::string> said{(of.empty() ? "" : "(" + of + ") ") + describe(shown)};
        for (const Option& option : options)
        {
            said.push_back(
                option.sentence.empty() ? "" : std::string(option.name) + ": " + std::string(option.sentence)
            );
        }
        putWithComment(padded(std::string(key.name), inComment_ ? valueColumn - 3 : valueColumn) + value + ";", said);
        writeEntriesOf(options, value);
    }

    /// What goes with the option `taken`, then, in comments, what goes with the others: an entry of several once.
    void writeEntriesOf(const Options& options, const std::string& taken)
    {
        Keys own;
        std::vector<std::pair<Key, std::string>> others; // with the options they go with
        for (const Option& option : options)
        {
            own = option.name == taken ? option.entries() : own;
        }
        writeAll(own);
        for (const Option& option : options)
        {
            for (const Key& key : option.entries())
            {
                const auto isSame = [&](const Key& other)
                { return other.name == key.name && describe(other) == describe(key); };
                const auto known =
                    std::find_if(others.begin(), others.end(), [&](const auto& other) { return isSame(other.first); });
                if (key.noEffect || std::any_of(own.begin(), own.end(), isSame))
                {
                    continue;
                }
                if (known != others.end())
                {
                    known->second += ", " + std::string(option.name);
                }
                else
                {
                    others.emplace_back(key, option.name);
                }
            }
        }
        for (const auto& [key, names] : others)
        {
            write(key, names);
        }
    }

    void writeDictionary(const Key& key, const std::string& of)
    {
        const Keys keys = key.entries();
        if (!key.eachOption)
        {
            writeOne(key, std::string(key.name), (of.empty() ? "" : "(" + of + ") ") + describe(key), keys);
            return;
        }
        // The entries that all have are explained in the first one.
        bool first = true;
        for (const Option& option : keys.front().options())
        {
            Keys own{{.name = keys.front().name, .example = option.name}};
            own = joined(std::move(own), option.entries());
            const Keys common(keys.begin() + 1, keys.end());
            own = joined(std::move(own), first ? common : bare(common));
            writeOne(key, std::string(first ? key.name : option.name), std::string(option.sentence), own);
            first = false;
        }
    }

    /// What the example has of `keys`, without comments.
    static Keys bare(const Keys& keys)
    {
        Keys all;
        for (const Key& key : keys)
        {
            if (key.alternative || key.noEffect)
            {
                continue;
            }
            all.push_back({.name = key.name, .example = valueOf(key)});
            for (const Option& option : key.options())
            {
                if (option.name == valueOf(key))
                {
                    all = joined(std::move(all), bare(option.entries()));
                }
            }
        }
        return all;
    }

    void writeOne(const Key& key, const std::string& name, const std::string& said, const Keys& keys)
    {
        put("");
        putWithComment(
            name, {said + (key.anyName && !key.eachOption ? (said.empty() ? "any name" : "; any name") : "")}
        );
        putWithComment("{", {});
        indent_ += 4;
        if (!key.example.empty())
        {
            putWithComment(std::string(key.example), {});
        }
        writeAll(keys);
        indent_ -= 4;
        putWithComment("}", {});
    }

    static std::string_view valueOf(const Key& key) { return key.example.empty() ? key.otherwise : key.example; }

    /// What a line begins with: its margin, in a comment with its slashes.
    std::string beginning() const
    {
        return inComment_ ? std::string(commentIndent_, ' ') + "// " + std::string(indent_ - commentIndent_, ' ')
                          : std::string(indent_, ' ');
    }

    void putWithComment(const std::string& entry, const std::vector<std::string>& said)
    {
        constexpr std::size_t longest = 60; // beside which there is room for a comment
        if (!last_.empty() && last_.back() == '}' && entry != "}")
        {
            put("");
        }
        const std::string below = inComment_ ? std::string(commentIndent_, ' ') + "//" : "";
        std::string line = beginning() + entry;
        bool first = true;
        for (const auto& sentence : said)
        {
            if (sentence.empty())
            {
                continue;
            }
            if (first && line.size() >= longest)
            {
                put(line);
                line = below;
            }
            const std::size_t column = std::max(commentColumn, first ? line.size() + 1 : 0);
            for (const auto& part : wrapped(sentence, width - commentColumn - 3, width - column - 3))
            {
                put(padded(first ? line : below, commentColumn) + "// " + part);
                first = false;
            }
        }
        if (first)
        {
            put(line);
        }
    }

    void put(const std::string& line)
    {
        // No empty line at the start of a dictionary, nor two of them.
        if (!line.empty() || !(last_.empty() || last_.back() == '{'))
        {
            out_ << line << "\n";
            last_ = line;
        }
    }

    std::ostringstream out_;
    std::string last_;
    std::size_t indent_ = 0;
    bool inComment_ = false;
    std::size_t commentIndent_ = 0; ///< where it begins
};

} // namespace

std::string describe(const Key& key)
{
    std::string text = key.unit.name == unit::none.name ? "" : "[" + std::string(key.unit.name) + "]";
    const auto add = [&](const std::string& part) { text += (text.empty() || part.empty() ? "" : ", ") + part; };
    add(rangeText(key.range));
    if (const Options options = key.options(); !options.empty())
    {
        std::string names;
        for (const Option& option : options)
        {
            names += (names.empty() ? "" : " | ") + std::string(option.name) +
                     (option.name == key.otherwise ? " (default)" : "");
        }
        add(names);
    }
    else if (!key.otherwise.empty())
    {
        add("default " + std::string(key.otherwise));
    }
    if (!key.leftOut.empty())
    {
        add("default " + std::string(key.leftOut));
    }
    return text + (text.empty() || key.sentence.empty() ? "" : ": ") + std::string(key.sentence);
}

std::string AnnotatedDictionary::file() const
{
    const auto slash = path.find('/');
    std::ostringstream out;
    out << "FoamFile\n{\n    version     2.0;\n    format      ascii;\n    class       " << foamClass
        << ";\n    location    \"" << path.substr(0, slash) << "\";\n    object      " << path.substr(slash + 1)
        << ";\n}\n\n";
    std::istringstream paragraphs(text);
    for (std::string paragraph; std::getline(paragraphs, paragraph);)
    {
        for (const auto& line : wrapped(paragraph, width - 3, width - 3))
        {
            out << "// " << line << "\n";
        }
    }
    out << (text.empty() ? "" : "\n");
    Layout layout;
    layout.writeAll(keys());
    return out.str() + layout.text();
}

} // namespace slosh
