#include "judging/breakdown.h"

#include <fmt/format.h>

#include <algorithm>

#include "diagnosis/calls/arguments.h"
#include "diagnosis/loops.h"
#include "diagnosis/sanitizer.h"
#include "files/files.h"
#include "judging/experiment.h"

namespace grade {

namespace {

/// CPU time of an answer. Limits are whole seconds: of calls it is one, with what the program's start takes.
constexpr double of_calls = 0.8, of_picture = 2;

/// A program with sanitizers.
struct Checked {
    const Programs& programs;
    const std::string& fragment;
    fs::path program, meshes;

    Runner runner(double limit) const { return {program, programs.sandbox(), meshes, limit, true}; }

    std::string in_words(const Fault& fault, bool is_one_call) const {
        return fault.trouble == Trouble::endless
                   ? loop_in_words(fault.excerpt, fragment, programs.text(fragment), is_one_call)
                   : fault_in_words(fault.excerpt, fragment);
    }
};

std::optional<Checked> checked(const Programs& programs, const Toolchain& chain, const std::string& fragment) {
    const auto program = programs.checked(fragment);
    if (!program) return std::nullopt;
    return Checked{programs, fragment, *program, chain.source / "scenes"};
}

/// Of calls, the first one that is not answered, alone; none: all are.
std::optional<Fault> first_breakdown(const Checked& checked, const Rows& calls, std::size_t& which) {
    Runner all = checked.runner(of_calls);
    const auto outcome = all.probe(checked.fragment, calls);
    const Fault* fault = std::get_if<Fault>(&outcome);
    if (!fault) return std::nullopt;
    which = call_at_end_of(fault->excerpt).value_or(0);
    if (fault->trouble != Trouble::endless || which >= calls.size()) return *fault;
    // many calls that each take a while are another thing
    Runner one = checked.runner(of_calls);
    const auto alone = one.probe(checked.fragment, {calls[which]});
    const Fault* same = std::get_if<Fault>(&alone);
    return same ? std::optional(*same) : std::nullopt;
}

void add_call(Finding& finding, const Signature& signature, const Row& call, const Outcome<Rows>& right) {
    finding.arguments = arguments_in_words(signature, call);
    finding.answer = "none";
    if (const Rows* answers = std::get_if<Rows>(&right)) finding.right = result_in_words(signature, answers->front());
    finding.code = call_in_code(signature, call);
    if (are_readable(signature))
        finding.command = fmt::format("./grade call {} '{}'", signature.fragment, finding.arguments);
}

}  // namespace

std::string breakdown_of(const Programs& programs, const Toolchain& chain, const std::string& fragment,
                         const Rows& calls) {
    const auto program = checked(programs, chain, fragment);
    std::size_t which = 0;
    const auto fault = program ? first_breakdown(*program, calls, which) : std::nullopt;
    return fault ? program->in_words(*fault, true) : "";
}

std::string breakdown_of(const Programs& programs, const Toolchain& chain, const std::string& fragment,
                         const Render& picture, std::uint64_t seed) {
    const auto program = checked(programs, chain, fragment);
    if (!program) return {};
    Runner runner = program->runner(of_picture);
    const auto outcome = runner.render(picture, seed, false);
    const Fault* fault = std::get_if<Fault>(&outcome);
    return fault ? program->in_words(*fault, false) : "";
}

void find_endless(const Programs& programs, const fs::path& solution, const Toolchain& chain,
                  const FragmentRecord& fragment, const std::vector<Check>& checks, std::uint64_t seed,
                  Finding& finding) try {
    constexpr int most_replicates = 4;
    const auto record = std::ranges::find(fragment.checks, Trouble::endless, &CheckRecord::trouble);
    if (record == fragment.checks.end()) return;
    const auto check = std::ranges::find_if(
        checks, [&](const Check& c) { return c.fragment == fragment.name && c.name == record->name; });
    const auto program = checked(programs, chain, fragment.name);
    if (check == checks.end() || !program) return;
    for (int k = 0; k < most_replicates && finding.fault.empty(); ++k) {
        const std::uint64_t own = replicate_seed(seed, *check, Stream::submission, k);
        const auto* probe = std::get_if<Probe>(&check->experiment);
        if (!probe) {
            Runner runner = program->runner(of_picture);
            const auto outcome = observe(runner, *check, own);
            if (const Fault* fault = std::get_if<Fault>(&outcome)) finding.fault = program->in_words(*fault, false);
            continue;
        }
        Generator generator(own);
        const Rows calls = probe->inputs(generator);
        std::size_t which = 0;
        const auto fault = first_breakdown(*program, calls, which);
        if (!fault) continue;
        finding.fault = program->in_words(*fault, true);
        const auto signature =
            signature_of(fragment.name, read_text(chain.includes.front() / "rt/fragments.h").value_or(""));
        if (!signature || fault->trouble != Trouble::endless || !finding.arguments.empty()) continue;
        Runner right(solution, programs.sandbox(), program->meshes, of_calls);
        add_call(finding, *signature, calls[which], right.probe(fragment.name, {calls[which]}));
    }
} catch (const std::runtime_error&) {
    // no more is known than before
}

}  // namespace grade
