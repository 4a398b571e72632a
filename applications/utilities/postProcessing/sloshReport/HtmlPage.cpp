// SPDX-License-Identifier: GPL-3.0-or-later
#include "HtmlPage.hpp"

#include <algorithm>
#include <charconv>

namespace slosh
{

namespace
{

constexpr std::string_view style = R"(
:root { color-scheme: light; }
body { margin: 0 auto; padding: 1rem; max-width: 62rem; font: 1rem/1.5 system-ui, "DejaVu Sans", Arial, sans-serif;
  color: #1c2733; background: #fff; overflow-wrap: anywhere; }
header { border-bottom: 3px solid #0b5fa5; margin-bottom: 1rem; }
h1 { font-size: 1.7rem; line-height: 1.2; margin: 0.5rem 0; }
h2 { font-size: 1.3rem; margin: 2.2rem 0 0.6rem; padding-bottom: 0.2rem; border-bottom: 1px solid #c9d3de; }
h3 { font-size: 1.05rem; margin: 1.4rem 0 0.4rem; }
header p { color: #516173; margin: 0.3rem 0 0.8rem; }
nav a { display: inline-block; margin: 0 1rem 0.3rem 0; color: #0b5fa5; }
table { border-collapse: collapse; font-size: 0.92rem; font-variant-numeric: tabular-nums; }
th, td { text-align: left; vertical-align: top; padding: 0.25rem 0.8rem 0.25rem 0; border-bottom: 1px solid #e3e9ef; }
thead th { border-bottom: 2px solid #c9d3de; }
tbody th { font-weight: 600; white-space: nowrap; }
th.n, td.n { text-align: right; overflow-wrap: normal; }
.wide { margin-bottom: 1rem; overflow-x: auto; overflow-wrap: normal; }
pre { white-space: pre-wrap; background: #f4f7fa; padding: 0.7rem; font-size: 0.8rem; line-height: 1.4; }
figure { margin: 0.6rem 0 1.2rem; }
figure img { display: block; max-width: 100%; height: auto; }
figcaption { color: #516173; font-size: 0.9rem; }
.row { display: grid; grid-template-columns: repeat(auto-fit, minmax(min(100%, 26rem), 1fr)); gap: 0 1rem; }
@media print { body { max-width: none; font-size: 10pt; padding: 0; } nav { display: none; }
  figure, tr { break-inside: avoid; } h2, h3 { break-after: avoid; } .wide { overflow: visible; }
  .row { grid-template-columns: 1fr 1fr; } }
)";

std::string base64(std::string_view bytes)
{
    constexpr std::string_view letters = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string text;
    text.reserve((bytes.size() + 2) / 3 * 4);
    for (std::size_t i = 0; i < bytes.size(); i += 3)
    {
        unsigned long group = 0;
        for (std::size_t k = 0; k < 3; ++k)
        {
            group = group << 8 | (i + k < bytes.size() ? static_cast<unsigned char>(bytes[i + k]) : 0u);
        }
        for (std::size_t k = 0; k < 4; ++k)
        {
            text += i + k > bytes.size() ? '=' : letters[group >> (18 - 6 * k) & 63];
        }
    }
    return text;
}

/// How many bytes the UTF-8 character at `at` takes; 0: none begins there.
std::size_t characterAt(std::string_view text, std::size_t at)
{
    const auto c = static_cast<unsigned char>(text[at]);
    const std::size_t n = c < 0x80                ? 1
                          : c >= 0xc2 && c < 0xe0 ? 2
                          : c >= 0xe0 && c < 0xf0 ? 3
                          : c >= 0xf0 && c < 0xf5 ? 4
                                                  : 0;
    for (std::size_t k = 1; k < n; ++k)
    {
        if (at + k >= text.size() || (static_cast<unsigned char>(text[at + k]) & 0xc0) != 0x80)
        {
            return 0;
        }
    }
    return n;
}

/// "12.5", "-3e-4", "7 %"; what is empty counts as one.
bool isNumber(const std::string& cell)
{
    double value = 0;
    const char* end = cell.data() + cell.size();
    const auto [rest, error] = std::from_chars(cell.data(), end, value);
    return cell.empty() || (error == std::errc() && (rest == end || std::string_view(rest) == " %"));
}

} // namespace

std::string escaped(std::string_view text)
{
    std::string out;
    for (std::size_t i = 0; i < text.size();)
    {
        const std::size_t n = characterAt(text, i);
        const auto c = static_cast<unsigned char>(text[i]);
        if (n == 0 || c == 0x7f || (c < 0x20 && c != '\n' && c != '\t'))
        {
            out += '?';
        }
        else if (c == '&' || c == '<' || c == '>' || c == '"')
        {
            out += c == '&' ? "&amp;" : c == '<' ? "&lt;" : c == '>' ? "&gt;" : "&quot;";
        }
        else
        {
            out += text.substr(i, n);
        }
        i += n == 0 ? 1 : n;
    }
    return out;
}

HtmlPage::HtmlPage(const std::string& title, const std::string& subtitle)
    : title_(escaped(title)), subtitle_(escaped(subtitle))
{
}

void HtmlPage::section(const std::string& id, const std::string& title)
{
    contents_ += "<a href=\"#" + id + "\">" + escaped(title) + "</a>\n";
    body_ += (body_.empty() ? "<section>\n" : "</section>\n<section>\n");
    body_ += "<h2 id=\"" + id + "\">" + escaped(title) + "</h2>\n";
}

void HtmlPage::heading(const std::string& title)
{
    body_ += "<h3>" + escaped(title) + "</h3>\n";
}

void HtmlPage::paragraph(const std::string& text)
{
    body_ += "<p>" + escaped(text) + "</p>\n";
}

void HtmlPage::preformatted(const std::string& text)
{
    body_ += "<pre>" + escaped(text) + "</pre>\n";
}

void HtmlPage::facts(const std::vector<std::pair<std::string, std::string>>& rows)
{
    body_ += "<table><tbody>\n";
    for (const auto& [name, what] : rows)
    {
        body_ += "<tr><th scope=\"row\">" + escaped(name) + "</th><td>" + escaped(what) + "</td></tr>\n";
    }
    body_ += "</tbody></table>\n";
}

void HtmlPage::table(const std::vector<std::string>& head, const std::vector<std::vector<std::string>>& rows)
{
    const auto cellOf = [](const std::vector<std::string>& row, std::size_t k)
    { return k < row.size() ? row[k] : std::string(); };
    std::vector<std::string> style;
    for (std::size_t k = 0; k < head.size(); ++k)
    {
        const bool numbers =
            std::all_of(rows.begin(), rows.end(), [&](const auto& row) { return isNumber(cellOf(row, k)); });
        style.emplace_back(numbers ? " class=\"n\"" : "");
    }
    body_ += "<div class=\"wide\"><table><thead><tr>";
    for (std::size_t k = 0; k < head.size(); ++k)
    {
        body_ += "<th scope=\"col\"" + style[k] + ">" + escaped(head[k]) + "</th>";
    }
    body_ += "</tr></thead><tbody>\n";
    for (const auto& row : rows)
    {
        body_ += "<tr>";
        for (std::size_t k = 0; k < head.size(); ++k)
        {
            body_ += "<td" + style[k] + ">" + escaped(cellOf(row, k)) + "</td>";
        }
        body_ += "</tr>\n";
    }
    body_ += "</tbody></table></div>\n";
}

void HtmlPage::picture(const std::string& type, std::string_view file, const std::string& caption)
{
    const std::string words = escaped(caption);
    body_ += "<figure><img alt=\"" + words + "\" src=\"data:image/" + type + ";base64," + base64(file) +
             "\" /><figcaption>" + words + "</figcaption></figure>\n";
}

std::string HtmlPage::text() const
{
    return "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\" />\n"
           "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\" />\n<title>" +
           title_ + "</title>\n<style>" + std::string(style) + "</style>\n</head>\n<body>\n<header>\n<h1>" + title_ +
           "</h1>\n<p>" + subtitle_ + "</p>\n<nav>\n" + contents_ + "</nav>\n</header>\n" + body_ +
           (body_.empty() ? "" : "</section>\n") + "</body>\n</html>\n";
}

} // namespace slosh
