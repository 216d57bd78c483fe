#include "diagnosis/source/renamed.h"

#include <algorithm>
#include <cctype>
#include <map>
#include <utility>

#include "textbook/tokens.h"

namespace grade {

namespace {

/// "quad.u"
bool is_name(const std::string& text) {
    const auto is_of_name = [](unsigned char c) { return std::isalnum(c) || c == '_' || c == '.'; };
    return !text.empty() && !std::isdigit(static_cast<unsigned char>(text[0])) && text[0] != '.' &&
           std::ranges::all_of(text, is_of_name);
}

bool is_renamed(const Expressions& all, const Mistake& change) {
    return change.pattern == "{1}" && change.made.nodes.size() == 1 && is_name(change.other) &&
           is_name(all.node(change.made.nodes.front()).text);
}

/// Where in a text a name stands, and what takes its place.
struct Place {
    std::size_t from, to;
    std::string by;
};

/// The place of a name, of several alike the one with this number.
Place place_of(const std::string& text, const std::string& name, std::size_t number, const std::string& by) {
    const std::vector<textbook::Token> tokens = textbook::tokens_of(text);
    for (std::size_t i = 0; i < tokens.size(); ++i) {
        if (tokens[i].kind != textbook::Token::Kind::name || (i > 0 && tokens[i - 1].text == ".")) continue;
        std::size_t last = i;
        while (last + 2 < tokens.size() && tokens[last + 1].text == "." &&
               tokens[last + 2].kind == textbook::Token::Kind::name)
            last += 2;
        if (text.substr(tokens[i].from, tokens[last].to - tokens[i].from) != name) continue;
        if (number-- == 0) return {tokens[i].from, tokens[last].to, by};
    }
    return {text.size(), text.size(), ""};
}

/// In the smallest expression that holds both; else in the statement.
Place place_in(const Expressions& all, const Mistake& change, const std::string& text, int whole) {
    const int node = change.made.nodes.front();
    const textbook::Node& of = all.node(node);
    std::size_t before = 0;
    for (int other = all.first; other < node; ++other) {
        const textbook::Node& one = all.node(other);
        const bool is_within = whole < 0 ? one.context == of.context && one.line == of.line : all.holds(whole, other);
        before += is_within && one.text == of.text;
    }
    return place_of(text, of.text, before, change.other);
}

}  // namespace

std::vector<Edit> renamed(const Expressions& all, const std::vector<Mistake>& changes) {
    constexpr std::size_t most_of_each = 60, most = 20'000;
    std::map<std::pair<int, std::string>, std::vector<const Mistake*>> of_statements;  // by line and text
    for (const Mistake& change : changes) {
        const textbook::Node& node = all.node(change.made.nodes.front());
        auto& some = of_statements[{node.line, node.context}];
        if (is_renamed(all, change) && some.size() < most_of_each) some.push_back(&change);
    }
    std::vector<Edit> pairs;
    for (const auto& [statement, some] : of_statements)
        for (std::size_t b = 1; b < some.size() && pairs.size() < most; ++b)
            for (std::size_t a = 0; a < b; ++a)
                if (some[a]->made.nodes != some[b]->made.nodes) pairs.push_back({some[a], some[b], true});
    return pairs;
}

Mistake of_both(const Expressions& all, const Edit& edit) {
    const int first = edit.first->made.nodes.front(), second = edit.second->made.nodes.front();
    int whole = -1;
    for (int around = all.first; around < all.first + int(all.nodes.size()) && whole < 0; ++around)
        if (all.holds(around, first) && all.holds(around, second))
            whole = around;  // parts stand before what holds them
    const int told = whole < 0 ? first : whole;
    std::string text = whole < 0 ? all.node(first).context : all.node(whole).text;
    std::vector<Place> places = {place_in(all, *edit.first, text, whole), place_in(all, *edit.second, text, whole)};
    std::ranges::sort(places, std::ranges::greater{}, &Place::from);
    for (const Place& place : places) text.replace(place.from, place.to - place.from, place.by);
    Mistake both{text};
    both.made.nodes = {told}, both.made.alternative = 1;  // its text is told as it stands
    return both;
}

}  // namespace grade
