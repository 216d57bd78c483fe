#include "commands/commands.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <future>
#include <memory>

#include "commands/last_run.h"
#include "commands/run.h"
#include "commands/watch.h"
#include "commands/words.h"
#include "files/files.h"
#include "files/interrupt.h"
#include "judging/grading.h"
#include "judging/own_picture.h"
#include "judging/provenance.h"
#include "programs/cache.h"
#include "programs/process.h"
#include "report/escape.h"
#include "report/folder.h"
#include "report/json.h"
#include "report/page.h"
#include "report/terminal.h"
#include "rt/files/scene_reader.h"
#include "studies/numbers.h"

namespace grade {

namespace {

struct GradeArguments {
    std::vector<std::string> words;  // a submission, and fragments
    std::string json, html, own_scene;
    std::optional<std::uint64_t> seed;
    std::optional<double> required;
    GradingSettings settings;  // those that have an option
    bool fresh = false, watch = false;
};

/// A folder as one would type it, with a slash at its end; empty where one stands in it.
std::string from_here(const fs::path& folder) {
    std::error_code error;
    const std::string whole = fs::weakly_canonical(folder, error).string();
    const std::string near = fs::relative(folder, error).string();
    if (error || near.empty()) return whole + "/";
    return near == "." ? ""
                       : std::min(near, whole, [](const auto& a, const auto& b) { return a.size() < b.size(); }) + "/";
}

/// Of every grading of what its user edits: what has not changed comes out as it did.
constexpr std::uint64_t own_seed = 1;

/// All that a grading needs, and what is done with it.
class Session {
public:
    Session(const GradeArguments& arguments, const Context& context)
        : arguments_(arguments),
          chain_(read_toolchain(context.toolchain)),
          assignment_(assignment_of(chain_)),
          chosen_(choose(arguments.words, chain_, assignment_)),
          command_(context.command),
          settings_(arguments.settings) {
        require_file(arguments.json, "--json");
        cache_ = cache_folder(chain_);
        // what its user edits gets the page as well
        const bool whole = chosen_.own && chosen_.fragments.empty() && !arguments.watch;
        html_ = page_folder(arguments.html, whole, chain_);
        if (!arguments.html.empty()) make_folder(html_, "--html");
        if (!arguments.settings.build.keep.empty()) make_folder(arguments.settings.build.keep, "--keep");
        set_up();
        // their closed forms take a while: meanwhile the fragments are compiled
        checks_ = std::async(std::launch::async, all_checks, settings_.seed).share();
        provenance_ = std::async(std::launch::async, find_provenance, std::cref(chain_)).share();
    }

    const Chosen& chosen() const { return chosen_; }
    Reader reader() const { return {has_colors(), chosen_.own, folder_}; }
    const Assignment& assignment() const { return assignment_; }

    Record grade() {
        const auto start = Clock::now();
        // whatever happens from now on, no record of an earlier grading is there
        if (settings_.partial) settings_.partial(Record{.submission = chosen_.submission, .command = command_});
        if (!html_.empty()) {
            fs::create_directories(html_);
            write_text(html_ / "index.html",
                       "<!doctype html><meta charset=utf-8><title>not complete</title><p>This grading is not complete: "
                       "it still runs, or it was stopped.\n");
        }
        ProgressLine line;
        progress_ = std::make_unique<Progress>(line.listener());
        Submission submission =
            read_submission(chosen_.submission, all_fragments(chain_, assignment_), chain_.source / "starter");
        note_given(submission, assignment_.asked(), chain_.blanks);
        settings_.provenance = provenance_.get();
        programs_ = std::make_unique<Programs>(submission, chain_, settings_.build, *progress_);
        Record record = grade_programs(*programs_, assignment_, chain_, checks_, settings_, *progress_);
        record.wall_seconds = std::chrono::duration<double>(Clock::now() - start).count();
        record.notes = submission.notes;
        if (chosen_.own && cache_) compare_with_last(record, *cache_ / last_run_file);
        if (!arguments_.json.empty()) write_text(arguments_.json, to_json(record));
        return record;
    }

    /// The table; the exit code.
    int tell(const Record& record) const {
        fmt::print("{}", table(record, reader()));
        // of one's own it is always the same
        if (!chosen_.own || arguments_.seed) fmt::print("seed {}; {}\n", record.seed, record.sandbox);
        if (record.reused > 0)
            fmt::print("{} checks as before: nothing that they depend on has changed (--fresh runs them again)\n",
                       record.reused);
        std::fflush(stdout);
        return arguments_.required && record.score() < *arguments_.required ? 1 : 0;
    }

    /// What to do next, last of all that is said.
    void tell_next(const Record& record) const {
        if (!chosen_.own || !cache_) return;
        const std::string folder = folder_ + place_of_fragments(record);
        std::vector<std::string> names = assignment_.names();
        const std::set<std::string> asked = assignment_.asked();
        std::erase_if(names, [&](const std::string& name) { return !asked.contains(name); });
        const std::string next = next_step(record, names, *cache_ / last_run_file, folder);
        if (!next.empty()) fmt::print("{}\n", next);
    }

    /// The page, with a picture of its own of what was graded last.
    void write_page(Record record) const {
        if (html_.empty()) return;
        ProgressLine line;
        line.show(0, 1, "drawing the picture of the page");
        if (!own_scene_.empty()) try {
                add_own_picture(record, *programs_, own_scene_, settings_.seed, settings_.time_limit);
            } catch (const std::runtime_error& error) {  // one picture less
                record.own_picture_scene = own_scene_.filename().string();
                record.own_picture_fault = error.what();
            }
        if (!chosen_.own) name_submission_in_calls(record, as_typed(chosen_.submission));
        grade::write_page(html_, "index.html", page(record, handout_beside(html_, chain_.source)));
        line.clear();
        if (!record.own_picture_fault.empty())
            fmt::print("no picture of your own: {}\n", printable_line(record.own_picture_fault));
        fmt::print("page: {}\n", (html_ / "index.html").string());
    }

private:
    /// Where the files of fragments are, within the submission, also where the first of them is missing.
    std::string place_of_fragments(const Record& record) const {
        const auto there = std::ranges::find_if(record.fragments,
                                                [](const FragmentRecord& fragment) { return !fragment.file.empty(); });
        std::error_code error;
        if (there == record.fragments.end())
            return fs::is_directory(fs::path(chosen_.submission) / "fragments", error) ? "fragments/" : "";
        const std::string within = fs::path(there->file).parent_path().string();
        return within.empty() ? "" : within + "/";
    }

    void set_up() {
        if (chosen_.own) folder_ = from_here(chosen_.submission);
        settings_.only = chosen_.fragments;
        settings_.seed = arguments_.seed ? *arguments_.seed : chosen_.own ? own_seed : fresh_seed();
        if (!arguments_.seed && !chosen_.own) command_ += fmt::format(" --seed {}", settings_.seed);
        settings_.pictures = !html_.empty() || chosen_.own;
        // a kit grades the code of its own user
        settings_.build.trusted |= chain_.is_kit && chosen_.own;
        if (chosen_.own && cache_ && settings_.build.keep.empty())
            settings_.build.kept = Kept(*cache_ / "kept", chain_, !arguments_.fresh);
        const fs::path gallery = chain_.source / "scenes/gallery/everything.toml";
        if (!arguments_.own_scene.empty())
            rt::read_scene(arguments_.own_scene);  // says what is wrong with it, before all the work
        if (!html_.empty())
            own_scene_ = !arguments_.own_scene.empty() ? fs::path(arguments_.own_scene)
                         : fs::exists(gallery)         ? gallery
                                                       : fs::path();
        if (!arguments_.json.empty())
            settings_.partial = [this](const Record& record) { write_text(arguments_.json, to_json(record)); };
        settings_.command = command_;
    }

    const GradeArguments& arguments_;
    Toolchain chain_;
    Assignment assignment_;
    Chosen chosen_;
    std::string folder_;  // of what is its user's own, from where they stand
    std::string command_;
    std::shared_future<Provenance> provenance_;
    std::optional<fs::path> cache_;
    fs::path html_;
    GradingSettings settings_;
    FutureChecks checks_;
    fs::path own_scene_;  // of the page; empty: none
    std::unique_ptr<Progress> progress_;
    std::unique_ptr<Programs> programs_;  // of the last grading
};

/// grade [SUBMISSION] [FRAGMENT...]. Returns the exit code: 0; 1 below what is required.
int run_grade(const GradeArguments& arguments, const Context& context) {
    stop_at_interrupt();
    Session session(arguments, context);
    if (arguments.watch) {
        watch(
            session.chosen().submission, session.reader(), session.assignment(), session.chosen().fragments,
            [&] { return session.grade(); }, [&](const Record& record) { session.write_page(record); });
        return 0;
    }
    const Record record = session.grade();
    const int code = session.tell(record);
    session.write_page(record);
    session.tell_next(record);
    return code;
}

}  // namespace

Command grade_command(CLI::App& app) {
    const auto arguments = std::make_shared<GradeArguments>();
    app.add_option("WORDS", arguments->words,
                   "a folder, a .zip or a .tar.gz, default: starter; and names of fragments, default: all")
        ->type_name("[SUBMISSION] [FRAGMENT...]");
    app.add_flag("--watch", arguments->watch, "grade again at each save, until Ctrl-C");
    app.add_option("--seed", arguments->seed,
                   "of all parameters and random numbers; default: 1 for the starter, else a fresh one")
        ->type_name("N")
        ->check(is_seed());
    app.add_option("--json", arguments->json, "write the record of the grading")->type_name("FILE");
    app.add_option("--html", arguments->html,
                   "write a page with all pictures into this folder; a whole starter always gets one")
        ->type_name("DIR");
    app.add_option("--require", arguments->required, "exit with 1 below so many points")
        ->type_name("POINTS")
        ->check(in_range(0, 1e6));
    app.add_option("--jobs", arguments->settings.build.jobs,
                   "how many programs run at a time; default: one for each core")
        ->check(CLI::Range(1, 1024));
    app.add_option("--time-limit", arguments->settings.time_limit, "CPU seconds for one answer of a fragment")
        ->capture_default_str()
        ->check(in_range(1, 600));
    app.add_option("--keep", arguments->settings.build.keep, "leave objects and programs in this folder")
        ->type_name("DIR");
    app.add_option("--picture", arguments->own_scene, "the scene of the submission's own picture on the page")
        ->type_name("SCENE");
    app.add_flag("--fresh", arguments->fresh, "run all checks again, also those that nothing has changed for");
    app.add_flag("--trusted", arguments->settings.build.trusted, "the code is your own: limits, but no sandbox");
    return {&app, [arguments](const Context& context) { return run_grade(*arguments, context); }};
}

}  // namespace grade
