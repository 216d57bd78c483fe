#include "report/markdown.h"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "files/words.h"
#include "report/escape.h"

namespace grade {

namespace {

/// Words within a line.
std::string inline_html(std::string_view words) {
    std::string safe = html_with_code(words);
    bool open = false;
    for (std::size_t at = 0; (at = safe.find("**", at)) != safe.npos; open = !open) {
        if (!open && safe.find("**", at + 2) == safe.npos) break;
        safe.replace(at, 2, open ? "</b>" : "<b>");
    }
    return safe;
}

/// "| a | b |"
std::vector<std::string_view> cells_of(std::string_view line) {
    std::vector<std::string_view> cells;
    line.remove_prefix(1);
    while (!line.empty()) {
        const auto end = std::min(line.find('|'), line.size());
        if (end == line.size() && line.find_first_not_of(' ') == line.npos) break;
        cells.push_back(line.substr(0, end));
        line.remove_prefix(std::min(end + 1, line.size()));
    }
    return cells;
}

/// Of a table's body, which narrow pages lay out as blocks: each cell knows what its column is.
std::string row_of(std::string_view line, const std::vector<std::string_view>& headers) {
    std::string text = "<tr>";
    const auto cells = cells_of(line);
    for (std::size_t i = 0; i < cells.size(); ++i)
        text += fmt::format("<td{}>{}</td>",
                            i > 0 && i < headers.size() && !trimmed(headers[i]).empty()
                                ? fmt::format(" data-is=\"{}\"", html(trimmed(headers[i])))
                                : "",
                            inline_html(cells[i]));
    return text + "</tr>\n";
}

std::string header_of(const std::vector<std::string_view>& headers) {
    std::string text = "<tr>";
    for (const std::string_view header : headers)
        text += trimmed(header).empty() ? "<td></td>" : fmt::format("<th>{}</th>", inline_html(header));
    return text + "</tr>\n";
}

/// number  among the page's tables: no two regions may have one name
std::string table_of(const std::vector<std::string_view>& rows, int number) {
    constexpr std::size_t many = 6;  // columns, for which there is room on wide pages alone
    const auto headers = cells_of(rows.front());
    std::string text =
        fmt::format("<div class=\"scroll plain{}\" role=\"region\" tabindex=\"0\" aria-label=\"table {}\"><table>\n",
                    headers.size() > many ? " many" : "", number);
    for (std::size_t i = 0; i < rows.size(); ++i)
        if (!rows[i].starts_with("|--")) text += i == 0 ? header_of(headers) : row_of(rows[i], headers);
    return text + "</table></div>\n";
}

/// "![what it shows](file)"
std::string picture_of(std::string_view line) {
    const auto middle = line.find("]("), end = line.find(')', middle);
    if (middle == line.npos || end == line.npos) return fmt::format("<p>{}</p>\n", inline_html(line));
    const std::string alt = html(line.substr(2, middle - 2));
    return fmt::format("<figure class=\"plot\"><img src=\"{}\" alt=\"{}\"></figure>\n",
                       html(line.substr(middle + 2, end - middle - 2)), alt);
}

/// Consecutive lines that begin like the first: a list, a paragraph.
std::string block_of(const std::vector<std::string_view>& lines) {
    const bool list = lines.front().starts_with("* ");
    std::string text = list ? "<ul>" : "<p>";
    for (const std::string_view line : lines)
        text += list ? fmt::format("<li>{}</li>\n", inline_html(line.substr(2))) : inline_html(line) + "\n";
    return text + (list ? "</ul>\n" : "</p>\n");
}

bool stands_alone(std::string_view line) { return line.empty() || line.starts_with("#") || line.starts_with("!["); }

bool of_one_kind(std::string_view a, std::string_view b) {
    return a.starts_with("|") == b.starts_with("|") && a.starts_with("* ") == b.starts_with("* ");
}

}  // namespace

std::string html_of_markdown(std::string_view text) {
    const auto lines = lines_of(text);
    std::string page = "<section class=\"card\">\n";
    int tables = 0;
    for (std::size_t i = 0; i < lines.size();) {
        const std::string_view line = lines[i];
        if (stands_alone(line)) {
            if (line.starts_with("## "))
                page += fmt::format("</section>\n<h2>{}</h2>\n<section class=\"card\">\n", inline_html(line.substr(3)));
            else if (line.starts_with("### "))
                page += fmt::format("<h3>{}</h3>\n", inline_html(line.substr(4)));
            else if (line.starts_with("!["))
                page += picture_of(line);
            ++i;
            continue;
        }
        std::vector<std::string_view> block;
        while (i < lines.size() && !stands_alone(lines[i]) && of_one_kind(line, lines[i])) block.push_back(lines[i++]);
        page += line.starts_with("|") ? table_of(block, ++tables) : block_of(block);
    }
    page += "</section>\n";
    constexpr std::string_view empty = "<section class=\"card\">\n</section>\n";  // before the first heading
    if (page.starts_with(empty)) page.erase(0, empty.size());
    return page;
}

}  // namespace grade
