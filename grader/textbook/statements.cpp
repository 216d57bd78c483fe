#include "textbook/statements.h"

namespace grade::textbook {

bool is_assigned(const std::string& sign) {
    return sign == "=" || sign == "+=" || sign == "-=" || sign == "*=" || sign == "/=";
}

std::string StatementReader::block() {
    const Block scope(*this);
    expect("{");
    std::string all = "{\n";
    while (!is("}")) {
        if (now().kind == Token::Kind::end) fail("the end of the file; expected \"}\"");
        all += statement();
    }
    expect("}");
    return all + "}\n";
}

std::string StatementReader::statement() {
    const std::size_t since = nodes_.size();
    if (is("{")) return block();
    if (take("if")) {
        const std::string condition = in_brackets();
        if (is("return")) where_ = fmt::format("if ({}) return ", condition_);
        if (is("break") || is("continue")) where_ = fmt::format("if ({}) ", condition_);
        std::string all = "if (" + condition + ") " + statement();
        where_.clear();
        if (take("else")) all += "else " + statement();
        return all;
    }
    if (take("while")) {
        const std::string condition = in_brackets();
        return "while (" + condition + ") " + body();
    }
    if (take("for")) return loop();
    if (is("break")) return jump("break", "continue");
    if (is("continue")) return jump("continue", "break");
    if (take("return")) {
        const Expression of = is("{") ? braced() : expression();
        expect(";");
        set_context(since, where_ + of.text);
        return "return " + of.code + ";\n";
    }
    return is_declaration() ? declaration() : assignment();
}

std::string StatementReader::in_brackets() {
    const std::size_t since = nodes_.size();
    expect("(");
    const Expression of = expression();
    expect(")");
    set_context(since, "if (" + of.text + ")");
    condition_ = of.text;
    return of.code;
}

std::string StatementReader::loop() {
    const Block scope(*this);
    expect("(");
    const bool is_constant = take("const");
    const std::size_t start = at_;
    skip_to({":", "="});
    const std::string name = tokens_[at_ - 1].text;
    declare(name);
    std::string head = (is_constant ? "const " : "") + joined(start, at_);
    if (take(":")) {
        const Expression range = is("{") ? braced() : expression();
        expect(")");
        return "for (" + head + " : " + range.inner + ") " + body();
    }
    expect("=");
    std::size_t since = nodes_.size();
    const Expression from = expression();
    expect(";");
    set_context(since, name + " = " + from.text), name_last(since, name, from);
    since = nodes_.size();
    const Expression while_true = expression();
    expect(";");
    set_context(since, while_true.text);
    const std::size_t step = at_;
    skip_to({")"});
    const std::string last = joined(step, at_);
    expect(")");
    return fmt::format("for ({} = {}; {}; {}) ", head, from.code, while_true.code, last) + body();
}

std::string StatementReader::body() {
    const Inside loop(*this, true);
    return statement();
}

/// Where the other one is chosen, that.
std::string StatementReader::jump(const std::string& word, const std::string& other) {
    const int line = now().line;
    expect(word);
    expect(";");
    if (!in_loop_) return word + ";\n";
    const std::size_t since = nodes_.size();
    const int node = add(word, {}, {other});
    nodes_.back().line = line;
    set_context(since, where_ + word);
    return fmt::format("{{\nif (textbook::at({0}, true) && textbook::chosen({0}) == 1) {1};\n{2};\n}}\n", node, other,
                       word);
}

bool StatementReader::is_declaration() const {
    if (is("const")) return true;
    if (!is_name()) return false;
    const std::size_t name = at_ + 1 + (tokens_[at_ + 1].text == "&");
    return tokens_[name].kind == Token::Kind::name;
}

std::string StatementReader::declaration() {
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
        locals_.insert(name), declare(name);
        if (take("=")) {
            const Expression of = is("{") ? braced() : expression();
            all += " = " + of.code;
            set_context(since, name + " = " + of.text), name_last(since, name, of);
        } else if (is("{")) {
            all += braced().inner;
        } else if (take("(")) {
            all += fmt::format("({})", list(arguments(")"), &Expression::code));
        }
        if (is(",")) all += ",";
    } while (take(","));
    expect(";");
    return all + ";\n";
}

std::string StatementReader::assignment() {
    const std::size_t since = nodes_.size(), start = at_;
    if (take("++") || take("--")) {
        skip_to({";"});
        expect(";");
        return joined(start, at_) + "\n";
    }
    std::size_t end = at_;
    int depth = 0;
    for (; depth > 0 || (tokens_[end].text != ";" && !is_assigned(tokens_[end].text)); ++end) {
        const bool is_other = tokens_[end].text == "{" || tokens_[end].kind == Token::Kind::end;
        if (is_other) fail("no statement that is known; expected an assignment");
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

}  // namespace grade::textbook
