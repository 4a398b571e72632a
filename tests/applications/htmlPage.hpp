// SPDX-License-Identifier: GPL-3.0-or-later
// A page of HTML as a test sees it: its faults, its pictures.
#pragma once

#include <string>
#include <vector>

namespace slosh
{

/// What is wrong with the nesting of tags, with attributes and with the characters between; "" where nothing is.
std::string faultOf(const std::string& page);
/// The pictures of a page, in their order, as files.
std::vector<std::string> picturesIn(const std::string& page);

} // namespace slosh
