#include <stdexcept>

// Some of toml++'s assertions can be reached by a file, and without them its behaviour is undefined: make them throw.
namespace rt {
struct ParserFault : std::logic_error {
    using std::logic_error::logic_error;
};
[[noreturn]] static void parser_fault(const char* condition) { throw ParserFault(condition); }
}  // namespace rt
#undef NDEBUG
#define TOML_ASSERT(condition) ((condition) ? void() : rt::parser_fault(#condition))

#include "rt/files/toml_table.h"

#include <fmt/format.h>
#include <toml++/toml.h>

#include <algorithm>

#include "rt/files/scene_reader.h"

namespace rt {
namespace {

[[noreturn]] void fail_in(const std::string& path, toml::source_position place, const std::string& wrong,
                          const std::string& expected) {
    const auto line = std::max(place.line, 1u), column = std::max(place.column, 1u);
    throw InputError(fmt::format("{}:{}:{}: {}; expected {}", path, line, column, one_line(wrong), expected));
}

std::string type_of(const toml::node& node) {
    switch (node.type()) {
        case toml::node_type::table:
            return "a table";
        case toml::node_type::array:
            return "an array";
        case toml::node_type::string:
            return "a string";
        case toml::node_type::integer:
            return "a whole number";
        case toml::node_type::floating_point:
            return "a number";
        case toml::node_type::boolean:
            return "true or false";
        default:
            return "a date or time";
    }
}

/// 1e70 and not 1e+70; two digits of what has many.
std::string short_number(Real x) {
    std::string text = fmt::format("{:.6g}", x);
    if (text.size() > 7) text = fmt::format("{:.2g}", x);
    std::erase(text, '+');
    return text;
}

std::string one_of(const std::vector<std::string>& words) { return fmt::format("one of {}", fmt::join(words, ", ")); }

/// Dotted keys nest tables without a bound, and the parser frees them by recursion: a long enough key overflows the
/// stack.
void check_nesting(std::string_view text, const std::string& path) {
    constexpr int most = 64;
    toml::source_position place{1, 0};
    int dots = 0;
    bool quotes = false, comment = false;
    for (const char c : text) {
        ++place.column;
        if (c == '\n') place = {place.line + 1, 0}, quotes = comment = false;
        if (c == '"' || c == '\'') quotes = true;
        if (c == '#' && !quotes) comment = true;
        if (std::string_view("=,[]{}\n").find(c) != std::string_view::npos) dots = 0;
        if (c == '.' && !comment && ++dots > most)
            fail_in(path, place, "too many dots in one key", fmt::format("at most {}", most));
    }
}

/// The first line without which the parser keeps its promises.
toml::source_index line_of_fault(std::string_view text) {
    toml::source_index line = 1;
    for (auto end = text.find('\n'); end != text.npos; end = text.find('\n', end + 1), ++line) try {
            (void)toml::parse(text.substr(0, end + 1));
        } catch (const ParserFault&) {
            return line;
        } catch (const toml::parse_error&) {}
    return line;
}

}  // namespace

struct Table::Inside {
    std::shared_ptr<const toml::table> root;
    const toml::table* table = nullptr;
    std::string path, key;  // of the file; of the table, with dots: empty for the whole file
    bool repeated = false;  // [[key]]

    std::string name() const {
        if (key.empty()) return "the file";
        if (repeated && table->is_inline()) return fmt::format("an entry of '{}'", key);
        return repeated ? fmt::format("[[{}]]", key) : fmt::format("[{}]", key);
    }
    const toml::node* find(std::string_view key, bool required) const;
    Real checked(const toml::node& node, std::string_view key, const Limits& limits) const;
    int whole(const toml::node& node, std::string_view key, int low, int high, const std::string& expected) const;
    [[noreturn]] void fail(std::string_view key, const std::string& wrong, const std::string& expected) const;
    [[noreturn]] void fail_at(const toml::node& node, const std::string& wrong, const std::string& expected) const;
    Table inner(const toml::table& inner_table, const std::string& inner_key, bool is_repeated) const;
};

Table Table::parse(std::string_view text, const std::string& path) {
    check_nesting(text, path);
    toml::table root;
    try {
        root = toml::parse(text, path);
    } catch (const toml::parse_error& error) {
        const std::string_view what = error.description(), context = "Error while parsing ";
        const auto colon = what.starts_with(context) ? what.find(": ") : what.npos;
        fail_in(path, error.source().begin, std::string(colon == what.npos ? what : what.substr(colon + 2)),
                "valid TOML, every key once, every number within 1e308");
    } catch (const ParserFault&) {
        fail_in(path, {line_of_fault(text), 1}, "no TOML", "key = value, [table] or # comment");
    }
    auto whole = std::make_shared<const toml::table>(std::move(root));
    const toml::table* const top = whole.get();
    Table table;
    table.inside_ = std::make_shared<const Inside>(Inside{std::move(whole), top, path, {}});
    return table;
}

bool Limits::hold(Real x) const {
    if (or_inf && x == inf) return true;
    return (above ? x > low : x >= low) && (below ? x < high : x <= high) && std::abs(x) >= least;
}

std::string Limits::expected() const {
    if (least > 0)
        return fmt::format("a number that is not 0, of a size from {} to {}", short_number(least), short_number(high));
    const std::string start = above && below ? "between" : above ? "above" : "from";
    std::string end = below ? " and " + short_number(high) : (above ? ", up to " : " to ") + short_number(high);
    if (or_inf) end = ", or inf";
    return fmt::format("a number {} {}{}{}", start, short_number(low), end, remark);
}

void Table::only(std::span<const std::string_view> keys) const {
    const std::vector<std::string> known(keys.begin(), keys.end());
    for (const auto& [key, node] : *inside_->table) {
        if (std::find(known.begin(), known.end(), key.str()) != known.end()) continue;
        const auto nearest = nearest_word(key.str(), known);
        const auto wrong = fmt::format("unknown key {} in {}", in_quotes(key.str()), inside_->name());
        const auto place = key.source().begin;
        fail_in(inside_->path, place ? place : node.source().begin, wrong,
                nearest ? fmt::format("'{}'?", *nearest) : one_of(known));
    }
}

bool Table::has(std::string_view key) const { return inside_->table->contains(key); }

std::vector<std::string> Table::keys() const {
    std::vector<std::string> keys;
    for (const auto& [key, node] : *inside_->table) keys.emplace_back(key.str());
    return keys;
}

void Table::fail(std::string_view key, const std::string& wrong, const std::string& expected) const {
    inside_->fail(key, wrong, expected);
}

void Table::Inside::fail(std::string_view key, const std::string& wrong, const std::string& expected) const {
    const toml::node* node = table->get(key);
    fail_at(node ? *node : *table, wrong, expected);
}

void Table::Inside::fail_at(const toml::node& node, const std::string& wrong, const std::string& expected) const {
    fail_in(path, node.source().begin, wrong, expected);
}

const toml::node* Table::Inside::find(std::string_view key, bool required) const {
    const toml::node* node = table->get(key);
    if (!node && required) fail(key, fmt::format("'{}' is missing in {}", key, name()), fmt::format("{} = ...", key));
    return node;
}

Real Table::Inside::checked(const toml::node& node, std::string_view key, const Limits& limits) const {
    const auto value = node.is_number() ? node.value<double>() : std::nullopt;
    if (!value) fail_at(node, fmt::format("{} is {}", in_quotes(key), type_of(node)), limits.expected());
    if (!limits.hold(*value)) fail_at(node, fmt::format("{} is {}", in_quotes(key), *value), limits.expected());
    return *value;
}

int Table::Inside::whole(const toml::node& node, std::string_view key, int low, int high,
                         const std::string& expected) const {
    if (!node.is_integer()) fail_at(node, fmt::format("{} is {}", in_quotes(key), type_of(node)), expected);
    const auto value = **node.as_integer();
    if (value < low || value > high) fail_at(node, fmt::format("{} is {}", in_quotes(key), value), expected);
    return int(value);
}

Real Table::number(std::string_view key, const Limits& limits, std::optional<Real> otherwise) const {
    const toml::node* node = inside_->find(key, !otherwise);
    return node ? inside_->checked(*node, key, limits) : *otherwise;
}

int Table::integer(std::string_view key, int low, int high, std::optional<int> otherwise) const {
    const toml::node* node = inside_->find(key, !otherwise);
    if (!node) return *otherwise;
    return inside_->whole(*node, key, low, high, fmt::format("a whole number from {} to {}", low, high));
}

bool Table::flag(std::string_view key, bool otherwise) const {
    const toml::node* node = inside_->find(key, false);
    if (node && !node->is_boolean()) fail(key, fmt::format("'{}' is {}", key, type_of(*node)), "true or false");
    return node ? **node->as_boolean() : otherwise;
}

std::string Table::text(std::string_view key) const {
    const toml::node* node = inside_->find(key, true);
    if (!node->is_string()) fail(key, fmt::format("'{}' is {}", key, type_of(*node)), "a string");
    return **node->as_string();
}

vec3 Table::vector(std::string_view key, const Limits& limits, std::optional<vec3> otherwise) const {
    const toml::node* node = inside_->find(key, !otherwise);
    if (!node) return *otherwise;
    const toml::array* array = node->as_array();
    const auto expected = [&] { return fmt::format("[x, y, z], each {}", limits.expected()); };
    if (!array) fail(key, fmt::format("'{}' is {}", key, type_of(*node)), expected());
    if (array->size() != 3) fail(key, fmt::format("'{}' has {} numbers", key, array->size()), expected());
    vec3 v;
    for (int i = 0; i < 3; ++i) v[i] = inside_->checked((*array)[std::size_t(i)], key, limits);
    return v;
}

ivec2 Table::pair(std::string_view key, int low, int high, std::optional<ivec2> otherwise) const {
    const toml::node* node = inside_->find(key, !otherwise);
    if (!node) return *otherwise;
    const toml::array* array = node->as_array();
    const auto expected = fmt::format("[width, height], each a whole number from {} to {}", low, high);
    if (!array || array->size() != 2) fail(key, fmt::format("'{}' is no pair", key), expected);
    const int x = inside_->whole((*array)[0], key, low, high, expected);
    return {x, inside_->whole((*array)[1], key, low, high, expected)};
}

Color Table::color(std::string_view key, const Limits& limits, std::optional<Color> otherwise) const {
    const toml::node* node = inside_->find(key, !otherwise);
    if (node && node->is_number()) return Color(inside_->checked(*node, key, limits));
    if (node && !node->is_array())
        fail(key, fmt::format("'{}' is {}", key, type_of(*node)), "[red, green, blue], or one number for all three");
    return vector(key, limits, otherwise);
}

vec3 Table::factors(std::string_view key, const Limits& limits) const {
    const toml::node* node = inside_->find(key, true);
    if (node->is_number()) return vec3(inside_->checked(*node, key, limits));
    if (!node->is_array())
        fail(key, fmt::format("'{}' is {}", key, type_of(*node)), "[x, y, z], or one number for all three");
    return vector(key, limits);
}

int Table::choice(std::string_view key, std::span<const std::string_view> words, std::optional<int> otherwise) const {
    if (!inside_->find(key, !otherwise)) return *otherwise;
    const std::string word = text(key);
    const auto found = std::find(words.begin(), words.end(), word);
    if (found == words.end())
        fail(key, fmt::format("'{}' is {}", key, in_quotes(word)), one_of({words.begin(), words.end()}));
    return int(found - words.begin());
}

Table Table::Inside::inner(const toml::table& inner_table, const std::string& inner_key, bool is_repeated) const {
    Table inner;
    inner.inside_ = std::make_shared<const Inside>(Inside{root, &inner_table, path, inner_key, is_repeated});
    return inner;
}

Table Table::table(std::string_view key) const {
    static const toml::table empty;
    const toml::node* node = inside_->find(key, false);
    if (node && !node->is_table()) fail(key, fmt::format("{} is {}", in_quotes(key), type_of(*node)), "a table");
    const std::string outer = inside_->key.empty() ? "" : inside_->key + '.';
    return inside_->inner(node ? *node->as_table() : empty, outer + std::string(key), false);
}

std::vector<Table> Table::tables(std::string_view key, bool required) const {
    const toml::node* node = inside_->find(key, false);
    std::vector<Table> tables;
    const bool is_outermost = inside_->key.empty();
    const std::string name = (is_outermost ? "" : inside_->key + '.') + std::string(key);
    const std::string expected =
        is_outermost ? fmt::format("[[{}]], once for each", key) : fmt::format("{} = [{{ ... }}, ...]", key);
    if (!node && required) fail(key, fmt::format("'{}' is missing in {}", key, inside_->name()), expected);
    if (!node) return tables;
    if (!node->is_array()) fail(key, fmt::format("'{}' is {}", key, type_of(*node)), expected);
    for (const toml::node& element : *node->as_array()) {
        if (!element.is_table())
            inside_->fail_at(element, fmt::format("'{}' holds {}", key, type_of(element)), expected);
        tables.push_back(inside_->inner(*element.as_table(), name, true));
    }
    return tables;
}

}  // namespace rt
