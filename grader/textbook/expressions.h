#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>
#include <stdexcept>
#include <string>
#include <vector>

#include "textbook/tokens.h"
#include "textbook/wrap.h"

namespace grade::textbook {

/// An expression: as it is written, and as it is compiled; `inner` is not watched itself.
struct Expression {
    std::string text, inner, code;
    bool is_literal = false;
    std::vector<Expression> sides{};  // of a sum or a product
    std::string sign{};               // between them
    int node = -1;
    int line = 0;
};

/// A source takes too long to be read.
struct TooLong : std::exception {
    const char* what() const noexcept override { return "a long source; expected a short one"; }
};

/// Reads expressions of a form, and gives each a number by which watch.h knows it.
class ExpressionReader {
public:
    ExpressionReader(const ExpressionReader&) = delete;
    ExpressionReader& operator=(const ExpressionReader&) = delete;
    virtual ~ExpressionReader() = default;

protected:
    ExpressionReader(std::string file, const std::string& text, const std::vector<std::string>& fragments, int first)
        : file_(std::move(file)),
          tokens_(tokens_of(text)),
          fragments_(fragments.begin(), fragments.end()),
          first_(first) {}

    /// A step into a part. Throws std::runtime_error where parts lie too deep within each other.
    class Deeper {
    public:
        explicit Deeper(ExpressionReader& reader) : depth_(reader.depth_) {
            constexpr int deepest = 200;
            if (depth_ >= deepest) reader.fail("too many brackets within each other; expected fewer");
            ++depth_;
        }
        Deeper(const Deeper&) = delete;
        Deeper& operator=(const Deeper&) = delete;
        ~Deeper() { --depth_; }

    private:
        int& depth_;
    };

    /// What is read until its end stands in one more block.
    class Block {
    public:
        explicit Block(ExpressionReader& reader) : blocks_(reader.blocks_) { blocks_.push_back(reader.at_); }
        Block(const Block&) = delete;
        Block& operator=(const Block&) = delete;
        ~Block() { blocks_.pop_back(); }

    private:
        std::vector<std::size_t>& blocks_;
    };

    void declare(const std::string& name) { declared_[name].push_back(blocks_); }

    const Token& now() const { return tokens_[std::min(at_, tokens_.size() - 1)]; }

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

    /// Throws std::runtime_error where none of these follows.
    void skip_to(std::initializer_list<std::string_view> signs);

    std::string joined(std::size_t from, std::size_t to) const;

    /// A chain of fields that stands there: "light.sphere.center"; where it ends.
    std::string chain_at(std::size_t i, std::size_t& end) const;

    void count_uses();

    int add(const std::string& text, const std::vector<Expression>& parts = {},
            std::vector<std::string> alternatives = {});

    /// What is compiled: what is in brackets is written more than once.
    void check_length(const std::string& code) const {
        constexpr std::size_t longest = 20'000;
        if (code.size() > longest) fail("a long expression; expected a short one");
    }

    void watch(Expression& of, int node) {
        check_length(of.inner);
        of.node = node;
        nodes_[std::size_t(node - first_)].line = of.line;
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

    Expression expression();

    /// One with "?", or without.
    Expression choice();

    /// The sides of a sum are of interest where it stands in brackets.
    Expression binary(int level);

    Expression joined_by(const Expression& left, const std::string& sign, const Expression& right);

    Expression unary();

    /// What stands between brackets, after the opening one.
    std::vector<Expression> arguments(std::string_view close);

    static std::string list(const std::vector<Expression>& all, std::string Expression::*part) {
        std::string text;
        for (const Expression& one : all) text += (text.empty() ? "" : ", ") + one.*part;
        return text;
    }

    /// Literals stay as they are: a constant may be a Real here, an int may not.
    Expression braced();

    /// "<double>" behind a name, where it is no comparison.
    std::string template_arguments();

    Expression postfix();
    void length_of(Expression& of, const std::string& sign);

    /// Puts its arguments behind a function's name.
    void call(Expression& function, const std::string& name, const std::string& qualified);

    /// What may be written in place of an expression, as it reads and as it is compiled.
    struct InPlace {
        std::vector<std::string> texts, codes;
    };
    static InPlace in_place_of_call(const std::string& name, bool is_method, const std::string& types,
                                    const std::vector<Expression>& all, const std::string& code);

    Expression primary();

    /// What a field or an element is taken of is not watched itself.
    void finish(Expression& all);

    /// A lambda, as it is.
    virtual Expression function_object();

    /// Whether a function may change its arguments: they are passed as they are.
    virtual bool changes_arguments(const std::string&) const { return false; }

    const std::string file_;
    std::vector<Token> tokens_;
    std::set<std::string> fragments_, constants_, locals_;
    bool is_source_ = false;       // a student's, not a form: of it, more is tried
    std::set<std::string> calls_;  // of fragments
    std::map<std::string, int> uses_;
    std::vector<std::size_t> blocks_;                                        // that are open, by where they begin
    std::map<std::string, std::vector<std::vector<std::size_t>>> declared_;  // in which blocks
    int first_;
    std::size_t at_ = 0;
    std::size_t read_ = 0;  // expressions, also those that were given up
    int depth_ = 0;         // of expressions and statements within each other
    std::vector<Node> nodes_;
    std::vector<Expression> called_with_;  // the last call
};

}  // namespace grade::textbook
