#include "diagnosis/diagnosis.h"

#include <fmt/format.h>

#include <array>
#include <cctype>
#include <map>
#include <optional>
#include <stdexcept>
#include <tuple>

namespace grade {

namespace {

/// The smaller one is told first: by verdict, by kind of evidence, by subject.
using Rank = std::tuple<int, int, Subject>;

int rank_of(Verdict verdict) {
    switch (verdict) {
        case Verdict::did_not_build:
            return 0;
        case Verdict::not_started:
            return 1;
        case Verdict::crashed:
            return 2;
        case Verdict::timed_out:
            return 3;
        case Verdict::not_finite:
        case Verdict::failed:
            return 4;
        case Verdict::inconclusive:
            return 5;
        case Verdict::passed:
            break;
    }
    return 6;
}

Rank rank_of(Verdict verdict, const CheckRecord& check, Subject subject) {
    const bool is_picture = !check.scene.empty();
    const int evidence = subject <= Subject::no_image ? 0 : is_picture ? 2 : 1;
    return {rank_of(verdict), evidence, subject};
}

std::string section_of(const std::string& fragment, Verdict verdict, const std::string& words) {
    switch (verdict) {
        case Verdict::passed:
            return {};
        case Verdict::crashed:
        case Verdict::timed_out:
        case Verdict::inconclusive:
            return std::string(verdicts_section);
        case Verdict::not_finite:
            return std::string(words.find("nan") != words.npos ? numbers_section : pictures_section);
        default:
            return fragment;
    }
}

std::optional<Subject> known_subject(std::string_view id) {
    static const std::map<std::string_view, Subject> subjects = {
        {"G1", Subject::sharing},    {"M2", Subject::sharing},    {"V0", Subject::no_image},
        {"G4", Subject::tone},       {"A1", Subject::geometry},   {"A2", Subject::geometry},
        {"L3", Subject::geometry},   {"D1", Subject::geometry},   {"D2", Subject::geometry},
        {"D3", Subject::geometry},   {"M1", Subject::geometry},   {"M3", Subject::geometry},
        {"P1", Subject::geometry},   {"F4", Subject::geometry},   {"W1", Subject::geometry},
        {"W2", Subject::geometry},   {"I1", Subject::radiometry}, {"L1", Subject::radiometry},
        {"L2", Subject::factor},     {"L4", Subject::radiometry}, {"P2", Subject::radiometry},
        {"P3", Subject::geometry},   {"P4", Subject::radiometry}, {"F1", Subject::radiometry},
        {"F2", Subject::radiometry}, {"F3", Subject::radiometry}, {"B1", Subject::radiometry},
        {"W3", Subject::radiometry}, {"G2", Subject::variance},   {"G3", Subject::variance},
        {"V1", Subject::variance},   {"V3", Subject::variance},   {"D4", Subject::variance},
        {"M4", Subject::variance}};
    const auto found = subjects.find(id);
    return found == subjects.end() ? std::nullopt : std::optional(found->second);
}

}  // namespace

Subject subject_of(std::string_view id) {
    if (const auto subject = known_subject(id)) return *subject;
    throw std::out_of_range(fmt::format("{}: no statistic has this id", id));
}

std::string section_of(const CheckRecord& check, const StatisticRecord* statistic) {
    // what is no statistic's: no picture of radiance, or a fragment that remembers
    if (!statistic && check.verdict == Verdict::failed)
        return std::string(check.message.find("again") != check.message.npos ? rules_section : pictures_section);
    if (!statistic) return section_of(check.fragment, check.verdict, check.message);
    // a fragment that remembers, or makes its own numbers
    const bool keeps_state = statistic->verdict == Verdict::failed && statistic->id == "V0";
    return keeps_state ? std::string(rules_section) : section_of(check.fragment, statistic->verdict, statistic->hint);
}

namespace {

/// A hint, and whether it is sure: a suspect whose outputs are those of every call, or what is no number or changes,
/// not what a deviation usually means.
struct FirstHint {
    std::string words;
    bool is_sure = false;
};

constexpr std::string_view bare = " calls are wrong; for arguments ";

/// Without the numbers that a finding says better.
FirstHint without_numbers(const StatisticRecord& statistic) {
    const std::size_t numbers = statistic.hint.find(bare);
    const auto has = [&](const char* words) { return statistic.hint.find(words) != statistic.hint.npos; };
    if (numbers == statistic.hint.npos)
        return {statistic.hint,
                statistic.exact && !has("(off by") && !has(" times what it must be") && !has("off by up to")};
    const std::size_t end = statistic.hint.rfind(": ", numbers);
    return {end == statistic.hint.npos ? "" : statistic.hint.substr(0, end), false};
}

std::string example(const Finding& finding) {
    if (finding.arguments.empty()) return {};
    return fmt::format("For {} the answer is {}, must be {}", finding.arguments, finding.answer, finding.right);
}

/// What is wrong, where, the simplest call: a line each.
std::string in_order(const FragmentRecord& fragment, const FirstHint& hint) {
    const Finding& finding = fragment.finding;
    const std::string cause = hint.is_sure || finding.how.empty() ? hint.words : finding.how;
    std::string text;
    for (const std::string& line : {cause, finding.where, example(finding)})
        if (!line.empty()) text += (text.empty() ? "" : "\n") + line;
    return text;
}

}  // namespace

Diagnosis diagnose(const FragmentRecord& fragment) {
    if (!fragment.message.empty())
        return {fragment.message, section_of(fragment.name, fragment.verdict, fragment.message)};
    const bool found = !fragment.finding.how.empty() || !fragment.finding.arguments.empty();
    FirstHint first;
    std::string section;
    std::optional<Rank> best;
    const auto tell = [&](Rank rank, const FirstHint& hint, const std::string& where_to_read) {
        if (best && *best <= rank) return;
        best = rank, first = hint, section = where_to_read;
    };
    for (const CheckRecord& check : fragment.checks) {
        if (check.verdict == Verdict::passed) continue;
        if (!check.message.empty())
            tell(rank_of(check.verdict, check, Subject::no_image),
                 {check.message,
                  check.verdict == Verdict::not_finite || check.message.find("again") != check.message.npos},
                 section_of(check, nullptr));
        for (const StatisticRecord& statistic : check.statistics)
            if (statistic.verdict != Verdict::passed && !statistic.hint.empty())
                tell(rank_of(statistic.verdict, check, known_subject(statistic.id).value_or(Subject::radiometry)),
                     found ? without_numbers(statistic) : FirstHint{statistic.hint}, section_of(check, &statistic));
    }
    if (!found) return {first.words, section};
    return {in_order(fragment, first), section};
}

std::string reading(const std::string& section) {
    return section.empty() ? section : fmt::format("handout.md, \"{}\"", section);
}

std::string anchor(const std::string& section) {
    std::string text;
    for (const char c : section) {
        if (std::isalnum(static_cast<unsigned char>(c)) || c == '-' || c == '_')
            text += char(std::tolower(static_cast<unsigned char>(c)));
        else if (c == ' ')
            text += '-';
    }
    return text;
}

std::string first_message(const FragmentRecord& fragment) { return diagnose(fragment).words; }

}  // namespace grade
