#include "diagnosis/where/simplest.h"

#include <algorithm>
#include <cmath>

#include "diagnosis/where/invariants.h"
#include "diagnosis/where/simpler_values.h"

namespace grade {

namespace {

/// Wrong by a hundredth or more, so that it shows.
bool shows(const Calls& calls, const Row& mine, const Row& right) {
    for (const double x : right)
        if (std::isnan(x)) return false;
    for (const Field& part : calls.result.parts) {
        if (!counts(calls.result, part, mine, right)) continue;
        const double scale = scale_of(part, mine, right);
        for (std::size_t c = 0; c < size_of(part.kind); ++c) {
            const double a = mine[part.at + c], b = right[part.at + c];
            if (a != b && !(std::abs(a - b) <= 0.01 * scale)) return true;
        }
    }
    return false;
}

class Shrinking {
public:
    Shrinking(const Calls& calls, const WrongCalls& region, const Ask& mine, const Ask& right)
        : calls_(calls), region_(region), mine_(mine), right_(right), invariants_(calls) {
        for (std::size_t k = 0; k < calls.size(); ++k)
            for (const Row* answer : {&calls.mine[k], &calls.right[k]})
                for (const double x : *answer)
                    if (std::isfinite(x)) largest_ = std::max(largest_, std::abs(x));
    }

    Example run() {
        start();
        all_defaults();
        for (int pass = 0; pass < 2; ++pass) {
            axes();
            for (std::size_t i = 0; i < calls_.layouts.front().parts.size(); ++i)
                if (calls_.told.empty() || calls_.told[i]) one(i);
        }
        leave_out();
        best_.told = calls_.told;
        defaults_that_matter();
        return as_printed(calls_, best_, mine_, right_);
    }

private:
    void start() {
        std::vector<std::size_t> fit;
        for (std::size_t k = 0; k < calls_.size(); ++k) is_nan_ = is_nan_ || is_nan(calls_.mine[k], calls_.right[k]);
        for (const bool there : {true, false})
            for (const bool clear : {true, false})
                for (std::size_t k = 0; k < calls_.size() && (clear || fit.empty()); ++k) {
                    if (is_nan_ && !is_nan(calls_.mine[k], calls_.right[k])) continue;
                    if (there && !is_there(calls_.rows[k], calls_.right[k])) continue;
                    const bool wrong = clear ? shows(calls_, calls_.mine[k], calls_.right[k]) : calls_.is_wrong(k);
                    if (wrong && (there || fit.empty())) fit.push_back(k);
                }
        std::ranges::stable_sort(fit, {}, [&](std::size_t k) { return calls_.rows[k].size(); });
        constexpr std::size_t most_tried = 8;
        std::size_t first = fit.empty() ? 0 : fit.front();
        for (std::size_t i = 0; i < std::min(most_tried, fit.size()) && !settled_; ++i) {
            const std::size_t k = fit[i];
            if (calls_.rows[k].size() > calls_.rows[fit.front()].size()) break;
            settled_ = is_settled({calls_.rows[k], calls_.mine[k], calls_.right[k]});
            if (settled_) first = k;
        }
        best_ = {calls_.rows[first], calls_.mine[first], calls_.right[first]};
        clear_ = shows(calls_, best_.mine, best_.right);
        there_ = is_there(best_.row, best_.right);
    }

    bool is_there(const Row& row, const Row& right) const {
        return !region_.holds || region_.holds(row, calls_.signature.of_arguments(row), right);
    }

    /// Whether both answers stay nearly the same when the numbers change by what rounding does.
    bool is_settled(const Example& example) const {
        constexpr double change = 1e-9, enough = 1e-3;
        Rows rows;
        for (const int turn : {0, 1, 2}) {
            Row row = example.row;
            for (const Field& part : calls_.signature.of_arguments(row).parts) {
                const bool is_number = part.kind == Kind::number || part.kind == Kind::vector ||
                                       part.kind == Kind::color || part.kind == Kind::pair;
                double scale = 0;
                for (std::size_t c = 0; c < size_of(part.kind); ++c)
                    scale = std::max(scale, std::abs(row[part.at + c]));
                if (!is_number || !std::isfinite(scale)) continue;
                for (std::size_t c = 0; c < size_of(part.kind); ++c) {
                    // bounds such as 0 stay
                    if (part.kind != Kind::vector && row[part.at + c] == 0) continue;
                    row[part.at + c] += change * scale * std::cos(2.1 * turn + double(part.at + c));
                }
            }
            rows.push_back(std::move(row));
        }
        const Rows mine = mine_(rows), right = right_(rows);
        if (mine.size() != rows.size() || right.size() != rows.size()) return false;
        const auto stays = [&](const Row& now, const Row& before) {
            if (now.size() != before.size()) return false;
            // where sums cancel, nothing is left to compare with
            if (std::ranges::equal(now, before, [&](double x, double y) { return std::abs(x - y) <= 1e-6 * largest_; }))
                return true;
            return is_alike(calls_.result, now, before, enough);
        };
        for (std::size_t k = 0; k < rows.size(); ++k)
            if (!stays(mine[k], example.mine) || !stays(right[k], example.right)) return false;
        return true;
    }

    /// Whether an answer is of the size of the calls' that were drawn.
    bool is_usual(const Row& answer) const {
        constexpr double times = 100;
        return std::ranges::all_of(answer,
                                   [&](double x) { return !(std::abs(x) > times * largest_) || std::isinf(x); });
    }

    /// Takes the first of these rows that is still wrong.
    void take(const Rows& rows) {
        if (rows.empty()) return;
        const Rows mine = mine_(rows), right = right_(rows);
        if (mine.size() != rows.size() || right.size() != rows.size()) return;
        for (std::size_t k = 0; k < rows.size(); ++k) {
            if (!is_wrong(rows[k], mine[k], right[k])) continue;
            Example next{rows[k], mine[k], right[k]};
            if (settled_ && !is_settled(next)) continue;
            best_ = std::move(next);
            return;
        }
    }

    /// In the way that the first call is.
    bool is_wrong(const Row& row, const Row& mine, const Row& right) const {
        if (mine.size() < best_.mine.size() || right.size() < best_.right.size()) return false;
        const bool wrong = clear_ ? shows(calls_, mine, right) : !is_equal(calls_.result, mine, right);
        if (!wrong || (is_nan_ && !is_nan(mine, right)) || (there_ && !is_there(row, right))) return false;
        return is_usual(mine) && is_usual(right);
    }

    void one(std::size_t i) {
        const Field part = calls_.signature.of_arguments(best_.row).parts[i];
        Rows rows;
        for (const auto& value : simpler_values(part, best_.row)) {
            Row row = best_.row;
            std::ranges::copy(value, row.begin() + std::ptrdiff_t(part.at));
            if (row != best_.row && invariants_.mend(row, i)) rows.push_back(std::move(row));
        }
        take(rows);
    }

    /// What does not matter.
    void all_defaults() {
        const Row defaults = calls_.signature.blank();
        const auto from = calls_.signature.of_arguments(defaults).parts,
                   to = calls_.signature.of_arguments(best_.row).parts;
        Row row = best_.row;
        for (std::size_t i = 0; i < to.size() && i < calls_.told.size(); ++i)
            for (std::size_t c = 0; !calls_.told[i] && c < size_of(to[i].kind); ++c)
                row[to[i].at + c] = defaults[from[i].at + c];
        take({row});
    }

    /// What does not matter in this call: with its default, the answers are the same.
    void leave_out() {
        const Row defaults = calls_.signature.blank();
        const auto from = calls_.signature.of_arguments(defaults).parts,
                   to = calls_.signature.of_arguments(best_.row).parts;
        for (std::size_t i = 0; i < to.size(); ++i) {
            Row row = best_.row;
            for (std::size_t c = 0; c < size_of(to[i].kind); ++c) row[to[i].at + c] = defaults[from[i].at + c];
            if (row == best_.row || to[i].name.find('.') == std::string::npos) continue;
            const Rows mine = mine_({row}), right = right_({row});
            if (mine == Rows{best_.mine} && right == Rows{best_.right}) best_.row = std::move(row);
        }
    }

    /// Defaults without which the call is not wrong.
    void defaults_that_matter() {
        const Row defaults = calls_.signature.blank();
        const auto from = calls_.signature.of_arguments(defaults).parts,
                   to = calls_.signature.of_arguments(best_.row).parts;
        best_.always.assign(to.size(), false);
        for (std::size_t i = 0; i < to.size(); ++i) {
            if (i < calls_.told.size() && !calls_.told[i]) continue;
            bool is_default = true, is_other = false;
            for (std::size_t c = 0; c < size_of(to[i].kind); ++c)
                is_default = is_default && best_.row[to[i].at + c] == defaults[from[i].at + c];
            Row row = best_.row;
            for (std::size_t k = 0; k < calls_.size() && is_default && !is_other; ++k)
                for (std::size_t c = 0; c < size_of(to[i].kind); ++c) {
                    row[to[i].at + c] = calls_.rows[k][calls_.layouts[k].parts[i].at + c];
                    is_other = is_other || row[to[i].at + c] != best_.row[to[i].at + c];
                }
            if (!is_other) continue;
            const Rows mine = mine_({row}), right = right_({row});
            best_.always[i] = mine.size() == 1 && right.size() == 1 && !is_wrong(row, mine.front(), right.front());
        }
    }

    /// Three vectors at right angles, as of a camera, or two, as of a quad.
    void axes() {
        const auto parts = calls_.signature.of_arguments(best_.row).parts;
        for (std::size_t i = 0; i + 1 < parts.size(); ++i) {
            const std::size_t count = parts[i].name.ends_with(".right") ? 3 : parts[i].name.ends_with(".u") ? 2 : 0;
            if (count == 0 || i + count > parts.size()) continue;
            Row row = best_.row;
            for (std::size_t a = 0; a < count; ++a)
                for (std::size_t c = 0; c < 3; ++c) row[parts[i + a].at + c] = a == c;
            if (row != best_.row && invariants_.mend(row, i)) take({row});
        }
    }

    const Calls& calls_;
    const WrongCalls& region_;
    const Ask &mine_, &right_;
    const Invariants invariants_;
    Example best_;
    double largest_ = 0;  // of the answers
    bool clear_ = false, is_nan_ = false, there_ = false, settled_ = false;
};

}  // namespace

Example simplest_wrong(const Calls& calls, const WrongCalls& region, const Ask& mine, const Ask& right) {
    return Shrinking(calls, region, mine, right).run();
}

Example as_printed(const Calls& calls, Example example, const Ask& mine, const Ask& right) {
    constexpr double enough = 1e-2;
    const Row defaults = calls.signature.blank();
    const auto from = calls.signature.of_arguments(defaults).parts,
               to = calls.signature.of_arguments(example.row).parts;
    for (const std::vector<bool>& told : {example.told, std::vector<bool>{}})
        for (const int digits : {6, 9, 12, 0}) {
            Row row = example.row;
            for (double& x : row) x = digits > 0 ? rounded(x, digits) : x;
            for (std::size_t i = 0; i < told.size(); ++i)
                for (std::size_t c = 0; !told[i] && c < size_of(to[i].kind); ++c)
                    row[to[i].at + c] = defaults[from[i].at + c];
            const Rows own = mine({row}), due = right({row});
            if (own.size() != 1 || due.size() != 1) continue;
            if (own[0].size() != example.mine.size() || due[0].size() != example.right.size()) continue;
            if (!is_alike(calls.result, own[0], example.mine, enough) ||
                !is_alike(calls.result, due[0], example.right, enough))
                continue;
            return {std::move(row), own[0], due[0], digits, told, example.always};
        }
    example.digits = 0, example.told.clear();
    return example;
}

void add_call(Finding& finding, const Signature& signature, const Example& example) {
    finding.arguments = arguments_in_words(signature, example.row, {example.told, example.always, example.digits});
    finding.code = call_in_code(signature, example.row);
    if (are_readable(signature))
        finding.command = fmt::format("./grade call {} '{}'", signature.fragment, finding.arguments);
}

}  // namespace grade
