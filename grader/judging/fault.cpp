#include "judging/fault.h"

#include <algorithm>

#include "diagnosis/sanitizer.h"
#include "judging/experiment.h"

namespace grade {

namespace {

constexpr double checked_seconds = 3;       // CPU seconds for one answer
constexpr std::size_t most_tried = 2;       // checks
constexpr std::size_t least_different = 3;  // calls: of rounding alone, fewer come out otherwise

bool is_suspect(const CheckRecord& check) {
    return check.verdict == Verdict::crashed || check.verdict == Verdict::not_finite ||
           check.trouble == Trouble::keeps_state || std::ranges::any_of(check.statistics, [](const StatisticRecord& s) {
               return s.id == "V0" && s.verdict == Verdict::failed;
           });
}

/// The answers of a new process; none where it breaks down.
Rows answers(const fs::path& program, const Sandbox& sandbox, const fs::path& meshes, const std::string& fragment,
             const Rows& rows, bool checked) {
    Runner runner(program, sandbox, meshes, checked_seconds, checked);
    auto outcome = runner.probe(fragment, rows);
    Rows* all = std::get_if<Rows>(&outcome);
    return all ? std::move(*all) : Rows{};
}

bool is_about(double x, double y) {
    return x == y || (std::isnan(x) && std::isnan(y)) || std::abs(x - y) <= 1e-3 * std::max(std::abs(x), std::abs(y));
}

/// nan is the same as nan.
bool is_the_same(const Rows& once, const Rows& again) {
    const auto same = [](double x, double y) { return x == y || (std::isnan(x) && std::isnan(y)); };
    return std::ranges::equal(once, again, [&](const Row& x, const Row& y) { return std::ranges::equal(x, y, same); });
}

/// Whether the answers depend on what happens to stand in memory: another build fills it with something else, always
/// the same.
bool reads_what_was_never_set(const Rows& once, const Rows& again, const Rows& checked, const Rows& checked_again) {
    if (once.empty() || checked.size() != once.size() || !is_the_same(checked, checked_again)) return false;
    if (!is_the_same(once, again)) return true;
    std::size_t different = 0;
    for (std::size_t k = 0; k < once.size(); ++k)
        different += once[k].size() != checked[k].size() ||
                     !std::equal(once[k].begin(), once[k].end(), checked[k].begin(), is_about);
    return different >= std::min(least_different, once.size());
}

}  // namespace

std::string find_fault(const Programs& programs, const Programs::Linked& plain, const Toolchain& chain,
                       const FragmentRecord& fragment, const std::vector<Check>& checks, std::uint64_t seed) try {
    std::vector<const Check*> suspects;
    for (const CheckRecord& record : fragment.checks) {
        const auto check = std::ranges::find_if(
            checks, [&](const Check& c) { return c.fragment == fragment.name && c.name == record.name; });
        if (is_suspect(record) && check != checks.end() && suspects.size() < most_tried) suspects.push_back(&*check);
    }
    if (suspects.empty()) return {};
    const auto program = programs.checked(fragment.name);
    if (!program) return {};
    const fs::path meshes = chain.source / "scenes";
    for (const Check* check : suspects) {
        const std::uint64_t own = replicate_seed(seed, *check, Stream::submission, 0);
        Runner runner(*program, programs.sandbox(), meshes, checked_seconds, true);
        const auto outcome = observe(runner, *check, own);
        if (const Fault* fault = std::get_if<Fault>(&outcome)) {
            if (const std::string words = fault_in_words(fault->excerpt, fragment.name); !words.empty()) return words;
            continue;  // it gives no answers to compare
        }
        const auto* probe = std::get_if<Probe>(&check->experiment);
        if (!probe) continue;
        Generator generator(own);
        const Rows rows = probe->inputs(generator);
        const auto ask = [&](const fs::path& which, bool checked) {
            return answers(which, programs.sandbox(), meshes, fragment.name, rows, checked);
        };
        if (reads_what_was_never_set(ask(plain.program, false), ask(plain.program, false), ask(*program, true),
                                     ask(*program, true)))
            return fragment.name + ".cpp: a variable is read that has been given no value";
    }
    return {};
} catch (const std::runtime_error&) {
    return {};  // no more is known than before
}

}  // namespace grade
