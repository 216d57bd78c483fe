#include <algorithm>

#include "textbook/expressions.h"
#include "textbook/operators.h"

namespace grade::textbook {

std::vector<Expression> ExpressionReader::arguments(std::string_view close) {
    std::vector<Expression> all;
    while (!is(close)) {
        const std::size_t since = nodes_.size();
        std::string field;
        if (close == "}" && take(".")) field = "." + tokens_[at_++].text + " = ", expect("=");
        all.push_back(is("{") ? braced() : expression());
        if (!field.empty()) all.back().code = field + (all.back().is_literal ? all.back().text : all.back().code);
        if (!field.empty()) all.back().is_literal = false;
        if (close == "}") set_context(since, all.back().text);
        if (!take(",")) break;
    }
    expect(close);
    return all;
}

Expression ExpressionReader::braced() {
    const Deeper deeper(*this);
    expect("{");
    std::vector<Expression> all = arguments("}");
    for (Expression& one : all)
        if (one.is_literal) one.code = one.text;
    Expression whole{fmt::format("({})", list(all, &Expression::text)),
                     fmt::format("{{{}}}", list(all, &Expression::code)), "", false};
    whole.code = whole.inner;
    return whole;
}

void ExpressionReader::call(Expression& function, const std::string& name, const std::string& qualified) {
    const std::string before = function.text, chain = function.inner;
    const auto all = arguments(")");
    called_with_ = all;
    function.text = before + "(" + list(all, &Expression::text) + ")";
    const std::string code = list(all, changes_arguments(name) ? &Expression::inner : &Expression::code);
    function.inner = (qualified.empty() ? chain : qualified) + "(" + code + ")";
    const bool is_method = before != short_name(name);
    const std::string types = is_method ? "" : chain.substr(std::min(name.size(), chain.size()));
    const InPlace others = in_place_of_call(name, is_method, types, all, code);
    if (others.codes.empty()) return;
    check_length(code);
    const int node = add(function.text, {}, others.texts);
    nodes_.back().function = name, nodes_.back().line = function.line;
    std::string choice = function.inner;
    for (std::size_t i = others.codes.size(); i-- > 0;)
        choice = fmt::format("(textbook::chosen({}) == {} ? {} : {})", node, i + 1, others.codes[i], choice);
    function.inner = fmt::format("textbook::at({}, {})", node, choice);  // that it is called is seen
}

ExpressionReader::InPlace ExpressionReader::in_place_of_call(const std::string& name, bool is_method,
                                                             const std::string& types,
                                                             const std::vector<Expression>& all,
                                                             const std::string& code) {
    InPlace others;
    const auto add_other = [&](std::string text, std::string written) {
        others.texts.push_back(std::move(text)), others.codes.push_back(std::move(written));
    };
    for (const std::string& other : is_method ? std::vector<std::string>() : functions_for(name))
        add_other(fmt::format("{}({})", short_name(other), list(all, &Expression::text)),
                  fmt::format("{}{}({})", other, types, code));
    const bool is_cross = is_cross_product(name);
    const bool has_order = name == "std::pow" || name == "std::atan2" || is_cross;
    if (!has_order || all.size() != 2) return others;
    add_other(fmt::format("{}({}, {})", short_name(name), all[1].text, all[0].text),
              fmt::format("{}({}, {})", name, all[1].code, all[0].code));
    if (!is_cross)
        add_other(fmt::format("{} * {}", all[0].text, all[1].text),
                  fmt::format("({}) * ({})", all[0].code, all[1].code));
    return others;
}

std::string ExpressionReader::template_arguments() {
    if (!is("<")) return {};
    int depth = 0;
    for (std::size_t i = at_; i + 1 < tokens_.size(); ++i) {
        const std::string& text = tokens_[i].text;
        depth += (text == "<") - (text == ">");
        const bool is_part =
            tokens_[i].kind != Token::Kind::sign || text == "<" || text == ">" || text == "," || text == "&";
        if (!is_part) return {};
        if (depth > 0) continue;
        if (tokens_[i + 1].text != "(" && tokens_[i + 1].text != "{") return {};
        std::string all = joined(at_, i + 1);
        at_ = i + 1;
        return all;
    }
    return {};
}

Expression ExpressionReader::function_object() {
    const std::size_t start = at_;
    skip_to({"{"});
    int depth = 0;
    do depth += is("{") - is("}"), ++at_;
    while (depth > 0);
    Expression all;
    all.text = "a function", all.inner = all.code = joined(start, at_);
    return all;
}

}  // namespace grade::textbook
