#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <memory>

#include "assignment/assignment.h"
#include "files/files.h"
#include "programs/cache.h"
#include "report/folder.h"
#include "report/terminal.h"
#include "rt/files/scene_reader.h"
#include "stress/report.h"
#include "stress/run.h"
#include "studies/commands.h"
#include "studies/numbers.h"
#include "studies/studies.h"

namespace grade::stress {

namespace {

struct StressArguments {
    std::string submission, json, html;
    StressSettings settings;
    double rays = 1e8;  // of the big counts
    bool many = false, list = false, require = false;
};

/// Throws rt::InputError.
void check(const StressArguments& arguments) {
    for (const std::string& name : arguments.settings.only)
        if (std::ranges::none_of(all_families(), [&](const Family& family) { return is_named(family, name); }))
            throw rt::InputError(fmt::format(
                "--only {}: no family and no fragment of a family has this name; expected one that --list prints",
                name));
    if (std::ranges::any_of(all_families(), [&](const Family& f) { return is_named(f, arguments.submission); }))
        throw rt::InputError(
            fmt::format("{0}: no submission; expected a folder or an archive, or --only {0}", arguments.submission));
    require_file(arguments.json, "--json");
    if (!arguments.html.empty()) make_folder(arguments.html, "--html");
}

void print_list() {
    for (const Family& family : all_families())
        fmt::print("{:<30}{:<24}{}; {}\n", family.name, family.fragments.front(), family.swept, family.error);
}

/// How extreme a scene a submission's fragments survive. Returns the exit code: 0; 1 with --require where ordinary
/// scenes fail.
int run_stress(const StressArguments& arguments, const Context& context) {
    if (arguments.list) return print_list(), 0;
    const Toolchain chain = read_toolchain(context.toolchain);
    const Assignment assignment = assignment_of(chain);
    check(arguments);
    const std::string path = arguments.submission.empty() ? (chain.source / "starter").string() : arguments.submission;
    const Submission submission = read_submission(path, assignment.names());

    ProgressLine line;
    StressSettings settings = arguments.settings;
    if (arguments.many) settings.rays = arguments.rays;
    settings.progress = line.listener();
    StressRecord record = stress_submission(submission, assignment, chain, settings);
    record.command = context.command;
    line.clear();

    if (!arguments.json.empty()) write_text(arguments.json, to_json(record));
    const fs::path html = page_folder(arguments.html, arguments.submission.empty() && settings.only.empty(), chain);
    if (!html.empty())
        write_page(html, "stress.html", page(record, assignment.title, handout_beside(html, chain.source)));
    fmt::print("{}{}\n", table(record, has_colors()), record.sandbox);
    if (!html.empty()) fmt::print("page: {}\n", (html / "stress.html").string());
    return arguments.require && record.scored() < record.most_scored() ? 1 : 0;
}

}  // namespace

Command stress_command(CLI::App& app) {
    const auto arguments = std::make_shared<StressArguments>();
    CLI::App* stress = app.add_subcommand("stress", purpose_of("stress"));
    stress->add_option("SUBMISSION", arguments->submission, "a folder, a .zip or a .tar.gz; default: starter");
    stress->add_option("--only", arguments->settings.only, "only these families, or those of these fragments")
        ->delimiter(',')
        ->allow_extra_args(false)
        ->type_name("NAME[,NAME...]");
    stress->add_option("--json", arguments->json, "write the record")->type_name("FILE");
    stress->add_option("--html", arguments->html, "write a page with plots into this folder; all of starter gets one")
        ->type_name("DIR");
    stress
        ->add_option("--jobs", arguments->settings.build.jobs,
                     "how many programs run at a time; default: one for each core")
        ->check(CLI::Range(1, 1024));
    stress->add_option("--time-limit", arguments->settings.time_limit, "CPU seconds for one answer")
        ->capture_default_str()
        ->check(in_range(1, 600));
    stress->add_flag("--long", arguments->many,
                     "also the big counts: 1e8 rays against closed meshes, 2e8 that leave surfaces");
    stress->add_option("--rays", arguments->rays, "of --long against meshes; twice as many leave surfaces")
        ->type_name("N")
        ->check(in_range(1, 1e12));
    stress->add_flag("--trusted", arguments->settings.build.trusted, "the code is your own: limits, but no sandbox");
    stress->add_flag("--list", arguments->list, "print the families and leave");
    stress->add_flag("--require", arguments->require, "exit with 1 unless all ordinary scenes are right");
    stress->fallthrough();
    return {stress, [arguments](const Context& context) { return run_stress(*arguments, context); }};
}

}  // namespace grade::stress
