#include "calibration/real.h"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "diagnosis/diagnosis.h"
#include "files/files.h"
#include "files/stamp.h"
#include "files/words.h"
#include "judging/grading.h"
#include "judging/run_check.h"
#include "report/json.h"

namespace grade::calibration {

namespace {

/// Of the record without what depends on time and load.
std::string timeless_hash(const Record& record) { return Stamp().add(timeless_json(record)).text(); }

/// Whether a statistic that fails knows its cause by itself.
bool has_suspect(const FragmentRecord& fragment) {
    for (const CheckRecord& check : fragment.checks)
        for (const StatisticRecord& statistic : check.statistics)
            if (statistic.verdict == Verdict::failed && statistic.worth == StatisticRecord::Worth::cause) return true;
    return false;
}

RealVerdict verdict_on(const FragmentRecord& fragment) {
    RealVerdict verdict{fragment.name, fragment.verdict, first_message(fragment), fragment.points,
                        fragment.cpu_seconds};
    if (!is_found(fragment.verdict)) return verdict;
    const Finding& finding = fragment.finding;
    verdict.by_arguments = finding.by_arguments, verdict.by_textbook = finding.by_textbook;
    verdict.by_repair = finding.by_repair;
    verdict.by_suspect = has_suspect(fragment);
    verdict.is_bare = finding.how.empty() && !finding.says_which && finding.fault.empty() &&
                      !finding.arguments.empty() && !verdict.by_suspect;
    verdict.diagnosis_seconds = finding.cpu_seconds;
    return verdict;
}

}  // namespace

std::vector<Bundle> bundles(const std::vector<const Variant*>& variants, const std::string& name, bool alternate) {
    std::map<std::string, std::vector<const Variant*>> waiting;
    for (const Variant* variant : variants) waiting[variant->fragment].push_back(variant);
    std::vector<Bundle> all;
    for (std::size_t turn = 0; !waiting.empty(); ++turn) {
        Bundle bundle{fmt::format("{}-{}", name, all.size()), {}};
        std::size_t place = 0;
        for (auto& [fragment, list] : waiting)
            if (!alternate || place++ % 2 == turn % 2)
                bundle.variants.push_back(list.front()), list.erase(list.begin());
        std::erase_if(waiting, [](const auto& entry) { return entry.second.empty(); });
        // results are kept by name: another choice of variants must not find those of this one
        Stamp names;
        for (const Variant* variant : bundle.variants) names.add(variant->name);
        bundle.name += "-" + names.text().substr(0, 4);
        if (!bundle.variants.empty()) all.push_back(std::move(bundle));
    }
    return all;
}

std::map<std::string, std::string> changed_texts(const Bundle& bundle, const Workshop& workshop) {
    std::map<std::string, std::string> texts;
    for (const Variant* variant : bundle.variants)
        texts[variant->fragment] = changed_text(*variant, workshop.chain().source);
    return texts;
}

std::vector<RealGrading> grade_changed(const Workshop& workshop, const std::map<std::string, std::string>& changed,
                                       const std::vector<std::uint64_t>& seeds, const std::set<std::string>& only,
                                       int jobs, std::size_t explained) {
    Submission submission{.name = "calibration"};
    for (const std::string& name : workshop.assignment().names())
        submission.texts[name] = changed.contains(name) ? changed.at(name) : workshop.solution_text(name);
    GradingSettings settings;
    settings.only = only;
    settings.build.jobs = jobs;
    settings.build.trusted = true;
    Progress silent({});
    Programs programs(submission, workshop.chain(), settings.build, silent);

    std::vector<RealGrading> gradings;
    for (const std::uint64_t seed : seeds) {
        settings.seed = seed;
        settings.explains = gradings.size() < explained;
        const auto& checks = workshop.checks(seed);
        settings.statistics = noisy_statistics(checks);
        const Record record =
            grade_programs(programs, workshop.assignment(), workshop.chain(), ready(checks), settings, silent);
        RealGrading grading;
        for (const FragmentRecord& fragment : record.fragments) grading.fragments.push_back(verdict_on(fragment));
        grading.record = timeless_hash(record);
        gradings.push_back(std::move(grading));
    }
    return gradings;
}

void write_grading(const fs::path& path, const RealGrading& grading) {
    nlohmann::ordered_json json;
    json["record"] = grading.record;
    for (const RealVerdict& f : grading.fragments)
        json["fragments"].push_back({{"name", f.fragment},
                                     {"verdict", name(f.verdict)},
                                     {"message", f.message},
                                     {"points", f.points},
                                     {"cpu_seconds", f.cpu_seconds},
                                     {"by_arguments", f.by_arguments},
                                     {"by_textbook", f.by_textbook},
                                     {"by_repair", f.by_repair},
                                     {"by_suspect", f.by_suspect},
                                     {"is_bare", f.is_bare},
                                     {"diagnosis_seconds", f.diagnosis_seconds}});
    fs::create_directories(path.parent_path());
    write_text(path, json.dump(1, ' ', false, nlohmann::json::error_handler_t::replace) + "\n");
}

std::optional<RealGrading> read_grading(const fs::path& path) {
    const auto text = read_text(path);
    if (!text) return std::nullopt;
    const auto json = nlohmann::json::parse(*text);
    RealGrading grading{{}, json.at("record")};
    // of a fragment that an earlier grader has graded, nothing is known of its diagnosis
    for (const auto& f : json.at("fragments"))
        grading.fragments.push_back(
            {f.at("name"), verdict_named(f.at("verdict")), f.at("message"), f.value("points", 0.0), f.at("cpu_seconds"),
             f.value("by_arguments", false), f.value("by_textbook", false), f.value("by_repair", false),
             f.value("by_suspect", false), f.value("is_bare", false), f.value("diagnosis_seconds", 0.0)});
    return grading;
}

Verdict verdict_named(const std::string& text) {
    const auto found = std::ranges::find(verdict_names, text);
    return found == verdict_names.end() ? Verdict::inconclusive : static_cast<Verdict>(found - verdict_names.begin());
}

bool is_found(Verdict verdict) {
    return verdict == Verdict::failed || verdict == Verdict::not_finite || verdict == Verdict::crashed ||
           verdict == Verdict::timed_out;
}

bool says_one_of(const std::string& message, const std::vector<std::string>& words) {
    const std::string text = lower(message);
    return std::ranges::any_of(words, [&](const std::string& word) { return text.find(lower(word)) != text.npos; });
}

}  // namespace grade::calibration
