#include "textbook/source.h"

#include <algorithm>
#include <map>

#include "textbook/statements.h"

namespace grade::textbook {

namespace {

constexpr std::size_t most_bytes = 64 << 10, most_tokens = 12'000, longest_token = 100;  // of a source
constexpr std::size_t most_tries = 4'000;                                                // of statements
constexpr std::size_t most_written = 400'000;

class SourceReader : StatementReader {
public:
    explicit SourceReader(const std::string& text) : StatementReader("", text, {}, 0), text_(text) {
        is_source_ = true;
    }

    EditableSource run() {
        const auto is_long = [](const Token& token) { return token.text.size() > longest_token; };
        if (tokens_.size() > most_tokens || std::ranges::any_of(tokens_, is_long)) throw TooLong();
        find_changing_functions();
        find_constants();
        count_uses();
        EditableSource all;
        std::size_t copied = 0;
        while (now().kind != Token::Kind::end) {
            if (!is_body()) {
                ++at_;
                continue;
            }
            all.text += text_.substr(copied, now().from - copied);
            const std::size_t start = at_;
            all.text += block();
            copied = tokens_[at_ - 1].to;
            if (at_ == start) fail("no function; expected one");
        }
        all.text += text_.substr(copied);
        if (all.text.size() > most_written) throw TooLong();
        all.nodes = std::move(nodes_);
        all.varying = varying();
        for (Node& node : all.nodes) {
            node.known_in = std::min<std::size_t>(1, node.blocks.size());  // in its function
            if (const auto constant = literals_.find(node.text); constant != literals_.end())
                node.literal = constant->second;
            for (const Token& token : tokens_of(node.name == node.text ? node.text : node.name + ", " + node.text)) {
                node.varies = node.varies || all.varying.contains(token.text);
                node.known_in = std::max(node.known_in, known_in(token.text, node.blocks));
            }
        }
        if (all.nodes.empty()) fail("no expression; expected some");
        return all;
    }

private:
    /// Functions and lambdas with a parameter that they may change.
    void find_changing_functions() {
        for (std::size_t i = 0; i + 1 < tokens_.size(); ++i) {
            if (tokens_[i].kind != Token::Kind::name) continue;
            std::size_t open = i + 1;
            if (tokens_[open].text == "=" && tokens_[open + 1].text == "[") open = closing(open + 1) + 1;
            if (open >= tokens_.size() || tokens_[open].text != "(") continue;
            const std::size_t close = closing(open);
            const bool is_defined =
                close + 1 < tokens_.size() && (tokens_[close + 1].text == "{" || tokens_[close + 1].text == "->");
            bool is_constant = false, changes = false;
            for (std::size_t k = open + 1; k < close; ++k) {
                if (tokens_[k].text == ",") is_constant = false;
                is_constant = is_constant || tokens_[k].text == "const";
                changes = changes || (!is_constant && (tokens_[k].text == "&" || tokens_[k].text == "*"));
            }
            if (is_defined && changes) changing_.insert(tokens_[i].text);
        }
    }

    /// Constants with a name and what they are. What passes through a function while it is computed is no constexpr; a
    /// real number need not be one.
    void find_constants() {
        for (std::size_t i = 0; i + 4 < tokens_.size(); ++i) {
            const bool is_real =
                tokens_[i + 1].text == "Real" || tokens_[i + 1].text == "double" || tokens_[i + 1].text == "float";
            if ((tokens_[i].text != "const" && tokens_[i].text != "constexpr") || !is_real) continue;
            const bool is_literal =
                tokens_[i + 4].kind == Token::Kind::number && i + 5 < tokens_.size() && tokens_[i + 5].text == ";";
            if (tokens_[i + 3].text == "=" && is_literal) literals_[tokens_[i + 2].text] = tokens_[i + 4].text;
            if (i == 0 || tokens_[i - 1].text != "static") tokens_[i].text = "const";
        }
    }

    /// How many of these blocks a variable needs to be known.
    std::size_t known_in(const std::string& name, const std::vector<std::size_t>& blocks) const {
        std::size_t most = 0;
        if (const auto found = declared_.find(name); found != declared_.end())
            for (const auto& at : found->second)
                if (at.size() <= blocks.size() && std::equal(at.begin(), at.end(), blocks.begin()))
                    most = std::max(most, at.size());
        return most;
    }

    /// Names behind which, or behind an element or a part of which, an assignment stands that is no declaration.
    std::set<std::string> varying() const {
        std::set<std::string> all;
        for (std::size_t i = 1; i + 1 < tokens_.size(); ++i) {
            const std::string& before = tokens_[i - 1].text;
            const bool is_first = before == ";" || before == "{" || before == "}" || before == ")" || before == "else";
            if (tokens_[i].kind != Token::Kind::name || !is_first) continue;
            std::size_t end = i + 1;
            while (end + 2 < tokens_.size() && (tokens_[end].text == "[" || tokens_[end].text == "."))
                end = tokens_[end].text == "[" ? closing(end) + 1 : end + 2;
            if (is_assigned(tokens_[end].text)) all.insert(tokens_[i].text);
        }
        return all;
    }

    /// The bracket that closes this one; what stands before the end where there is none.
    std::size_t closing(std::size_t open) const {
        int depth = 0;
        for (std::size_t i = open; i < tokens_.size(); ++i) {
            const std::string& text = tokens_[i].text;
            depth += text == "(" || text == "[" || text == "{";
            depth -= text == ")" || text == "]" || text == "}";
            if (depth == 0) return i;
        }
        return tokens_.size() - look_ahead - 1;
    }

    /// Whether a function's body begins here: behind its parameters, or what it returns.
    bool is_body() const {
        if (!is("{")) return false;
        bool has_parameters = false;
        int depth = 0;
        for (std::size_t i = at_; i-- > 0;) {
            const std::string& text = tokens_[i].text;
            if (text == ";" || text == "{" || text == "}") break;
            depth += (text == ")") - (text == "(");
            has_parameters = has_parameters || text == ")";
            if (depth > 0) continue;
            for (const char* word : {"constexpr", "consteval", "namespace", "struct", "class", "enum", "union", "="})
                if (text == word) return false;
        }
        return has_parameters;
    }

    /// As the reader of forms has it; else with what stands before its first "=" as it is; else all of it as it is.
    std::string statement() override {
        const Deeper deeper(*this);
        if (++tries_ > most_tries) throw TooLong();
        if (const std::string label = labels(); !label.empty()) return label;
        if (is("constexpr") || is("static")) return as_it_is();  // computed once, or when it is compiled
        const std::size_t start = at_, since = nodes_.size();
        const auto go_back = [&] {
            at_ = start;
            nodes_.resize(since);
        };
        try {
            return StatementReader::statement();
        } catch (const std::runtime_error&) {
            go_back();
        }
        try {
            return with_value();
        } catch (const std::runtime_error&) {
            go_back();
        }
        return has_body() ? with_body() : as_it_is();
    }

    /// "case 1:", "default:"
    std::string labels() {
        const std::size_t start = at_;
        if (!is("case") && !is("default")) return {};
        skip_to({":"});
        expect(":");
        return raw(start, at_) + "\n";
    }

    /// "auto [x, y] = f(u);"
    std::string with_value() {
        const std::size_t start = at_, since = nodes_.size();
        while (!is("=")) {
            if (is("(") || is("{") || is(";") || now().kind == Token::Kind::end) fail("no value; expected one");
            at_ = is("[") ? closing(at_) + 1 : at_ + 1;
        }
        const std::size_t end = at_;
        const std::string before = raw(start, end);
        expect("=");
        const Expression of = is("{") ? braced() : expression();
        expect(";");
        set_context(since, joined(start, end) + " = " + of.text);
        return before + " = " + of.code + ";\n";
    }

    bool has_body() const {
        for (const char* word : {"if", "while", "for", "switch"})
            if (is(word)) return true;
        return is("do");
    }

    /// What stands in its brackets as it is.
    std::string with_body() {
        const std::size_t start = at_;
        if (take("do")) {
            std::string all = "do " + body();
            const std::size_t end = at_;
            expect("while");
            at_ = closing(at_) + 1;
            expect(";");
            return all + raw(end, at_) + "\n";
        }
        const bool is_if = is("if"), is_switch = is("switch");
        ++at_;
        take("constexpr");
        if (!is("(")) fail("no condition; expected one");
        at_ = closing(at_) + 1;
        std::string all = raw(start, at_) + " ";
        const Inside loop(*this, is_if ? in_loop_ : !is_switch);
        all += statement();
        if (is_if && take("else")) all += "else " + statement();
        return all;
    }

    std::string as_it_is() {
        const std::size_t start = at_;
        const bool is_type = is("struct") || is("class") || is("enum") || is("union");
        while (!is(";")) {
            if (is("}") || now().kind == Token::Kind::end) fail("no statement; expected one");
            const bool is_bracket = is("(") || is("[") || is("{");
            at_ = is_bracket ? closing(at_) + 1 : at_ + 1;
            if (is_type && tokens_[at_ - 1].text == "}" && !is(";")) fail("no type; expected one");
        }
        expect(";");
        return raw(start, at_) + "\n";
    }

    /// A lambda: its body's statements are read.
    Expression function_object() override {
        const std::size_t start = at_;
        at_ = closing(at_) + 1;
        const std::size_t open = at_;
        if (is("(")) at_ = closing(at_) + 1;
        const std::size_t close = at_;
        skip_to({"{"});
        const std::string head = raw(start, at_);
        const Block scope(*this);
        for (std::size_t i = open; i + 1 < close; ++i)
            if (tokens_[i].kind == Token::Kind::name && (tokens_[i + 1].text == "," || tokens_[i + 1].text == ")"))
                declare(tokens_[i].text);
        const Inside lambda(*this, false);
        Expression all;
        all.text = "a function";
        all.inner = all.code = head + block();
        return all;
    }

    bool changes_arguments(const std::string& name) const override {
        return changing_.contains(name) || name == "std::swap" || name == "std::exchange" || name == "std::modf" ||
               name == "std::frexp";
    }

    std::string raw(std::size_t from, std::size_t to) const {
        return to > from ? text_.substr(tokens_[from].from, tokens_[to - 1].to - tokens_[from].from) : std::string();
    }

    const std::string& text_;
    std::set<std::string> changing_;
    std::map<std::string, std::string> literals_;  // by name
    std::size_t tries_ = 0;
};

}  // namespace

bool needs_preprocessor(const std::string& text) {
    for (std::size_t at = 0; at < text.size(); at = text.find('\n', at), at += at < text.size()) {
        const std::size_t first = text.find_first_not_of(" \t", at);
        if (first >= text.size() || text[first] != '#') continue;
        const std::size_t word = text.find_first_not_of(" \t", first + 1);
        if (word != text.npos && text.compare(word, 7, "include") != 0 && text.compare(word, 6, "pragma") != 0)
            return true;
    }
    return false;
}

EditableSource editable(const std::string& text) {
    if (needs_preprocessor(text)) throw std::runtime_error("a line for the preprocessor; expected #include alone");
    if (text.size() > most_bytes) throw std::runtime_error("a source of more than 64 kB; expected a short one");
    EditableSource all = SourceReader(text).run();
    all.text = std::string("#include \"rt/fragments.h\"\n") + watched_text +
               "\nnamespace textbook = grade::textbook;\n#pragma GCC diagnostic ignored \"-Wnarrowing\"\n" + all.text;
    return all;
}

}  // namespace grade::textbook
