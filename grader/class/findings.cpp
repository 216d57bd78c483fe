#include "class/findings.h"

#include <algorithm>
#include <cctype>
#include <map>

#include "diagnosis/diagnosis.h"

namespace grade::course {

namespace {

/// A text of fewer tokens than this is written alike by many.
constexpr int fewest_tokens = 60;
constexpr std::size_t most_sharers = 3;

/// The first line, each number as #: what is off by 2.01 and by 1.98 is off in the same way.
std::string kind_of(const std::string& words) {
    std::string kind;
    for (const char c : words.substr(0, words.find('\n'))) {
        const bool number = std::isdigit(static_cast<unsigned char>(c)) != 0;
        if (!number && !(c == '.' && kind.ends_with('#')))
            kind += c;
        else if (!kind.ends_with('#'))
            kind += '#';
    }
    return kind;
}

}  // namespace

std::vector<Mistake> mistakes(const std::vector<Result>& results) {
    std::map<std::pair<std::string, std::string>, Mistake> all;
    for (std::size_t i = 0; i < results.size(); ++i) {
        if (!results[i].record) continue;
        for (const FragmentRecord& fragment : results[i].record->fragments) {
            if (fragment.verdict == Verdict::passed || fragment.verdict == Verdict::not_started) continue;
            const std::string words = diagnose(fragment).words;
            Mistake& mistake = all[{fragment.name, kind_of(words)}];
            if (mistake.who.empty()) mistake.fragment = fragment.name, mistake.hint = words.substr(0, words.find('\n'));
            mistake.who.push_back(i);
        }
    }
    std::vector<Mistake> sorted;
    for (auto& [key, mistake] : all) sorted.push_back(std::move(mistake));
    std::ranges::stable_sort(sorted, std::ranges::greater{}, [](const Mistake& m) { return m.who.size(); });
    return sorted;
}

std::vector<Twins> twins(const std::vector<Result>& results) {
    std::map<std::pair<std::string, std::string>, std::vector<std::size_t>> sharers;
    for (std::size_t i = 0; i < results.size(); ++i)
        for (const auto& [fragment, print] : results[i].prints)
            if (print.tokens >= fewest_tokens) sharers[{fragment, print.hash}].push_back(i);
    std::map<std::pair<std::size_t, std::size_t>, Twins> pairs;
    for (const auto& [key, who] : sharers) {
        if (who.size() < 2 || who.size() > most_sharers) continue;
        for (std::size_t a = 0; a < who.size(); ++a)
            for (std::size_t b = a + 1; b < who.size(); ++b) {
                Twins& pair = pairs[{who[a], who[b]}];
                pair.a = who[a], pair.b = who[b];
                pair.fragments.push_back(key.first);
                pair.tokens += results[who[a]].prints.at(key.first).tokens;
            }
    }
    std::vector<Twins> sorted;
    for (auto& [key, pair] : pairs) sorted.push_back(std::move(pair));
    std::ranges::stable_sort(sorted, std::ranges::greater{}, &Twins::tokens);
    return sorted;
}

}  // namespace grade::course
