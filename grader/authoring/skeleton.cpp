#include "authoring/skeleton.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <ranges>
#include <regex>

#include "assignment/strip.h"
#include "files/files.h"
#include "rt/files/scene_reader.h"

namespace grade::authoring {

namespace {

/// How an argument of a type is drawn in a check; structs have their defaults.
const std::map<std::string, std::string>& draws() {
    static const std::map<std::string, std::string> all = {
        {"Real", "between(random, 0, 1)"},
        {"int", "whole_between(random, 1, 8)"},
        {"bool", "chance(random, 0.5)"},
        {"Event", "rt::Event(whole_between(random, 0, 4))"},
        {"vec2", "square(random)"},
        {"vec3", "box(random, -1, 1)"},
        {"Color", "rt::Color(box(random, 0, 1))"},
        {"Function", "Integrand{Integrand::Kind::polynomial, {1}}"},
        {"std::span<Real>", "std::vector<double>(4, between(random, 0, 1))"},
        {"std::span<Color>", "std::vector<rt::Color>(4, rt::Color(box(random, 0, 1)))"},
        {"std::span<Stratum>", "std::vector<StratumOf>{{0, 1, {0.5}}}"}};
    return all;
}

std::string draw_of(const std::string& type) {
    const auto found = draws().find(type);
    return found != draws().end() ? found->second : fmt::format("rt::{}{{}}", type);
}

std::vector<std::string> names_of(const Signature& signature) {
    std::vector<std::string> names;
    for (const Signature::Argument& argument : signature.arguments) names.push_back(argument.name);
    return names;
}

/// Lines of their own: two draws in one list of arguments have no order.
std::string drawn(const Signature& signature) {
    std::string lines;
    for (const auto& [type, name] : signature.arguments)
        lines += fmt::format("        const auto {} = {};\n", name, draw_of(type));
    return lines;
}

/// "return not_started(point);" without the call.
std::string neutral_of(const std::string& fallback) {
    constexpr std::string_view begin = "return not_started(", end = ");";
    if (!fallback.starts_with(begin) || !fallback.ends_with(end)) return fallback;
    const std::string value = fallback.substr(begin.size(), fallback.size() - begin.size() - end.size());
    return fmt::format("return {};", value);
}

/// What takes the place of a name wherever it stands alone.
std::string renamed(std::string text, const std::string& from, const std::string& to) {
    const auto is_part = [](char c) { return std::isalnum(static_cast<unsigned char>(c)) || c == '_'; };
    for (std::size_t at = 0; (at = text.find(from, at)) != text.npos; at += to.size()) {
        const std::size_t end = at + from.size();
        if ((at > 0 && is_part(text[at - 1])) || (end < text.size() && is_part(text[end]))) continue;
        text.replace(at, from.size(), to);
    }
    return text;
}

/// Whether the words call a fragment, which a check can only name.
bool calls_fragment(const std::string& words, const std::string& header) {
    static const std::regex call("(\\w+)\\(");
    for (std::sregex_iterator match(words.begin(), words.end(), call), end; match != end; ++match)
        if (declaration_of((*match)[1], header)) return true;
    return false;
}

std::string without_semicolon(const std::string& line) { return line.substr(0, line.size() - 1); }

}  // namespace

std::string from_template(const fs::path& project, const std::string& name,
                          const std::map<std::string, std::string>& values) {
    std::string text = must_read(project / "grader/authoring/templates" / (name + ".in")), made;
    std::size_t at = 0;
    for (;;) {
        const std::size_t begin = text.find('@', at), end = begin == text.npos ? begin : text.find('@', begin + 1);
        if (end == text.npos) return made + text.substr(at);
        made += text.substr(at, begin - at) + values.at(text.substr(begin + 1, end - begin - 1));
        at = end + 1;
    }
}

void require_known_types(const Declaration& fragment) {
    const Signature& signature = fragment.signature;
    std::vector<std::string> types{signature.result};
    for (const Signature::Argument& argument : signature.arguments) types.push_back(argument.type);
    std::vector<std::string> drawn;
    for (const auto& entry : draws()) drawn.push_back(entry.first);
    for (const std::string& type : types)
        if (!draws().contains(type) && !is_structure(type))
            throw rt::InputError(fmt::format(
                "{}: no fragment has had the type {} yet; expected {}, {}, or a new one, with a line of its own in "
                "grader/protocol/rows.h and in grader/diagnosis/calls/signature.cpp",
                fragment.line, type, fmt::join(drawn, ", "), fmt::join(structures(), ", ")));
}

std::string solution_skeleton(const fs::path& project, const Declaration& fragment, const std::string& like) {
    const Signature& signature = fragment.signature;
    if (!like.empty()) {
        const fs::path file = project / "solution" / (like + ".cpp");
        Marked marked = find_region(must_read(file), file.string());
        marked.region = {marked.indent + "// FILL IN: what the student must write",
                         marked.indent + neutral_of(marked.fallback)};
        std::string text;
        bool is_first = true;
        for (const std::string& line : marked.before) {
            text += line + "\n";
            if (line.starts_with("/// ") && is_first) text.erase(text.size() - line.size() - 1);
            if (line.starts_with("/// ") && is_first)
                text += "/// FILL IN: what it returns, in one sentence; the lines below are another's.\n///\n" + line +
                        "\n";
            is_first = is_first && !line.starts_with("///");
        }
        text += marked.indent + "// BEGIN SOLUTION\n";
        for (const std::string& line : marked.region) text += line + "\n";
        text += marked.indent + "// END SOLUTION: " + marked.fallback + "\n";
        for (const std::string& line : marked.after) text += line + "\n";
        return renamed(text, like, signature.fragment);
    }
    std::size_t width = std::string_view("returns").size();
    for (const auto& [type, name] : signature.arguments) width = std::max(width, name.size());
    std::string arguments;
    for (const auto& [type, name] : signature.arguments)
        arguments += fmt::format("/// {:{}}  FILL IN [unit]\n", name, width);
    const std::string fallback =
        fmt::format("return not_started({}{});", signature.result, signature.result == "Real" ? "(0)" : "{}");
    return from_template(project, "fragment.cpp",
                         {{"arguments", arguments},
                          {"declaration", without_semicolon(fragment.line)},
                          {"neutral", neutral_of(fallback)},
                          {"fallback", fallback}});
}

std::string checks_skeleton(const fs::path& project, const Declaration& fragment, const std::string& solution,
                            const std::string& id) {
    const Signature& signature = fragment.signature;
    std::vector<std::string> lambda;
    for (const std::string& name : names_of(signature)) lambda.push_back("[[maybe_unused]] const auto& " + name);
    std::string neutral = neutral_of(find_region(solution, signature.fragment).fallback);
    if (calls_fragment(neutral, must_read(project / "starter/rt/fragments.h"))) neutral = "return {};";
    const bool in_rt = signature.result != "int" && signature.result != "bool";
    return from_template(project, "checks.cpp",
                         {{"name", signature.fragment},
                          {"id", id},
                          {"draws", drawn(signature)},
                          {"names", fmt::format("{}", fmt::join(names_of(signature), ", "))},
                          {"lambda", fmt::format("{}", fmt::join(lambda, ", "))},
                          {"result", (in_rt ? "rt::" : "") + signature.result},
                          {"neutral", neutral}});
}

std::string check_skeleton(const fs::path& project, const Declaration& fragment, const std::string& name,
                           const std::string& id) {
    return from_template(project, "check.cpp",
                         {{"name", name},
                          {"fragment", fragment.signature.fragment},
                          {"id", id},
                          {"draws", drawn(fragment.signature)},
                          {"names", fmt::format("{}", fmt::join(names_of(fragment.signature), ", "))}});
}

}  // namespace grade::authoring
