#include "judging/time_outs.h"

#include <algorithm>

namespace grade {

bool is_late(const FragmentRecord& fragment, const CheckRecord& check) {
    const auto first = std::ranges::find(fragment.checks, Verdict::timed_out, &CheckRecord::verdict);
    return first != fragment.checks.end() && &*first < &check;
}

void leave_out(CheckRecord& check) {
    check.verdict = Verdict::timed_out;
    check.message = "not run, since an earlier check of this fragment timed out";
    check.trouble = Trouble::not_run;
    check.excerpt.clear();
    check.statistics.clear();
    check.cost = check.solution_cost = std::nullopt;
    check.picture = check.solution_picture = {};
}

void leave_out_late(FragmentRecord& fragment) {
    for (CheckRecord& check : fragment.checks)
        if (is_late(fragment, check)) leave_out(check);
}

}  // namespace grade
