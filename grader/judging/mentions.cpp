#include "judging/mentions.h"

#include <algorithm>
#include <cctype>
#include <vector>

namespace grade {

namespace {

bool in_name(char c) { return std::isalnum(static_cast<unsigned char>(c)) || c == '_'; }

std::set<std::string> words_of(const std::string& text) {
    std::set<std::string> words;
    for (auto at = text.begin(); at != text.end();) {
        const auto first = std::find_if(at, text.end(), in_name), last = std::find_if_not(first, text.end(), in_name);
        words.emplace(first, last);
        at = last;
    }
    return words;
}

}  // namespace

std::set<std::string> with_mentioned(std::set<std::string> names, const std::set<std::string>& fragments,
                                     const std::function<std::string(const std::string&)>& source) {
    std::vector<std::string> open(names.begin(), names.end());
    while (!open.empty()) {
        const std::set<std::string> words = words_of(source(open.back()));
        open.pop_back();
        for (const std::string& word : words)
            if (fragments.contains(word) && names.insert(word).second) open.push_back(word);
    }
    return names;
}

}  // namespace grade
