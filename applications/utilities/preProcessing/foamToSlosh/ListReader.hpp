// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "dictionary/Dictionary.hpp"

#include <string>
#include <vector>

namespace slosh
{

/// An entry that is a list, read token by token: lists of mixed content such as blocks and regions.
class ListReader
{
public:
    /// The tokens of an entry of `dict`, without a count before the list. Throws CaseError where the entry is missing.
    ListReader(const Dictionary& dict, const std::string& key);

    bool atEnd() const { return at_ == tokens_.size(); }
    bool nextIs(char punctuation) const { return !atEnd() && tokens_[at_].is(punctuation); }
    bool nextIsWord(const std::string& word = "") const; ///< this one, or any
    std::string place() const;                           ///< "system/blockMeshDict:31", of the next token

    // Each takes what it names, or throws CaseError with the line, saying what stands there instead.
    void expect(char punctuation);
    std::string word();
    double number();
    int label();                                    ///< a whole number
    Vec vector();                                   ///< (x y z)
    std::vector<int> labels();                      ///< (a b ...)
    void skip();                                    ///< one token, or a bracket with all in it
    Dictionary dictionary(const std::string& name); ///< { ... }

private:
    CaseError misplaced(const std::string& wanted) const;
    const Token& take(const std::string& wanted, Token::Kind kind);
    std::string file_;
    std::vector<Token> tokens_;
    std::size_t at_ = 0;
};

} // namespace slosh
