#include "diagnosis/source/edited_calls.h"

#include <algorithm>
#include <cctype>

namespace grade {

namespace {

constexpr std::size_t most_of_each = 48;  // calls

/// As many of them as are asked, evenly.
std::vector<std::size_t> spread(const std::vector<std::size_t>& all) {
    std::vector<std::size_t> some;
    const std::size_t count = std::min(all.size(), most_of_each);
    for (std::size_t i = 0; i < count; ++i) some.push_back(all[i * all.size() / count]);
    return some;
}

}  // namespace

EditedCalls::EditedCalls(const Calls& calls, const Editable& source) : calls_(calls), source_(source) {
    for (std::size_t k = 0; k < calls.size(); ++k) (is_right(k, calls.mine[k]) ? right_ : wrong_).push_back(k);
    wrong_ = spread(wrong_), right_ = spread(right_);
    for (std::size_t k = 0; k < calls.size(); ++k)
        if (std::ranges::count(wrong_, k) + std::ranges::count(right_, k) == 0) others_.push_back(k);
}

/// Whether it is the student's fragment, as long as nothing is changed.
bool EditedCalls::answers_as_before(const Rows& answers) const {
    std::size_t i = 0;
    for (const auto* some : {&wrong_, &right_})
        for (const std::size_t k : *some) {
            if (i >= answers.size() || answers[i].size() != calls_.mine[k].size()) return false;
            if (!is_equal(calls_.result, answers[i++], calls_.mine[k])) return false;
        }
    return true;
}

bool EditedCalls::see() {
    arguments_ = calls_.layouts.front(), told_ = calls_.told;
    for (std::size_t i = 0; i < arguments_.parts.size(); ++i) {
        const std::string& name = arguments_.parts[i].name;
        const bool varies = source_.varying.contains(name.substr(0, name.find('.')));
        arguments_vary_ = arguments_vary_ || varies;
        if (varies) told_[i] = false;
    }
    if (!arguments_vary_) quantities_ = as_code(quantities_of(arguments_, told_));
    for (std::size_t i = 0; i < quantities_.size(); ++i) {
        arguments_.parts.push_back({quantities_[i].words, Kind::number, calls_.rows.front().size() + i});
        told_.push_back(quantities_[i].kind != Quantity::Kind::number);
    }
    all_.nodes = source_.nodes;
    all_.seen.assign(source_.nodes.size(), textbook::Value::Kind::none);
    Rows rows, as_it_is;
    for (const auto* some : {&wrong_, &right_})
        for (const std::size_t k : *some) {
            rows.push_back(textbook::row_of(call(calls_, k, true)));
            as_it_is.push_back(textbook::row_of(call(calls_, k, false)));
        }
    if (!answers_as_before(source_.ask(as_it_is))) return false;
    const Rows kinds = source_.ask(rows);
    for (const Row& row : kinds)
        for (std::size_t i = 0; i < std::min(row.size(), all_.seen.size()); ++i)
            if (row[i] > 0 && row[i] < double(textbook::Value::Kind::vector) + 1)
                all_.seen[i] = textbook::Value::Kind(int(row[i]));
    return kinds.size() == rows.size();
}

std::vector<Rows> EditedCalls::answers(const std::vector<Edit>& edits, const Rows& calls) {
    Rows rows;
    for (const Edit& edit : edits)
        for (const Row& row : calls) {
            textbook::EditedCall one{source_.nodes.size(), false, {}, row};
            for (const Quantity& quantity : quantities_)
                one.more.push_back(quantity.value(row, calls_.layouts.front(), {}));
            rows.push_back(textbook::row_of(one, edit.first ? &edit.first->made : nullptr, nullptr));
        }
    asked_ += rows.size();
    const Rows all = source_.ask(rows);
    std::vector<Rows> of_each;
    if (all.size() != rows.size()) return of_each;
    for (std::size_t i = 0; i < edits.size(); ++i) {
        const auto first = all.begin() + std::ptrdiff_t(i * calls.size());
        of_each.emplace_back(first, first + std::ptrdiff_t(calls.size()));
    }
    return of_each;
}

textbook::EditedCall EditedCalls::call(const Calls& of, std::size_t k, bool only_kinds) const {
    textbook::EditedCall all{source_.nodes.size(), only_kinds, {}, of.rows[k]};
    // lists may be longer in other calls: then the quantities stand elsewhere
    if (all.arguments.size() != calls_.rows.front().size()) return all;
    for (const Quantity& quantity : quantities_) all.more.push_back(quantity.value(of.rows[k], of.layouts[k], {}));
    for (const double x : borrowed_.values(of.rows[k], of.layouts[k])) all.more.push_back(x);
    return all;
}

bool EditedCalls::is_literal(const textbook::Mistake& made) const {
    return std::isdigit(static_cast<unsigned char>(all_.node(made.nodes.front()).text[0]));
}

}  // namespace grade
