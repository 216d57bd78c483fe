#include "programs/programs.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <sys/stat.h>

#include <algorithm>

#include "programs/compile.h"
#include "programs/parallel.h"
#include "programs/preprocess.h"
#include "submission/code_only.h"

namespace grade {

namespace {

Programs::Problem not_started(const Submission& submission, const std::string& fragment) {
    if (const auto complaint = submission.complaints.find(fragment); complaint != submission.complaints.end())
        return {Verdict::not_started, fmt::format("{}.cpp is {}", fragment, complaint->second)};
    const std::string file = submission.folder + fragment + ".cpp";
    if (submission.texts.contains(fragment)) return {Verdict::not_started, "fill in " + file};
    return {Verdict::not_started, file + " is not in the submission", Trouble::missing};
}

}  // namespace

Programs::Programs(const Submission& submission, const Toolchain& chain, const BuildSettings& settings,
                   Progress& progress)
    : submission_(submission), chain_(chain), settings_(settings), progress_(progress) {
    work_ = settings.keep.empty() ? temporary_.path() : fs::absolute(settings.keep);
    fs::create_directories(work_);
    sandbox_ = find_sandbox(settings.trusted, {chain.includes.front() / "rt/fragments.h", chain.archives.front()},
                            chain.own_folders());
    if (sandbox_.own_user) {
        umask(022);
        fs::permissions(work_, fs::perms(0711));
    }
    if (chain.is_kit) sandbox_.readable.push_back(chain.archives.front().parent_path() / "lib");
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

std::string Programs::complaint(const std::string& fragment) const {
    const auto problem = problems_.find(fragment);
    if (problem == problems_.end()) return {};
    const bool started = problem->second.verdict != Verdict::not_started;
    return (started ? "did not build: " : "not started: ") + problem->second.message;
}

const std::string& Programs::warnings(const std::string& fragment) const {
    static const std::string none;
    const auto found = warnings_.find(fragment);
    return found == warnings_.end() ? none : found->second;
}

std::set<std::string> Programs::all() const {
    std::set<std::string> names;
    for (const auto& [name, object] : objects_) names.insert(name);
    return names;
}

std::set<std::string> Programs::names() const {
    std::set<std::string> names;
    for (const auto& [name, object] : chain_.solution_objects) names.insert(name);
    return names;
}

bool Programs::is_filled(const std::string& fragment) const {
    const auto text = submission_.texts.find(fragment);
    return text != submission_.texts.end() && !is_blank(text->second, chain_.blanks / (fragment + ".cpp"));
}

int Programs::to_compile(const std::set<std::string>& fragments) const {
    return int(
        std::ranges::count_if(fragments, [&](const std::string& name) { return !has(name) && is_filled(name); }));
}

void Programs::compile(const std::set<std::string>& fragments) {
    std::vector<std::string> wanted;
    for (const std::string& name : fragments) {
        if (has(name) || problems_.contains(name)) continue;
        if (!is_filled(name))
            problems_[name] = not_started(submission_, name);
        else if (settings_.only_changed && read_text(chain_.source / "solution" / (name + ".cpp")) == text(name))
            objects_[name] = chain_.solution_objects.at(name);
        else
            wanted.push_back(name);
    }
    in_parallel(int(wanted.size()), settings_.jobs, [&](int i) {
        const std::string& name = wanted[std::size_t(i)];
        progress_.tell("compiling " + name);
        if (const auto before = settings_.kept.object(name, text(name))) {
            const std::string said = settings_.kept.warnings(name, text(name));
            const std::scoped_lock lock(lock_);
            objects_[name] = *before, warnings_[name] = said;
        } else {
            const Compiled compiled = compile_fragment(chain_, sandbox_, name, text(name),
                                                       submission_.folder + name + ".cpp", folder("objects/" + name));
            if (compiled.good) {
                settings_.kept.keep_object(name, text(name), compiled.object, compiled.warnings);
                const std::scoped_lock lock(lock_);
                objects_[name] = compiled.object, warnings_[name] = compiled.warnings;
            } else {
                fails(name, compiled.message);
            }
        }
        progress_.done(Work::compile);
    });
}

const Programs::Linked& Programs::with(const std::set<std::string>& fragments, Others others) {
    // what is the solution's own object makes no other program
    std::set<std::string> own;
    for (const std::string& name : fragments)
        if (has(name) && (others == Others::blanks || objects_.at(name) != chain_.solution_objects.at(name)))
            own.insert(name);
    Entry* entry = nullptr;
    std::size_t number = 0;
    {
        const std::scoped_lock lock(lock_);
        auto& place = linked_[{others, own}];
        if (!place) place = std::make_unique<Entry>();
        entry = place.get(), number = linked_.size();
    }
    std::call_once(entry->once, [&] {
        std::vector<fs::path> list;
        for (const auto& [name, object] : others == Others::solution ? chain_.solution_objects : chain_.blank_objects)
            list.push_back(own.contains(name) ? objects_.at(name) : object);
        const std::string kind = others == Others::solution ? "solution" : "blanks";
        const std::string name = own.empty()       ? kind
                                 : own.size() == 1 ? fmt::format("{}-{}", *own.begin(), kind)
                                                   : fmt::format("{}-of-own-{}-{}", own.size(), kind, number);
        entry->linked.program = folder("programs/" + name) / "child";
        entry->linked.errors = link_child(chain_, sandbox_, list, entry->linked.program);
        if (own.empty() && !entry->linked.errors.empty())
            throw std::runtime_error(fmt::format("the {} cannot be linked: {}", kind, entry->linked.errors));
    });
    return entry->linked;
}

std::optional<fs::path> Programs::checked(const std::string& fragment) const {
    // a step of another user cannot see its own /proc
    if (sandbox_.kind == Sandbox::Kind::container) return std::nullopt;
    return compiled_again(with_sanitizers(chain_), fragment, text(fragment), "checked");
}

std::optional<fs::path> Programs::with_text(const std::string& fragment, const std::string& text,
                                            const std::string& how) const {
    return compiled_again(chain_, fragment, text, how);
}

std::optional<std::string> Programs::preprocessed(const std::string& fragment) const {
    return grade::preprocessed(chain_, sandbox_, text(fragment), folder("preprocessed/" + fragment));
}

std::optional<fs::path> Programs::compiled_again(const Toolchain& chain, const std::string& fragment,
                                                 const std::string& text, const std::string& how) const {
    // a fragment whose compilation is made slow shall not pay for that with every program that a hint asks for
    constexpr double most_seconds = most_compiler_seconds / 4;
    const Compiled compiled = compile_fragment(chain, sandbox_, fragment, text, fragment + ".cpp",
                                               folder(how + "/" + fragment), most_seconds);
    if (!compiled.good) return std::nullopt;
    std::vector<fs::path> list;
    for (const auto& [name, object] : chain_.solution_objects)
        list.push_back(name == fragment ? compiled.object : object);
    const fs::path program = folder(fmt::format("programs/{}-{}", fragment, how)) / "child";
    return link_child(chain, sandbox_, list, program).empty() ? std::optional(program) : std::nullopt;
}

fs::path Programs::must_link(const std::set<std::string>& fragments, Others others) {
    const Linked& linked = with(fragments, others);
    if (!linked.errors.empty())
        throw SubmissionError(
            fmt::format("{}: {} cannot be linked: {}", submission_.name, fmt::join(fragments, ", "), linked.errors));
    return linked.program;
}

fs::path Programs::own_without(const std::set<std::string>& fragments) {
    std::set<std::string> names = all();
    for (const std::string& name : fragments) names.erase(name);
    if (const Linked& linked = with(names, Others::blanks); linked.errors.empty()) return linked.program;
    std::erase_if(names, [&](const std::string& name) { return !with({name}, Others::blanks).errors.empty(); });
    return must_link(names, Others::blanks);
}

fs::path Programs::copy_for(const std::string& name, const fs::path& program) const {
    const fs::path copy = folder("runs/" + name) / "child";
    std::error_code error;
    fs::create_hard_link(program, copy, error);
    if (error) fs::copy_file(program, copy);
    return copy;
}

}  // namespace grade
