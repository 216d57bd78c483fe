#pragma once

#include <optional>

#include "diagnosis/calls/calls.h"
#include "diagnosis/forms/mistakes.h"
#include "textbook/form.h"

namespace grade {

/// A textbook's form that is asked about calls.
class Asked {
public:
    explicit Asked(const textbook::Form& form) : form_(form) {}

    const textbook::Form& form() const { return form_; }
    int first() const { return form_.first; }

    /// The answer with so many mistakes in it; none where it breaks off.
    Row answer(const Row& row, const Layout& layout, const Mistake* first = nullptr, const Mistake* second = nullptr);

    /// Those that make sense in what was seen in the calls, the simplest first.
    std::vector<Mistake> mistakes_of(const Calls& calls);

    /// "`2 * x` in place of `x`, in `y = x * x`"; or without the expression that it stands in.
    std::string words_of(const Mistake& mistake, bool with_context = true) const;

private:
    const textbook::Form& form_;
    Row changed_;
};

Ask answers_of(const textbook::Form& form, const Signature& signature);

/// The calls with the form's answers as the right ones; none: it breaks off in one.
std::optional<Calls> with_answers_of(Asked& asked, Calls calls);

/// The same; where the form is the solution, the calls in which it is.
std::optional<Calls> as_form_has(const Calls& calls, Asked& asked, bool sampled);

/// The calls with other random numbers.
Calls with_numbers(const Calls& calls, const Change& base, Asked& asked);

}  // namespace grade
