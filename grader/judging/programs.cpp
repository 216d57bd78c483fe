#include "judging/programs.h"

#include <fmt/format.h>

#include "build/code_only.h"
#include "build/compile.h"
#include "judging/parallel.h"

namespace grade {

namespace {

std::string not_started(const Submission& submission, const std::string& fragment) {
    if (const auto complaint = submission.complaints.find(fragment); complaint != submission.complaints.end())
        return fmt::format("{}.cpp is {}", fragment, complaint->second);
    if (submission.texts.contains(fragment)) return fmt::format("fill in {}{}.cpp", submission.folder, fragment);
    return fmt::format("{}{}.cpp is not in the submission", submission.folder, fragment);
}

}  // namespace

Programs::Programs(const Submission& submission, const Assignment& assignment, const Toolchain& chain,
                   const BuildSettings& settings, Progress& progress)
    : submission_(submission.name), assignment_(assignment), chain_(chain), settings_(settings), progress_(progress) {
    work_ = settings.keep.empty() ? temporary_.path() : fs::absolute(settings.keep);
    fs::create_directories(work_);
    sandbox_ = find_sandbox(settings.trusted);
    compile(submission);
    if (settings.apart) link_apart();
    if (settings.together) link_together();
}

bool Programs::is_graded(const Fragment& fragment) const {
    return !fragment.given && (settings_.only.empty() || settings_.only.contains(fragment.name));
}

fs::path Programs::folder(const std::string& name) const {
    const fs::path path = work_ / name;
    fs::remove_all(path);
    fs::create_directories(path);
    return path;
}

void Programs::fails(const std::string& fragment, const std::string& message) {
    const std::scoped_lock lock(lock_);
    problems_[fragment] = {Verdict::did_not_build, message};
    objects_.erase(fragment);
}

/// Each fragment that is there and more than the blank becomes an object; for a program of all, also those that are not
/// graded.
void Programs::compile(const Submission& submission) {
    std::vector<const Fragment*> wanted;
    for (const Fragment& fragment : assignment_.fragments) {
        const auto text = submission.texts.find(fragment.name);
        const bool filled = text != submission.texts.end() && !fragment.given &&
                            !is_blank(text->second, chain_.blanks / (fragment.name + ".cpp"));
        if (filled && (settings_.together || is_graded(fragment))) wanted.push_back(&fragment);
        if (!filled && is_graded(fragment))
            problems_[fragment.name] = {Verdict::not_started, not_started(submission, fragment.name)};
    }
    progress_.expect(int(wanted.size()));
    in_parallel(int(wanted.size()), settings_.jobs, [&](int i) {
        const std::string& name = wanted[std::size_t(i)]->name;
        const std::string& text = submission.texts.at(name);
        const auto before = settings_.kept.object(name, text);
        const Compiled compiled = before ? Compiled{true, *before, {}}
                                         : compile_fragment(chain_, sandbox_, name, text,
                                                            submission.folder + name + ".cpp",
                                                            folder("objects/" + name));
        if (compiled.good) {
            if (!before) settings_.kept.keep_object(name, text, compiled.object);
            const std::scoped_lock lock(lock_);
            objects_[name] = compiled.object;
            sources_[name] = text;
        } else {
            fails(name, compiled.message);
        }
        progress_.tell("compiling " + name, 1);
    });
}

/// The solution's objects, but for this fragment the submission's.
std::string Programs::link(const std::string& fragment, const fs::path& program) const {
    std::vector<fs::path> list;
    for (const auto& [name, object] : chain_.solution_objects)
        list.push_back(name == fragment ? objects_.at(name) : object);
    return link_child(chain_, list, program);
}

/// These objects of the submission, and blanks for the others.
std::string Programs::link_all(const std::map<std::string, fs::path>& own, const fs::path& program) const {
    std::vector<fs::path> list;
    for (const auto& [name, blank] : chain_.blank_objects) list.push_back(own.contains(name) ? own.at(name) : blank);
    return link_child(chain_, list, program);
}

void Programs::link_apart() {
    std::vector<std::string> graded;
    for (const Fragment& fragment : assignment_.fragments)
        if (is_graded(fragment) && has(fragment.name)) graded.push_back(fragment.name);
    if (graded.empty()) return;
    progress_.expect(int(graded.size()) + 1);
    std::vector<std::string> errors(graded.size());
    for (const std::string& name : graded) programs_[name] = folder("programs/" + name) / "child";
    in_parallel(int(graded.size()) + 1, settings_.jobs, [&](int i) {
        if (i == 0) {
            solution_ = folder("programs/solution") / "child";
            if (const auto complaint = link("", solution_); !complaint.empty())
                throw std::runtime_error("the solution cannot be linked: " + complaint);
        } else {
            const std::string& name = graded[std::size_t(i) - 1];
            errors[std::size_t(i) - 1] = link(name, programs_.at(name));
        }
        progress_.tell("linking", 1);
    });
    for (std::size_t i = 0; i < graded.size(); ++i)
        if (!errors[i].empty()) fails(graded[i], errors[i]);
}

void Programs::link_together() {
    together_ = folder("programs/own") / "child";
    if (link_all(objects_, together_).empty()) return;

    // one of them does not go with the framework: leave out those that do not even alone
    const auto candidates = objects_;
    for (const auto& [name, object] : candidates) {
        const std::string errors = link_all({{name, object}}, together_);
        if (errors.empty()) continue;
        if (is_graded(assignment_.fragments[assignment_.place(name)])) fails(name, errors);
        objects_.erase(name);
    }
    if (const auto errors = link_all(objects_, together_); !errors.empty())
        throw std::runtime_error("the submission's fragments cannot be linked with each other: " + errors);
}

fs::path Programs::together_without(const std::set<std::string>& fragments) const {
    auto left = objects_;
    for (const std::string& name : fragments) left.erase(name);
    const fs::path program = folder("programs/picture") / "child";
    if (const auto errors = link_all(left, program); !errors.empty())
        throw std::runtime_error("the submission's fragments cannot be linked with each other: " + errors);
    return program;
}

}  // namespace grade
