#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>

#include "calibration/fast.h"
#include "calibration/report.h"
#include "calibration/workshop.h"
#include "files/files.h"
#include "report/folder.h"
#include "report/markdown.h"
#include "report/terminal.h"
#include "rt/files/scene_reader.h"
#include "studies/commands.h"
#include "studies/shard.h"
#include "studies/studies.h"

namespace grade::calibration {

namespace {

struct CalibrateArguments {
    std::string results;  // folder; empty: calibration/ in the build's folder
    std::string out;      // folder of the report; empty: that of the results
    std::string shard = "1/1";
    bool fast = false, report = false;
    int seeds = 1;  // of fast
    Amount amount;
    int jobs = 0;
    std::vector<std::string> names;  // of variants or fragments; empty: all
};

/// Grades fragments that are known to be wrong or right, and reports how often the verdict is so. Returns the exit
/// code: 0 where the work is done; with `fast`, 1 unless each wrong variant fails and each right one passes.
int run_calibrate(const CalibrateArguments& arguments, const Context& context) {
    const auto [shard, shards] = shard_of(arguments.shard);
    const fs::path results = arguments.results.empty() ? fs::path(context.toolchain).parent_path() / "calibration"
                                                       : fs::absolute(arguments.results);
    const Workshop workshop(context.toolchain, results, arguments.amount, arguments.names);
    if (!fs::is_directory(workshop.chain().source / "solution"))
        throw rt::InputError("calibrate needs the folder solution/, which is not here");
    if (workshop.variants().empty())
        throw rt::InputError("no variant and no fragment has such a name; tests/variants holds them");
    if (arguments.fast) return grade_fast(workshop, !arguments.names.empty(), arguments.seeds, arguments.jobs) ? 0 : 1;

    ProgressLine line(true);
    const auto tell = [&line](int done, int all, const std::string& doing) {
        constexpr int step = int(Work::check);  // all steps and all replays are counted alike
        line.show(done / step, all / step, doing);
    };
    if (!arguments.report) run_steps(steps_of(workshop), shard, shards, arguments.jobs, tell);
    if (!arguments.report && shards > 1) {
        line.clear();
        fmt::print("shard {} is done: {}\n", arguments.shard, workshop.results().string());
        return 0;
    }
    const Summary summary = summarize(workshop, arguments.jobs, tell);
    line.clear();
    const fs::path out = arguments.out.empty() ? workshop.results() : fs::path(arguments.out);
    make_folder(out, "--out");
    const std::string text = calibration_report(summary, context.command, "calibration.svg");
    write_text(out / "calibration.md", text);
    handout_beside(out, workshop.chain().source);
    write_page(out, "calibration.html",
               plain_page("How far verdicts can be trusted",
                          "what was to be shown of verdicts, beside what was measured", "", html_of_markdown(text)));
    write_text(out / "calibration.svg", log_log(budget_plot(summary, int(workshop.assignment().fragments.size()))));
    fmt::print("{}\n{}\n", text.substr(0, text.find("\n## Sizes of a bias")), (out / "calibration.md").string());
    return 0;
}

}  // namespace

Command calibrate_command(CLI::App& app) {
    const auto arguments = std::make_shared<CalibrateArguments>();
    CLI::App* trust = app.add_subcommand("calibrate", purpose_of("calibrate"));
    trust->add_option("NAME", arguments->names, "only variants or fragments with such a name");
    trust->add_flag("--fast", arguments->fast,
                    "one wrong variant of each fragment and all right ones, once; exit with 1 where one is off");
    trust->add_option("--seeds", arguments->seeds, "with --fast: under so many seeds; says where they differ")
        ->check(CLI::Range(1, 10000));
    trust->add_flag("--report", arguments->report, "run nothing: report on what is there");
    trust->add_option("--shard", arguments->shard, "do the second of four parts of the work: 2/4")
        ->type_name("PART/PARTS");
    trust->add_option("--folder", arguments->results, "where results are kept, and work goes on after an interruption")
        ->type_name("DIR");
    trust->add_option("--out", arguments->out, "where the report goes; default: to the results")->type_name("DIR");
    trust->add_option("--replicates", arguments->amount.replicates, "of each check of each variant")
        ->capture_default_str()
        ->check(CLI::Range(64, 1000000));
    trust->add_option("--gradings", arguments->amount.gradings, "of whole right submissions")
        ->capture_default_str()
        ->check(CLI::Range(1, 1000000));
    trust->add_option("--draws", arguments->amount.draws, "replayed gradings of the solution")
        ->capture_default_str()
        ->check(CLI::Range(1000, 1000000000));
    trust->add_option("--jobs", arguments->jobs, "how many programs run at a time")->check(CLI::Range(1, 1024));
    trust->fallthrough();
    return {trust, [arguments](const Context& context) { return run_calibrate(*arguments, context); }};
}

}  // namespace grade::calibration
