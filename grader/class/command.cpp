#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <map>
#include <memory>
#include <set>
#include <utility>

#include "class/entries.h"
#include "class/grading.h"
#include "class/report.h"
#include "class/results.h"
#include "convert/read_record.h"
#include "files/files.h"
#include "files/interrupt.h"
#include "judging/provenance.h"
#include "programs/toolchain.h"
#include "report/escape.h"
#include "report/folder.h"
#include "rt/files/scene_reader.h"
#include "studies/commands.h"
#include "studies/numbers.h"
#include "studies/studies.h"

namespace grade::course {

namespace {

struct ClassArguments {
    std::string submissions, out, shard;
    std::optional<std::uint64_t> seed;
    ClassSettings settings;  // those that have an option
};

/// That of the first call, which later ones go on with: OUT/seed.
std::uint64_t seed_of(const ClassArguments& arguments, const fs::path& out) {
    const fs::path file = out / "seed";
    if (!arguments.seed) {
        if (const auto text = read_text(file, 100)) {
            if (const auto seed = seed_in(text->substr(0, text->find('\n')))) return *seed;
            throw rt::InputError(
                fmt::format("{}: holds no seed; expected the number that is in the records; --seed N writes it anew",
                            file.string()));
        }
        if (!arguments.shard.empty())
            throw rt::InputError(
                "--shard needs --seed N: parts that are graded with seeds of their own are not one class");
    }
    const std::uint64_t seed = arguments.seed ? *arguments.seed : fresh_seed();
    write_text(file, fmt::format("{}\n", seed));
    return seed;
}

/// What is written into the submissions' own folder would be more submissions to the next call.
void require_apart(const fs::path& out, const fs::path& submissions) {
    std::error_code error;
    const fs::path whole = fs::canonical(submissions, error) / "", inner = fs::weakly_canonical(fs::absolute(out)) / "";
    if (!error && inner.string().starts_with(whole.string()))
        throw rt::InputError(fmt::format("-o {}: is within {}; expected a folder beside it: {}-graded", out.string(),
                                         submissions.string(), submissions.parent_path().string()));
}

constexpr const char* codes =
    "Exit code: 0 all are graded; 1 all but those that cannot be read; 2 none can be read, or the call is wrong;\n"
    "3 the machine failed for some, or a part is missing: the same call grades the rest.";

/// Where nothing could be read, what was given is no export of a class.
///
/// is_part  what is not graded is another part's
int code_of(const std::vector<Result>& results, bool is_part) {
    const auto unread = std::ranges::count_if(results, [](const Result& result) { return !result.fault.empty(); });
    if (std::cmp_equal(unread, results.size())) {
        fmt::print(stderr, "no submission could be read; expected folders, archives, or files with fragments\n");
        return 2;
    }
    if (is_part) return 0;
    return std::ranges::any_of(results, is_open) ? 3 : unread > 0 ? 1 : 0;
}

/// Grades what has no record yet, then writes tables and pages. Returns the exit code, one of `codes`.
int run_class(const ClassArguments& arguments, const Context& context) {
    stop_at_interrupt();
    const Toolchain chain = read_toolchain(context.toolchain);
    const Assignment assignment = assignment_of(chain);
    ClassSettings settings = arguments.settings;
    GradingSettings& grading = settings.grading;
    if (!arguments.shard.empty()) settings.shard = shard_of(arguments.shard);
    const fs::path folder = fs::path(arguments.submissions) / "";
    const fs::path out =
        arguments.out.empty() ? fs::path(folder.parent_path().string() + "-graded") : fs::path(arguments.out);
    require_apart(out, folder);
    std::vector<Entry> entries = read_export(arguments.submissions, assignment, chain.source / "starter");
    make_folder(out / "records", "-o");
    grading.seed = seed_of(arguments, out), grading.provenance = find_provenance(chain);
    grading.command = fmt::format("grade SUBMISSION --seed {}", grading.seed);
    grading.build.jobs = 1;  // several are graded at a time
    std::vector<Result> results = results_of(entries, assignment, chain, grading);
    const Outcome outcome = [&] {
        try {
            return grade_all(entries, results, assignment, chain, settings, out);
        } catch (const Interrupted&) {
            fmt::print(stderr, "Interrupted. The same call goes on from here.\n");
            throw;
        }
    }();
    for (Result& result : results) result.record = find_record(out, result);
    write_class(out, results, assignment.title, handout_beside(out, chain.source));
    fmt::print("{}", class_table(results));
    fmt::print("{} graded now, {} as before; seed {}; {}\n", outcome.graded, outcome.before, grading.seed,
               (out / "index.html").string());
    for (const std::string& trouble : outcome.troubles) fmt::print(stderr, "not graded: {}\n", printable_line(trouble));
    return outcome.troubles.empty() ? code_of(results, !arguments.shard.empty()) : 3;
}

struct MergeArguments {
    std::string out;
    std::vector<std::string> parts;
};

using Parts = std::vector<std::pair<std::string, std::vector<Result>>>;  // by folder

/// Keys are hashes of texts and of what they are graded with.
Parts read_parts(const std::vector<std::string>& folders) {
    Parts parts;
    std::map<std::string, std::pair<std::string, std::string>> seen;  // by path: the key, and whose
    for (const std::string& folder : folders) {
        parts.emplace_back(folder, read_list(folder));
        for (const Result& result : parts.back().second) {
            const auto& [key, first] = seen.try_emplace(result.path, result.key, folder).first->second;
            if (key != result.key)
                throw rt::InputError(
                    fmt::format("{} and {}: {} was graded with another seed, limit or grader, or has "
                                "other texts; expected parts of one class",
                                first, folder, printable_line(result.path)));
        }
    }
    return parts;
}

/// The records of all parts, and the tables and pages of the whole.
int run_merge(const MergeArguments& arguments) {
    const fs::path out = arguments.out;
    Parts parts = read_parts(arguments.parts);
    make_folder(out / "records", "OUT");
    std::vector<Result> results;
    std::set<std::string> seen;
    std::string title;
    for (auto& [part, list] : parts) {
        for (Result& result : list) {
            if (result.record) {
                if (title.empty()) title = result.record->title;
                for (const auto file : {record_file, pictures_file})
                    if (const auto text = read_text(file(part, result.key), most_record_bytes))
                        write_text(file(out, result.key), *text);
            }
            if (seen.insert(result.path).second) results.push_back(std::move(result));
        }
    }
    std::ranges::sort(results, {}, &Result::path);
    for (Result& result : results) result.record = find_record(out, result);
    write_class(out, results, title);
    fmt::print("{}", class_table(results));
    if (const auto missing = std::ranges::count_if(results, is_open); missing > 0)
        fmt::print(stderr, "{} in no part; expected all parts\n", counted(std::size_t(missing)));
    return code_of(results, false);
}

}  // namespace

Command class_command(CLI::App& app) {
    const auto arguments = std::make_shared<ClassArguments>();
    CLI::App* command = app.add_subcommand("class", purpose_of("class"));
    command->footer(codes);
    command->add_option("SUBMISSIONS", arguments->submissions, "a folder of folders, archives, or files")->required();
    command->add_option("-o,--out", arguments->out, "where records, tables and pages go; default: SUBMISSIONS-graded")
        ->type_name("OUT");
    command->add_option("--seed", arguments->seed, "default: that of the call before, else a fresh one")
        ->check(is_seed());
    command->add_option("--jobs", arguments->settings.jobs, "submissions at a time; default: one for each core")
        ->check(CLI::Range(1, 1024));
    command->add_option("--shard", arguments->shard, "grade the second of four parts: 2/4")->type_name("PART/PARTS");
    command
        ->add_option("--time-limit", arguments->settings.grading.time_limit, "CPU seconds for one answer of a fragment")
        ->capture_default_str()
        ->check(in_range(1, 600));
    command->add_flag("--pictures", arguments->settings.grading.pictures,
                      "pages with pictures; what is graded without is graded again");
    command->add_flag("--trusted", arguments->settings.grading.build.trusted, "no sandbox: for code that is your own");
    return {command, [arguments](const Context& context) { return run_class(*arguments, context); }};
}

Command merge_command(CLI::App& app) {
    const auto arguments = std::make_shared<MergeArguments>();
    CLI::App* command = app.add_subcommand("merge", purpose_of("merge"));
    command->footer(codes);
    command->add_option("OUT", arguments->out, "where the whole goes")->required();
    command->add_option("PART", arguments->parts, "what grade class --shard has written")->required();
    return {command, [arguments](const Context&) { return run_merge(*arguments); }, false};
}

}  // namespace grade::course
