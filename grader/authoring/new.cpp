#include "authoring/new.h"

#include <fmt/format.h>

#include <algorithm>
#include <regex>

#include "assignment/strip.h"
#include "authoring/names.h"
#include "authoring/skeleton.h"
#include "files/files.h"
#include "rt/files/scene_reader.h"
#include "rt/files/toml_table.h"

namespace grade::authoring {

namespace {

const fs::path header_file = "starter/rt/fragments.h", list_file = "assignment.toml", handout_file = "handout.md";

void require_new(const fs::path& project, const fs::path& file) {
    if (fs::exists(project / file))
        throw rt::InputError(file.string() + ": is there already; expected a new name, or to edit that file");
}

void require_fragment(const Assignment& assignment, const std::string& name) {
    const auto names = assignment.names();
    if (std::ranges::count(names, name) > 0) return;
    const auto nearest = rt::nearest_word(name, names);
    throw rt::InputError(fmt::format("{}: no fragment has this name; expected {}", rt::in_quotes(name),
                                     nearest ? *nearest + "?" : "one that assignment.toml lists"));
}

/// Where the line that holds these words ends, after its line break.
std::size_t end_of_line_with(const std::string& text, const std::regex& words, const fs::path& file,
                             const std::string& expected) {
    std::smatch match;
    if (!std::regex_search(text, match, words))
        throw rt::InputError(
            fmt::format("{}:1:1: there is no line to write after; expected {}", file.string(), expected));
    const std::size_t end = text.find('\n', std::size_t(match.position() + match.length()));
    return end == text.npos ? text.size() : end + 1;
}

/// The fragment that the new one comes after.
std::string place_for(const Assignment& assignment, const NewFragment& fragment) {
    if (!fragment.like.empty() && fragment.part.empty()) return fragment.like;
    const std::string part = fragment.part.empty() ? assignment.parts.back().name : fragment.part;
    std::string last;
    for (const Fragment& other : assignment.fragments)
        if (other.part == part) last = other.name;
    if (last.empty())
        throw rt::InputError(fmt::format(
            "--part {}: no part with fragments has this name; expected one of assignment.toml", rt::in_quotes(part)));
    return last;
}

Declaration declare(const std::string& header, const NewFragment& fragment) {
    std::string line = fragment.declaration.empty() ? "" : fragment.declaration + ";";
    while (line.ends_with(";;")) line.pop_back();
    if (line.empty()) {
        const auto other = declaration_of(fragment.like, header);
        line = other ? other->line : "";
        const std::size_t at = line.find(" " + fragment.like + "(");
        if (at != line.npos) line.replace(at + 1, fragment.like.size(), fragment.name);
    }
    const auto declaration = declaration_of(fragment.name, line + "\n");
    if (!declaration || declaration->signature.arguments.empty())
        throw rt::InputError(
            fmt::format("--declare {}: is no declaration of {}; expected one as fragments.h has them: "
                        "--declare 'DiskSample {}(vec2 u)'",
                        rt::in_quotes(fragment.declaration), fragment.name, fragment.name));
    if (line.size() > 120)
        throw rt::InputError(
            fmt::format("{}: the declaration has {} columns; expected at most 120, on one line: a "
                        "shorter name",
                        fragment.name, line.size()));
    require_known_types(*declaration);
    return *declaration;
}

/// The id of the first statistic in a file of checks.
std::string id_in(const std::string& checks) {
    std::smatch match;
    return std::regex_search(checks, match, std::regex("\\.id = \"(\\w+)\"")) ? match[1].str() : "V3";
}

std::string with_section(const std::string& handout, const std::string& after, const std::string& section) {
    const std::size_t at = handout.find("\n### " + after + "\n");
    if (at == handout.npos)
        throw rt::InputError(fmt::format("{}:1:1: has no section ### {}, after which the new one comes; expected it",
                                         handout_file.string(), after));
    const std::size_t end = std::min(handout.find("\n### ", at + 1), handout.find("\n## ", at + 1));
    std::string text = handout;
    return text.insert(end == text.npos ? text.size() : end + 1, section);
}

/// The change of a text as a patch with two lines around it.
std::string hunk_of(const std::string& before, const std::string& after) {
    const auto lines_of = [](const std::string& text) {
        std::vector<std::string> lines;
        std::size_t at = 0;
        for (std::size_t end; (end = text.find('\n', at)) != text.npos; at = end + 1)
            lines.push_back(text.substr(at, end - at));
        return lines;
    };
    const auto a = lines_of(before), b = lines_of(after);
    std::size_t same = 0, last = 0;
    while (same < a.size() && same < b.size() && a[same] == b[same]) ++same;
    while (last < a.size() - same && last < b.size() - same && a[a.size() - 1 - last] == b[b.size() - 1 - last]) ++last;
    const std::size_t first = same - std::min<std::size_t>(same, 2), more = std::min<std::size_t>(last, 2);
    std::string text = fmt::format("@@ -{},{} +{},{} @@\n", first + 1, a.size() - last + more - first, first + 1,
                                   b.size() - last + more - first);
    for (std::size_t i = first; i < same; ++i) text += " " + a[i] + "\n";
    for (std::size_t i = same; i < a.size() - last; ++i) text += "-" + a[i] + "\n";
    for (std::size_t i = same; i < b.size() - last; ++i) text += "+" + b[i] + "\n";
    for (std::size_t i = 0; i < more; ++i) text += " " + a[a.size() - last + i] + "\n";
    text.pop_back();
    return text;
}

/// The number that the next mistake gets, and whether one has this name already.
int next_number(const fs::path& folder, const std::string& name) {
    int number = 0;
    for (const auto& entry : fs::directory_iterator(folder)) {
        const std::string stem = entry.path().stem().string();
        if (const std::size_t at = stem.find('_'); at != stem.npos && stem.substr(at + 1) == name)
            throw rt::InputError(entry.path().string() +
                                 ": is there already; expected a new name, or to edit that file");
        number = std::max(number, std::atoi(stem.c_str()));
    }
    return number + 1;
}

/// The README of the variants with one more row in the table below a heading.
std::string with_row(std::string readme, const std::string& heading, const std::string& row) {
    const std::size_t section = readme.find("\n## " + heading + "\n");
    std::size_t at = section == readme.npos ? readme.npos : readme.find("\n|---", section);
    if (at == readme.npos)
        throw rt::InputError(
            fmt::format("tests/variants/README.md:1:1: has no table below ## {}; expected one", heading));
    while (readme.compare(at, 2, "\n|") == 0) at = readme.find('\n', at + 1);
    return readme.insert(at + 1, row);
}

}  // namespace

Files new_fragment(const fs::path& project, const Assignment& assignment, const NewFragment& fragment) {
    const std::string& name = fragment.name;
    require_name(name);
    if (!fragment.like.empty()) require_fragment(assignment, fragment.like);
    if (fragment.like.empty() && fragment.declaration.empty())
        throw rt::InputError(
            fmt::format("{}: what does it take and return? Expected --like OTHER, or --declare 'DiskSample {}(vec2 u)'",
                        name, name));
    const fs::path solution = "solution/" + name + ".cpp", checks = "grader/checks/" + name + ".cpp",
                   blank_file = "starter/fragments/" + name + ".cpp";
    for (const fs::path& file : {solution, checks, blank_file}) require_new(project, file);
    std::string header = must_read(project / header_file), list = must_read(project / list_file);
    if (declaration_of(name, header) || std::ranges::count(assignment.names(), name) > 0)
        throw rt::InputError(fmt::format("{}: {} or {} has it already; expected a new name", name, header_file.string(),
                                         list_file.string()));
    require_free_name(project, name);

    const Declaration declaration = declare(header, fragment);
    const std::string before = place_for(assignment, fragment);
    header.insert(end_of_line_with(header, std::regex("\n[^/ \n][^\n]* " + before + "\\("), header_file,
                                   "the declaration of " + before),
                  declaration.line + "\n");
    std::size_t at = end_of_line_with(list, std::regex("\"" + before + "\"[^\n]*\\}"), list_file,
                                      "{ name = \"" + before + "\", ... } on a line");
    if (const std::size_t brace = list.rfind('}', at); list.compare(brace, 2, "},") != 0)
        list.insert(brace + 1, ","), ++at;
    list.insert(at, fmt::format("  {{ name = \"{}\", points = {:g} }},\n", name, fragment.points));

    const bool same_signature = fragment.declaration.empty();
    const std::string text = solution_skeleton(project, declaration, same_signature ? fragment.like : "");
    const std::string id = id_in(must_read(project / "grader/checks" / (before + ".cpp")));
    return {{header_file, header},
            {list_file, list},
            {solution, text},
            {blank_file, blank(find_region(text, solution.string()))},
            {checks, checks_skeleton(project, declaration, text, id)},
            {handout_file, with_section(must_read(project / handout_file), before,
                                        from_template(project, "section.md", {{"name", name}}))}};
}

Files new_scene(const fs::path& project, const std::string& name, const std::string& like) {
    require_name(name);
    const fs::path file = "scenes/" + name + ".toml";
    require_new(project, file);
    std::string text = from_template(project, "scene.toml", {});
    if (!like.empty()) {
        std::string other = must_read(project / "scenes" / (like + ".toml"));
        while (other.starts_with("#")) other.erase(0, other.find('\n') + 1);
        text = text.substr(0, text.find('\n') + 1) + other;
    }
    return {{file, text}};
}

Files new_check(const fs::path& project, const std::string& name, const std::string& fragment) {
    require_name(name);
    const fs::path file = "grader/checks/" + fragment + ".cpp";
    std::string text = must_read(project / file);
    const auto declaration = declaration_of(fragment, must_read(project / header_file));
    if (!declaration) throw rt::InputError(fragment + ": fragments.h declares no such fragment; expected one of it");
    if (text.find(fmt::format("\"{}\"", name)) != text.npos)
        throw rt::InputError(fmt::format("{}: has a check {} already; expected a new name", file.string(), name));
    const std::size_t function = text.find("\nChecks check_" + fragment + "(");
    const std::string call = fmt::format("{}_{}()", fragment, name);
    const auto after = [&](std::string_view words, std::size_t from) {
        return from == text.npos ? text.npos : text.find(words, from);
    };
    constexpr std::string_view joined = "    return joined(";
    const std::size_t list = after("return {", function), in_lines = after("};\n}", list),
                      in_line = after("}; }\n", list);
    if (const std::size_t at = std::min(in_lines, in_line); at != text.npos)
        text.insert(at, ", " + call);
    else if (const std::size_t all = after("    return checks;\n}", function); all != text.npos)
        text.insert(all, "    checks.push_back(" + call + ");\n");
    else if (const std::size_t sum = after(joined, function), end = after(");\n}", sum); end != text.npos)
        text.insert(end, "), {" + call + "}").insert(sum + joined.size(), "joined(");
    else
        throw rt::InputError(
            fmt::format("{}:1:1: its function returns neither a list nor `checks` nor joined(...); expected one of "
                        "them, to which {} can be added",
                        file.string(), call));
    text.insert(function + 1, check_skeleton(project, *declaration, name, id_in(text)));
    return {{file, text}};
}

Files new_variant(const fs::path& project, const NewVariant& variant) {
    require_name(variant.name);
    // lines of the patch's head, which is read again
    for (const auto& [option, words] : {std::pair("--what", &variant.what), {"--says", &variant.says}})
        if (words->find('\n') != words->npos)
            throw rt::InputError(fmt::format("{}: has several lines; expected one", option));
    const fs::path solution = "solution/" + variant.fragment + ".cpp", folder = "tests/variants";
    const std::string text = must_read(project / solution);
    const std::size_t at = variant.old_text.empty() ? text.npos : text.find(variant.old_text);
    if (at == text.npos || text.find(variant.old_text, at + 1) != text.npos)
        throw rt::InputError(fmt::format("--old {}: is {} in {}; expected text that is there once",
                                         rt::in_quotes(variant.old_text), at == text.npos ? "not" : "more than once",
                                         solution.string()));
    std::string changed = text;
    changed.replace(at, variant.old_text.size(), variant.new_text);
    if (changed == text) throw rt::InputError("--new: changes nothing; expected another text than --old");

    const int number = next_number(project / folder / (variant.right ? "right" : "wrong"), variant.name);
    const std::string stem =
        variant.right ? variant.fragment + "_" + variant.name : fmt::format("{}_{}", number, variant.name);
    const fs::path file = folder / (variant.right ? "right" : "wrong") / (stem + ".patch");
    require_new(project, file);
    const std::string what = variant.what.empty() ? "FILL IN: what it does" : variant.what;
    const std::string patch = from_template(project, "mistake.patch",
                                            {{"number", variant.right ? "" : fmt::format("{} ", number)},
                                             {"what", what},
                                             {"fragment", variant.fragment},
                                             {"says", variant.says.empty() ? "" : "# says: " + variant.says + "\n"},
                                             {"hunk", hunk_of(text, changed)}});
    const std::string row =
        variant.right ? fmt::format("| {} | `{}` | `{}` |\n", what, stem, variant.fragment)
                      : fmt::format("| {} | {} | `{}` | `{}` |  |\n", number, what, variant.name, variant.fragment);
    return {{file, patch},
            {folder / "README.md",
             with_row(must_read(project / folder / "README.md"), variant.right ? "Right" : "Wrong", row)}};
}

}  // namespace grade::authoring
