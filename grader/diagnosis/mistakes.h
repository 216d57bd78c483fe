#pragma once

#include <deque>

#include "diagnosis/calls.h"
#include "diagnosis/changes.h"
#include "textbook/form.h"

/// What is done wrong in one expression of a formula.
namespace grade {

/// A value that can stand in another's place.
struct OtherValue {
    std::string name;
    textbook::Value::Kind kind;
    int node = -1;       // in the form; -1: an argument
    std::size_t at = 0;  // in the row of arguments
};

struct Mistake {
    const char* pattern = "";  // {0}: what is written, {1}: the other value; of an alternative, its text
    const char* usually = "";  // what that is in most code
    double cost = 0;           // the simpler, the less
    textbook::Mistake made{};
    const OtherValue* other = nullptr;
    const Change* of_arguments = nullptr;  // in place of one in an expression
};

/// A textbook's form that is asked about calls.
class Asked {
public:
    explicit Asked(const textbook::Form& form) : form_(form) {}
    Asked(const Asked&) = delete;
    Asked& operator=(const Asked&) = delete;

    int first() const { return form_.first; }

    /// The answer with so many mistakes in it; none where it breaks off.
    Row answer(const Row& row, const Layout& layout, const Mistake* first = nullptr, const Mistake* second = nullptr);

    /// Those that make sense in what was seen in the calls, the simplest first. They are valid as long as this is.
    std::vector<Mistake> mistakes_in(const Calls& calls);

    /// "`2 * x` in place of `x`, in `y = x * x`"
    std::string words_of(const Mistake& mistake) const;

private:
    friend class MistakesMade;

    const double* numbers_of(const OtherValue& other) const;

    const textbook::Form& form_;
    const Row* row_ = nullptr;  // the present one
    Row changed_;
    std::deque<OtherValue> others_;
};

}  // namespace grade
