#pragma once

#include <algorithm>
#include <cstdint>
#include <random>
#include <string>
#include <vector>

/// Cases made from a corpus: number i of a seed is always the same.
namespace fuzz {

using Random = std::mt19937_64;

inline std::size_t below(Random& random, std::size_t n) { return n == 0 ? 0 : random() % n; }

/// One of the texts, with some of its bytes changed, removed, doubled, or replaced by a word that means something.
///
/// words  may be empty
inline std::string mutated(const std::vector<std::string>& corpus, const std::vector<std::string>& words,
                           std::uint64_t seed, std::uint64_t number) {
    Random random(seed * 0x9e3779b97f4a7c15u + number);
    std::string text = corpus[below(random, corpus.size())];
    const std::size_t changes = below(random, 6);
    for (std::size_t k = 0; k <= changes; ++k) {
        const std::size_t at = below(random, text.size() + 1), length = std::min(text.size() - at, below(random, 24));
        switch (below(random, 7)) {
            case 0:
                if (at < text.size()) text[at] = char(text[at] ^ (1 << below(random, 8)));
                break;
            case 1:
                if (at < text.size()) text[at] = char(random());
                break;
            case 2:
                text.erase(at, length);
                break;
            case 3:
                text.insert(below(random, text.size() + 1), text.substr(at, length));
                break;
            case 4:
                text.resize(at);
                break;
            case 5:
                if (!words.empty()) text.replace(at, length, words[below(random, words.size())]);
                break;
            default: {
                const std::string& other = corpus[below(random, corpus.size())];
                text.replace(at, length, other.substr(below(random, other.size() + 1), below(random, 64)));
            }
        }
    }
    return text;
}

}  // namespace fuzz
