#include "diagnosis/rules/shares.h"

#include <fmt/format.h>

#include <algorithm>

#include "diagnosis/changes/answer_forms.h"

namespace grade {

namespace {

constexpr std::size_t least_calls = 8;

/// The calls, with what one colour adds in place of the whole answer.
Calls with_share(const Calls& calls, std::size_t part, const Ask& mine, const Ask& right) {
    Rows rows = calls.rows;
    for (std::size_t k = 0; k < rows.size(); ++k)
        for (std::size_t c = 0; c < 3; ++c) rows[k][calls.layouts[k].parts[part].at + c] = 0;
    Calls added = calls;
    const Rows own = mine(rows), due = right(rows);
    if (own.size() != rows.size() || due.size() != rows.size()) return {calls.signature, {}, {}, {}, {}, {}, {}};
    for (std::size_t k = 0; k < rows.size(); ++k)
        for (std::size_t i = 0; i < added.right[k].size(); ++i) {
            added.mine[k][i] -= own[k][i], added.right[k][i] -= due[k][i];
            // what rounding leaves
            for (Row* row : {&added.mine[k], &added.right[k]})
                if (std::abs((*row)[i]) < 1e-12) (*row)[i] = 0;
        }
    return added;
}

bool is_nothing(const Row& row) {
    return std::ranges::all_of(row, [](double x) { return x == 0; });
}

struct Share {
    std::string colour;
    Calls calls;  // with the share in place of the answers
};

/// Whether one share holds all of another one and more, or is the same again: its colour is a factor of the other.
bool holds(const Share& whole, const Share& part) {
    for (std::size_t k = 0; k < whole.calls.size(); ++k)
        for (std::size_t c = 0; c < 3; ++c)
            if (whole.calls.right[k][c] < part.calls.right[k][c] * (1 - 1e-9)) return false;
    return true;
}

std::vector<Share> shares_of(const Calls& calls, const Ask& mine, const Ask& right) {
    const auto& parts = calls.layouts.front().parts;
    std::vector<Share> all;
    for (std::size_t i = 0; i < parts.size(); ++i) {
        if (parts[i].kind != Kind::color || !calls.told[i]) continue;
        Share share{parts[i].name, with_share(calls, i, mine, right)};
        if (!std::ranges::all_of(share.calls.right, is_nothing)) all.push_back(std::move(share));
    }
    std::vector<Share> own;
    for (std::size_t i = 0; i < all.size(); ++i) {
        bool is_factor = false;
        for (std::size_t j = 0; j < all.size(); ++j)
            is_factor = is_factor || (i != j && holds(all[i], all[j]) && (j < i || !holds(all[j], all[i])));
        if (!is_factor) own.push_back(all[i]);
    }
    return own;
}

}  // namespace

std::string wrong_shares(const Calls& calls, const Ask& mine, const Ask& right) {
    if (calls.result.parts.size() != 1 || calls.result.parts.front().kind != Kind::color) return {};
    std::string found, unknown;
    std::size_t good = 0;
    for (const auto& [colour, added] : shares_of(calls, mine, right)) {
        std::vector<std::size_t> scope;
        bool is_all = true, is_wrong = false;
        for (std::size_t k = 0; k < added.size(); ++k) {
            if (is_nothing(added.right[k]) && is_nothing(added.mine[k])) continue;
            scope.push_back(k);
            is_all = is_all && is_equal(calls.result, added.right[k], calls.right[k]);
            is_wrong = is_wrong || !is_equal(calls.result, added.mine[k], added.right[k]);
        }
        if (scope.size() < least_calls || is_all) continue;
        if (!is_wrong) {
            ++good;
            continue;
        }
        const auto form = form_of(added, calls.result.parts.front(), added.right, scope, false);
        std::string& list = form ? found : unknown;
        list +=
            fmt::format("{}what `{}` adds {}", list.empty() ? "" : ", and ", colour, form ? form->words : "is wrong");
    }
    if (found.empty() && (unknown.empty() || good == 0)) return {};
    return found.empty() ? unknown : unknown.empty() ? found : found + "; " + unknown;
}

}  // namespace grade
