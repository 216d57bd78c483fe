#pragma once

#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <set>
#include <string>

#include "files/files.h"
#include "programs/kept.h"
#include "programs/progress.h"
#include "programs/sandbox.h"
#include "programs/toolchain.h"
#include "statistics/verdict.h"
#include "submission/submission.h"

namespace grade {

/// How a submission's fragments are compiled and linked.
struct BuildSettings {
    int jobs = 0;               // at a time; 0: one for each core
    bool trusted = false;       // limits, but no sandbox
    bool only_changed = false;  // what is the solution's word for word is not compiled again
    fs::path keep;              // where objects and programs stay; empty: nowhere
    Kept kept;                  // objects of an earlier run, and for the next
};

/// A submission's fragments, compiled one by one, and programs with any of them. A fragment that has not been compiled,
/// or not for good, is in no program.
class Programs {
public:
    /// Why a fragment is in no program.
    struct Problem {
        Verdict verdict;  // not_started or did_not_build
        std::string message;
        Trouble trouble = Trouble::none;
    };

    /// Who stands in for the fragments that a program does not have from the submission.
    enum class Others { solution, blanks };

    struct Linked {
        fs::path program;
        std::string errors;  // empty: it is there
    };

    /// Throws std::runtime_error where the machine fails, as do all that follow.
    Programs(const Submission& submission, const Toolchain& chain, const BuildSettings& settings, Progress& progress);

    /// How many of these compile() would compile.
    int to_compile(const std::set<std::string>& fragments) const;

    /// Compiles these. What does not compile, or is a blank, is a problem of that fragment only.
    void compile(const std::set<std::string>& fragments);

    const std::string& submission() const { return submission_.name; }
    const std::map<std::string, std::string>& texts() const { return submission_.texts; }  // by fragment
    std::string file_of(const std::string& fragment) const { return submission_.folder + fragment + ".cpp"; }
    const Sandbox& sandbox() const { return sandbox_; }
    const Kept& kept() const { return settings_.kept; }
    const std::map<std::string, Problem>& problems() const { return problems_; }
    std::string complaint(const std::string& fragment) const;  // of its problem; empty: none
    bool has(const std::string& fragment) const { return objects_.contains(fragment); }
    std::set<std::string> all() const;                               // those that are compiled
    std::set<std::string> names() const;                             // of all fragments that there can be
    const std::string& warnings(const std::string& fragment) const;  // of the compiler, a line each
    const std::string& text(const std::string& fragment) const { return submission_.texts.at(fragment); }

    /// The program with these fragments of the submission; made once. With none of them: the solution's.
    const Linked& with(const std::set<std::string>& fragments, Others others = Others::solution);

    /// The program with this fragment of the submission, compiled with sanitizers. None: there are none here, or it
    /// does not link.
    std::optional<fs::path> checked(const std::string& fragment) const;

    /// The program with this fragment compiled from another text. None: it does not compile.
    ///
    /// how  names the text: one of another name stays as it is
    std::optional<fs::path> with_text(const std::string& fragment, const std::string& text,
                                      const std::string& how) const;

    /// The text of a fragment with its own macros put in. None: the preprocessor cannot.
    std::optional<std::string> preprocessed(const std::string& fragment) const;

    /// The program with these. Throws SubmissionError with the first errors where they do not go together.
    fs::path must_link(const std::set<std::string>& fragments, Others others = Others::solution);

    /// The submission's own program: all of its fragments but these, blanks for the others. Those that do not link even
    /// alone are left out.
    fs::path own_without(const std::set<std::string>& fragments);

    /// The fragment does not link with the solution's others.
    void fails(const std::string& fragment, const std::string& message);

    /// A program in a new folder of its own, to which it may write.
    fs::path copy_for(const std::string& name, const fs::path& program) const;

private:
    struct Entry {
        std::once_flag once;
        Linked linked;
    };

    fs::path folder(const std::string& name) const;
    bool is_filled(const std::string& fragment) const;
    std::optional<fs::path> compiled_again(const Toolchain& chain, const std::string& fragment, const std::string& text,
                                           const std::string& how) const;

    const Submission submission_;
    const Toolchain& chain_;
    BuildSettings settings_;
    Progress& progress_;
    TemporaryFolder temporary_;
    fs::path work_;
    Sandbox sandbox_;
    std::map<std::string, Problem> problems_;
    std::map<std::string, fs::path> objects_;  // by fragment
    std::map<std::string, std::string> warnings_;
    std::map<std::pair<Others, std::set<std::string>>, std::unique_ptr<Entry>> linked_;
    mutable std::mutex lock_;
};

}  // namespace grade
