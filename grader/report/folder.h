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
/// read   where to read about it, HTML, as read_link makes it; empty: nowhere
/// body   sections, as html_of_markdown makes them
std::string plain_page(const std::string& title, const std::string& about, const std::string& read,
                       const std::string& body);

/// Where a page in this folder, which is made, finds the handout of the project or kit. As a page, which needs nothing
/// else, it comes along: the folder may be moved.
std::string handout_beside(const std::filesystem::path& folder, const std::filesystem::path& project);

/// Writes a page, and in all pages of its folder their links anew: to those that are there, and for the others the
/// commands that make them, and to the handout where it came along. Nothing is linked from a page that has no place for
/// links.
///
/// file  its name: index.html, stress.html, converge.html, lesson.html or calibration.html
void write_page(const std::filesystem::path& folder, const std::string& file, const std::string& text);

}  // namespace grade
