#pragma once

#include "diagnosis/calls/quantities.h"
#include "diagnosis/source/borrowed.h"
#include "diagnosis/source/edits_in_words.h"
#include "diagnosis/source/repair.h"

namespace grade {

/// A fragment's calls, asked again with changes of its source.
class EditedCalls {
protected:
    static constexpr std::size_t most_at_once = 2'000;  // rows in one frame
    static constexpr std::size_t most_rows = 400'000;   // in all

    EditedCalls(const Calls& calls, const Editable& source);

    /// What the expressions' values are, and which of the arguments' dot products and lengths may be missing in them;
    /// false: the program does not tell.
    bool see();

    /// Of each edit, to all of these calls; empty: the program has ended.
    std::vector<Rows> answers(const std::vector<Edit>& edits, const Rows& calls);

    textbook::EditedCall call(const Calls& of, std::size_t k, bool only_kinds) const;

    bool is_right(std::size_t k, const Row& answer) const { return is_answer(calls_.result, answer, calls_.right[k]); }
    bool is_literal(const textbook::Mistake& made) const;

    const Calls& calls_;
    const Editable& source_;
    std::vector<std::size_t> wrong_, right_, others_;  // calls: some of either kind, and the rest of both
    Layout arguments_;                                 // and the quantities behind them
    std::vector<bool> told_;
    bool arguments_vary_ = false;  // some get other values: what was passed is not what is there
    std::vector<Quantity> quantities_;
    Borrowed borrowed_;
    Expressions all_;
    std::size_t asked_ = 0;

private:
    bool answers_as_before(const Rows& answers) const;
};

}  // namespace grade
