// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace slosh
{

/// Text as it stands between tags or in an attribute: & < > " become entities, control characters and what is no UTF-8
/// a question mark.
std::string escaped(std::string_view text);

/// One page that needs nothing beside itself: style inline, pictures as data: addresses, no script. Its tags are closed
/// as XML wants it. What is given is text, never tags.
class HtmlPage
{
public:
    HtmlPage(const std::string& title, const std::string& subtitle);

    /// Begins a section; the contents at the top lead to it.
    void section(const std::string& id, const std::string& title);
    void heading(const std::string& title); ///< inside a section
    void paragraph(const std::string& text);
    void preformatted(const std::string& text);
    /// Names and what they are.
    void facts(const std::vector<std::pair<std::string, std::string>>& rows);
    /// Columns of numbers stand at the right. A row shorter than the head is filled up.
    void table(const std::vector<std::string>& head, const std::vector<std::vector<std::string>>& rows);
    /// `type`: "svg+xml" or "png"; `file`: its bytes.
    void picture(const std::string& type, std::string_view file, const std::string& caption);
    /// Pictures up to endRow() stand side by side where there is room.
    void beginRow() { body_ += "<div class=\"row\">\n"; }
    void endRow() { body_ += "</div>\n"; }

    std::string text() const;

private:
    std::string title_, subtitle_, contents_, body_;
};

} // namespace slosh
