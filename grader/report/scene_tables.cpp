#include "report/scene_tables.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <vector>

#include "rt/files/scene_keys.h"

namespace grade {

namespace {

using rt::Kind, rt::KeyTable, rt::KeyWords, rt::Limits;

/// 1e30 and not 1e+30; a number that JSON has as well.
std::string plain(double x) {
    std::string text = fmt::format("{}", x);
    std::erase(text, '+');
    return text;
}

/// As short as people like it; what no one reaches is left out.
std::string range(const Limits& limits) {
    std::string text;
    if (limits.least > 0)
        text = "not 0";
    else if (limits.above)
        text = limits.below ? fmt::format("between {} and {}", limits.low, limits.high) : "above " + plain(limits.low);
    else if (limits.low > -rt::huge)
        text = limits.high < rt::huge && limits.high < 1e30 ? fmt::format("{} to {}", limits.low, limits.high)
                                                            : "from " + plain(limits.low);
    return (text.empty() ? "" : ", " + text) + (limits.or_inf ? ", or `inf`" : "");
}

std::string value(const KeyWords& key) {
    switch (key.kind) {
        case Kind::number:
            return "number" + range(key.limits);
        case Kind::whole:
            return "whole number" + range(key.limits);
        case Kind::flag:
            return "`true`, `false`";
        case Kind::text:
            return "text";
        case Kind::vector:
            return "`[x, y, z]`";
        case Kind::pair:
            return "`[x, y]`" + range(key.limits);
        case Kind::color:
            return "colour" + range(key.limits);
        case Kind::factors:
            return "a number or `[x, y, z]`" + range(key.limits);
        case Kind::choice:
            return fmt::format("`\"{}\"`", fmt::join(rt::sampler_names, "\"`, `\""));
        case Kind::table:
            break;
    }
    return "table";
}

std::string with_unit(const KeyWords& key) {
    return fmt::format("{}{}", key.meaning, key.unit.empty() ? "" : fmt::format(" [{}]", key.unit));
}

/// What follows "shape." in "shape.sphere"; none: the table is not within that.
std::optional<std::string_view> within(const KeyTable& table, std::string_view outer) {
    if (outer.empty() || !table.name.starts_with(outer) || table.name.size() == outer.size()) return std::nullopt;
    return table.name[outer.size()] == '.' ? std::optional(table.name.substr(outer.size() + 1)) : std::nullopt;
}

bool is_there(std::string_view name) { return std::ranges::count(rt::scene_tables(), name, &KeyTable::name) > 0; }

std::string in_quotes(std::string_view text) {
    std::string quoted = "\"";
    for (const char c : text) quoted += c == '"' || c == '\\' ? std::string{'\\', c} : std::string{c};
    return quoted + "\"";
}

/// The part of the schema for a number within limits, without its braces.
std::string number_schema(const Limits& limits, const char* type) {
    std::string text = fmt::format(R"("type": "{}")", type);
    if (limits.low > -rt::huge)
        text += fmt::format(R"(, "{}": {})", limits.above ? "exclusiveMinimum" : "minimum", plain(limits.low));
    if (limits.high < rt::huge && !limits.or_inf)
        text += fmt::format(R"(, "{}": {})", limits.below ? "exclusiveMaximum" : "maximum", plain(limits.high));
    if (limits.least > 0) text += R"(, "not": {"const": 0})";
    return text;
}

std::string array_schema(const std::string& number, int count) {
    return fmt::format(R"("type": "array", "items": {{{0}}}, "minItems": {1}, "maxItems": {1})", number, count);
}

/// The same for what a key holds that is no table.
std::string value_schema(const KeyWords& key) {
    const std::string number = number_schema(key.limits, "number"), whole = number_schema(key.limits, "integer");
    switch (key.kind) {
        case Kind::number:
            return number;
        case Kind::whole:
            return whole;
        case Kind::flag:
            return R"("type": "boolean")";
        case Kind::vector:
            return array_schema(number, 3);
        case Kind::pair:
            return array_schema(whole, 2);
        case Kind::color:
        case Kind::factors:
            return fmt::format(R"("anyOf": [{{{}}}, {{{}}}])", number, array_schema(number, 3));
        case Kind::choice:
            return fmt::format(R"("enum": ["{}"])", fmt::join(rt::sampler_names, "\", \""));
        default:
            return R"("type": "string")";
    }
}

std::string inner_schema(const std::string& name, const std::string& indent);

/// An object with these keys alone. type: what its key of that name must say; empty: it has none.
std::string object_schema(const KeyTable& table, std::string_view type, const std::string& indent) {
    const std::string in = indent + "  ";
    std::vector<std::string> lines, required;
    if (!type.empty()) {
        lines.push_back(fmt::format(R"({}"type": {{"const": "{}"}})", in, type));
        required.emplace_back("type");
    }
    for (const KeyWords& key : table.keys) {
        const std::string name = (table.name.empty() ? "" : std::string(table.name) + ".") + std::string(key.name);
        const std::string held = key.kind == Kind::table ? inner_schema(name, in) : value_schema(key);
        lines.push_back(
            fmt::format(R"({}"{}": {{"description": {}, {}}})", in, key.name, in_quotes(with_unit(key)), held));
        if (key.otherwise.empty()) required.emplace_back(key.name);
    }
    std::string text = fmt::format("\"type\": \"object\", \"additionalProperties\": false, ");
    if (!required.empty()) text += fmt::format("\"required\": [\"{}\"], ", fmt::join(required, "\", \""));
    return text + fmt::format("\"properties\": {{\n{}\n{}}}", fmt::join(lines, ",\n"), indent);
}

/// What a table of this name holds: one of several types, as often as wanted; materials by their names; or keys.
std::string inner_schema(const std::string& name, const std::string& indent) {
    std::vector<std::string> types;
    for (const KeyTable& table : rt::scene_tables()) {
        if (table.name == name)
            return name == "materials" ? fmt::format(R"("type": "object", "additionalProperties": {{{}}})",
                                                     object_schema(table, "", indent))
                                       : object_schema(table, "", indent);
        if (const auto type = within(table, name))
            types.push_back(fmt::format("{{{}}}", object_schema(table, *type, indent)));
    }
    return fmt::format(R"("type": "array", "items": {{"anyOf": [{}]}})", fmt::join(types, ", "));
}

}  // namespace

std::string describe_keys(const std::string& name) {
    const bool typed = !is_there(name);
    std::string rows;
    for (const KeyTable& table : rt::scene_tables()) {
        const auto inner = within(table, name);
        if (table.name != name && !inner) continue;
        std::string first = typed ? fmt::format("`\"{}\"` | ", *inner) : "";
        for (const KeyWords& key : table.keys) {
            if (key.kind == Kind::table && table.name.empty()) continue;  // has a section of its own
            rows += fmt::format("| {}`{}{}` | {} | {} | {} |\n", first,
                                !typed && inner ? std::string(*inner) + "." : "", key.name, value(key),
                                key.otherwise.empty() ? "must be set" : key.otherwise, with_unit(key));
            if (typed) first = " | ";
        }
    }
    if (rows.empty()) return rows;
    return fmt::format("| {}key | value | default | meaning |\n|{}---|---|---|---|\n{}", typed ? "`type` | " : "",
                       typed ? "---|" : "", rows);
}

std::string scene_schema() {
    return fmt::format(
        "{{\n\"$schema\": \"http://json-schema.org/draft-07/schema#\",\n\"title\": \"A scene of Penumbra\",\n"
        "\"description\": \"Made by ./grade describe --update scenes/scene.schema.json. The handout's section Scene "
        "files has the whole story.\",\n{}\n}}\n",
        object_schema(rt::scene_tables().front(), "", ""));
}

}  // namespace grade
