#include "diagnosis/diagnosis.h"

#include <fmt/format.h>

#include <cctype>
#include <map>
#include <optional>
#include <stdexcept>
#include <tuple>
#include <utility>

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

std::string section_of(const std::string& fragment, Verdict verdict, Trouble trouble) {
    switch (verdict) {
        case Verdict::passed:
            return {};
        case Verdict::inconclusive:
            return std::string(verdicts_section);
        case Verdict::not_finite:  // where a fragment's own 0/0 comes from is among its pitfalls
            return trouble == Trouble::not_a_number ? fragment : std::string(pictures_section);
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
        return std::string(check.trouble == Trouble::keeps_state ? rules_section : pictures_section);
    if (!statistic) return section_of(check.fragment, check.verdict, check.trouble);
    // a fragment that remembers, or makes its own numbers
    const bool keeps_state = statistic->verdict == Verdict::failed && statistic->id == "V0";
    return keeps_state ? std::string(rules_section) : section_of(check.fragment, statistic->verdict, Trouble::none);
}

namespace {

/// A hint, without the numbers that a finding says better, and what it is worth.
struct FirstHint {
    std::string words;
    StatisticRecord::Worth worth = StatisticRecord::Worth::guess;
    bool is_slow = false, is_changing = false;  // wrong answers may say why, or a variable without a value
    bool is_nan = false;                        // others may be wrong as well
    bool is_disputed = false;                   // another check knows another cause
};

/// Whether a message says all: a program that breaks down, what is no number, what changes.
bool is_sure(const CheckRecord& check) {
    return check.verdict == Verdict::not_finite || check.verdict == Verdict::crashed ||
           check.verdict == Verdict::timed_out || check.trouble == Trouble::keeps_state;
}

std::string example(const Finding& finding) {
    if (finding.arguments.empty()) return {};
    const std::string answer = fmt::format("For {} the answer is {}", finding.arguments, finding.answer);
    return finding.right.empty() ? answer : answer + ", must be " + finding.right;
}

/// What is wrong, where, the simplest call: a line each. What a deviation usually means is said only where nothing is
/// sure, not even a call.
std::string in_order(const FragmentRecord& fragment, const FirstHint& hint) {
    const Finding& finding = fragment.finding;
    // of causes of a few calls each, a mistake that explains all calls is the right one
    const bool is_of_few = hint.is_disputed && finding.has_name;
    const bool is_sure = hint.worth == StatisticRecord::Worth::cause && !is_of_few;
    const bool is_wrong_first = hint.is_slow && !finding.how.empty();
    const bool is_nan_alone = hint.is_nan && finding.of_nan;  // then the usual reasons of a nan say less
    std::string cause = (is_sure && !is_wrong_first && !is_nan_alone) || finding.how.empty() ? hint.words : finding.how;
    if (is_sure && !hint.is_nan && cause == hint.words && finding.line > 0 && !cause.empty() && cause.back() != '?')
        cause += fmt::format(": see line {}", finding.line);
    if (hint.is_changing && !finding.fault.empty()) cause.clear();
    if (finding.how.empty() && !finding.arguments.empty() && hint.worth == StatisticRecord::Worth::guess) cause.clear();
    std::string beside = hint.is_nan ? finding.of_numbers : "";
    // nan and all
    if (beside.starts_with("the fragment answers exactly") || beside.starts_with("with `"))
        cause = std::exchange(beside, "");
    // where no call shows it, and it has no name, what was measured does
    const bool is_shown =
        !finding.arguments.empty() || finding.by_textbook || hint.worth != StatisticRecord::Worth::fact;
    std::string text;
    for (const std::string& line : {cause, beside, is_shown || cause == hint.words ? "" : hint.words, finding.fault,
                                    finding.where, example(finding)})
        if (!line.empty()) text += (text.empty() ? "" : "\n") + line;
    return text;
}

}  // namespace

std::string tile_in_words(const Tiles& tiles, std::size_t tile) {
    const int left = int(tile) % tiles.columns * Tiles::side, top = int(tile) / tiles.columns * Tiles::side;
    return fmt::format("pixels {} to {} from the left and {} to {} from the top are {:.3g} bright, must be {:.3g}",
                       left, left + Tiles::side - 1, top, top + Tiles::side - 1, tiles.mine[tile], tiles.right[tile]);
}

Diagnosis diagnose(const FragmentRecord& fragment) {
    if (!fragment.message.empty())
        return {fragment.message, section_of(fragment.name, fragment.verdict, Trouble::none)};
    const Finding& finding = fragment.finding;
    const bool found = !finding.how.empty() || !finding.arguments.empty() || !finding.fault.empty();
    FirstHint first;
    std::string section;
    std::optional<Rank> best;
    std::string picture;  // where the picture of the first hint is wrong
    const auto tell = [&](Rank rank, const FirstHint& hint, const std::string& where_to_read, const Tiles& tiles) {
        const bool are_causes = hint.worth == StatisticRecord::Worth::cause && first.worth == hint.worth;
        if (best && *best == rank && are_causes && hint.words != first.words) first.is_disputed = true;
        if (best && *best <= rank) return;
        best = rank, first = hint, section = where_to_read;
        picture = tiles.empty() ? "" : tile_in_words(tiles, tiles.clearest());
    };
    for (const CheckRecord& check : fragment.checks) {
        if (check.verdict == Verdict::passed) continue;
        if (!check.message.empty())
            tell(rank_of(check.verdict, check, Subject::no_image),
                 {check.message, is_sure(check) ? StatisticRecord::Worth::cause : StatisticRecord::Worth::fact,
                  check.verdict == Verdict::timed_out, check.trouble == Trouble::keeps_state,
                  check.verdict == Verdict::not_finite},
                 section_of(check, nullptr), {});
        for (const StatisticRecord& statistic : check.statistics)
            if (statistic.verdict != Verdict::passed && !statistic.hint.empty())
                tell(rank_of(statistic.verdict, check, known_subject(statistic.id).value_or(Subject::radiometry)),
                     {found ? statistic.without_numbers : statistic.hint, statistic.worth},
                     section_of(check, &statistic), check.tiles);
    }
    if (!fragment.said.empty()) return {fragment.said, section};
    if (fragment.warnings.find("[-Wreturn-type]") != std::string::npos)  // its answers say nothing
        return {"not every way through it ends with `return`: what its answer is then, is chance", fragment.name};
    if (!found && !picture.empty()) return {first.words + "\nMost clearly, " + picture, section};
    if (!found) return {first.words, section};
    // what a picture looks like follows from answers that are wrong
    return {in_order(fragment, first), section == pictures_section ? fragment.name : section};
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
