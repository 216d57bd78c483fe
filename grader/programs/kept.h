#pragma once

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>

#include "files/files.h"
#include "files/stamp.h"
#include "programs/toolchain.h"
#include "record/record.h"

namespace grade {

/// A picture that a program was asked for.
struct Drawn {
    rt::Image image;
    std::string fault;   // why there is none; empty: there is one
    double seconds = 0;  // CPU time of rendering alone; 0: it was drawn before
};

/// What one grading of the same folder leaves for the next: the objects of fragments, and the records of checks. Each
/// is found again under a hash of all that it was made from, and of the grader itself.
class Kept {
public:
    /// Keeps nothing and finds nothing.
    Kept() = default;

    /// Throws std::runtime_error where the folder cannot be made.
    ///
    /// finds  whether what is there is found; else it is only kept for the next
    Kept(const fs::path& folder, const Toolchain& chain, bool finds = true);

    /// The object that was compiled from this text, what the compiler said, and where it goes for the next grading.
    std::optional<fs::path> object(const std::string& fragment, const std::string& text) const;
    std::string warnings(const std::string& fragment, const std::string& text) const;
    void keep_object(const std::string& fragment, const std::string& text, const fs::path& object,
                     const std::string& warnings) const;

    /// A check's record. made_from: settings and sources.
    std::optional<CheckRecord> check(const std::string& key, const std::string& made_from) const;

    /// What calls of a fragment show.
    std::optional<Finding> finding(const std::string& key, const std::string& made_from) const;
    void keep_finding(const std::string& key, const std::string& made_from, const Finding& finding) const;

    /// A picture; made_from: all that it depends on beside the framework.
    std::optional<Drawn> drawn(const std::string& name, const std::string& made_from) const;
    void keep_drawn(const std::string& name, const std::string& made_from, const Drawn& drawn) const;

    /// Only verdicts that do not depend on how busy the machine is.
    void keep_check(const std::string& key, const std::string& made_from, const CheckRecord& record) const;

private:
    template <class Value>
    std::optional<Value> read(const std::string& name, const std::string& made_from,
                              Value (*from)(const nlohmann::ordered_json&)) const;
    void write(const std::string& name, const std::string& made_from, const nlohmann::ordered_json& json) const;
    fs::path path(const std::string& name, const std::string& made_from) const;

    fs::path folder_;  // empty: nothing is kept
    bool finds_ = false;
    Stamp framework_;
};

}  // namespace grade
