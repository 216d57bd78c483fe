#pragma once

#include <cstdint>
#include <functional>
#include <set>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "textbook/node.h"
#include "textbook/watch.h"

namespace grade::textbook {

using Answer = std::function<std::vector<double>(std::span<const double>)>;

/// A fragment as a textbook writes it, each of whose expressions can be changed.
struct Form {
    std::string fragment;
    std::string says;      // what is wrong with it; empty: it is right
    bool has_other_order;  // samples come in another order than the solution's: an answer that differs may be right
    int first = 0;         // the number of its first node
    std::vector<Node> nodes;
    Answer answer;                // to a row of arguments
    std::set<std::string> calls;  // other fragments that it asks
    void (*begin)();              // other forms ask it for its fragment's answers
    void (*end)();                // no longer
};

/// A form that others ask for its fragment's answers, as long as this lives, in place of the fragment's first form.
class StandIn {
public:
    explicit StandIn(const Form& form) : form_(form) { form_.begin(); }
    ~StandIn() { form_.end(); }
    StandIn(const StandIn&) = delete;
    StandIn& operator=(const StandIn&) = delete;

private:
    const Form& form_;
};

/// Sets a variable back when it goes.
template <class Value>
class Restored {
public:
    Restored(Value& place, Value meanwhile) : place_(place), before_(std::exchange(place, meanwhile)) {}
    ~Restored() { place_ = before_; }
    Restored(const Restored&) = delete;
    Restored& operator=(const Restored&) = delete;

private:
    Value& place_;
    const Value before_;
};

/// What the build makes of a form's code.
struct Compiled {
    Answer answer;
    void (*begin)();
    void (*end)();
};

/// Right ones, made by the build from forms/, and those that are wrong as a whole, from mistakes/. A fragment needs no
/// form.
const std::vector<Form>& forms();

/// As wrap_forms writes them.
std::vector<Form> read_forms(std::span<const unsigned char> texts, std::span<const std::uint32_t> numbers,
                             std::vector<Compiled> codes);

}  // namespace grade::textbook
