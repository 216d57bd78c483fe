#pragma once

#include "diagnosis/calls/calls.h"

/// What one part of an answer is, compared with the right one.
namespace grade {

struct AnswerForm {
    std::string words;  // "is 2 times too large"; empty: it is right
    double cost = 0;

    /// Always the same, which says nothing of a cause; of a vector, not normalised.
    enum class Kind { other, constant, not_unit };
    Kind kind = Kind::other;
};

/// One part of the answers to some calls.
struct PartOfCalls {
    const Calls& calls;
    const Field& part;
    const Rows& right_rows;
    const std::vector<std::size_t>& scope;  // the calls

    std::size_t size() const { return size_of(part.kind); }
    double mine(std::size_t k, std::size_t c) const { return calls.mine[k][part.at + c]; }
    double right(std::size_t k, std::size_t c) const { return right_rows[k][part.at + c]; }

    /// Whether mine is expected(call, component) everywhere.
    template <class F>
    bool equals(F expected) const {
        for (const std::size_t k : scope) {
            double scale = 1e-9;
            for (std::size_t c = 0; c < size(); ++c)
                if (std::isfinite(mine(k, c))) scale = std::max(scale, std::abs(mine(k, c)));
            for (std::size_t c = 0; c < size(); ++c)
                if (!is_close(mine(k, c), expected(k, c), scale)) return false;
        }
        return true;
    }
};

/// The simplest form in the calls of `scope` with which `mine` follows from `right`; none: there is none. Where only
/// simple ones are asked for: the same, the opposite sign, a constant factor.
std::optional<AnswerForm> form_of(const Calls& calls, const Field& part, const Rows& right,
                                  const std::vector<std::size_t>& scope, bool only_simple);

}  // namespace grade
