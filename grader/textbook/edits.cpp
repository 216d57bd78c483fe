#include "textbook/edits.h"

#include <algorithm>
#include <cmath>
#include <span>
#include <stdexcept>

namespace grade::textbook {

Numbers row_of(const EditedCall& call, const Mistake* first, const Mistake* second) {
    Numbers row{double(call.nodes), double(call.only_kinds), double(call.more.size()),
                double((first != nullptr) + (second != nullptr))};
    for (const Mistake* mistake : {first, second}) {
        if (!mistake) continue;
        row.insert(row.end(), {double(mistake->alternative), double(mistake->made), double(mistake->function),
                               double(mistake->other_node), double(mistake->other_at), double(mistake->nodes.size())});
        row.insert(row.end(), mistake->nodes.begin(), mistake->nodes.end());
    }
    row.insert(row.end(), call.arguments.begin(), call.arguments.end());
    row.insert(row.end(), call.more.begin(), call.more.end());
    return row;
}

double seen(const Value& value) {
    const std::size_t count = value.kind == Value::Kind::vector ? 3 : value.kind == Value::Kind::pair ? 2 : 1;
    const std::span<const double> x(value.x, count);
    const auto has = [&](auto is) { return std::ranges::any_of(x, is); };
    double mark = 0;
    if (has([](double v) { return std::isnan(v); }))
        mark = mark_of_nan;
    else if (has([](double v) { return std::isinf(v); }))
        mark = mark_of_infinity;
    else if (!has([](double v) { return v != 0; }))
        mark = mark_of_zero;
    return double(value.kind) + (value.kind == Value::Kind::none ? 0 : mark);
}

namespace {

class Reader {
public:
    explicit Reader(std::span<const double> row) : row_(row) {}

    template <class Whole>
    Whole next() {
        constexpr double most = 1e6;
        if (at_ >= row_.size()) throw std::out_of_range("a call with mistakes that is too short");
        const double x = row_[at_++];
        if (!(std::abs(x) <= most)) throw std::domain_error("a number that is none of a mistake");
        return Whole(x);
    }

    Mistake mistake() {
        Mistake read;
        read.alternative = next<int>(), read.made = Made(next<int>()), read.function = next<std::size_t>();
        read.other_node = next<int>(), read.other_at = next<std::size_t>();
        for (auto count = next<std::size_t>(); count > 0; --count) read.nodes.push_back(next<int>());
        return read;
    }

    Numbers rest() const { return {row_.begin() + std::ptrdiff_t(at_), row_.end()}; }

private:
    std::span<const double> row_;
    std::size_t at_ = 0;
};

}  // namespace

EditedCall edited_call_of(std::span<const double> row) {
    Reader in(row);
    EditedCall call{in.next<std::size_t>(), in.next<int>() != 0};
    const auto more = in.next<std::size_t>();
    for (int count = in.next<int>(); count > 0; --count) call.mistakes.push_back(in.mistake());
    if (call.mistakes.size() > std::size(Watch{}.mistakes)) throw std::domain_error("more mistakes than can be made");
    call.arguments = in.rest();
    if (more > call.arguments.size()) throw std::out_of_range("a call with mistakes that is too short");
    call.more.assign(call.arguments.end() - std::ptrdiff_t(more), call.arguments.end());
    call.arguments.resize(call.arguments.size() - more);
    return call;
}

}  // namespace grade::textbook
