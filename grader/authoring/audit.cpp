#include "authoring/audit.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <regex>
#include <set>

#include "assignment/strip.h"
#include "authoring/skeleton.h"
#include "calibration/variant.h"
#include "files/files.h"
#include "files/words.h"
#include "report/describe.h"
#include "rt/calls.h"
#include "rt/files/scene_reader.h"

namespace grade::authoring {

namespace {

using calibration::Variant;

bool has_word(const std::string& text, const std::string& word) {
    return std::regex_search(text, std::regex("\\b" + word + "\\b"));
}

/// The fragments that each scene is for: those that its comment names, and those that are called for it.
std::map<std::string, std::vector<std::string>> scenes_by_fragment(const fs::path& project) {
    std::map<std::string, std::vector<std::string>> scenes;
    for (const auto& entry : fs::directory_iterator(project / "scenes")) {
        if (entry.path().extension() != ".toml") continue;
        std::set<std::string> names;
        const rt::Scene scene = rt::read_scene(entry.path().string());
        for (const rt::Calls& stage : rt::calls_of(rt::make_plan(scene)))
            names.insert(stage.fragments.begin(), stage.fragments.end());
        const std::string text = must_read(entry.path()), comment = text.substr(0, text.find("\n\n"));
        static const std::regex word("\\w+");
        for (std::sregex_iterator match(comment.begin(), comment.end(), word), end; match != end; ++match)
            names.insert(match->str());
        for (const std::string& name : names) scenes[name].push_back(entry.path().stem().string());
    }
    for (auto& [name, list] : scenes) std::ranges::sort(list);
    return scenes;
}

/// The tables of tests/variants/pictures.toml, as texts.
std::map<std::string, std::string> picture_tables(const std::string& text) {
    std::map<std::string, std::string> tables;
    static const std::regex head("(^|\n)\\[(\\w+)\\]\n");
    for (std::sregex_iterator match(text.begin(), text.end(), head), end; match != end; ++match) {
        const std::size_t at = std::size_t(match->position() + match->length());
        tables[(*match)[2]] = text.substr(at, text.find("\n[", at) - at);
    }
    return tables;
}

/// Looks at all that belongs to one fragment.
class Auditor {
public:
    Auditor(const fs::path& project, const Assignment& assignment)
        : project_(project),
          assignment_(assignment),
          header_(must_read(project / header_file)),
          handout_(must_read(project / handout_file)),
          promises_(must_read(project / "tests/variants/promises.py")),
          pictures_(picture_tables(must_read(project / pictures_file))),
          variants_(calibration::read_variants(project / "tests/variants")),
          scenes_(scenes_by_fragment(project)) {}

    Audit of(const std::string& fragment) {
        found_ = {.fragment = fragment};
        look_at_assignment();
        look_at_solution();
        look_at_checks();
        look_at_variants();
        look_at_handout();
        look_at_pictures();
        return found_;
    }

private:
    void lacks_at(const std::string& place, const std::string& what) { found_.lacks.push_back(place + ": " + what); }
    void lacks(const fs::path& file, const std::string& what) { lacks_at(file.string() + ":1:1", what); }

    /// What a skeleton has left open.
    void look_for_blanks(const fs::path& file, const std::string& text, const std::string& part) {
        if (const std::size_t at = part.find(to_fill_in); at != part.npos)
            lacks_at(place_of(file, text, text.find(part) + at),
                     fmt::format("{} still stands here; expected what it asks for", to_fill_in));
    }

    void look_at_assignment() {
        const auto entry = std::ranges::find(assignment_.fragments, found_.fragment, &Fragment::name);
        if (entry == assignment_.fragments.end())
            lacks(list_file, fmt::format("does not list {0}; expected {{ name = \"{0}\", points = ... }}: without it, "
                                         "it is handed out filled in",
                                         found_.fragment));
        else if (!entry->given && entry->points == 0)
            lacks(list_file, fmt::format("{} has no points; expected some, or given = true", found_.fragment));
    }

    void look_at_solution() {
        const std::string& name = found_.fragment;
        const fs::path file = "solution/" + name + ".cpp";
        const std::string text = must_read(project_ / file);
        const auto declaration = declaration_of(name, header_);
        if (!declaration) return lacks(header_file, fmt::format("does not declare {}; expected it, on one line", name));
        try {
            require_known_types(*declaration);
        } catch (const rt::InputError& error) {
            lacks(header_file, error.what());
        }
        look_for_blanks(file, text, text);
        const std::vector<std::string> comment = comment_of(name, text);
        if (comment.empty())
            return lacks(file, "has no comment above the function; expected what it does, takes and returns");
        const auto tells = [&](const std::string& word) {
            return std::ranges::any_of(comment, [&](const std::string& line) {
                return trimmed(line).starts_with(word) && line.size() > word.size();
            });
        };
        for (const Signature::Argument& argument : declaration->signature.arguments)
            if (!std::ranges::any_of(comment, [&](const std::string& line) { return has_word(line, argument.name); }))
                lacks(file, fmt::format("its comment does not say what {} is; expected a line with its unit and space",
                                        argument.name));
        for (const char* word : {"returns", "blank"})
            if (!tells(word)) lacks(file, fmt::format("its comment has no line \"{} ...\"; expected one", word));
        if (!std::ranges::any_of(comment, [](const std::string& line) { return line.starts_with("Source:"); }))
            lacks(file, "its comment names no source; expected \"Source: ...\"");
        const Marked marked = find_region(text, file.string());
        look_at_region(file, marked);
        look_at_copies(assignment_.asked().contains(name) ? blank(marked) : filled(marked));
    }

    /// What is made or told of the solution elsewhere.
    void look_at_copies(const std::string& handed_out) {
        const std::string& name = found_.fragment;
        const fs::path starter = "starter/fragments/" + name + ".cpp",
                       example = "tests/example/fragments/" + name + ".cpp", answers = "grader/THINK.md";
        if (read_text(project_ / starter) != handed_out)
            lacks(starter,
                  "is not made of the solution as it is; expected what cmake --build --preset release "
                  "--target starter_fragments writes");
        if (!fs::exists(project_ / example))
            lacks(example, "is not there; expected what the example submission has of it: the solution, or a mistake");
        if (must_read(project_ / answers).find("\n### " + name + "\n") == std::string::npos)
            lacks(answers,
                  fmt::format("has no section ### {}; expected the answer to its question in the handout", name));
    }

    /// A blank says that it is one, and returns something else than the solution.
    void look_at_region(const fs::path& file, const Marked& marked) {
        const std::size_t call = marked.fallback.find("not_started(");
        if (call == marked.fallback.npos)
            return lacks(file, "the blank does not report itself; expected END SOLUTION: return not_started(VALUE);");
        const std::string value = marked.fallback.substr(call + 12, marked.fallback.size() - call - 14);
        std::vector<std::string> said;
        for (const std::string& line : marked.region)
            if (const std::string words = trimmed(line); !words.empty() && !words.starts_with("//"))
                said.push_back(words);
        if (said == std::vector{"return " + value + ";"})
            lacks(file, "the solution returns what the blank returns; expected a solution");
    }

    void look_at_checks() {
        const std::string& name = found_.fragment;
        const fs::path file = "grader/checks/" + name + ".cpp";
        const std::string text = must_read(project_ / file);
        look_for_blanks(file, text, text);
        for (const Check& check : checks_of(name, 1)) {
            ++found_.checks, found_.statistics += int(check.statistics.size());
            for (const Statistic& statistic : check.statistics)
                if (handout_.find("\n| " + statistic.id + " | ") == handout_.npos)
                    lacks(file, fmt::format("{} measures {}, which the handout does not explain; expected a row of "
                                            "\"What is measured\"",
                                            check.name, statistic.id));
        }
        if (found_.checks == 0) lacks(file, "no check looks at this fragment; expected one, and a new build");
    }

    void look_at_variants() {
        const std::string& name = found_.fragment;
        for (const Variant& variant : variants_) {
            if (variant.fragment != name) continue;
            found_.wrong += variant.kind == Variant::Kind::wrong, found_.right += variant.kind == Variant::Kind::right;
            const fs::path file = "tests/variants/" + variant.name + ".patch";
            look_for_blanks(file, variant.patch, variant.patch);
            try {
                changed_text(variant, project_, "0.01");
            } catch (const rt::InputError& error) {
                found_.lacks.emplace_back(error.what());
            }
        }
        for (std::size_t at = 0; (at = promises_.find("(\"" + name + "\", ", at)) != promises_.npos; ++at)
            ++found_.promises;
        const std::string& new_one = "; expected one: grade new mistake NAME --of " + name + " --old ... --new ...";
        if (found_.wrong == 0) lacks("tests/variants/wrong", "no mistake of " + name + new_one);
        if (found_.right == 0) lacks("tests/variants/right", "no other right way of " + name + new_one + " --right");
    }

    void look_at_handout() {
        const std::string& name = found_.fragment;
        const auto section = section_of(name, handout_);
        if (!section) return lacks(handout_file, fmt::format("has no section ### {}; expected one", name));
        const std::string place = place_of(handout_file, handout_, handout_.find("\n### " + name + "\n") + 1);
        look_for_blanks(handout_file, handout_, *section);
        const auto needs = [&](const char* block) {
            if (section->find(fmt::format("<!-- {}: {} -->", block, name)) == section->npos)
                lacks_at(place,
                         fmt::format("has no block of {0}; expected <!-- {0}: {1} --> and <!-- end -->", block, name));
        };
        needs("checks");
        if (!is_drawn_with_its_part()) needs("pictures");
        if (const std::string made = with_new_tables(*section, assignment_, "handout.md"); made != *section)
            lacks_at(place,
                     "its table is not what the checks are; expected that of ./grade describe --update handout.md");
    }

    /// No stage calls it, and plots of its whole part stand in front of the part's sections.
    bool is_drawn_with_its_part() const {
        const std::size_t section = handout_.find("\n### " + found_.fragment + "\n");
        const std::size_t part = handout_.rfind("\n## ", section), first = handout_.find("\n### ", part);
        return !scenes_.contains(found_.fragment) && !pictures_.contains(found_.fragment) && part != handout_.npos &&
               handout_.substr(part, first - part).find("](scenes/pictures/") != std::string::npos;
    }

    void look_at_pictures() {
        const std::string& name = found_.fragment;
        if (const auto scenes = scenes_.find(name); scenes != scenes_.end()) found_.scenes = scenes->second;
        if (is_drawn_with_its_part()) return;
        const auto table = pictures_.find(name);
        if (table == pictures_.end()) {
            lacks(pictures_file, fmt::format("has no table [{}]; expected its pictures for the handout", name));
        } else {
            for (const char* picture : {"", "_blank"})
                if (!fs::exists(project_ / "scenes/pictures" / (name + picture + ".png")))
                    lacks_at("scenes/pictures/" + name + picture + ".png:1:1",
                             "is not there; expected what scenes/render_pictures " + name + " draws");
            static const std::regex scene("\nscene = \"([\\w/]+)\"|^scene = \"([\\w/]+)\"");
            if (std::smatch match; std::regex_search(table->second, match, scene))
                found_.scenes.insert(found_.scenes.begin(), match[1].matched ? match[1] : match[2]);
        }
        const bool is_drawn = table != pictures_.end() && table->second.find("warp = ") != std::string::npos;
        if (found_.scenes.empty() && !is_drawn)
            lacks("scenes", fmt::format("none calls {0} or names it in its comment; expected one, or warp = ... in {1}",
                                        name, pictures_file.string()));
    }

    inline static const fs::path header_file = "starter/rt/fragments.h", list_file = "assignment.toml",
                                 handout_file = "handout.md", pictures_file = "tests/variants/pictures.toml";

    fs::path project_;
    const Assignment& assignment_;
    std::string header_, handout_, promises_;
    std::map<std::string, std::string> pictures_;
    std::vector<Variant> variants_;
    std::map<std::string, std::vector<std::string>> scenes_;
    Audit found_;
};

}  // namespace

std::vector<Audit> audit(const fs::path& project, const Assignment& assignment,
                         const std::vector<std::string>& fragments) {
    Auditor auditor(project, assignment);
    std::vector<Audit> all;
    for (const std::string& name : fragments.empty() ? assignment.names() : fragments) all.push_back(auditor.of(name));
    return all;
}

}  // namespace grade::authoring
