#include "commands/last_run.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

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

std::string to_do(bool is_blank, const std::string& folder, const std::string& name) {
    return fmt::format("next: {} {}{}.cpp, then ./grade {}", is_blank ? "fill in" : "mend", folder, name, name);
}

}  // namespace

void compare_with_last(Record& record, const std::filesystem::path& file) {
    auto last = nlohmann::ordered_json::parse(read_text(file).value_or(""), nullptr, false);
    if (!last.is_object()) last = nlohmann::ordered_json::object();
    constexpr std::size_t most = 8;
    std::vector<std::pair<double, std::string>> changes;  // points gained, in words
    double all_gained = 0;
    for (const FragmentRecord& fragment : record.fragments) {
        auto& before = last[fragment.name];
        const std::string verdict = in_words(fragment.verdict);
        if (before.is_object() && !before.value("verdict", "").empty()) {
            const double gained = fragment.points - before.value("points", 0.0);
            const std::string was = before.value("verdict", "");
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
    for (const FragmentRecord& fragment : record.fragments)
        if (fragment.verdict != Verdict::passed)
            return to_do(fragment.verdict == Verdict::not_started, folder, fragment.name);
    if (record.fragments.empty()) return {};
    const auto last = nlohmann::json::parse(read_text(file).value_or(""), nullptr, false);
    const auto begin = std::ranges::find(names, record.fragments.back().name);
    const auto first = std::size_t(begin - names.begin());
    for (std::size_t k = 1; k < names.size(); ++k) {
        const std::string& name = names[(first + k) % names.size()];
        const bool is_known = last.is_object() && last.contains(name) && last[name].is_object();
        const std::string verdict = is_known ? last[name].value("verdict", "") : in_words(Verdict::not_started);
        if (verdict != in_words(Verdict::passed)) return to_do(verdict == in_words(Verdict::not_started), folder, name);
    }
    return {};
}

std::string last_call(const std::filesystem::path& file, const std::string& fragment) {
    const auto last = nlohmann::json::parse(read_text(file).value_or(""), nullptr, false);
    const bool is_known = last.is_object() && last.contains(fragment) && last[fragment].is_object();
    return is_known ? last[fragment].value("call", "") : "";
}

}  // namespace grade
