#include "calibration/fast.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <map>

#include "calibration/real.h"
#include "calibration/results.h"

namespace grade::calibration {

namespace {

struct Counts {
    int variants = 0, off = 0, named = 0, asked = 0;
    int gradings = 0, other_verdicts = 0, other_points = 0;
};

/// Words without line breaks, cut where they are long.
std::string one_line(std::string words) {
    std::ranges::replace(words, '\n', ' ');
    return words.substr(0, 150);
}

/// "passed under 7 and 9, 0.5 points under 12", of the seeds that say other than most.
template <class Value>
std::string others(const std::vector<Value>& values, const std::string& unit, int& count) {
    std::map<Value, std::vector<int>> seeds;
    for (std::size_t i = 0; i < values.size(); ++i) seeds[values[i]].push_back(int(i) + 1);
    const auto most = std::ranges::max_element(seeds, {}, [](const auto& entry) { return entry.second.size(); });
    std::string words;
    for (const auto& [value, list] : seeds) {
        if (value == most->first) continue;
        count += int(list.size());
        words += fmt::format("{}{}{} under {}", words.empty() ? "" : ", ", value, unit, fmt::join(list, " "));
    }
    return words;
}

void tell(const Variant& variant, bool is_wrong, const std::vector<RealVerdict>& verdicts, Counts& counts) {
    const RealVerdict& first = verdicts.front();
    const auto is_good = [&](const RealVerdict& v) {
        return is_wrong ? is_found(v.verdict) : v.verdict == Verdict::passed;
    };
    const bool asks = is_wrong && !variant.says.empty(), says = !asks || says_one_of(first.message, variant.says);
    const bool good = std::ranges::all_of(verdicts, is_good);
    ++counts.variants, counts.off += !good, counts.asked += asks, counts.named += asks && says;
    fmt::print("{} {:<46} {:<22} {:<12} {}{}\n", good ? "ok " : "OFF", variant.name, first.fragment,
               name(first.verdict), says ? "" : "[cause not named] ", one_line(first.message));
    std::vector<std::string> words;
    std::vector<double> points;
    for (const RealVerdict& v : verdicts) words.emplace_back(name(v.verdict)), points.push_back(v.points);
    counts.gradings += int(verdicts.size());
    for (const std::string& said :
         {others(words, "", counts.other_verdicts), others(points, " points", counts.other_points)})
        if (!said.empty()) fmt::print("    {}\n", said);
    std::fflush(stdout);
}

}  // namespace

bool grade_fast(const Workshop& workshop, bool by_name, int seeds, int jobs) {
    auto wrong = workshop.variants(Variant::Kind::wrong);
    if (!by_name) {
        std::set<std::string> seen;
        std::erase_if(wrong, [&](const Variant* v) { return !seen.insert(v->fragment).second; });
    }
    Counts counts;
    for (const auto& [list, is_wrong] :
         {std::pair(wrong, true), std::pair(workshop.variants(Variant::Kind::right), false)})
        for (const Bundle& bundle : bundles(list, "", false)) {
            std::set<std::string> only;
            for (const Variant* variant : bundle.variants) only.insert(variant->fragment);
            const auto gradings =
                grade_changed(workshop, changed_texts(bundle, workshop), seeds_from_1(seeds), only, jobs, 1);
            for (std::size_t i = 0; i < gradings.front().fragments.size(); ++i) {
                std::vector<RealVerdict> verdicts;
                for (const RealGrading& grading : gradings) verdicts.push_back(grading.fragments.at(i));
                const auto variant = std::ranges::find(bundle.variants, verdicts.front().fragment, &Variant::fragment);
                tell(**variant, is_wrong, verdicts, counts);
            }
        }
    fmt::print("{} gradings of variants, {} off; cause named in {} of {}\n", counts.variants, counts.off, counts.named,
               counts.asked);
    if (seeds > 1)
        fmt::print("{} (variant, seed): {} have another verdict than most seeds give that variant, {} other points\n",
                   counts.gradings, counts.other_verdicts, counts.other_points);
    return counts.off == 0;
}

}  // namespace grade::calibration
