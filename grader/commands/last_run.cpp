#include "commands/last_run.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <optional>

#include "files/files.h"
#include "report/terminal.h"

namespace grade {

namespace {

/// "passed, was failed (+3 points)", "still failed, but 1.5 points more"
std::string change_in_words(const std::string& was, const std::string& verdict, double gained) {
    const std::string points = std::abs(gained) == 1 ? "point" : "points";
    if (was == verdict)
        return gained > 0 ? fmt::format("still {}, but {:g} {} more", verdict, gained, points)
                          : fmt::format("{} as before, {:g} {} less", verdict, -gained, points);
    return fmt::format("{}, was {}{}", verdict, was, gained != 0 ? fmt::format(" ({:+g} {})", gained, points) : "");
}

using Json = nlohmann::ordered_json;

/// What is kept of the last run, by fragment.
Json last_of(const std::filesystem::path& file) {
    Json last = Json::parse(read_text(file).value_or(""), nullptr, false);
    return last.is_object() ? last : Json::object();
}

/// A word that is kept of a fragment; none: nothing is kept of it.
std::optional<std::string> kept(const Json& last, const std::string& fragment, const char* key) {
    const auto found = last.find(fragment);
    if (found == last.end() || !found->is_object()) return std::nullopt;
    return found->value(key, "");
}

std::string to_do(bool is_blank, const std::string& folder, const std::string& name) {
    return fmt::format("next: {} {}{}.cpp, then ./grade {}", is_blank ? "fill in" : "mend", folder, name, name);
}

}  // namespace

void compare_with_last(Record& record, const std::filesystem::path& file) {
    Json last = last_of(file);
    constexpr std::size_t most = 8;
    std::vector<std::pair<double, std::string>> changes;  // points gained, in words
    double all_gained = 0;
    for (const FragmentRecord& fragment : record.fragments) {
        const std::string verdict = in_words(fragment.verdict);
        const std::string was = kept(last, fragment.name, "verdict").value_or("");
        Json& before = last[fragment.name];
        if (!was.empty()) {
            const double gained = fragment.points - before.value("points", 0.0);
            if (gained != 0 || was != verdict)
                changes.emplace_back(gained, fragment.name + ": " + change_in_words(was, verdict, gained));
            all_gained += gained;
        }
        const Finding& finding = fragment.finding;
        before = {{"verdict", verdict},
                  {"points", fragment.points},
                  {"call", finding.command.empty() ? "" : finding.arguments}};
    }
    std::ranges::stable_sort(changes, {}, [](const auto& change) { return change.first >= 0; });
    for (std::size_t i = 0; i < std::min(changes.size(), most); ++i) record.changes.push_back(changes[i].second);
    if (changes.size() > most)
        record.changes.push_back(fmt::format("and {} more; {:+g} points in all", changes.size() - most, all_gained));
    write_text(file, last.dump(1) + "\n");
}

std::string next_step(const Record& record, const std::vector<std::string>& names, const std::filesystem::path& file,
                      const std::string& folder) {
    for (const bool is_blank : {false, true})  // what is begun comes first
        for (const FragmentRecord& fragment : record.fragments)
            if (fragment.verdict != Verdict::passed && is_blank == (fragment.verdict == Verdict::not_started))
                return to_do(is_blank, folder, fragment.name);
    if (record.fragments.empty()) return {};
    const Json last = last_of(file);
    const auto begin = std::ranges::find(names, record.fragments.back().name);
    const auto first = std::size_t(begin - names.begin());
    for (const bool is_blank : {false, true})
        for (std::size_t k = 1; k < names.size(); ++k) {
            const std::string& name = names[(first + k) % names.size()];
            const std::string verdict = kept(last, name, "verdict").value_or(in_words(Verdict::not_started));
            if (verdict != in_words(Verdict::passed) && is_blank == (verdict == in_words(Verdict::not_started)))
                return to_do(is_blank, folder, name);
        }
    return {};
}

std::string last_call(const std::filesystem::path& file, const std::string& fragment) {
    return kept(last_of(file), fragment, "call").value_or("");
}

}  // namespace grade
