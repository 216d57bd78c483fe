#include "class/compare.h"

#include <fmt/format.h>

#include <algorithm>

#include "convert/words.h"
#include "diagnosis/diagnosis.h"
#include "report/escape.h"
#include "report/terminal.h"

namespace grade::course {

namespace {

const FragmentRecord* find(const Record& record, const std::string& name) {
    const auto found = std::ranges::find(record.fragments, name, &FragmentRecord::name);
    return found == record.fragments.end() ? nullptr : &*found;
}

/// The first line of what is wrong; empty: nothing is.
std::string first_line(const FragmentRecord& fragment) {
    if (fragment.verdict == Verdict::passed) return {};
    const std::string words = printable(diagnose(fragment).words, 160);
    return words.substr(0, words.find('\n'));
}

/// Checks whose verdicts are others: "width (failed, was passed)".
std::string changed_checks(const FragmentRecord& a, const FragmentRecord& b) {
    std::string text;
    for (const CheckRecord& check : b.checks) {
        const auto was = std::ranges::find(a.checks, check.name, &CheckRecord::name);
        if (was != a.checks.end() && was->verdict != check.verdict)
            text += fmt::format("{}{} {}, was {}", text.empty() ? "" : "; ", check.name, in_words(check.verdict),
                                in_words(was->verdict));
    }
    return text;
}

std::string why(const FragmentRecord& a, const FragmentRecord& b) {
    std::string text;
    const auto add = [&](const std::string& words) { text += (text.empty() || words.empty() ? "" : "; ") + words; };
    if (a.verdict != b.verdict) add(fmt::format("{}, was {}", in_words(b.verdict), in_words(a.verdict)));
    if (a.max_points != b.max_points)
        add(fmt::format("worth {} points, was {}", short_number(b.max_points), short_number(a.max_points)));
    if (a.sha256 != b.sha256) add("another text");
    add(changed_checks(a, b));
    const std::string words = first_line(b);
    return text + (words.empty() ? "" : ": " + words);
}

}  // namespace

std::vector<Change> changes_between(const Record& before, const Record& after) {
    std::vector<Change> changes;
    for (const FragmentRecord& b : after.fragments) {
        const FragmentRecord* a = find(before, b.name);
        if (!a)
            changes.push_back({b.name, 0, b.points, "was not graded"});
        else if (a->verdict != b.verdict || a->points != b.points || a->max_points != b.max_points)
            changes.push_back({b.name, a->points, b.points, why(*a, b)});
    }
    for (const FragmentRecord& a : before.fragments)
        if (!find(after, a.name)) changes.push_back({a.name, a.points, 0, "is not graded any more"});
    std::ranges::stable_sort(changes, {}, [](const Change& change) { return change.after - change.before; });
    return changes;
}

std::vector<std::string> made_differently(const Record& before, const Record& after) {
    const Provenance &a = before.provenance, &b = after.provenance;
    std::vector<std::string> lines;
    if (a.assignment != b.assignment) lines.emplace_back("assignment.toml is another one");
    if (before.seed != after.seed) lines.push_back(fmt::format("seed {}, was {}", after.seed, before.seed));
    if (a.program != b.program)
        lines.push_back(fmt::format("the grader is another one: {} {}, was {} {}", b.version, b.commit.substr(0, 12),
                                    a.version, a.commit.substr(0, 12)));
    if (a.reference != b.reference) lines.emplace_back("the reference or the framework is another one");
    if (a.checks != b.checks && before.seed == after.seed) lines.emplace_back("the checks are others");
    if (before.selection != after.selection) lines.emplace_back("other fragments were asked for");
    if (before.limits.time != after.limits.time)
        lines.push_back(fmt::format("time limit {} s, was {} s", after.limits.time, before.limits.time));
    return lines;
}

std::string lines_of(const std::vector<Change>& changes) {
    std::string text;
    for (const Change& change : changes)
        text += fmt::format("  {:>5} -> {:<5} {}: {}\n", short_number(change.before), short_number(change.after),
                            printable_line(change.fragment), printable_line(change.why));
    return text;
}

}  // namespace grade::course
