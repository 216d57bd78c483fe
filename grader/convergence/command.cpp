#include <fmt/format.h>
#include <fmt/ranges.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <memory>

#include "convergence/measure.h"
#include "convergence/report.h"
#include "files/files.h"
#include "files/stamp.h"
#include "programs/cache.h"
#include "programs/programs.h"
#include "report/folder.h"
#include "report/markdown.h"
#include "report/page_parts.h"
#include "report/terminal.h"
#include "rt/files/scene_reader.h"
#include "studies/commands.h"
#include "studies/numbers.h"
#include "studies/studies.h"

namespace grade::convergence {

namespace {

struct ConvergeArguments {
    std::vector<std::string> words;  // a submission, scenes
    std::string json, csv, out, folder;
    Amounts amounts;
    BuildSettings build{.only_changed = true};
    bool fresh = false, require = false;
};

/// The scenes among the words, or those of scenes/bench.
std::vector<fs::path> scenes_of(const std::vector<std::string>& words, const fs::path& source) {
    std::vector<fs::path> scenes;
    for (const std::string& word : words)
        if (word.ends_with(".toml")) scenes.emplace_back(word);
    if (scenes.empty())
        for (const auto& entry : fs::directory_iterator(source / "scenes/bench"))
            if (entry.path().extension() == ".toml") scenes.push_back(entry.path());
    std::ranges::sort(scenes);
    for (const fs::path& scene : scenes) rt::read_scene(scene.string());  // says what is wrong with it, before all work
    return scenes;
}

/// The submission among the words; the starter where there is none.
std::string submission_of(const std::vector<std::string>& words, const fs::path& source) {
    std::vector<std::string> others;
    for (const std::string& word : words)
        if (!word.ends_with(".toml")) others.push_back(word);
    if (others.size() > 1)
        throw rt::InputError(fmt::format(
            "{}: one submission too many; expected a submission, then scenes whose names end in .toml", others[1]));
    return others.empty() ? (source / "starter").string() : others[0];
}

void check_amounts(const Amounts& amounts) {
    for (std::size_t i = 1; i < amounts.samples.size(); ++i)
        if (amounts.samples[i] <= amounts.samples[i - 1])
            throw rt::InputError(fmt::format("--samples {}: {} is not above {}; expected ascending numbers",
                                             fmt::join(amounts.samples, ","), amounts.samples[i],
                                             amounts.samples[i - 1]));
}

/// Of all that the solution's pictures are made from.
std::string stamp_of_solution(const Toolchain& chain) {
    std::vector<fs::path> files = chain.archives;
    for (const auto& [name, object] : chain.solution_objects) files.push_back(object);
    return Stamp().add(chain.description).add_files(chain.source, files).text();
}

/// The solution's program, and the submission's where it has fragments of its own. The note says what stands in for
/// what is missing.
void add_programs(Bench& bench, Programs& programs, const Assignment& assignment, const Toolchain& chain,
                  std::string& note) {
    std::vector<std::string> missing, broken;
    const auto names = assignment.names();
    programs.compile({names.begin(), names.end()});
    for (const auto& [name, problem] : programs.problems())
        (problem.verdict == Verdict::did_not_build ? broken : missing).push_back(name);
    const auto stands_in = [&](const char* why, const std::vector<std::string>& fragments) {
        if (!fragments.empty())
            note += fmt::format("{}; the right one stands in: {}. ", why, fmt::join(fragments, ", "));
    };
    const std::set<std::string> own = programs.all();
    stands_in("Did not build", broken);
    if (!own.empty())
        stands_in("Not started", missing);
    else
        note += "Nothing is filled in yet: the right ones alone. ";

    bench.solution = programs.with({}).program;
    bench.solution_stamp = stamp_of_solution(chain);
    const fs::path mine = programs.must_link(own);
    if (mine == bench.solution) return;
    bench.submission = mine;
    Stamp stamp;
    stamp.add(bench.solution_stamp);
    for (const std::string& name : own) stamp.add(name).add(programs.text(name));
    bench.submission_stamp = stamp.text();
}

/// A page with plots.
///
/// project  whose handout the page leads to
void write_report(const ConvergenceRecord& record, const fs::path& out, const fs::path& project) {
    make_folder(out, "--out");
    for (const SceneRecord& scene : record.scenes)
        for (const Against against : {Against::seconds, Against::rays})
            if (!scene.curves.empty()) write_text(out / plot_file(scene, against), log_log(error_plot(scene, against)));
    const std::string text = report(record);
    write_text(out / "converge.md", text);
    const std::string read = read_link("Error against run time", handout_beside(out, project)) + ".";
    write_page(out, "converge.html",
               plain_page("Error against run time", record.submission, read, html_of_markdown(text)));
}

/// Error against run time. Returns the exit code: 0; 1 with --require where the submission is biased or breaks down.
int run_converge(const ConvergeArguments& arguments, const Context& context) {
    const Toolchain chain = read_toolchain(context.toolchain);
    const Assignment assignment = assignment_of(chain);
    check_amounts(arguments.amounts);
    require_file(arguments.json, "--json");
    require_file(arguments.csv, "--csv");
    if (!arguments.out.empty()) make_folder(arguments.out, "--out");
    const auto scenes = scenes_of(arguments.words, chain.source);
    const Submission submission = read_submission(submission_of(arguments.words, chain.source), assignment.names());

    ConvergenceRecord record;
    Bench bench;
    bench.results = arguments.folder.empty() ? cache_folder(chain).value_or(temporary_place()) / "convergence"
                                             : fs::path(arguments.folder);
    bench.fresh = arguments.fresh;
    ProgressLine line;
    int scenes_done = 0;
    bench.progress = [&](double done, const std::string& doing) {
        line.show(int(100 * (scenes_done + done) / double(scenes.size())), 100, doing);
    };
    bench.progress(0, "compiling");
    Progress silent({});
    Programs programs(submission, chain, arguments.build, silent);
    bench.sandbox = programs.sandbox();
    add_programs(bench, programs, assignment, chain, record.note);
    int copies = 0;
    bench.copy = [&](const fs::path& program) { return programs.copy_for(fmt::to_string(copies++), program); };

    record.submission = submission.name;
    record.toolchain = chain.description;
    record.version = PENUMBRA_VERSION;
    record.command = context.command;
    record.sandbox = bench.sandbox.description;
    const double budget = arguments.amounts.budget / double(scenes.size());
    for (const fs::path& scene : scenes) {
        record.scenes.push_back(measure(scene, bench, arguments.amounts, budget));
        ++scenes_done;
    }
    line.clear();
    if (!arguments.json.empty()) write_text(arguments.json, to_json(record));
    if (!arguments.csv.empty()) write_text(arguments.csv, to_csv(record));
    const bool own = std::ranges::all_of(arguments.words, [](const std::string& w) { return w.ends_with(".toml"); });
    const fs::path out = page_folder(arguments.out, own, chain);
    if (!out.empty()) write_report(record, out, chain.source);
    fmt::print("{}", table(record, has_colors()));
    if (!out.empty()) fmt::print("page: {}\n", (out / "converge.html").string());
    const bool broken = std::ranges::any_of(record.scenes, [](const SceneRecord& s) { return !s.fault.empty(); });
    return arguments.require && (broken || record.is_biased()) ? 1 : 0;
}

}  // namespace

Command converge_command(CLI::App& app) {
    const auto arguments = std::make_shared<ConvergeArguments>();
    Amounts& amounts = arguments->amounts;
    CLI::App* converge = app.add_subcommand("converge", purpose_of("converge"));
    converge
        ->add_option("WORDS", arguments->words,
                     "a folder, a .zip or a .tar.gz; scene files; default: starter, and those of scenes/bench")
        ->type_name("[SUBMISSION] [SCENE...]");
    converge->add_option("--samples", amounts.samples, "levels of samples a pixel")
        ->delimiter(',')
        ->capture_default_str()
        ->check(CLI::Range(1, 1 << 20));
    converge->add_option("--samplers", amounts.samplers, "patterns; times to an error need random")
        ->delimiter(',')
        ->capture_default_str()
        ->check(CLI::IsMember(std::vector<std::string>(rt::sampler_names.begin(), rt::sampler_names.end())));
    converge->add_option("--replicates", amounts.replicates, "pictures of each level")
        ->capture_default_str()
        ->check(CLI::Range(2, 10000));
    converge->add_option("--side", amounts.side, "pixels of the longer side of a picture; 0: as the scene has it")
        ->capture_default_str()
        ->check(CLI::Range(0, 4096));
    converge->add_option("--budget", amounts.budget, "CPU seconds for all pictures; the last levels are left out first")
        ->capture_default_str()
        ->check(in_range(0.1, 1e9));
    converge->add_option("--time-limit", amounts.time_limit, "CPU seconds for one picture")
        ->capture_default_str()
        ->check(in_range(1, 600));
    converge->add_option("--json", arguments->json, "write the record")->type_name("FILE");
    converge->add_option("--csv", arguments->csv, "write one line for each level")->type_name("FILE");
    converge->add_option("--out", arguments->out, "write a page with plots into this folder; starter gets one")
        ->type_name("DIR");
    converge
        ->add_option("--folder", arguments->folder, "where results are kept, and work goes on after an interruption")
        ->type_name("DIR");
    converge->add_flag("--fresh", arguments->fresh, "measure anew what is kept, but for references");
    converge
        ->add_option("--jobs", arguments->build.jobs, "how many compilers run at a time; pictures are timed one by one")
        ->check(CLI::Range(1, 1024));
    converge->add_flag("--trusted", arguments->build.trusted, "the code is your own: limits, but no sandbox");
    converge->add_flag("--require", arguments->require, "exit with 1 where a bias is shown or a picture is missing");
    converge->fallthrough();
    return {converge, [arguments](const Context& context) { return run_converge(*arguments, context); }};
}

}  // namespace grade::convergence
