#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <filesystem>
#include <memory>

#include "class/compare.h"
#include "class/compare_classes.h"
#include "class/results.h"
#include "convert/read_record.h"
#include "convert/tables.h"
#include "convert/words.h"
#include "files/files.h"
#include "files/interrupt.h"
#include "judging/grading.h"
#include "judging/provenance.h"
#include "report/escape.h"
#include "report/json.h"
#include "report/terminal.h"
#include "rt/files/scene_reader.h"
#include "studies/commands.h"
#include "studies/studies.h"

namespace grade::course {

namespace {

struct AgainArguments {
    std::string record, submission, out;
    GradingSettings settings;  // those that have an option
};

/// Grades with the seed, the selection and the limits of a record.
Record grade_as(const Record& before, const AgainArguments& arguments, const Context& context) {
    stop_at_interrupt();
    const Toolchain chain = read_toolchain(context.toolchain);
    const Assignment assignment = assignment_of(chain);
    const auto names = assignment.names();
    for (const std::string& name : before.selection)
        if (std::ranges::count(names, name) == 0)
            throw rt::InputError(fmt::format("{}: the record is of a fragment {}, which the assignment does not have",
                                             arguments.record, name));
    Submission submission =
        read_submission(arguments.submission, all_fragments(chain, assignment), chain.source / "starter");
    note_given(submission, assignment.asked(), chain.blanks);
    GradingSettings settings = arguments.settings;
    settings.only = {before.selection.begin(), before.selection.end()};
    settings.seed = before.seed, settings.time_limit = before.limits.time;
    settings.provenance = find_provenance(chain), settings.command = context.command;
    ProgressLine line;
    settings.progress = line.listener();
    Record after = grade_submission(submission, assignment, chain, ready(all_checks(before.seed)), settings);
    after.notes = submission.notes;
    return after;
}

void tell_differences(const Record& before, const Record& after) {
    if (before.sha256 != after.sha256) fmt::print("the submission has other texts\n");
    for (const std::string& line : made_differently(before, after)) fmt::print("{}\n", printable_line(line));
}

/// The better of both, by student: those of `after`, and of `before` whom it lacks.
std::vector<TableRow> better_of(const std::vector<Result>& before, const std::vector<Result>& after) {
    std::vector<TableRow> rows;
    const auto row = [](const Result& r) { return TableRow{r.student, r.record ? &*r.record : nullptr, r.fault}; };
    for (const Result& b : after) {
        const Result* a = of_student(before, b);
        const bool keep = a && a->record && (!b.record || a->record->score() > b.record->score());
        rows.push_back(row(keep ? *a : b));
    }
    for (const Result& a : before)
        if (!of_student(after, a)) rows.push_back(row(a));
    return rows;
}

/// With the record's seed, selection and limits, into a new record. Returns the exit code.
int run_replay(const AgainArguments& arguments, const Context& context) {
    const Record before = read_record(arguments.record);
    fs::path out = arguments.out;
    if (out.empty()) {
        out = arguments.record;
        out.replace_extension(".replay.json");
    }
    std::error_code error;
    if (fs::exists(out, error))
        throw rt::InputError(
            fmt::format("{}: is there already; expected a new file: no record is overwritten", out.string()));
    const Record after = grade_as(before, arguments, context);
    write_text(out, to_json(after));
    fmt::print("{}\n", table(after, {.color = has_colors()}));
    tell_differences(before, after);
    fmt::print("{}{}\n", lines_of(changes_between(before, after)), out.string());
    return 0;
}

/// Returns the exit code: 0 where points and verdicts are the record's, else 1. Throws rt::InputError for texts that
/// the record is not of.
int run_verify(const AgainArguments& arguments, const Context& context) {
    const Record before = read_record(arguments.record);
    if (!before.is_complete())
        throw rt::InputError(
            fmt::format("{}: this grading is not complete; expected one that ran to its end", arguments.record));
    const Record after = grade_as(before, arguments, context);
    if (before.sha256 != after.sha256)
        throw rt::InputError(fmt::format("{}: holds other texts than {} is of; expected what was graded",
                                         arguments.submission, arguments.record));
    tell_differences(before, after);
    const auto changes = changes_between(before, after);
    if (changes.empty()) {
        fmt::print("the same points and verdicts: {}\n", score_in_words(after));
        return 0;
    }
    fmt::print("{}, was {}\n{}", score_in_words(after), score_in_words(before), lines_of(changes));
    return 1;
}

/// What both have.
CLI::App* add_again_command(CLI::App& app, const char* name, AgainArguments& arguments) {
    CLI::App* command = app.add_subcommand(name, purpose_of(name));
    command->add_option("RECORD", arguments.record, "as grade --json FILE writes it")->required();
    command->add_option("SUBMISSION", arguments.submission, "a folder, a .zip or a .tar.gz")->required();
    command->add_flag("--trusted", arguments.settings.build.trusted, "no sandbox: for code that is your own");
    return command;
}

struct CompareArguments {
    std::string before, after, better;
};

/// What is another between two records or two graded classes, and why. Returns the exit code: 0 where nothing is, else
/// 1.
int run_compare(const CompareArguments& arguments) {
    std::error_code error;
    for (const std::string& side : {arguments.before, arguments.after})
        if (!fs::exists(side, error))
            throw rt::InputError(side + ": not there; expected a record, or what grade class has written");
    require_file(arguments.better, "--better");
    const bool classes = fs::is_directory(arguments.before, error);
    if (classes != fs::is_directory(arguments.after, error))
        throw rt::InputError(fmt::format("{} and {}: one is a record, one a class; expected two of a kind",
                                         arguments.before, arguments.after));
    if (classes) {
        const std::vector<Result> before = read_list(arguments.before), after = read_list(arguments.after);
        if (!arguments.better.empty()) write_text(arguments.better, csv_table(better_of(before, after)));
        const Comparison all = compare_classes(before, after);
        fmt::print("{}", all.text);
        return all.same ? 0 : 1;
    }
    if (!arguments.better.empty()) throw rt::InputError("--better is for two classes; expected their folders");
    const Record before = read_record(arguments.before), after = read_record(arguments.after);
    tell_differences(before, after);
    const auto changes = changes_between(before, after);
    fmt::print("{}, was {}\n{}", score_in_words(after), score_in_words(before), lines_of(changes));
    return changes.empty() ? 0 : 1;
}

}  // namespace

Command replay_command(CLI::App& app) {
    const auto arguments = std::make_shared<AgainArguments>();
    CLI::App* command = add_again_command(app, "replay", *arguments);
    command->add_option("-o,--out", arguments->out, "the new record; default: RECORD with .replay before its ending")
        ->type_name("FILE");
    return {command, [arguments](const Context& context) { return run_replay(*arguments, context); }};
}

Command verify_command(CLI::App& app) {
    const auto arguments = std::make_shared<AgainArguments>();
    CLI::App* command = add_again_command(app, "verify", *arguments);
    return {command, [arguments](const Context& context) { return run_verify(*arguments, context); }};
}

Command compare_command(CLI::App& app) {
    const auto arguments = std::make_shared<CompareArguments>();
    CLI::App* command = app.add_subcommand("compare", purpose_of("compare"));
    command->add_option("BEFORE", arguments->before, "a record, or what grade class has written")->required();
    command->add_option("AFTER", arguments->after, "likewise")->required();
    command->add_option("--better", arguments->better, "write the better of both for each student, of classes")
        ->type_name("CSV");
    return {command, [arguments](const Context&) { return run_compare(*arguments); }, false};
}

}  // namespace grade::course
