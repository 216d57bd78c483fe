#pragma once

#include <string>
#include <vector>

#include "diagnosis/calls/calls.h"
#include "textbook/form.h"

namespace grade {

/// "a < b"; of a choice, the condition is one.
bool is_comparison(const textbook::Node& node);

/// Values of a textbook's expressions that may be missing in a student's source, in words that can be written there: of
/// arguments and of parts of the answer.
class Borrowed {
public:
    struct Expression {
        std::string words;  // "dot(direction, n)"
        bool is_vector;
        std::size_t form;  // of those that answer as the solution does
        std::size_t node;
        bool is_compared = false;  // a textbook compares it with something
    };

    Borrowed() = default;
    explicit Borrowed(const Calls& calls);

    const std::vector<Expression>& all() const { return all_; }

    /// The numbers of all of them in this call, one after the other; nan where one is not computed.
    Row values(const Row& row, const Layout& layout) const;

private:
    void add_form(const Calls& calls, const textbook::Form& form);

    std::vector<const textbook::Form*> forms_;
    std::vector<Expression> all_;
};

}  // namespace grade
