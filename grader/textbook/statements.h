#pragma once

#include "textbook/expressions.h"

namespace grade::textbook {

/// Reads statements: declarations, if, for, while, return and assignments.
/// Whether a sign gives what stands before it another value.
bool is_assigned(const std::string& sign);

class StatementReader : protected ExpressionReader {
protected:
    using ExpressionReader::ExpressionReader;

    std::string block();

    /// As it is compiled. Throws std::runtime_error for what is none of these.
    virtual std::string statement();

    /// A condition, as it is compiled.
    std::string in_brackets();

    std::string loop();

    bool is_declaration() const;
    std::string declaration();
    std::string assignment();

private:
    std::string condition_, where_;  // the last one; what stands before a return that depends on it
};

}  // namespace grade::textbook
