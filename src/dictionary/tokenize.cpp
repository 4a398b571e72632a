// SPDX-License-Identifier: GPL-3.0-or-later
#include "dictionary/tokenize.hpp"

#include "base/CaseError.hpp"

#include <cctype>
#include <charconv>

namespace slosh
{

bool isNumber(std::string_view text, double& value)
{
    if (!text.empty() && text.front() == '+')
    {
        text.remove_prefix(1);
    }
    if (text.empty() ||
        (std::isdigit(static_cast<unsigned char>(text.front())) == 0 && text.front() != '-' && text.front() != '.'))
    {
        return false;
    }
    if (text.size() > 1 && text.front() == '-' && std::isalpha(static_cast<unsigned char>(text[1])) != 0)
    {
        return false; // -inf, -nan
    }
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    return error == std::errc() && end == text.data() + text.size();
}

namespace
{

class Tokenizer
{
public:
    Tokenizer(std::string_view text, const std::string& file) : text_(text), file_(file) {}

    std::vector<Token> run()
    {
        while (skipBlanks())
        {
            const char c = text_[at_];
            if (std::string_view("()[]{};").find(c) != std::string_view::npos)
            {
                tokens_.push_back({Token::Kind::punctuation, std::string(1, c), 0, line_});
                ++at_;
            }
            else if (c == '"')
            {
                quoted();
            }
            else if (text_.substr(at_, 2) == "#{")
            {
                verbatim();
            }
            else
            {
                word();
            }
        }
        return std::move(tokens_);
    }

private:
    [[noreturn]] void unfinished(const std::string& what, int line) const
    {
        throw errorIn(placeIn(file_, line), what + " is not closed");
    }

    /// To the next token; false at the end.
    bool skipBlanks()
    {
        while (at_ < text_.size())
        {
            if (std::isspace(static_cast<unsigned char>(text_[at_])) != 0)
            {
                line_ += text_[at_++] == '\n';
            }
            else if (text_.substr(at_, 2) == "//")
            {
                at_ = std::min(text_.find('\n', at_), text_.size());
            }
            else if (text_.substr(at_, 2) == "/*")
            {
                const auto end = text_.find("*/", at_ + 2);
                if (end == std::string_view::npos)
                {
                    unfinished("the comment", line_);
                }
                skipTo(end + 2);
            }
            else
            {
                return true;
            }
        }
        return false;
    }

    void skipTo(std::size_t end)
    {
        for (; at_ < end; ++at_)
        {
            line_ += text_[at_] == '\n';
        }
    }

    void quoted()
    {
        const int begin = line_;
        std::string value;
        for (++at_; at_ < text_.size() && text_[at_] != '"'; ++at_)
        {
            // \" is a quote, \ at the end of a line joins it to the next; any other backslash belongs to the text.
            if (text_[at_] == '\\' && at_ + 1 < text_.size() && (text_[at_ + 1] == '"' || text_[at_ + 1] == '\n'))
            {
                ++at_;
            }
            line_ += text_[at_] == '\n';
            if (text_[at_] != '\n')
            {
                value += text_[at_];
            }
            else if (text_[at_ - 1] != '\\')
            {
                unfinished("the string", begin);
            }
        }
        if (at_ == text_.size())
        {
            unfinished("the string", begin);
        }
        ++at_;
        tokens_.push_back({Token::Kind::string, std::move(value), 0, begin});
    }

    /// #{ ... #}, which is code, as one string.
    void verbatim()
    {
        const std::size_t end = text_.find("#}", at_ + 2);
        if (end == std::string_view::npos)
        {
            unfinished("the code", line_);
        }
        tokens_.push_back({Token::Kind::string, std::string(text_.substr(at_ + 2, end - at_ - 2)), 0, line_});
        skipTo(end + 2);
    }

    void word()
    {
        const std::size_t begin = at_;
        const bool startsNumber = std::isdigit(static_cast<unsigned char>(text_[at_])) != 0;
        int parentheses = 0;
        for (; at_ < text_.size(); ++at_)
        {
            const char c = text_[at_];
            if (text_.substr(at_, 3) == "${{" && (at_ == begin || text_.substr(begin, at_ - begin) == "-"))
            {
                inlineExpression(begin);
                return;
            }
            if (c == '$' && text_.substr(at_, 2) == "${")
            {
                at_ = text_.find('}', at_);
                if (at_ == std::string_view::npos)
                {
                    unfinished("the macro", line_);
                }
                continue;
            }
            if (std::isspace(static_cast<unsigned char>(c)) != 0 ||
                std::string_view("[]{};\"").find(c) != std::string_view::npos || text_.substr(at_, 2) == "//" ||
                text_.substr(at_, 2) == "/*")
            {
                break;
            }
            // 3(1 2 3) is a number and a list, div(phi,U) one word, ($x $y) a list of macros.
            if (c == '(' && (startsNumber || text_[begin] == '$'))
            {
                break;
            }
            parentheses += c == '(' ? 1 : c == ')' ? -1 : 0;
            if (parentheses < 0)
            {
                break;
            }
        }
        Token token{Token::Kind::word, std::string(text_.substr(begin, at_ - begin)), 0, line_};
        if (isNumber(token.text, token.number))
        {
            token.kind = Token::Kind::number;
        }
        const bool takesExpression = token.text == "#eval" || token.text == "#calc";
        const bool takesFunction = token.text == "#includeFunc";
        tokens_.push_back(std::move(token));
        if (takesExpression)
        {
            expression();
        }
        if (takesFunction)
        {
            function();
        }
    }

    /// ${{ x }} is #eval { x }, and -${{ x }} is #eval { -(x) }.
    void inlineExpression(std::size_t begin)
    {
        const int line = line_;
        const std::size_t end = text_.find("}}", at_);
        if (end == std::string_view::npos)
        {
            unfinished("the expression", line);
        }
        const std::string x(text_.substr(at_ + 3, end - at_ - 3));
        const bool isNegative = at_ > begin;
        tokens_.push_back({Token::Kind::word, "#eval", 0, line});
        tokens_.push_back({Token::Kind::string, isNegative ? "-(" + x + ")" : x, 0, line});
        skipTo(end + 2);
    }

    /// name(a, b) after #includeFunc as one string; a quoted one is a string already.
    void function()
    {
        if (!skipBlanks() || text_[at_] == '"')
        {
            return;
        }
        const std::size_t begin = at_;
        at_ = std::min(text_.find_first_of("(;{} \t\r\n", begin), text_.size());
        if (at_ < text_.size() && text_[at_] == '(')
        {
            const std::size_t end = text_.find(')', at_);
            if (end == std::string_view::npos)
            {
                unfinished("the list of arguments", line_);
            }
            skipTo(end + 1);
        }
        tokens_.push_back({Token::Kind::string, std::string(text_.substr(begin, at_ - begin)), 0, line_});
    }

    /// { ... } after #eval as one string; a quoted one is a string already.
    void expression()
    {
        if (!skipBlanks() || text_[at_] != '{')
        {
            return;
        }
        const int begin = line_;
        int depth = 0;
        for (std::size_t end = at_; end < text_.size(); ++end)
        {
            depth += text_[end] == '{' ? 1 : text_[end] == '}' ? -1 : 0;
            if (depth == 0)
            {
                tokens_.push_back({Token::Kind::string, std::string(text_.substr(at_ + 1, end - at_ - 1)), 0, begin});
                skipTo(end + 1);
                return;
            }
        }
        unfinished("the expression", begin);
    }

    std::string_view text_;
    const std::string& file_;
    std::size_t at_ = 0;
    int line_ = 1;
    std::vector<Token> tokens_;
};

} // namespace

std::vector<Token> tokenize(std::string_view text, const std::string& file)
{
    return Tokenizer(text, file).run();
}

} // namespace slosh
