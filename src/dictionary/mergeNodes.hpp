// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "dictionary/DictionaryNode.hpp"

#include <memory>
#include <string>

namespace slosh
{

/// #inputMode: what becomes of an entry that is there already.
enum class InputMode
{
    merge,
    overwrite,
    protect,
    error
};

/// A copy of `node` and of all below it, as the dictionary `name` of `parent`.
std::shared_ptr<Dictionary::Node>
copyOf(const Dictionary::Node& node, const std::string& name, Dictionary::Node* parent);

/// Puts the entries of `other` into `node`.
void merge(Dictionary::Node& node, const Dictionary::Node& other, InputMode mode);

} // namespace slosh
