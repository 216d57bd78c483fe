#include "report/describe.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <set>
#include <sstream>

#include "checks/kit/check.h"
#include "report/scene_tables.h"
#include "rt/files/scene_reader.h"

namespace grade {

namespace {

/// The checks of some grading seeds, one after the other: what they do not agree on depends on the seed.
const std::vector<std::vector<Check>>& checks_of_seeds() {
    static const std::vector<std::vector<Check>> all = {all_checks(1), all_checks(2), all_checks(3)};
    return all;
}

/// The same statistic under each seed.
using Statistics = std::vector<const Statistic*>;

/// A number of the statistics; where they differ, its share of the truth, if they agree on that, or a word.
std::string number(const Statistics& statistics, double Statistic::*field) {
    std::set<std::string> plain, shares;
    for (const Statistic* s : statistics) {
        plain.insert(fmt::format("{:.3g}", s->*field));
        shares.insert(s->truth && *s->truth != 0 ? fmt::format("{:.2g} %", 100 * s->*field / std::abs(*s->truth)) : "");
    }
    if (plain.size() == 1) return *plain.begin();
    return shares.size() == 1 && !shares.begin()->empty() ? *shares.begin() : "by scene";
}

std::string truth(const Statistics& statistics) {
    std::set<std::string> values;
    for (const Statistic* s : statistics)
        values.insert(s->truth ? fmt::format("{:.4g}", *s->truth) : "as the solution");
    return values.size() == 1 ? *values.begin() : "by scene";
}

std::string row(const std::string& check, const Statistics& statistics) {
    const Statistic& s = *statistics.front();
    std::string what = s.what;
    for (std::size_t at = 0; (at = what.find('|', at)) != what.npos; at += 2) what.insert(at, "\\");
    const std::string within = number(statistics, s.exact ? &Statistic::delta : &Statistic::delta0);
    return fmt::format("| {} | {} | {} | {} | {} | {} |\n", check, s.id, what, truth(statistics), within,
                       s.exact ? "the same" : number(statistics, &Statistic::delta));
}

std::string experiment(const Check& check) {
    const auto* render = std::get_if<Render>(&check.experiment);
    return render ? fmt::format("picture, {} samples a pixel", render->samples) : "calls";
}

std::string rounded_points(double x) { return fmt::format("{:g}", std::round(100 * x) / 100); }

/// As a fraction: decimals of thirds do not add up.
std::string share_of(int part, int all) {
    const int common = std::gcd(part, all);
    return part == all ? "1" : fmt::format("{}/{}", part / common, all / common);
}

/// Where a block's text ends: at its end marker.
constexpr std::string_view opening = "<!-- ", end_marker = "<!-- end -->";

}  // namespace

std::string describe_points(const Assignment& assignment) {
    std::string text = "| part | fragments and their points | points |\n|---|---|---|\n";
    double all = 0;
    for (const Part& part : assignment.parts) {
        std::vector<std::string> names;
        double sum = 0;
        for (const Fragment& fragment : assignment.fragments) {
            if (fragment.part != part.name) continue;
            names.push_back(fmt::format("[`{0}`](#{0}) {1}", fragment.name,
                                        fragment.given ? "given" : rounded_points(fragment.points)));
            sum += fragment.points;
        }
        all += sum;
        text += fmt::format("| {} | {} | {} |\n", part.title, fmt::join(names, ", "), rounded_points(sum));
    }
    return text + fmt::format("| | | **{}** |\n", rounded_points(all));
}

std::string describe_checks(const Assignment& assignment, const std::string& fragment) {
    if (std::ranges::count(assignment.names(), fragment) == 0)
        return "Not part of this assignment: this fragment is handed out filled in.\n";
    const Fragment& entry = assignment.fragments.at(assignment.place(fragment));
    if (entry.given) return "Given: this fragment is handed out filled in, and gives no points.\n";

    std::string rows;
    int shares = 0;
    for (const Check& check : checks_of_seeds().front()) shares += check.fragment == fragment ? check.share : 0;
    for (const Check& check : checks_of_seeds().front()) {
        if (check.fragment != fragment) continue;
        std::string name = fmt::format("`{}` ({}): {}", check.name, share_of(check.share, shares), experiment(check));
        for (std::size_t k = 0; k < check.statistics.size(); ++k) {
            Statistics same;
            for (const auto& checks : checks_of_seeds()) {
                const auto twin = std::ranges::find_if(
                    checks, [&](const Check& c) { return c.fragment == fragment && c.name == check.name; });
                if (twin != checks.end() && k < twin->statistics.size()) same.push_back(&twin->statistics[k]);
            }
            rows += row(name, same);
            name.clear();
        }
    }
    return fmt::format("{} point{}.\n\n", rounded_points(entry.points), entry.points == 1 ? "" : "s") +
           "| check (share) | id | measures | must be | right within | wrong beyond |\n|---|---|---|---|---|---|\n" +
           rows;
}

std::string with_new_tables(const std::string& handout, const Assignment& assignment, const std::string& path) {
    std::string text;
    std::size_t at = 0;
    for (;;) {
        const std::size_t begin = handout.find(opening, at), close = handout.find("-->", begin);
        if (begin == handout.npos || close == handout.npos) return text + handout.substr(at);
        const std::string name = handout.substr(begin + opening.size(), close - begin - opening.size() - 1);
        const std::size_t body = close + 3;
        text += handout.substr(at, body - at);
        at = body;
        const auto fail = [&](const std::string& what) {
            const auto line = std::count(handout.begin(), handout.begin() + std::ptrdiff_t(begin), '\n') + 1;
            throw rt::InputError(fmt::format("{}:{}:1: {}", path, line, what));
        };

        std::string block;
        if (name == "points") {
            block = describe_points(assignment);
        } else if (name.starts_with("checks: ")) {
            const std::string fragment = name.substr(8);
            if (checks_of(fragment, 1).empty())
                fail(fmt::format("no fragment is named \"{}\"; expected one of fragments.h", fragment));
            block = describe_checks(assignment, fragment);
        } else if (name.starts_with("keys: ")) {
            block = describe_keys(name == "keys: file" ? "" : name.substr(6));
            if (block.empty())
                fail(fmt::format("scenes have no table \"{}\"; expected one of scene_keys.h", name.substr(6)));
        } else if (name != "count") {
            continue;
        }
        const std::size_t end = handout.find(end_marker, body);
        if (end == handout.npos) fail(fmt::format("this block has no end; expected {}", end_marker));
        text += name == "count" ? std::to_string(assignment.asked().size()) : "\n\n" + block + "\n";
        text += end_marker;
        at = end + end_marker.size();
    }
}

std::string handed_out(const std::string& handout, const Assignment& assignment, const std::string& path) {
    const std::vector<std::string> names = assignment.names();
    std::istringstream lines(with_new_tables(handout, assignment, path));
    std::string text, part;  // part: since its heading of the second level
    bool code = false, out = false;
    int left = 0, dropped = 0;
    const auto close = [&] {
        if (left == 0 && dropped > 0)
            part = part.substr(0, part.find('\n')) +
                   "\n\nNot part of this assignment: its fragments are handed out filled in.\n\n";
        text += part;
        part.clear(), left = dropped = 0;
    };
    for (std::string line; std::getline(lines, line);) {
        code ^= line.starts_with("```");
        const bool heading = !code && (line.starts_with("# ") || line.starts_with("## ") || line.starts_with("### "));
        if (heading) {
            const std::string title = line.substr(line.find(' ') + 1);
            if (!line.starts_with("### ")) close();
            out = line.starts_with("### ") && std::ranges::count(names, title) == 0 &&
                  handout.find(fmt::format("<!-- checks: {} -->", title)) != handout.npos;
            dropped += out, left += std::ranges::count(names, title) > 0;
        }
        if (!out) part += line + "\n";
    }
    close();
    if (!handout.ends_with('\n')) text.pop_back();
    return text;
}

}  // namespace grade
