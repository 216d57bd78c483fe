#include "diagnosis/source/borrowed.h"

#include <algorithm>
#include <cctype>
#include <limits>
#include <map>
#include <optional>
#include <set>

#include "diagnosis/calls/expressions.h"
#include "diagnosis/forms/asked.h"

namespace grade {

using textbook::Value;

namespace {

bool is_some_number(Value::Kind kind) { return kind == Value::Kind::number || kind == Value::Kind::whole; }

/// What a form's expressions are in some calls, and what can be said of them without the form's own variables.
class FormInWords {
public:
    FormInWords(const Calls& calls, const textbook::Form& form) : calls_(calls), form_(form) {
        constexpr std::size_t most = 48;  // calls
        Asked asked(form);
        for (std::size_t i = 0; i < std::min(most, calls.size()) && is_right_; ++i) {
            const std::size_t k = i * calls.size() / std::min(most, calls.size());
            asked_.push_back(k);
            is_right_ = is_answer(calls.result, asked.answer(calls.rows[k], calls.layouts[k]), calls.right[k]);
            seen_.push_back(textbook::watch.values);
        }
        for (std::size_t i = 0; i < form.nodes.size(); ++i)
            if (const std::string name = variable_set_by(form.nodes[i]); !name.empty()) set_by_[name] = i;
        for (const Field& argument : calls.layouts.front().parts)
            arguments_.insert(argument.name.substr(0, argument.name.find('.')));
    }

    bool is_right() const { return is_right_; }

    std::optional<Value::Kind> kind_of(std::size_t node) const {
        Value::Kind kind = Value::Kind::none;
        for (const auto& values : seen_)
            if (values[node].kind != Value::Kind::none) kind = values[node].kind;
        return is_some_number(kind) || kind == Value::Kind::vector ? std::optional(kind) : std::nullopt;
    }

    /// "direction.z", where the expression is that part of the right answers, or "" where the part has no name; none:
    /// it is no part of them.
    std::optional<std::string> part_of_answer(std::size_t node) const {
        for (const Field& part : calls_.result.parts) {
            const std::size_t count = size_of(part.kind);
            if (is_as_part(node, part.at, count)) return part.name;
            for (std::size_t c = 0; c < count && count > 1; ++c)
                if (is_as_part(node, part.at + c, 1)) return part.name.empty() ? "" : part.name + "." + "xyz"[c];
        }
        return std::nullopt;
    }

    /// The expression, with what its variables stand for; empty: that is long, or cannot be said.
    std::string words(std::size_t node) const { return simplified(expanded(form_.nodes[node].text, 0)); }

private:
    /// "c" of "c = a + b", if the expression is all that it is set to.
    static std::string variable_set_by(const textbook::Node& node) {
        const std::size_t at = node.context.find(" = ");
        return at != node.context.npos && node.context.substr(at + 3) == node.text ? node.context.substr(0, at) : "";
    }

    bool is_as_part(std::size_t node, std::size_t at, std::size_t count) const {
        bool any = false;
        for (std::size_t i = 0; i < asked_.size(); ++i) {
            const Value& value = seen_[i][node];
            if (value.kind == Value::Kind::none) continue;
            if ((count == 3) != (value.kind == Value::Kind::vector)) return false;
            for (std::size_t c = 0; c < count; ++c)
                if (std::abs(value.x[c] - calls_.right[asked_[i]][at + c]) > 1e-9 * (1 + std::abs(value.x[c])))
                    return false;
            any = true;
        }
        return any;
    }

    static std::size_t end_of_name(const std::string& text, std::size_t at) {
        while (at < text.size() && (std::isalnum(static_cast<unsigned char>(text[at])) || text[at] == '_')) ++at;
        return at;
    }

    std::string expanded(const std::string& text, int depth) const {
        constexpr int deepest = 4;
        std::string all;
        for (std::size_t at = 0; at < text.size();) {
            if (!std::isalpha(static_cast<unsigned char>(text[at]))) {
                all += text[at++];
                continue;
            }
            const std::size_t end = end_of_name(text, at);
            const std::string name = text.substr(at, end - at);
            at = end;
            const bool is_field = !all.empty() && all.back() == '.', is_called = at < text.size() && text[at] == '(';
            const auto set = set_by_.find(name);
            if (is_field || is_called || set == set_by_.end()) {
                if (!is_field && !is_called && !arguments_.contains(name) && name != "pi" && name != "inf") return {};
                all += name;
                continue;
            }
            std::string meaning = part_of_answer(set->second).value_or("");
            if (meaning.empty() && depth < deepest)
                meaning = bracketed(expanded(form_.nodes[set->second].text, depth + 1));
            const bool has_field = at < text.size() && text[at] == '.';
            if (meaning.empty() || meaning == "()" || (has_field && meaning.find('(') != meaning.npos)) return {};
            all += meaning;
        }
        return all;
    }

    const Calls& calls_;
    const textbook::Form& form_;
    std::vector<std::size_t> asked_;
    std::vector<std::vector<Value>> seen_;  // by call that was asked
    std::map<std::string, std::size_t> set_by_;
    std::set<std::string> arguments_;
    bool is_right_ = true;
};

/// The sides of comparisons.
std::vector<int> compared_in(const textbook::Form& form) {
    std::vector<int> all;
    for (const textbook::Node& node : form.nodes)
        if (is_comparison(node)) all.insert(all.end(), node.parts.begin(), node.parts.end());
    return all;
}

}  // namespace

bool is_comparison(const textbook::Node& node) {
    const auto has = [&](const char* sign) { return node.text.find(sign) != node.text.npos; };
    return node.parts.size() == 2 && (has(" < ") || has(" > ") || has(" <= ") || has(" >= "));
}

Borrowed::Borrowed(const Calls& calls) {
    for (const textbook::Form& form : textbook::forms())
        if (form.fragment == calls.signature.fragment && form.says.empty() && calls.size() > 0) add_form(calls, form);
}

void Borrowed::add_form(const Calls& calls, const textbook::Form& form) {
    constexpr std::size_t most = 40, longest = 40;  // letters: more is no hint but a solution
    const FormInWords said(calls, form);
    if (!said.is_right()) return;
    forms_.push_back(&form);
    for (std::size_t i = 0; i < form.nodes.size() && all_.size() < most; ++i) {
        const auto kind = said.kind_of(i);
        // to say what the answer is would be no hint
        if (!kind || !form.nodes[i].function.empty() || said.part_of_answer(i)) continue;
        const std::string words = said.words(i);
        const bool is_computed = words.find_first_of("(*/+- ") != words.npos;
        const auto is_same = [&](const Expression& other) { return other.words == words; };
        if (is_computed && words.size() <= longest && std::ranges::none_of(all_, is_same))
            all_.push_back({words, *kind == Value::Kind::vector, forms_.size() - 1, i});
    }
    for (const int node : compared_in(form))
        for (Expression& one : all_)
            one.is_compared = one.is_compared || one.words == said.words(std::size_t(node - form.first));
}

Row Borrowed::values(const Row& row, const Layout& layout) const {
    std::vector<std::vector<Value>> of_forms;
    for (const textbook::Form* form : forms_) {
        Asked(*form).answer(row, layout);
        of_forms.push_back(textbook::watch.values);
    }
    Row all;
    for (const Expression& one : all_) {
        const Value& value = of_forms[one.form][one.node];
        for (int c = 0; c < (one.is_vector ? 3 : 1); ++c)
            all.push_back(value.kind == Value::Kind::none ? std::numeric_limits<double>::quiet_NaN() : value.x[c]);
    }
    return all;
}

}  // namespace grade
