#include "assignment/assignment.h"

#include <algorithm>
#include <stdexcept>

#include "files/files.h"
#include "rt/files/scene_reader.h"
#include "rt/files/toml_table.h"

namespace grade {

std::size_t Assignment::place(const std::string& fragment) const {
    const auto found = std::ranges::find(fragments, fragment, &Fragment::name);
    if (found == fragments.end()) throw std::out_of_range("no fragment is named \"" + fragment + "\"");
    return std::size_t(found - fragments.begin());
}

std::vector<std::string> Assignment::names() const {
    std::vector<std::string> names;
    for (const Fragment& fragment : fragments) names.push_back(fragment.name);
    return names;
}

std::set<std::string> Assignment::asked() const {
    std::set<std::string> names;
    for (const Fragment& fragment : fragments)
        if (!fragment.given) names.insert(fragment.name);
    return names;
}

Assignment read_assignment(const std::string& path) {
    std::error_code error;
    const std::optional<std::string> text = read_text(fs::canonical(path, error));
    if (!text) throw rt::InputError(path + ":1:1: cannot be read; expected the assignment's parts and fragments");
    const rt::Table file = rt::Table::parse(*text, path);
    file.only({"title", "part", "theory"});

    Assignment assignment;
    assignment.title = file.text("title");
    if (file.has("theory")) {
        const rt::Table theory = file.table("theory");
        theory.only({"points"});
        assignment.theory_points = theory.number("points", rt::not_negative);
    }
    for (const rt::Table& part : file.tables("part")) {
        part.only({"name", "title", "fragments", "visibility"});
        const int visibility = part.choice("visibility", visibilities, 0);
        assignment.parts.push_back({part.text("name"), part.text("title")});
        for (const rt::Table& entry : part.tables("fragments")) {
            entry.only({"name", "points", "given", "visibility"});
            Fragment fragment{
                entry.text("name"), part.text("name"), 0, entry.flag("given", false),
                std::string(visibilities[std::size_t(entry.choice("visibility", visibilities, visibility))])};
            if (std::ranges::count(assignment.fragments, fragment.name, &Fragment::name) > 0)
                entry.fail("name", "a second fragment \"" + fragment.name + "\"", "each name once");
            fragment.points =
                entry.number("points", rt::not_negative, fragment.given ? std::optional(0.0) : std::nullopt);
            if (fragment.given) fragment.points = 0;
            assignment.fragments.push_back(fragment);
        }
    }
    return assignment;
}

}  // namespace grade
