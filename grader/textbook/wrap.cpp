#include "textbook/wrap.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>
#include <stdexcept>

#include "textbook/tokens.h"

namespace grade::textbook {

namespace {

/// An expression: as it is written, and as it is compiled; `inner` is not watched itself.
struct Expression {
    std::string text, inner, code;
    bool is_literal = false;
    std::vector<Expression> sides{};  // of a sum in brackets
    std::string sign{};               // between them
    int node = -1;
};

struct Operator {
    int level;
    const char* name;                 // its function object, and those of the others, for watch.h
    std::vector<std::string> others;  // in its place; then its sides exchanged, where that is another value
};

/// Those of which the right side may not be computed have no function object.
const std::map<std::string, Operator>& operators() {
    static const std::map<std::string, Operator> all{
        {"||", {1, "", {"&&"}}},
        {"&&", {2, "", {"||"}}},
        {"==", {3, "std::equal_to<>, std::not_equal_to<>", {"!="}}},
        {"!=", {3, "std::not_equal_to<>, std::equal_to<>", {"=="}}},
        {"<", {4, "std::less<>, std::less_equal<>, std::greater<>", {"<=", ">"}}},
        {">", {4, "std::greater<>, std::greater_equal<>, std::less<>", {">=", "<"}}},
        {"<=", {4, "std::less_equal<>, std::less<>, std::greater_equal<>", {"<", ">="}}},
        {">=", {4, "std::greater_equal<>, std::greater<>, std::less_equal<>", {">", "<="}}},
        {"+", {5, "std::plus<>, std::minus<>, std::multiplies<>", {"-", "*"}}},
        {"-", {5, "std::minus<>, std::plus<>, std::multiplies<>, textbook::Reversed<std::minus<>>", {"+", "*"}}},
        {"*", {6, "std::multiplies<>, textbook::Quotient, std::plus<>, std::minus<>", {"/", "+", "-"}}},
        {"/",
         {6,
          "textbook::Quotient, std::multiplies<>, std::minus<>, textbook::Reversed<textbook::Quotient>",
          {"*", "-"}}},
        {"%", {6, "textbook::Rest, textbook::Quotient", {"/"}}},
    };
    return all;
}

/// What is written in place of a function.
const std::vector<std::string>& functions_for(const std::string& name) {
    static const std::map<std::string, std::vector<std::string>> all{
        {"std::sin", {"std::cos", "std::tan"}},
        {"std::cos", {"std::sin"}},
        {"std::tan", {"std::sin", "std::atan"}},
        {"std::min", {"std::max"}},
        {"std::max", {"std::min"}},
        {"std::floor", {"std::ceil", "std::round"}},
        {"std::ceil", {"std::floor"}},
        {"std::acos", {"std::asin", "std::cos"}},
        {"std::asin", {"std::acos", "std::sin"}},
        {"std::log", {"std::exp", "std::log2", "std::log10"}},
        {"std::exp", {"std::log"}},
        {"dot", {}},
    };
    static const std::vector<std::string> none;
    const auto found = all.find(name);
    return found == all.end() ? none : found->second;
}

/// "sqrt" of "std::sqrt"
std::string short_name(const std::string& name) {
    if (name == "safe_sqrt") return "sqrt";
    return name.starts_with("std::") || name.starts_with("glm::") ? name.substr(5) : name;
}

class Wrapper {
public:
    Wrapper(const std::string& file, const std::string& text, const std::vector<std::string>& fragments, int first)
        : file_(file), tokens_(tokens_of(text)), fragments_(fragments.begin(), fragments.end()), first_(first) {}

    Wrapped run() {
        skip_to_function();
        Wrapped all;
        const std::size_t start = at_;
        std::size_t name = at_;
        while (!is("(")) name = at_++;
        all.fragment = tokens_[name].text;
        while (!is("{")) ++at_;
        all.head = joined(start, at_);
        count_uses();
        all.code = block();
        all.nodes = std::move(nodes_);
        return all;
    }

private:
    // ---- tokens ----

    const Token& now() const { return tokens_[at_]; }
    bool is(std::string_view text) const { return now().kind != Token::Kind::end && now().text == text; }
    bool is_name(std::size_t ahead = 0) const {
        return at_ + ahead < tokens_.size() && tokens_[at_ + ahead].kind == Token::Kind::name;
    }
    bool take(std::string_view text) {
        if (!is(text)) return false;
        ++at_;
        return true;
    }
    void expect(std::string_view text) {
        if (!take(text)) fail(fmt::format("\"{}\"; expected \"{}\"", now().text, text));
    }
    [[noreturn]] void fail(const std::string& what) const {
        throw std::runtime_error(fmt::format("{}:{}:{}: {}", file_, now().line, now().column, what));
    }

    std::string joined(std::size_t from, std::size_t to) const {
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

    /// Past "namespace rt {".
    void skip_to_function() {
        while (!is("namespace")) {
            if (now().kind == Token::Kind::end) fail("no \"namespace rt {\"; expected one around a function");
            ++at_;
        }
        at_ += 3;
    }

    /// A chain of fields that stands there: "light.sphere.center"; where it ends.
    std::string chain_at(std::size_t i, std::size_t& end) const {
        std::string chain = tokens_[i].text;
        end = i + 1;
        while (end + 1 < tokens_.size() && tokens_[end].text == "." && tokens_[end + 1].kind == Token::Kind::name &&
               tokens_[end + 2].text != "(") {
            chain += "." + tokens_[end + 1].text;
            end += 2;
        }
        return chain;
    }

    void count_uses() {
        for (std::size_t i = at_; i < tokens_.size();) {
            std::size_t end = i + 1;
            if (tokens_[i].kind == Token::Kind::name) ++uses_[chain_at(i, end)];
            i = end;
        }
    }

    // ---- nodes ----

    int add(const std::string& text, const std::vector<Expression>& parts = {},
            std::vector<std::string> alternatives = {}) {
        nodes_.push_back({text, text, "", "", {}, std::move(alternatives)});
        for (const Expression& part : parts)
            if (part.node >= 0) nodes_.back().parts.push_back(part.node);
        return first_ + int(nodes_.size()) - 1;
    }
    static void watch(Expression& of, int node) {
        of.node = node;
        of.code = fmt::format("textbook::at({}, {})", node, of.inner);
    }

    /// Puts the statement's text into the nodes that were added since.
    void set_context(std::size_t since, const std::string& text) {
        for (std::size_t i = since; i < nodes_.size(); ++i)
            if (nodes_[i].context.empty()) nodes_[i].context = text;
    }

    /// The last node since then is a variable's value, whose name says more.
    void name_last(std::size_t since, const std::string& name, const Expression& of) {
        if (nodes_.size() > since && nodes_.back().text == of.text) nodes_.back().name = name;
    }

    // ---- expressions ----

    Expression expression() {
        const Expression condition = binary(1);
        if (!take("?")) return condition;
        const Expression first = expression();
        expect(":");
        const Expression second = expression();
        Expression all;
        all.text = fmt::format("{} ? {} : {}", condition.text, first.text, second.text);
        all.inner = fmt::format("({} ? {} : {})", condition.code, first.code, second.code);
        watch(all, add(all.text, {first, second}));
        return all;
    }

    /// The sides of a sum are of interest where it stands in brackets.
    Expression binary(int level) {
        Expression left = unary();
        for (;;) {
            const auto found = operators().find(now().text);
            if (now().kind != Token::Kind::sign || found == operators().end() || found->second.level < level)
                return left;
            ++at_;
            left = joined_by(left, *found, binary(found->second.level + 1));
        }
    }

    Expression joined_by(const Expression& left, const std::pair<const std::string, Operator>& sign,
                         const Expression& right) {
        Expression all;
        all.text = fmt::format("{} {} {}", left.text, sign.first, right.text);
        std::vector<std::string> alternatives;
        for (const std::string& other : sign.second.others)
            alternatives.push_back(fmt::format("{} {} {}", left.text, other, right.text));
        if (sign.first == "-" || sign.first == "/")
            alternatives.push_back(fmt::format("{} {} {}", right.text, sign.first, left.text));
        const bool is_after = sign.second.level == 6 && !right.sides.empty();
        const bool is_before = sign.second.level == 6 && !left.sides.empty() && !is_after;
        const Expression& group = is_after ? right : left;
        if (is_after)
            alternatives.push_back(fmt::format("{} {} {} {} {}", left.text, sign.first, group.sides[0].text, group.sign,
                                               group.sides[1].text));
        if (is_before)
            alternatives.push_back(fmt::format("{} {} {} {} {}", group.sides[0].text, group.sign, group.sides[1].text,
                                               sign.first, right.text));
        const int node = add(all.text, {left, right}, alternatives);
        if (*sign.second.name)
            all.inner = fmt::format("textbook::binary<{}>({}, {}, {})", sign.second.name, node, left.code, right.code);
        else
            all.inner = fmt::format("(textbook::chosen({0}) == 1 ? {1} {3} {2} : {1} {4} {2})", node, left.code,
                                    right.code, sign.second.others.front(), sign.first);
        if (is_after)
            all.inner = fmt::format("textbook::regrouped<{}, {}, true>({}, {}, {}, {}, {}, {})",
                                    function_of(group.sign), function_of(sign.first), node, alternatives.size(),
                                    all.inner, left.code, group.sides[0].code, group.sides[1].code);
        if (is_before)
            all.inner = fmt::format("textbook::regrouped<{}, {}, false>({}, {}, {}, {}, {}, {})",
                                    function_of(group.sign), function_of(sign.first), node, alternatives.size(),
                                    all.inner, group.sides[0].code, group.sides[1].code, right.code);
        watch(all, node);
        if (sign.second.level == 5) all.sides = {left, right}, all.sign = sign.first;
        return all;
    }

    /// The function object of a sign.
    static std::string function_of(const std::string& sign) {
        const std::string names = operators().at(sign).name;
        return names.substr(0, names.find(','));
    }

    Expression unary() {
        for (const char* sign : {"-", "!"}) {
            if (!take(sign)) continue;
            const Expression of = unary();
            Expression all{sign + of.text, fmt::format("({}{})", sign, of.code), "", of.is_literal};
            watch(all, add(all.text, {of}));
            return all;
        }
        return postfix();
    }

    /// What stands between brackets, after the opening one.
    std::vector<Expression> arguments(std::string_view close) {
        std::vector<Expression> all;
        while (!is(close)) {
            const std::size_t since = nodes_.size();
            all.push_back(is("{") ? braced() : expression());
            if (close == "}") set_context(since, all.back().text);
            if (!take(",")) break;
        }
        expect(close);
        return all;
    }

    static std::string list(const std::vector<Expression>& all, std::string Expression::*part) {
        std::string text;
        for (const Expression& one : all) text += (text.empty() ? "" : ", ") + one.*part;
        return text;
    }

    /// Literals stay as they are: a constant may be a Real here, an int may not.
    Expression braced() {
        expect("{");
        std::vector<Expression> all = arguments("}");
        for (Expression& one : all)
            if (one.is_literal) one.code = one.text;
        Expression whole{"(" + list(all, &Expression::text) + ")", "{" + list(all, &Expression::code) + "}", "", false};
        whole.code = whole.inner;
        return whole;
    }

    Expression postfix() {
        Expression all = primary();
        for (;;) {
            if (take(".")) {
                const std::string name = now().text;
                ++at_;
                all.text += "." + name, all.inner += "." + name;
                if (take("(")) call(all, name, "");
            } else if (take("[")) {
                const Expression index = expression();
                expect("]");
                all.text += "[" + index.text + "]",
                    all.inner = "textbook::element(" + all.inner + ", " + index.code + ")";
            } else {
                return all;
            }
            finish(all);
        }
    }

    /// Puts its arguments behind a function's name.
    void call(Expression& function, const std::string& name, const std::string& qualified) {
        const std::string before = function.text;
        const auto all = arguments(")");
        called_with_ = all;
        function.text = before + "(" + list(all, &Expression::text) + ")";
        const std::string code = list(all, &Expression::code);
        function.inner = (qualified.empty() ? function.inner : qualified) + "(" + code + ")";
        std::vector<std::string> alternatives, codes;
        for (const std::string& other : functions_for(name)) {
            alternatives.push_back(short_name(other) + "(" + list(all, &Expression::text) + ")");
            codes.push_back(other + "(" + code + ")");
        }
        if ((name == "std::pow" || name == "std::atan2") && all.size() == 2) {
            alternatives.push_back(fmt::format("{}({}, {})", short_name(name), all[1].text, all[0].text));
            codes.push_back(fmt::format("{}({}, {})", name, all[1].code, all[0].code));
            alternatives.push_back(fmt::format("{} * {}", all[0].text, all[1].text));
            codes.push_back(fmt::format("({}) * ({})", all[0].code, all[1].code));
        }
        if (codes.empty()) return;
        const int node = add(function.text, {}, alternatives);
        nodes_.back().function = name;
        std::string choice = function.inner;
        for (std::size_t i = codes.size(); i-- > 0;)
            choice = fmt::format("(textbook::chosen({}) == {} ? {} : {})", node, i + 1, codes[i], choice);
        function.inner = choice;
    }

    Expression primary() {
        Expression all;
        if (take("(")) {
            const Expression of = expression();
            expect(")");
            return {"(" + of.text + ")",
                    "(" + of.inner + ")",
                    "(" + of.code + ")",
                    of.is_literal,
                    of.sides,
                    of.sign,
                    of.node};
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
        if (is("(") && end - 1 > 0 && chain == name) {
            take("(");
            call(all, name, fragments_.contains(name) ? "any::" + name : "");
        } else if (is("{")) {
            const Expression fields = braced();
            all.text += fields.text, all.inner += fields.inner;
        } else {
            const bool is_constant = chain == "inf" || chain == "pi" || chain.find("::") != std::string::npos;
            const bool is_once = uses_[chain] < 2 || (constants_.contains(chain) && uses_[chain] < 3);
            all.code = all.inner;
            if (!is_constant && !is_once && chain != "true" && chain != "false") watch(all, add(all.text));
            return all;
        }
        finish(all);
        return all;
    }

    /// What a field or an element is taken of is not watched itself.
    void finish(Expression& all) {
        if (is(".") || is("["))
            all.code = all.inner;
        else
            watch(all, add(all.text, called_with_));
        called_with_.clear();
    }

    /// A lambda, as it is.
    Expression function_object() {
        const std::size_t start = at_;
        while (!is("{")) ++at_;
        int depth = 0;
        do depth += is("{") - is("}"), ++at_;
        while (depth > 0);
        Expression all;
        all.text = "a function", all.inner = all.code = joined(start, at_);
        return all;
    }

    // ---- statements ----

    std::string block() {
        expect("{");
        std::string all = "{\n";
        while (!is("}")) {
            if (now().kind == Token::Kind::end) fail("the end of the file; expected \"}\"");
            all += statement();
        }
        expect("}");
        return all + "}\n";
    }

    std::string statement() {
        const std::size_t since = nodes_.size();
        if (is("{")) return block();
        if (take("if")) {
            const std::string condition = in_brackets();
            std::string all = "if (" + condition + ") " + statement();
            if (take("else")) all += "else " + statement();
            return all;
        }
        if (take("while")) {
            const std::string condition = in_brackets();
            return "while (" + condition + ") " + statement();
        }
        if (take("for")) return loop();
        for (const char* word : {"continue", "break"})
            if (take(word)) {
                expect(";");
                return std::string(word) + ";\n";
            }
        if (take("return")) {
            const Expression of = is("{") ? braced() : expression();
            expect(";");
            set_context(since, of.text);
            return "return " + of.code + ";\n";
        }
        return is_declaration() ? declaration() : assignment();
    }

    std::string in_brackets() {
        const std::size_t since = nodes_.size();
        expect("(");
        const Expression of = expression();
        expect(")");
        set_context(since, "if (" + of.text + ")");
        return of.code;
    }

    std::string loop() {
        expect("(");
        const bool is_constant = take("const");
        const std::size_t start = at_;
        while (!is(":") && !is("=")) ++at_;
        std::string head = (is_constant ? "const " : "") + joined(start, at_);
        if (take(":")) {
            const Expression range = expression();
            expect(")");
            return "for (" + head + " : " + range.inner + ") " + statement();
        }
        expect("=");
        const std::size_t since = nodes_.size();
        const Expression from = expression();
        expect(";");
        const Expression while_true = expression();
        expect(";");
        set_context(since, while_true.text);
        const std::size_t step = at_;
        while (!is(")")) ++at_;
        const std::string last = joined(step, at_);
        expect(")");
        return fmt::format("for ({} = {}; {}; {}) ", head, from.code, while_true.code, last) + statement();
    }

    bool is_declaration() const {
        if (is("const")) return true;
        if (!is_name()) return false;
        const std::size_t name = at_ + 1 + (tokens_[at_ + 1].text == "&");
        return tokens_[name].kind == Token::Kind::name;
    }

    std::string declaration() {
        const bool is_constant = take("const");
        std::string all = (is_constant ? "const " : "") + now().text;
        ++at_;
        if (is("&") && !is_constant) fail("a reference that may be written through; expected a value");
        if (take("&")) all += "&";
        do {
            const std::size_t since = nodes_.size();
            const std::string name = now().text;
            ++at_;
            all += " " + name;
            if (is_constant) constants_.insert(name);
            if (take("=")) {
                const Expression of = is("{") ? braced() : expression();
                all += " = " + of.code;
                set_context(since, name + " = " + of.text), name_last(since, name, of);
            } else if (is("{")) {
                all += braced().inner;
            } else if (take("(")) {
                all += "(" + list(arguments(")"), &Expression::code) + ")";
            }
            if (is(",")) all += ",";
        } while (take(","));
        expect(";");
        return all + ";\n";
    }

    std::string assignment() {
        const std::size_t since = nodes_.size(), start = at_;
        if (take("++") || take("--")) {
            while (!is(";")) ++at_;
            expect(";");
            return joined(start, at_) + "\n";
        }
        std::size_t end = at_;
        int depth = 0;
        for (; depth > 0 || (tokens_[end].text != ";" && !is_assigned(tokens_[end].text)); ++end) {
            if (tokens_[end].kind == Token::Kind::end) fail("no statement that is known; expected an assignment");
            depth += (tokens_[end].text == "(") - (tokens_[end].text == ")");
        }
        if (!is_assigned(tokens_[end].text)) {
            const Expression called = postfix();
            expect(";");
            set_context(since, called.text);
            return called.inner + ";\n";
        }
        const std::string left = joined(at_, end), sign = tokens_[end].text;
        at_ = end + 1;
        const Expression right = expression();
        expect(";");
        set_context(since, fmt::format("{} {} {}", left, sign, right.text));
        return fmt::format("{} {} {};\n", left, sign, right.code);
    }

    static bool is_assigned(const std::string& sign) {
        return sign == "=" || sign == "+=" || sign == "-=" || sign == "*=" || sign == "/=";
    }

    const std::string file_;
    std::vector<Token> tokens_;
    std::set<std::string> fragments_, constants_;
    std::map<std::string, int> uses_;
    int first_;
    std::size_t at_ = 0;
    std::vector<WrappedNode> nodes_;
    std::vector<Expression> called_with_;  // the last call
};

}  // namespace

Wrapped wrap(const std::string& file, const std::string& text, const std::vector<std::string>& fragments, int first) {
    Wrapped all = Wrapper(file, text, fragments, first).run();
    if (constexpr std::string_view says = "// says: "; text.starts_with(says))
        all.says = text.substr(says.size(), text.find('\n') - says.size());
    return all;
}

}  // namespace grade::textbook
