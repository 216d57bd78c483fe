#pragma once

#include "textbook/expressions.h"

namespace grade::textbook {

/// Whether a sign gives what stands before it another value.
bool is_assigned(const std::string& sign);

/// Reads statements: declarations, if, for, while, return and assignments.
class StatementReader : protected ExpressionReader {
protected:
    using ExpressionReader::ExpressionReader;

    std::string block();

    /// As it is compiled. Throws std::runtime_error for what is none of these.
    virtual std::string statement();

    /// A condition, as it is compiled.
    std::string in_brackets();

    std::string loop();

    /// What is read until its end is in a loop, where `break` and `continue` may be taken for each other, or is not.
    class Inside {
    public:
        Inside(StatementReader& reader, bool is_loop) : in_loop_(reader.in_loop_), before_(in_loop_) {
            in_loop_ = is_loop;
        }
        Inside(const Inside&) = delete;
        Inside& operator=(const Inside&) = delete;
        ~Inside() { in_loop_ = before_; }

    private:
        bool& in_loop_;
        bool before_;
    };

    /// Of a loop.
    std::string body();

    bool is_declaration() const;
    std::string declaration();
    std::string assignment();

    bool in_loop_ = false;

private:
    std::string jump(const std::string& word, const std::string& other);

    std::string condition_, where_;  // the last one; what stands before a return that depends on it
};

}  // namespace grade::textbook
