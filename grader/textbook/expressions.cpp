#include "textbook/expressions.h"

#include <algorithm>

#include "textbook/operators.h"

namespace grade::textbook {

void ExpressionReader::skip_to(std::initializer_list<std::string_view> signs) {
    while (std::ranges::none_of(signs, [&](std::string_view sign) { return is(sign); })) {
        if (now().kind == Token::Kind::end) fail(fmt::format("the end of the file; expected \"{}\"", *signs.begin()));
        ++at_;
    }
}

std::string ExpressionReader::joined(std::size_t from, std::size_t to) const {
    std::string all;
    for (std::size_t i = from; i < to; ++i) {
        const bool is_word = tokens_[i].kind != Token::Kind::sign;
        const bool is_after_word = i > from && tokens_[i - 1].kind != Token::Kind::sign;
        const bool is_after = i > from && (tokens_[i - 1].text == "," || tokens_[i - 1].text == "&");
        if (is_word && (is_after_word || is_after || (i > from && tokens_[i - 1].text == ">"))) all += ' ';
        all += tokens_[i].text;
    }
    return all;
}

std::string ExpressionReader::chain_at(std::size_t i, std::size_t& end) const {
    std::string chain = tokens_[i].text;
    end = i + 1;
    while (end + 1 < tokens_.size() && tokens_[end].text == "." && tokens_[end + 1].kind == Token::Kind::name &&
           tokens_[end + 2].text != "(") {
        chain += "." + tokens_[end + 1].text;
        end += 2;
    }
    return chain;
}

void ExpressionReader::count_uses() {
    for (std::size_t i = at_; i < tokens_.size();) {
        std::size_t end = i + 1;
        if (tokens_[i].kind == Token::Kind::name) ++uses_[chain_at(i, end)];
        i = end;
    }
}

int ExpressionReader::add(const std::string& text, const std::vector<Expression>& parts,
                          std::vector<std::string> alternatives) {
    constexpr std::size_t most = 600, longest = 3'000, most_read = 20'000;
    if (++read_ > most_read) throw TooLong();
    if (nodes_.size() >= most || text.size() > longest) fail("a long expression; expected a short one");
    nodes_.push_back({text, text, "", "", {}, std::move(alternatives)});
    nodes_.back().blocks = blocks_;
    for (const Expression& part : parts)
        if (part.node >= 0) nodes_.back().parts.push_back(part.node);
    return first_ + int(nodes_.size()) - 1;
}

Expression ExpressionReader::expression() {
    const Deeper deeper(*this);
    return choice();
}

Expression ExpressionReader::choice() {
    Expression condition = binary(1);
    if (!take("?")) return condition;
    const Expression first = expression();
    expect(":");
    const Expression second = expression();
    Expression all;
    all.line = condition.line;
    all.text = fmt::format("{} ? {} : {}", condition.text, first.text, second.text);
    all.inner = fmt::format("({} ? {} : {})", condition.code, first.code, second.code);
    watch(all, add(all.text, {condition, first, second}));
    return all;
}

Expression ExpressionReader::binary(int level) {
    Expression left = unary();
    for (;;) {
        const auto found = operators().find(now().text);
        if (now().kind != Token::Kind::sign || found == operators().end() || found->second.level < level) return left;
        ++at_;
        left = joined_by(left, found->first, binary(found->second.level + 1));
    }
}

namespace {

/// A product in a sum, or a sum in brackets in a product: brackets may be missing, or too many.
bool is_group_of(const Expression& side, const Operator& whole) {
    if (side.sides.empty()) return false;
    const int level = operators().at(side.sign).level;
    return (level == 5 && whole.level == 6) || (level == 6 && whole.level == 5);
}

}  // namespace

Expression ExpressionReader::joined_by(const Expression& left, const std::string& sign, const Expression& right) {
    const Operator& as = operators().at(sign);
    Expression all;
    all.line = left.line;
    all.text = fmt::format("{} {} {}", left.text, sign, right.text);
    std::vector<std::string> alternatives;
    for (const std::string& other : as.others) {
        const bool is_looser = loosest(left.text) < operators().at(other).level;
        alternatives.push_back(
            fmt::format(fmt::runtime(is_looser ? "({}) {} {}" : "{} {} {}"), left.text, other, right.text));
    }
    if (sign == "*") alternatives.push_back(fmt::format("dot({}, {})", left.text, right.text));
    if (sign == "-" || sign == "/") alternatives.push_back(fmt::format("{} {} {}", right.text, sign, left.text));
    constexpr std::size_t short_code = 2'000;  // what is in a group is written twice, and so on outwards
    const bool is_short = left.code.size() + right.code.size() < short_code;
    // a product in a sum lacks brackets: not tried in forms, of which there are many
    const bool is_tried = is_short && (as.level == 6 || is_source_);
    const bool is_after = is_tried && is_group_of(right, as),
               is_before = is_tried && !is_after && is_group_of(left, as);
    const Expression& group = is_after ? right : left;
    const char* const regrouped = as.level == 6 ? "{} {} {} {} {}" : is_after ? "({} {} {}) {} {}" : "{} {} ({} {} {})";
    if (is_after)
        alternatives.push_back(fmt::format(fmt::runtime(regrouped), left.text, sign, group.sides[0].text, group.sign,
                                           group.sides[1].text));
    if (is_before)
        alternatives.push_back(fmt::format(fmt::runtime(regrouped), group.sides[0].text, group.sign,
                                           group.sides[1].text, sign, right.text));
    const int node = add(all.text, {left, right}, alternatives);
    if (is_after || is_before)
        all.inner = fmt::format("textbook::regrouped<{}, {}, {}>({}, {}, {}, {}, {}, {})", function_of(group.sign),
                                is_after, as.name, node, alternatives.size(), left.code, right.code,
                                group.sides[0].code, group.sides[1].code);
    else if (*as.name)
        all.inner = fmt::format("textbook::binary<{}>({}, {}, {})", as.name, node, left.code, right.code);
    else  // with && for ||, or the other way round, where the alternative is chosen
        all.inner = fmt::format("({0} ? (textbook::chosen({1}) {2} 1 || {3}) : (textbook::chosen({1}) {2} 1 && {3}))",
                                left.code, node, sign == "||" ? "!=" : "==", right.code);
    watch(all, node);
    if (as.level == 5 || as.level == 6) {
        all.sides = {left, right}, all.sign = sign;
        for (Expression& side : all.sides) side.sides.clear();  // nobody asks for those, of which there may be many
    }
    return all;
}

Expression ExpressionReader::unary() {
    const Deeper deeper(*this);
    const int line = now().line;
    for (const char* sign : {"-", "!"}) {
        if (!take(sign)) continue;
        const Expression of = unary();
        Expression all{sign + of.text, fmt::format("({}{})", sign, of.code), "", of.is_literal};
        all.line = line;
        watch(all, add(all.text, {of}));
        return all;
    }
    for (const char* sign : {"+", "*", "&", "++", "--"}) {
        if (!take(sign)) continue;
        const Expression of = unary();
        Expression all{sign + of.text, sign + of.inner, sign + of.inner};
        all.line = line;
        return all;
    }
    return postfix();
}

Expression ExpressionReader::postfix() {
    Expression all = primary();
    for (;;) {
        if (is(".") || is("->")) {
            const std::string sign = now().text, name = tokens_[++at_].text;
            ++at_;
            if (name == "length" && is("(") && tokens_[at_ + 1].text == ")") {
                at_ += 2;
                length_of(all, sign);
                continue;
            }
            all.text += sign + name, all.inner += sign + name;
            if (take("(")) call(all, name, "");
        } else if (take("[")) {
            const Expression index = expression();
            expect("]");
            all.text += "[" + index.text + "]", all.inner = "textbook::element(" + all.inner + ", " + index.code + ")";
        } else if (is("++") || is("--")) {
            all.text += now().text, all.inner += now().text, all.code = all.inner;
            ++at_;
            return all;
        } else {
            return all;
        }
        finish(all);
    }
}

/// Of a vector, it is often meant to be another function's value.
void ExpressionReader::length_of(Expression& of, const std::string& sign) {
    const std::string vector = sign == "->" ? "*" + of.text : of.text;
    of.text += sign + "length()";
    const int node = add(of.text, {}, {"length(" + vector + ")"});
    of.inner = fmt::format("textbook::length_of({}, {}{})", node, sign == "->" ? "*" : "", of.inner);
    watch(of, node);
}

Expression ExpressionReader::primary() {
    Expression all;
    all.line = now().line;
    if (take("(")) {
        if (is_name() && is_number_type(now().text) && tokens_[at_ + 1].text == ")") {  // a cast
            const std::string type = now().text;
            at_ += 2;
            const Expression of = unary();
            return {type + "(" + of.text + ")", "(" + type + ")" + of.code, "(" + type + ")" + of.code};
        }
        const Expression of = expression();
        expect(")");
        return {"(" + of.text + ")",
                "(" + of.inner + ")",
                "(" + of.code + ")",
                of.is_literal,
                of.sides,
                of.sign,
                of.node,
                of.line};
    }
    if (is("[")) return function_object();
    if (now().kind == Token::Kind::number) {
        all.text = all.inner = now().text, all.is_literal = true;
        ++at_;
        watch(all, add(all.text));
        return all;
    }
    if (!is_name()) fail(fmt::format("\"{}\"; expected an expression", now().text));
    std::size_t end;
    const std::string chain = chain_at(at_, end);
    const std::string name = now().text;
    at_ = end;
    all.text = short_name(chain), all.inner = chain;
    if (const std::string types = template_arguments(); !types.empty()) all.inner += types;
    if (is("(") && end - 1 > 0 && chain == name) {
        take("(");
        if (fragments_.contains(name)) calls_.insert(name);
        call(all, name, fragments_.contains(name) ? "any::" + name : "");
    } else if (is("{")) {
        const Expression fields = braced();
        all.text += fields.text, all.inner += fields.inner;
    } else {
        const bool is_constant = chain == "inf" || chain == "pi" || chain.find("::") != std::string::npos;
        // what stands once may be changed where it comes from, but for a field of what was computed; in a student's
        // source the line is told that way
        const bool is_once = (uses_[chain] < 2 || (constants_.contains(chain) && uses_[chain] < 3)) &&
                             !(chain != name && (is_source_ || locals_.contains(name)));
        all.code = all.inner;
        if (!is_constant && !is_once && chain != "true" && chain != "false") watch(all, add(all.text));
        return all;
    }
    finish(all);
    return all;
}

void ExpressionReader::finish(Expression& all) {
    if (is(".") || is("["))
        all.code = all.inner;
    else
        watch(all, add(all.text, called_with_));
    called_with_.clear();
}

}  // namespace grade::textbook
