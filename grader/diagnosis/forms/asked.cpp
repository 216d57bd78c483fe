#include "diagnosis/forms/asked.h"

#include <fmt/format.h>

#include "diagnosis/calls/expressions.h"
#include "diagnosis/forms/whole_expression.h"

namespace grade {

using textbook::Value;
using textbook::watch;

Row Asked::answer(const Row& row, const Layout& layout, const Mistake* first, const Mistake* second) {
    const Row* asked = &row;
    for (const Mistake* mistake : {first, second})
        if (mistake && mistake->of_arguments) {
            if (asked != &changed_) changed_ = row;
            asked = &changed_;
            if (!mistake->of_arguments->make(changed_, layout) || changed_.size() != row.size()) return {};
        }
    watch.begin(form_.first, form_.nodes.size(), *asked, first ? &first->made : nullptr,
                second ? &second->made : nullptr);
    try {
        return form_.answer(*asked);
    } catch (const std::exception&) {
        return {};
    }
}

std::vector<Mistake> Asked::mistakes_of(const Calls& calls) {
    Expressions all{form_.nodes, form_.first, std::vector<Value::Kind>(form_.nodes.size(), Value::Kind::none)};
    for (std::size_t k = 0; k < calls.size(); ++k) {
        answer(calls.rows[k], calls.layouts[k]);
        for (std::size_t i = 0; i < all.seen.size(); ++i)
            if (watch.values[i].kind != Value::Kind::none) all.seen[i] = watch.values[i].kind;
    }
    return mistakes_in(all, calls.layouts.front(), calls.told);
}

std::string Asked::words_of(const Mistake& mistake, bool with_context) const {
    if (mistake.of_arguments) return mistake.of_arguments->words;
    const Expressions all{form_.nodes, form_.first};
    if (const auto whole = of_whole(all, mistake)) return words_of(*whole, with_context);
    const textbook::Node& node = all.node(mistake.made.nodes.front());
    const bool is_everywhere = mistake.made.nodes.size() > 1;
    const bool has_context = !is_everywhere && with_context && node.context != node.text;
    const std::string words = in_place(changed_in_words(all, mistake), written_in_words(all, mistake),
                                       has_context ? which_in_words(all, mistake, true) : "");
    if (is_everywhere) return words + " everywhere";
    return has_context ? fmt::format("{}, where a textbook has `{}`", words, node.context) : words;
}

Ask answers_of(const textbook::Form& form, const Signature& signature) {
    return [&form, &signature](const Rows& rows) {
        Asked asked(form);
        Rows all;
        for (const Row& row : rows) all.push_back(asked.answer(row, signature.of_arguments(row)));
        return all;
    };
}

std::optional<Calls> with_answers_of(Asked& asked, Calls calls) {
    for (std::size_t k = 0; k < calls.size(); ++k) {
        Row answer = asked.answer(calls.rows[k], calls.layouts[k]);
        // a book's formula may be no number where the solution is one
        if (answer.size() != calls.right[k].size() || is_nan(answer, calls.right[k])) return std::nullopt;
        calls.right[k] = std::move(answer);
    }
    return calls;
}

std::optional<Calls> as_form_has(const Calls& calls, Asked& asked, bool sampled) {
    constexpr double least = 0.9;  // of the calls, in which the form must be the solution
    Calls same = those_of(calls, [&](std::size_t k) {
        return is_answer(calls.result, asked.answer(calls.rows[k], calls.layouts[k]), calls.right[k]);
    });
    if (double(same.size()) >= least * double(calls.size())) return same;
    return sampled ? with_answers_of(asked, calls) : std::nullopt;
}

Calls with_numbers(const Calls& calls, const Change& base, Asked& asked) {
    Calls all = calls;
    for (std::size_t k = 0; k < all.size(); ++k) {
        base.make(all.rows[k], all.layouts[k]);
        all.right[k] = asked.answer(all.rows[k], all.layouts[k]);
    }
    return all;
}

}  // namespace grade
