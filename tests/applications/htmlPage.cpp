// SPDX-License-Identifier: GPL-3.0-or-later
#include "htmlPage.hpp"

#include <regex>
#include <sstream>

namespace slosh
{

namespace
{

/// All that stands between `begin` and the next `end`, taken out.
std::string without(std::string text, const std::string& begin, const std::string& end)
{
    for (auto at = text.find(begin); at != std::string::npos; at = text.find(begin, at))
    {
        at += begin.size();
        text.erase(at, text.find(end, at) - at);
    }
    return text;
}

std::string fromBase64(const std::string& text)
{
    const std::string letters = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string bytes;
    unsigned long group = 0;
    int bits = 0;
    for (const char c : text.substr(0, text.find('=')))
    {
        group = (group << 6 | letters.find(c)) & 0xffffff;
        bits += 6;
        if (bits >= 8)
        {
            bits -= 8;
            bytes += static_cast<char>(group >> bits & 0xff);
        }
    }
    return bytes;
}

} // namespace

std::string faultOf(const std::string& page)
{
    // Style is no markup, and the bytes of pictures are looked at elsewhere.
    const std::string text = without(without(page, "<style>", "<"), ";base64,", "\"");
    const std::regex begin(R"(([a-z][a-z0-9]*)((?: [a-z-]+="[^"<]*")*)( /)?)"), entity("(amp|lt|gt|quot);.*");
    std::vector<std::string> open;
    std::istringstream in(text.substr(text.find('<', 1)));
    std::string tag, between;
    for (in.get(); std::getline(in, tag, '>') && std::getline(in, between, '<');)
    {
        std::smatch match;
        if (tag[0] == '/')
        {
            if (open.empty() || open.back() != tag.substr(1))
            {
                return "<" + tag + "> closes " + (open.empty() ? "nothing" : "<" + open.back() + ">");
            }
            open.pop_back();
        }
        else if (!std::regex_match(tag, match, begin))
        {
            return "no tag: <" + tag + ">";
        }
        else if (!match[3].matched)
        {
            open.push_back(match[1]);
        }
        for (const std::string& words : {tag, between})
        {
            for (auto at = words.find('&'); at != std::string::npos; at = words.find('&', at + 1))
            {
                if (!std::regex_match(words.substr(at + 1, 6), entity))
                {
                    return "not escaped: " + words.substr(at, 20);
                }
            }
        }
        if (between.find('>') != std::string::npos)
        {
            return "not escaped: " + between;
        }
    }
    return open.empty() ? "" : "<" + open.back() + "> is not closed";
}

std::vector<std::string> picturesIn(const std::string& page)
{
    std::vector<std::string> pictures;
    const std::string begin = ";base64,";
    for (auto at = page.find(begin); at != std::string::npos; at = page.find(begin, at + 1))
    {
        pictures.push_back(fromBase64(page.substr(at + begin.size(), page.find('"', at) - at - begin.size())));
    }
    return pictures;
}

} // namespace slosh
