#pragma once

#include <string>
#include <string_view>

namespace grade {

/// A report in Markdown as the sections of a page: of all Markdown what reports have, which is headings of the second
/// level and below, paragraphs, lists, tables, pictures, **bold** and `code`. Heading and words before the first
/// section come first; the heading of the first level is left to the page.
std::string html_of_markdown(std::string_view text);

}  // namespace grade
