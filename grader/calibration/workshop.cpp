#include "calibration/workshop.h"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

#include "files/files.h"
#include "files/stamp.h"
#include "programs/compile.h"
#include "programs/parallel.h"
#include "programs/progress.h"

namespace grade::calibration {

namespace {

/// Of all that decides what a fragment's replicates are: its own checks, and what all share. Without a fragment, of all
/// that decides what becomes of a submission.
std::string stamp(const fs::path& source, const std::vector<std::string>& fragments, const std::string& fragment) {
    std::vector<fs::path> files;
    std::vector<std::string> folders{"starter/rt",    "solution",          "scenes",
                                     "grader/checks", "grader/statistics", "grader/child"};
    if (fragment.empty()) folders.emplace_back("grader/judging");
    for (const std::string& folder : folders)
        for (const auto& entry : fs::recursive_directory_iterator(source / folder)) {
            const fs::path& path = entry.path();
            const bool of_another = !fragment.empty() && folder == "grader/checks" && path.stem() != fragment &&
                                    std::ranges::count(fragments, path.stem().string()) > 0;
            if (is_source(path) && !of_another) files.push_back(path);
        }
    return Stamp().add_files(source, std::move(files)).text();
}

std::vector<Variant> chosen(std::vector<Variant> all, const std::vector<std::string>& words) {
    if (words.empty()) return all;
    std::erase_if(all, [&](const Variant& v) {
        return std::ranges::none_of(
            words, [&](const std::string& word) { return v.fragment == word || v.name.find(word) != v.name.npos; });
    });
    return all;
}

}  // namespace

Workshop::Workshop(const fs::path& toolchain, const fs::path& results, Amount amount,
                   const std::vector<std::string>& words)
    : chain_(read_toolchain(toolchain)),
      assignment_(assignment_of(chain_)),
      sandbox_(find_sandbox(true)),
      amount_(amount),
      results_(results),
      variants_(chosen(read_variants(chain_.source / "tests/variants"), words)),
      by_name_(!words.empty()) {
    // what is not asked is not graded
    std::erase_if(variants_, [&](const Variant& v) { return !assignment_.asked().contains(v.fragment); });
}

std::set<std::string> Workshop::fragments() const {
    std::set<std::string> names;
    if (by_name_)
        for (const Variant& variant : variants_) names.insert(variant.fragment);
    else
        for (const std::string& name : assignment_.names()) names.insert(name);
    return names;
}

fs::path Workshop::results(const std::string& fragment) const {
    const std::scoped_lock lock(lock_);
    fs::path& folder = folders_[fragment];
    if (folder.empty())
        folder = results_ / fmt::format("{}-{}", fragment.empty() ? "whole" : fragment,
                                        stamp(chain_.source, assignment_.names(), fragment));
    return folder;
}

std::vector<const Variant*> Workshop::variants(Variant::Kind kind) const {
    std::vector<const Variant*> list;
    for (const Variant& variant : variants_)
        if (variant.kind == kind) list.push_back(&variant);
    return list;
}

const std::vector<Check>& Workshop::checks(std::uint64_t seed) const {
    const std::scoped_lock lock(lock_);
    auto& list = checks_[seed];
    if (list.empty()) list = all_checks(seed);
    return list;
}

std::vector<const Check*> Workshop::checks(std::uint64_t seed, const std::string& fragment) const {
    std::vector<const Check*> list;
    for (const Check& check : checks(seed))
        if (check.fragment == fragment) list.push_back(&check);
    return list;
}

std::string Workshop::solution_text(const std::string& fragment) const {
    return read_text(chain_.source / "solution" / (fragment + ".cpp")).value();
}

fs::path Workshop::program(const std::string& name, const std::string& fragment, const std::string& text) const {
    const fs::path folder = results(fragment) / "programs" / name, program = folder / "child";
    if (fs::exists(program)) return program;
    fs::create_directories(folder);
    std::vector<fs::path> objects;
    for (const auto& [other, object] : chain_.solution_objects)
        if (other != fragment) objects.push_back(object);
    const TemporaryFolder work;
    if (!fragment.empty()) {
        const Compiled compiled = compile_fragment(chain_, sandbox_, fragment, text, name + ".cpp", work.path());
        if (!compiled.good) throw std::runtime_error(fmt::format("{} does not compile: {}", name, compiled.message));
        objects.push_back(compiled.object);
    }
    if (const auto errors = link_child(chain_, sandbox_, objects, folder / "linking"); !errors.empty())
        throw std::runtime_error(fmt::format("{} cannot be linked: {}", name, errors));
    fs::rename(folder / "linking", program);
    return program;
}

fs::path Workshop::program(const Variant& variant) const {
    return program(variant.name, variant.fragment, changed_text(variant, chain_.source));
}

fs::path Workshop::solution_program() const {
    static std::mutex one_at_a_time;
    const std::scoped_lock lock(one_at_a_time);
    return program("solution", "", "");
}

bool Step::is_done() const { return std::ranges::all_of(results, is_whole); }

void run_steps(const std::vector<Step>& steps, int shard, int shards, int jobs, const Progress::Listener& listener) {
    std::vector<const Step*> open;
    for (std::size_t i = 0; i < steps.size(); ++i)
        if (int(i % std::size_t(shards)) == shard && !steps[i].is_done()) open.push_back(&steps[i]);
    Progress progress(listener);
    progress.expect(Work::check, int(open.size()));
    in_parallel(int(open.size()), jobs, [&](int i) {
        const Step& step = *open[std::size_t(i)];
        progress.tell(step.name);
        step.run();
        progress.done(Work::check);
    });
}

}  // namespace grade::calibration
