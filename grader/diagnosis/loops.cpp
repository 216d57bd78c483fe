#include "diagnosis/loops.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <set>
#include <sstream>
#include <vector>

#include "diagnosis/sanitizer.h"
#include "protocol/protocol.h"
#include "textbook/tokens.h"

namespace grade {

namespace {

struct Loop {
    int first, last;  // lines
};

/// The loops of a source, each before those within it.
class Loops {
public:
    explicit Loops(const std::string& source) : tokens_(textbook::tokens_of(source)) {
        constexpr std::size_t most = 200;
        for (std::size_t at = 0; at < tokens_.size() && all.size() < most; ++at)
            if ((is(at, "for") || is(at, "while") || is(at, "do")) && !ends_of_do_.contains(at))
                all.push_back({tokens_[at].line, tokens_[behind_statement(at, 0) - 1].line});
    }

    std::vector<Loop> all;

private:
    bool is(std::size_t at, const char* text) const { return at < tokens_.size() && tokens_[at].text == text; }

    /// Behind the bracket that closes the one there.
    std::size_t behind_brackets(std::size_t at) const {
        int depth = 0;
        for (; at < tokens_.size(); ++at) {
            depth += int(is(at, "(") || is(at, "{") || is(at, "[")) - int(is(at, ")") || is(at, "}") || is(at, "]"));
            if (depth <= 0) return at + 1;
        }
        return tokens_.size();
    }

    std::size_t behind_statement(std::size_t at, int depth) {
        constexpr int most_nested = 100;
        if (at >= tokens_.size() || depth > most_nested) return tokens_.size();
        if (is(at, "{")) return behind_brackets(at);
        if (is(at, "if") || is(at, "for") || is(at, "while")) {
            const std::size_t end = behind_statement(behind_brackets(at + 1), depth + 1);
            return is(at, "if") && is(end, "else") ? behind_statement(end + 1, depth + 1) : end;
        }
        if (is(at, "do")) {
            const std::size_t end = behind_statement(at + 1, depth + 1);
            ends_of_do_.insert(end);
            return std::min(behind_brackets(end + 1) + 1, tokens_.size());
        }
        while (at < tokens_.size() && !is(at, ";") && !is(at, "}"))
            at = is(at, "(") || is(at, "{") || is(at, "[") ? behind_brackets(at) : at + 1;
        return std::min(at + 1, tokens_.size());
    }

    std::vector<textbook::Token> tokens_;
    std::set<std::size_t> ends_of_do_;  // `while` behind the body of a `do`
};

using Lines = std::vector<int>;

/// The file's own lines of each place that was told, the innermost first.
std::vector<Lines> places(const std::string& said, const std::string& file) {
    std::vector<Lines> all;
    std::istringstream lines(said);
    for (std::string line; std::getline(lines, line);) {
        if (line + "\n" == place_at_end) all.emplace_back();
        const int number = line_in(line, file);
        if (number > 0 && !all.empty()) all.back().push_back(number);
    }
    std::erase_if(all, [](const Lines& own) { return own.empty(); });
    return all;
}

}  // namespace

std::optional<std::size_t> call_at_end_of(const std::string& said) {
    const std::string_view words = call_at_end;
    const std::size_t at = said.rfind(words);
    std::size_t number = 0;
    if (at == said.npos) return std::nullopt;
    const char* const end = said.data() + said.size();
    return std::from_chars(said.data() + at + words.size(), end, number).ec == std::errc() ? std::optional(number)
                                                                                           : std::nullopt;
}

std::string loop_in_words(const std::string& said, const std::string& fragment, const std::string& source,
                          bool is_endless) {
    const std::string file = fragment + ".cpp";
    const std::vector<Lines> all = places(said, file);
    if (all.empty()) return {};
    std::optional<Loop> innermost;
    for (const Loop& loop : Loops(source).all) {
        const auto is_in = [&loop](int line) { return line >= loop.first && line <= loop.last; };
        const auto passes = [&](const Lines& own) { return std::ranges::any_of(own, is_in); };
        const bool is_smaller = !innermost || loop.last - loop.first <= innermost->last - innermost->first;
        if (is_smaller && std::ranges::all_of(all, passes)) innermost = loop;
    }
    const int line = innermost ? innermost->first : all.front().front();
    return fmt::format("{}:{}: {}", file, line,
                       !innermost   ? "here it was when its time ended"
                       : is_endless ? "the loop here does not end"
                                    : "in the loop here its time ended");
}

}  // namespace grade
