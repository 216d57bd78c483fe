#include "textbook/tokens.h"

#include <array>
#include <cctype>
#include <string_view>

#include "files/source_text.h"

namespace grade::textbook {

namespace {

constexpr std::array<std::string_view, 14> long_signs{
    "<=", ">=", "==", "!=", "&&", "||", "+=", "-=", "*=", "/=", "++", "--", "->", "::"};

class Reader {
public:
    explicit Reader(const std::string& text) : text_(text) {}

    std::vector<Token> all() {
        std::vector<Token> tokens;
        while (skip(), at_ < text_.size()) {
            Token token{Token::Kind::sign, "", line_, column_, at_};
            const std::size_t start = at_;
            if (std::isdigit(static_cast<unsigned char>(text_[at_]))) {
                token.kind = Token::Kind::number;
                while (at_ < text_.size() && (is_word(text_[at_]) || text_[at_] == '.' || is_sign_of_exponent()))
                    step(1);
            } else if (is_word(text_[at_])) {
                token.kind = Token::Kind::name;
                while (at_ < text_.size() && (is_word(text_[at_]) || text_.compare(at_, 2, "::") == 0))
                    step(is_word(text_[at_]) ? 1 : 2);
            } else {
                const std::size_t end = behind_quoted(text_, at_);
                step(end == at_ ? length_of_sign() : end - at_);
            }
            token.text = text_.substr(start, at_ - start), token.to = at_;
            tokens.push_back(std::move(token));
        }
        for (int i = 0; i < look_ahead; ++i) tokens.push_back({Token::Kind::end, "", line_, column_, at_, at_});
        return tokens;
    }

private:
    bool is_sign_of_exponent() const {
        return (text_[at_] == '-' || text_[at_] == '+') && (text_[at_ - 1] == 'e' || text_[at_ - 1] == 'E');
    }

    std::size_t length_of_sign() const {
        for (const std::string_view sign : long_signs)
            if (text_.compare(at_, sign.size(), sign) == 0) return sign.size();
        return 1;
    }

    void step(std::size_t count) {
        for (; count > 0 && at_ < text_.size(); --count, ++at_) {
            const bool is_end = text_[at_] == '\n';
            line_ += is_end, column_ = is_end ? 1 : column_ + 1;
        }
    }

    void skip() {
        while (at_ < text_.size()) {
            if (const std::size_t end = behind_comment(text_, at_); end != at_) {
                step(end - at_);
                continue;
            }
            const bool is_rest = text_[at_] == '#';
            if (!is_rest && !std::isspace(static_cast<unsigned char>(text_[at_]))) return;
            do step(1);
            while (is_rest && at_ < text_.size() && text_[at_] != '\n');
        }
    }

    const std::string& text_;
    std::size_t at_ = 0;
    int line_ = 1, column_ = 1;
};

}  // namespace

std::vector<Token> tokens_of(const std::string& text) { return Reader(text).all(); }

}  // namespace grade::textbook
