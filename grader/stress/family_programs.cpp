#include "stress/family_programs.h"

#include <fmt/format.h>

#include <stdexcept>
#include <vector>

#include "build/code_only.h"
#include "judging/parallel.h"

namespace grade {

FamilyPrograms::FamilyPrograms(const Submission& submission, const Toolchain& chain, const Sandbox& sandbox,
                               bool student)
    : submission_(submission), chain_(chain), sandbox_(sandbox), student_(student) {}

void FamilyPrograms::compile(const std::set<std::string>& fragments, int jobs) {
    std::vector<std::pair<std::string, const std::string*>> sources;
    for (const std::string& name : fragments) {
        const std::string file = name + ".cpp";
        const auto text = submission_.texts.find(name);
        const auto complaint = submission_.complaints.find(name);
        if (complaint != submission_.complaints.end()) complaints_[name] = file + " is " + complaint->second;
        else if (text == submission_.texts.end()) complaints_[name] = file + " is not in the submission";
        else if (is_blank(text->second, chain_.blanks / file)) complaints_[name] = "not started";
        else if (const auto mine = chain_.solution_objects.find(name);
                 mine != chain_.solution_objects.end() && read_text(chain_.source / "solution" / file) == text->second)
            own_[name] = mine->second;
        else sources.emplace_back(name, &text->second);
    }
    in_parallel(int(sources.size()), jobs, [&](int i) {
        const auto& [name, text] = sources[std::size_t(i)];
        const fs::path folder = work_.path() / "objects" / name;
        fs::create_directories(folder);
        const Compiled compiled =
            compile_fragment(chain_, sandbox_, name, *text, submission_.folder + name + ".cpp", folder);
        const std::scoped_lock lock(lock_);
        if (compiled.good) own_[name] = compiled.object;
        else complaints_[name] = "did not build: " + compiled.message;
    });
}

std::string FamilyPrograms::complaint(const std::string& fragment) const {
    const auto found = complaints_.find(fragment);
    return found == complaints_.end() ? "" : found->second;
}

fs::path FamilyPrograms::with(const std::set<std::string>& fragments) {
    const std::scoped_lock lock(lock_);
    // in student mode all that is there; else what differs from the solution
    std::set<std::string> own;
    for (const auto& [name, object] : own_) {
        const auto mine = chain_.solution_objects.find(name);
        const bool same = mine != chain_.solution_objects.end() && mine->second == object;
        if (student_ || (fragments.contains(name) && !same)) own.insert(name);
    }
    const auto found = linked_.find(own);
    if (found != linked_.end()) return found->second;

    const auto& others = student_ ? chain_.blank_objects : chain_.solution_objects;
    std::vector<fs::path> objects;
    for (const auto& [name, symbol] : chain_.symbols) {
        if (own.contains(name)) objects.push_back(own_.at(name));
        else if (const auto other = others.find(name); other != others.end()) objects.push_back(other->second);
    }
    const fs::path folder = work_.path() / fmt::format("program{}", linked_.size());
    fs::create_directories(folder);
    const fs::path program = folder / "child";
    if (const auto errors = link_child(chain_, objects, program); !errors.empty())
        throw std::runtime_error("the fragments cannot be linked: " + errors);
    return linked_[own] = program;
}

fs::path FamilyPrograms::copy_for(const std::string& name, const fs::path& program) const {
    const fs::path folder = work_.path() / "runs" / name;
    fs::remove_all(folder);
    fs::create_directories(folder);
    fs::create_hard_link(program, folder / "child");
    return folder / "child";
}

}  // namespace grade
