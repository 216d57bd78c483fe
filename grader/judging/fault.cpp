#include "judging/fault.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "diagnosis/calls/calls.h"
#include "diagnosis/sanitizer.h"
#include "files/files.h"
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

/// The answers of four processes, two of them with sanitizers.
struct AnswersOfFour {
    Rows once, again, checked, checked_again;
};

/// Whether these numbers of the answers depend on what happens to stand in memory: another build fills it with
/// something else, always the same.
bool reads_what_was_never_set(const AnswersOfFour& all, std::size_t at, std::size_t count) {
    const auto part = [&](const Rows& rows) {
        Rows parts;
        for (const Row& row : rows) {
            const std::size_t from = std::min(at, row.size());
            parts.emplace_back(row.begin() + std::ptrdiff_t(from),
                               row.begin() + std::ptrdiff_t(std::min(from + count, row.size())));
        }
        return parts;
    };
    const Rows once = part(all.once), checked = part(all.checked);
    if (once.empty() || checked.size() != once.size() || !is_the_same(checked, part(all.checked_again))) return false;
    if (!is_the_same(once, part(all.again))) return true;
    std::size_t different = 0;
    for (std::size_t k = 0; k < once.size(); ++k) different += !std::ranges::equal(once[k], checked[k], is_about);
    return different >= std::min(least_different, once.size());
}

/// What is said of that; empty: it is not so.
std::string never_set_in_words(const AnswersOfFour& all, const std::string& fragment, const std::string& header) {
    constexpr std::size_t any = 1 << 20;
    const std::string what = ".cpp: a variable is read that has been given no value";
    if (!reads_what_was_never_set(all, 0, any)) return {};
    const auto signature = signature_of(fragment, header);
    std::vector<std::string> parts;
    const Layout result = signature ? signature->of_result(all.once.front()) : Layout{};
    for (const Field& part : result.parts)
        if (reads_what_was_never_set(all, part.at, size_of(part.kind))) parts.push_back(name_of(part));
    const bool is_told = !parts.empty() && parts.size() < result.parts.size();
    return fragment + what +
           (is_told ? fmt::format(", or a part of the answer is not set: {}", fmt::join(parts, ", ")) : "");
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
        const std::string words = never_set_in_words(
            {ask(plain.program, false), ask(plain.program, false), ask(*program, true), ask(*program, true)},
            fragment.name, read_text(chain.includes.front() / "rt/fragments.h").value_or(""));
        if (!words.empty()) return words;
    }
    return {};
} catch (const std::runtime_error&) {
    return {};  // no more is known than before
}

}  // namespace grade
