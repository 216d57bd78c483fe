#include "report/folder.h"

#include <fmt/format.h>

#include "files/files.h"
#include "report/escape.h"
#include "report/page_parts.h"

namespace fs = std::filesystem;

namespace grade {

const char* const page_links = "<nav class=\"pages\" aria-label=\"pages of this folder\"></nav>\n";

namespace {

constexpr std::string_view links_begin = "<nav class=\"pages\" aria-label=\"pages of this folder\">";
constexpr std::string_view links_end = "</nav>";

/// A page that a command writes, and what it answers.
struct FolderPage {
    const char *file, *name, *answers, *command;
};

constexpr FolderPage folder_pages[] = {
    {"index.html", "grading", "what is right, what is wrong, and why", "./grade [SUBMISSION --html DIR]"},
    {"stress.html", "extreme cases", "how extreme a scene the fragments survive",
     "./grade stress [SUBMISSION --html DIR]"},
    {"converge.html", "error against run time", "how fast pictures lose their noise",
     "./grade converge [SUBMISSION --out DIR]"},
    {"lesson.html", "integrals", "how the error of part 1 falls with the points",
     "./grade lesson [SUBMISSION --out DIR]"},
    {"calibration.html", "trust", "how often a verdict errs", "./grade calibrate --out DIR"},
};

/// The handout as a page where there is one: beside a kit, or in the project's build folder.
fs::path handout_in(const fs::path& project) {
    for (const char* page : {"handout.html", "build/release/handout.html"})
        if (fs::exists(project / page)) return project / page;
    return project / "handout.md";
}

/// The links of one page of the folder.
std::string links_of(const fs::path& folder, const std::string& own) {
    std::string there, others;
    for (const FolderPage& page : folder_pages)
        if (page.file == own)
            there += fmt::format("<b aria-current=\"page\">{}</b>", page.name);
        else if (fs::exists(folder / page.file))
            there += fmt::format("<a href=\"{}\" title=\"{}\">{}</a>", page.file, page.answers, page.name);
        else
            others += fmt::format("<li>{}, {}: <code>{}</code></li>", page.name, page.answers, page.command);
    if (fs::exists(folder / "handout.html")) there += "<a href=\"handout.html\">handout</a>";
    if (others.empty()) return there;
    return there + fmt::format("<details><summary>more pages</summary><ul>{}</ul></details>", others);
}

}  // namespace

std::string page_head(const std::string& title, const char* style) {
    return fmt::format(
        "<!doctype html>\n<html lang=\"en\"><head><meta charset=\"utf-8\"><meta name=\"viewport\" "
        "content=\"width=device-width\"><title>{}</title><style>{}{}</style></head><body>",
        html(title), page_style, style);
}

std::string plain_page(const std::string& title, const std::string& about, const std::string& read,
                       const std::string& body) {
    return fmt::format(
        "{0}<main>\n{1}<header><div><h1>{2}</h1><p>{3}</p>{4}</div></header>\n{5}</main></body></html>\n",
        page_head(title), page_links, html(title), html(about),
        read.empty() ? "" : fmt::format("<p class=\"soft\">{}</p>", read), body);
}

std::string handout_beside(const fs::path& folder, const fs::path& project) {
    fs::create_directories(folder);
    const fs::path handout = handout_in(project), copy = folder / handout.filename();
    const std::string there = fs::relative(handout, folder).generic_string();
    if (handout.extension() != ".html") return there;
    std::error_code error;
    if (fs::equivalent(copy, handout, error)) return copy.filename().string();
    fs::copy_file(handout, copy, fs::copy_options::overwrite_existing, error);
    if (!error) return copy.filename().string();
    fs::remove(copy, error);  // no room: a page without it is better than none
    return there;
}

void write_page(const fs::path& folder, const std::string& file, const std::string& text) {
    fs::create_directories(folder);
    write_text(folder / file, text);
    for (const FolderPage& page : folder_pages) {
        std::string old = read_text(folder / page.file, 1u << 30).value_or("");
        const auto begin = old.find(links_begin), end = old.find(links_end, begin);
        if (begin == old.npos || end == old.npos) continue;
        const auto from = begin + links_begin.size();
        const std::string links = links_of(folder, page.file);
        if (old.compare(from, end - from, links) == 0) continue;
        write_text(folder / page.file, old.replace(from, end - from, links));
    }
}

}  // namespace grade
