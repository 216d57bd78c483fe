#include "textbook/watch.h"

#include <stdexcept>

namespace grade::textbook {

thread_local Watch watch;

namespace {

/// The value as it is after the mistakes in it; noted for expressions that take it in place of theirs.
void pass(int node, Value::Kind kind, double* x, std::size_t count) {
    constexpr std::size_t most = 100'000;
    if (++watch.passed > most) throw std::runtime_error("the call takes too long");
    for (const Mistake* mistake : watch.mistakes)
        if (mistake && mistake->make && mistake->is_of(node)) mistake->make(x);
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

/// Rounded towards 0, as code does; what is no such number is a large one.
int whole(double x) {
    constexpr double most = 1e6;
    return std::abs(x) < most ? int(x) : int(most);
}

}  // namespace

double at(int node, double x) { return number(node, Value::Kind::number, x); }

int at(int node, int x) { return whole(number(node, Value::Kind::whole, x)); }

std::size_t at(int node, std::size_t x) {
    return std::size_t(std::max(0, whole(number(node, Value::Kind::whole, double(x)))));
}

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
