#include "textbook/watch.h"

#include <cmath>
#include <limits>
#include <stdexcept>

#include "textbook/functions.h"

namespace grade::textbook {

thread_local Watch watch;

void Watch::begin(int first_node, std::size_t nodes, std::span<const double> arguments, const Mistake* one,
                  const Mistake* another) {
    first = first_node, passed = 0;
    values.assign(nodes, {});
    row = arguments;
    mistakes[0] = one, mistakes[1] = another;
}

int chosen(int node) {
    for (const Mistake* mistake : watch.mistakes)
        if (mistake && mistake->alternative != 0 && mistake->is_of(node)) return mistake->alternative;
    return 0;
}

namespace {

using rt::vec3;

/// The numbers of the other value that a mistake takes.
const double* other_of(const Mistake& mistake) {
    static constexpr double nothing[3]{std::numeric_limits<double>::quiet_NaN(), 0, 0};
    if (mistake.other_node < 0) return mistake.other_at < watch.row.size() ? &watch.row[mistake.other_at] : nothing;
    const std::size_t node = std::size_t(mistake.other_node);
    if (node >= watch.values.size() || watch.values[node].kind == Value::Kind::none) return nothing;
    return watch.values[node].x;  // else it is not computed yet
}

vec3 vector_of(const double* x) { return {x[0], x[1], x[2]}; }
void put(double* x, vec3 v) { x[0] = v.x, x[1] = v.y, x[2] = v.z; }

/// Numbers of a kind's size.
void make(const Mistake& mistake, Value::Kind kind, double* x) {
    const std::size_t f = mistake.function;
    const auto apply = [=](const auto& functions) { *x = functions[f].value(*x); };
    switch (mistake.made) {
        case Made::nothing:
            return;
        case Made::yes:
            *x = 1;
            return;
        case Made::no:
            *x = 0;
            return;
        case Made::opposite:
            *x = 1 - *x;
            return;
        case Made::number: {
            *x = scalar_functions[f].value(*x);
            // as code does, but for 1 / 0, which no code survives
            if (kind == Value::Kind::whole && !std::isfinite(*x)) throw std::runtime_error("no whole number");
            if (kind == Value::Kind::whole) *x = std::trunc(*x);
            return;
        }
        case Made::tolerance:
            return apply(tolerance_functions);
        case Made::tolerance_with:
            *x = relative_tolerances[f].value(*x, *other_of(mistake));
            return;
        case Made::share:
            return apply(share_functions);
        case Made::limit:
            return apply(limit_functions);
        case Made::pair:
            for (int c = 0; c < 2; ++c) x[c] = pair_functions[f].value(x[c]);
            return;
        case Made::exchanged:
            std::swap(x[0], x[1]);
            return;
        case Made::vector:
            put(x, vector_functions[f].value(vector_of(x)));
            return;
        case Made::color:
            put(x, color_functions[f].value(vector_of(x)));
            return;
        case Made::number_with:
            *x = of_two_scalars[f].value(*x, *other_of(mistake));
            return;
        case Made::pair_with:
            std::copy_n(other_of(mistake), 2, x);
            return;
        case Made::vector_with:
            put(x, of_two_vectors[f].value(vector_of(x), vector_of(other_of(mistake))));
            return;
        case Made::color_with:
            put(x, of_two_colors[f].value(vector_of(x), vector_of(other_of(mistake))));
            return;
        case Made::scaled_with:
            put(x, vector_scales[f].value(0, *other_of(mistake)) * vector_of(x));
            return;
    }
}

/// The value as it is after the mistakes in it; noted for expressions that take it in place of theirs.
void pass(int node, Value::Kind kind, double* x, std::size_t count) {
    constexpr std::size_t most = 100'000;
    if (++watch.passed > most) throw std::runtime_error("the call takes too long");
    for (const Mistake* mistake : watch.mistakes)
        if (mistake && mistake->is_of(node)) make(*mistake, kind, x);
    const std::size_t i = std::size_t(node - watch.first);
    if (node < watch.first || i >= watch.values.size()) return;  // of a form that this one calls
    Value& value = watch.values[i];
    value.kind = kind;
    for (std::size_t c = 0; c < count; ++c) value.x[c] = x[c];
}

double number(int node, Value::Kind kind, double x) {
    pass(node, kind, &x, 1);
    return x;
}

/// Rounded towards 0, as code does; what is no such number is a large one. What is not changed keeps all of its digits.
template <class Whole>
Whole whole(int node, Whole x) {
    constexpr double most = 1e6;
    const double value = number(node, Value::Kind::whole, double(x));
    if (value == double(x)) return x;
    return Whole(std::max(std::is_unsigned_v<Whole> ? 0 : -most, std::abs(value) < most ? value : most));
}

}  // namespace

double at(int node, double x) { return number(node, Value::Kind::number, x); }

float at(int node, float x) { return float(number(node, Value::Kind::number, double(x))); }

int at(int node, int x) { return whole(node, x); }

std::size_t at(int node, std::size_t x) { return whole(node, x); }

bool at(int node, bool x) { return number(node, Value::Kind::flag, x) != 0; }

rt::vec2 at(int node, rt::vec2 x) {
    pass(node, Value::Kind::pair, &x.x, 2);
    return x;
}

rt::vec3 at(int node, rt::vec3 x) {
    pass(node, Value::Kind::vector, &x.x, 3);
    return x;
}

}  // namespace grade::textbook
