#pragma once

#include <filesystem>
#include <string>

/// Pages of several commands that stand in one folder, with one look, and lead to each other.
namespace grade {

/// Where a page has its links to the others; write_page fills it.
extern const char* const page_links;

/// A page about what a command has measured, with the style of all.
///
/// about  a line below the title
/// body   sections, as html_of_markdown makes them
std::string plain_page(const std::string& title, const std::string& about, const std::string& body);

/// Writes a page, and in all pages of its folder their links anew: to those that are there, and for the others the
/// commands that make them. Nothing is linked from a page that has no place for links.
///
/// file  its name: index.html, stress.html, converge.html, lesson.html or calibration.html
void write_page(const std::filesystem::path& folder, const std::string& file, const std::string& text);

}  // namespace grade
