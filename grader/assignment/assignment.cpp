#include "assignment/assignment.h"

#include <algorithm>
#include <stdexcept>

#include "files/files.h"
#include "rt/files/scene_reader.h"
#include "rt/files/toml_table.h"

namespace grade {

namespace {

constexpr rt::Limits points{.low = 0, .high = most_points};

/// visibility  its part's
Fragment read_fragment(const rt::Table& entry, const std::string& part, int visibility,
                       const std::vector<std::string>& known) {
    entry.only({"name", "points", "given", "visibility"});
    Fragment fragment{entry.text("name"), part, 0, entry.flag("given", false),
                      std::string(visibilities[std::size_t(entry.choice("visibility", visibilities, visibility))])};
    if (!known.empty() && std::ranges::count(known, fragment.name) == 0) {
        const auto nearest = rt::nearest_word(fragment.name, known);
        entry.fail("name", "unknown fragment " + rt::in_quotes(fragment.name),
                   nearest ? rt::in_quotes(*nearest) + "?" : "one that starter/rt/fragments.h declares");
    }
    fragment.points = entry.number("points", points, fragment.given ? std::optional(0.0) : std::nullopt);
    if (fragment.given && fragment.points > 0)
        entry.fail("points", "is of a fragment that is handed out filled in", "no points, or given = false");
    return fragment;
}

}  // namespace

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

std::vector<std::string> fragments_in(const std::string& folder) {
    std::vector<std::string> names;
    std::error_code error;
    for (fs::directory_iterator at(folder, error), end; !error && at != end; at.increment(error))
        if (at->path().extension() == ".cpp") names.push_back(at->path().stem().string());
    return names;
}

Assignment read_assignment(const std::string& path, const std::vector<std::string>& known) {
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
        assignment.theory_points = theory.number("points", points);
    }
    for (const rt::Table& part : file.tables("part", true)) {
        part.only({"name", "title", "fragments", "visibility"});
        const int visibility = part.choice("visibility", visibilities, 0);
        const std::string name = part.text("name");
        if (std::ranges::count(assignment.parts, name, &Part::name) > 0)
            part.fail("name", "a second part " + rt::in_quotes(name), "each name once");
        assignment.parts.push_back({name, part.text("title")});
        for (const rt::Table& entry : part.tables("fragments", true)) {
            const Fragment fragment = read_fragment(entry, name, visibility, known);
            if (std::ranges::count(assignment.fragments, fragment.name, &Fragment::name) > 0)
                entry.fail("name", "a second fragment " + rt::in_quotes(fragment.name), "each name once");
            assignment.fragments.push_back(fragment);
        }
    }
    if (assignment.fragments.empty()) file.fail("part", "no part has a fragment", "{ name = ..., points = ... }");
    return assignment;
}

}  // namespace grade
