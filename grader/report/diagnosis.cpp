#include "report/diagnosis.h"

#include <fmt/format.h>

#include <array>
#include <cctype>
#include <map>
#include <optional>
#include <stdexcept>
#include <tuple>

namespace grade {

namespace {

/// The smaller one is told first: by verdict, by kind of evidence, by family.
using Rank = std::tuple<int, int, Family>;

int rank_of(Verdict verdict) {
    switch (verdict) {
        case Verdict::did_not_build: return 0;
        case Verdict::not_started: return 1;
        case Verdict::crashed: return 2;
        case Verdict::timed_out: return 3;
        case Verdict::not_finite:
        case Verdict::failed: return 4;
        case Verdict::inconclusive: return 5;
        case Verdict::passed: break;
    }
    return 6;
}

Rank rank_of(Verdict verdict, const CheckRecord& check, Family family) {
    const bool is_picture = !check.scene.empty();
    const int evidence = family <= Family::no_image ? 0 : is_picture ? 2 : 1;
    return {rank_of(verdict), evidence, family};
}

std::string section_of(const std::string& fragment, Verdict verdict, const std::string& words) {
    switch (verdict) {
        case Verdict::passed: return {};
        case Verdict::crashed:
        case Verdict::timed_out:
        case Verdict::inconclusive: return std::string(verdicts_section);
        case Verdict::not_finite:
            return std::string(words.find("nan") != words.npos ? numbers_section : pictures_section);
        default: return fragment;
    }
}

}  // namespace

Family family_of(std::string_view id) {
    static const std::map<std::string_view, Family> families = {
        {"G1", Family::sharing},    {"M2", Family::sharing},    {"V0", Family::no_image},
        {"G4", Family::tone},       {"A1", Family::geometry},   {"A2", Family::geometry},
        {"L3", Family::geometry},   {"D1", Family::geometry},   {"D2", Family::geometry},
        {"D3", Family::geometry},   {"M1", Family::geometry},   {"M3", Family::geometry},
        {"P1", Family::geometry},   {"F4", Family::geometry},   {"W1", Family::geometry},
        {"W2", Family::geometry},   {"I1", Family::radiometry}, {"L1", Family::radiometry},
        {"L2", Family::factor},     {"L4", Family::radiometry}, {"P2", Family::radiometry},
        {"P3", Family::geometry},   {"P4", Family::radiometry}, {"F1", Family::radiometry},
        {"F2", Family::radiometry}, {"F3", Family::radiometry}, {"B1", Family::radiometry},
        {"W3", Family::radiometry}, {"G2", Family::variance},   {"G3", Family::variance},
        {"V1", Family::variance},   {"V3", Family::variance},   {"D4", Family::variance},
        {"M4", Family::variance}};
    const auto found = families.find(id);
    return found == families.end() ? Family::radiometry : found->second;  // a course's own
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

Diagnosis diagnose(const FragmentRecord& fragment) {
    if (!fragment.message.empty())
        return {fragment.message, section_of(fragment.name, fragment.verdict, fragment.message)};
    Diagnosis first;
    std::optional<Rank> best;
    const auto tell = [&](Rank rank, const std::string& words, const std::string& section) {
        if (words.empty() || (best && *best <= rank)) return;
        best = rank;
        first = {words, section};
    };
    for (const CheckRecord& check : fragment.checks) {
        if (check.verdict == Verdict::passed) continue;
        tell(rank_of(check.verdict, check, Family::no_image), check.message, section_of(check, nullptr));
        for (const StatisticRecord& statistic : check.statistics)
            if (statistic.verdict != Verdict::passed)
                tell(rank_of(statistic.verdict, check, family_of(statistic.id)), statistic.hint,
                     section_of(check, &statistic));
    }
    return first;
}

std::string reading(const std::string& section) {
    return section.empty() ? section : fmt::format("handout.md, \"{}\"", section);
}

std::string anchor(const std::string& section) {
    std::string text;
    for (const char c : section) {
        if (std::isalnum(static_cast<unsigned char>(c)) || c == '-' || c == '_')
            text += char(std::tolower(static_cast<unsigned char>(c)));
        else if (c == ' ') text += '-';
    }
    return text;
}

}  // namespace grade
