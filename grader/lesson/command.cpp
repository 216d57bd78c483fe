#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>

#include "assignment/assignment.h"
#include "lesson/lesson.h"
#include "programs/cache.h"
#include "programs/programs.h"
#include "programs/runner.h"
#include "report/folder.h"
#include "report/markdown.h"
#include "report/page_parts.h"
#include "studies/commands.h"
#include "studies/studies.h"

namespace grade::lesson {

namespace {

struct LessonArguments {
    std::string submission, out;
    BuildSettings build{.only_changed = true};
};

constexpr const char* lesson_words =
    "A fragment of part 1 adds up samples of a function whose integral is known. Each line is the error of its sums, "
    "by the way\nthe points are chosen: the steeper it falls, the fewer points a picture needs.\n\n";

/// What a page says of one integral, in Markdown.
std::string section_of(const LessonIntegrand& integrand, const std::vector<LessonCurve>& curves,
                       const std::string& plot) {
    std::string text = fmt::format(
        "## {0}\n\n![relative error of {0} against the number of points]({1})\n\n"
        "| points | fragment | error falls as |\n|---|---|---|\n",
        integrand.title, plot);
    for (const LessonCurve& curve : curves)
        text += fmt::format("| {} | `{}` | {} |\n", method_names[std::size_t(curve.method)],
                            method_fragments[std::size_t(curve.method)],
                            curve.slope ? fmt::format("N^{:.2f}", *curve.slope) : "exact but for rounding");
    return text + "\n";
}

/// The errors of part 1's fragments against the number of points, as a table and as plots: the same bytes on each run.
int run_lesson(const LessonArguments& arguments, const Context& context) {
    constexpr double time_limit = 5;  // CPU seconds of one answer
    const Toolchain chain = read_toolchain(context.toolchain);
    const Assignment assignment = assignment_of(chain);
    const std::string path = arguments.submission.empty() ? (chain.source / "starter").string() : arguments.submission;
    const Submission submission = read_submission(path, assignment.names());
    const std::set<std::string> fragments{"integrate_uniform", "integrate_monte_carlo", "integrate_stratified"};
    Progress silent({});
    Programs programs(submission, chain, arguments.build, silent);
    programs.compile(fragments);
    for (const std::string& name : fragments)
        if (const std::string complaint = programs.complaint(name); !complaint.empty())
            fmt::print("{}: {}\n", name, complaint);
    Runner runner(programs.copy_for("lesson", programs.must_link(fragments)), programs.sandbox(),
                  chain.source / "scenes", time_limit);

    const fs::path out = page_folder(arguments.out, arguments.submission.empty(), chain);
    if (!out.empty()) make_folder(out, "--out");
    std::string sections;
    for (const LessonIntegrand& integrand : lesson_integrands()) {
        std::vector<LessonCurve> curves;
        for (const Method method : {Method::uniform, Method::random, Method::stratified, Method::importance})
            if (programs.complaint(method_fragments[std::size_t(method)]).empty())
                curves.push_back(lesson_curve(integrand, method, runner));
        if (curves.empty()) continue;
        fmt::print("{}\n  {:<12}{:>12}{:>12}{:>12}  error falls as\n", integrand.title, "", "16 points", "256", "4096");
        for (const LessonCurve& curve : curves) {
            fmt::print("  {:<12}", method_names[std::size_t(curve.method)]);
            for (const LessonPoint& point : curve.points)
                if (point.n == 16 || point.n == 256 || point.n == 4096) fmt::print("{:>12.2g}", point.error);
            fmt::print("  {}\n", curve.slope ? fmt::format("N^{:.2f}", *curve.slope) : "exact but for rounding");
        }
        if (out.empty()) continue;
        const fs::path file = out / fmt::format("lesson_{}.svg", integrand.name);
        sections += section_of(integrand, curves, file.filename().string());
        write_text(file, log_log(lesson_plot(integrand, curves)));
        fmt::print("  {}\n", file.string());
    }
    if (sections.empty()) {
        if (!out.empty()) fmt::print("no page: none of {} runs\n", fmt::join(fragments, ", "));
        return 0;
    }
    const std::string read = read_link("Integrals in one dimension", handout_beside(out, chain.source)) + ".";
    write_page(out, "lesson.html",
               plain_page("Integrals: how the error falls with the number of points", submission.name, read,
                          html_of_markdown(lesson_words + sections)));
    fmt::print("page: {}\n", (out / "lesson.html").string());
    return 0;
}

}  // namespace

Command lesson_command(CLI::App& app) {
    const auto arguments = std::make_shared<LessonArguments>();
    CLI::App* lesson = app.add_subcommand("lesson", purpose_of("lesson"));
    lesson->add_option("SUBMISSION", arguments->submission, "a folder, a .zip or a .tar.gz; default: starter");
    lesson->add_option("--out", arguments->out, "write a page with the plots into this folder; starter gets one")
        ->type_name("DIR");
    lesson->add_flag("--trusted", arguments->build.trusted, "the code is your own: limits, but no sandbox");
    lesson->fallthrough();
    return {lesson, [arguments](const Context& context) { return run_lesson(*arguments, context); }};
}

}  // namespace grade::lesson
