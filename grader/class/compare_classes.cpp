#include "class/compare_classes.h"

#include <fmt/format.h>

#include "class/compare.h"
#include "convert/words.h"
#include "report/escape.h"

namespace grade::course {

namespace {

struct Counts {
    int rise = 0, fall = 0, same = 0, open = 0, come = 0, gone = 0;
};

/// What has no record for the machine's trouble is no loss of points.
std::string points_of(const Result& result) {
    if (is_open(result)) return "not graded";
    return result.record ? short_number(result.record->score()) : "none";
}

/// The lines of a student whom both have; none where all is as before.
std::string lines_on(const Result& a, const Result& b, Counts& counts) {
    const std::string name = printable_line(b.student.name, 100);
    if (is_open(a) || is_open(b)) {
        ++counts.open;
        return fmt::format("{}: {}, was {}\n", name, points_of(b), points_of(a));
    }
    const double gained = (b.record ? b.record->score() : 0) - (a.record ? a.record->score() : 0);
    const auto changes = a.record && b.record ? changes_between(*a.record, *b.record) : std::vector<Change>{};
    counts.rise += gained > 0, counts.fall += gained < 0, counts.same += gained == 0;
    if (gained == 0 && changes.empty()) return {};
    return fmt::format("{}: {}, was {} ({:+g})\n{}", name, points_of(b), points_of(a), gained, lines_of(changes));
}

std::string sum_of(const Counts& counts) {
    std::string text = fmt::format("{} rise, {} fall, {} as before", counts.rise, counts.fall, counts.same);
    if (counts.come > 0) text += fmt::format(", {} new", counts.come);
    if (counts.gone > 0) text += fmt::format(", {} gone", counts.gone);
    if (counts.open > 0) text += fmt::format(", {} not graded in both", counts.open);
    return text + "\n";
}

}  // namespace

const Result* of_student(const std::vector<Result>& list, const Result& result) {
    const auto found = std::ranges::find(list, result.student.key(), [](const Result& r) { return r.student.key(); });
    return found == list.end() ? nullptr : &*found;
}

Comparison compare_classes(const std::vector<Result>& before, const std::vector<Result>& after) {
    Comparison all;
    Counts counts;
    for (const Result& b : after) {
        if (const Result* a = of_student(before, b)) {
            all.text += lines_on(*a, b, counts);
        } else {
            all.text += fmt::format("{}: new, {}\n", printable_line(b.student.name, 100), points_of(b));
            ++counts.come;
        }
    }
    for (const Result& a : before)
        if (!of_student(after, a)) {
            all.text += fmt::format("{}: gone, was {}\n", printable_line(a.student.name, 100), points_of(a));
            ++counts.gone;
        }
    // so far there are lines of what is another alone
    all.same = all.text.empty();
    const auto graded = [](const Result& r) { return r.record.has_value(); };
    const auto a = std::ranges::find_if(before, graded), b = std::ranges::find_if(after, graded);
    if (a != before.end() && b != after.end())
        for (const std::string& line : made_differently(*a->record, *b->record))
            all.text += printable_line(line) + "\n";
    all.text += sum_of(counts);
    return all;
}

}  // namespace grade::course
