#include "diagnosis/mistakes.h"

#include <algorithm>
#include <stdexcept>

#include "diagnosis/expressions.h"
#include "diagnosis/functions.h"
#include "diagnosis/scalars.h"

namespace grade {

using textbook::Value;
using textbook::watch;

Row Asked::answer(const Row& row, const Layout& layout, const Mistake* first, const Mistake* second) {
    row_ = &row;
    for (const Mistake* mistake : {first, second})
        if (mistake && mistake->of_arguments) {
            if (row_ != &changed_) changed_ = row;
            row_ = &changed_;
            if (!mistake->of_arguments->make(changed_, layout) || changed_.size() != row.size()) return {};
        }
    watch.first = form_.first, watch.passed = 0;
    watch.values.assign(form_.nodes.size(), {});
    watch.mistakes[0] = first ? &first->made : nullptr, watch.mistakes[1] = second ? &second->made : nullptr;
    try {
        return form_.answer(*row_);
    } catch (const std::exception&) {
        return {};
    }
}

const double* Asked::numbers_of(const OtherValue& other) const {
    static constexpr double nothing[3]{std::numeric_limits<double>::quiet_NaN(), 0, 0};
    if (other.node < 0) return &(*row_)[other.at];
    const Value& value = watch.values[std::size_t(other.node)];
    return value.kind == Value::Kind::none ? nothing : value.x;  // it is not computed yet
}

namespace {

bool is_number(std::string_view text) { return text.find_first_not_of("0123456789.") == text.npos; }

}  // namespace

std::string Asked::words_of(const Mistake& mistake) const {
    if (mistake.of_arguments) return mistake.of_arguments->words;
    const textbook::Node& node = form_.nodes[std::size_t(mistake.made.nodes.front() - form_.first)];
    const bool is_everywhere = mistake.made.nodes.size() > 1;
    const auto called = [](std::string_view call) { return std::string(call.substr(0, call.find('('))); };
    if (mistake.made.alternative != 0 && is_everywhere)
        return in_place(called(mistake.pattern), called(node.text)) + " everywhere";
    const auto changed = [&] {
        if (mistake.made.alternative != 0) return std::string(mistake.pattern);
        if (mistake.other) return filled(mistake.pattern, node.name, mistake.other->name);
        if (!is_number(node.text)) return filled(mistake.pattern, node.name);
        double x[3]{std::stod(node.text)};  // another number in place of this one
        mistake.made.make(x);
        return number_in_words(x[0]);
    };
    const std::string words = in_place(changed(), mistake.made.alternative != 0 ? node.text : node.name);
    if (is_everywhere) return words + " everywhere";
    return node.context == node.text ? words : fmt::format("{}, in `{}`", words, node.context);
}

/// Makes the list.
class MistakesMade {
public:
    MistakesMade(Asked& asked, const Calls& calls) : asked_(asked), form_(asked.form_), calls_(calls) {}

    std::vector<Mistake> run() {
        see();
        for (std::size_t i = 0; i < seen_.size(); ++i) {
            if (seen_[i] == Value::Kind::none) continue;
            add_alternatives(i);
            if (seen_[i] == Value::Kind::flag) add_flag(i);
            if (is_number(seen_[i])) add_number(i);
            if (seen_[i] == Value::Kind::pair) add_pair(i);
            if (seen_[i] == Value::Kind::vector) add_vector(i);
        }
        std::ranges::stable_sort(all_, {}, &Mistake::cost);
        return std::move(all_);
    }

private:
    static bool is_number(Value::Kind kind) { return kind == Value::Kind::number || kind == Value::Kind::whole; }
    /// "0.5", "vec2(1)"
    static bool is_literal(std::string_view text) {
        for (const std::string_view type : {"vec2(", "vec3(", "Color("})
            if (text.starts_with(type)) text.remove_prefix(type.size());
        return text.find_first_not_of("0123456789.)") == text.npos;
    }

    /// What kinds of values the nodes have, and which can be taken in place of others.
    void see() {
        seen_.assign(form_.nodes.size(), Value::Kind::none);
        for (std::size_t k = 0; k < calls_.size(); ++k) {
            asked_.answer(calls_.rows[k], calls_.layouts[k]);
            for (std::size_t i = 0; i < seen_.size(); ++i)
                if (watch.values[i].kind != Value::Kind::none) seen_[i] = watch.values[i].kind;
        }
        asked_.others_.clear();
        for (std::size_t i = 0; i < seen_.size(); ++i)
            if (seen_[i] != Value::Kind::none && seen_[i] != Value::Kind::flag && !is_literal(form_.nodes[i].text))
                asked_.others_.push_back({form_.nodes[i].name, seen_[i], int(i)});
        const Layout& layout = calls_.layouts.front();
        for (const Scalar& s : scalars_of(layout, calls_.told))
            asked_.others_.push_back({s.name, s.whole ? Value::Kind::whole : Value::Kind::number, -1, s.at(layout)});
        for (std::size_t i = 0; i < layout.parts.size(); ++i) {
            const Field& part = layout.parts[i];
            const bool is_pair = part.kind == Kind::pair;
            if (calls_.told[i] && (is_pair || part.kind == Kind::vector || part.kind == Kind::color))
                asked_.others_.push_back({part.name, is_pair ? Value::Kind::pair : Value::Kind::vector, -1, part.at});
        }
    }

    bool is_argument(std::string_view name) const {
        return std::ranges::any_of(asked_.others_,
                                   [&](const OtherValue& other) { return other.node < 0 && other.name == name; });
    }

    /// The nodes of which `is_alike` holds, if this one is the first of them; else none.
    template <class Alike>
    std::vector<int> first_of(std::size_t node, Alike is_alike) const {
        std::vector<int> all;
        for (std::size_t i = 0; i < form_.nodes.size(); ++i)
            if (is_alike(i)) all.push_back(form_.first + int(i));
        return all.size() > 1 && all.front() == form_.first + int(node) ? all : std::vector<int>();
    }

    void add(std::size_t node, Mistake mistake) {
        if (!everywhere_.empty()) {
            Mistake all = mistake;
            all.made.nodes = everywhere_, all.cost += 0.1;
            all_.push_back(std::move(all));
        }
        mistake.made.nodes = {form_.first + int(node)};
        all_.push_back(std::move(mistake));
    }

    /// The mistakes that are added next are also made wherever the same is written.
    void set_everywhere(std::size_t node) {
        const std::string_view text = form_.nodes[node].text;
        everywhere_ = is_argument(text) ? std::vector<int>() : first_of(node, [&](std::size_t i) {
            return text == form_.nodes[i].text && seen_[i] == seen_[node];
        });
    }

    void add_alternatives(std::size_t i) {
        const textbook::Node& node = form_.nodes[i];
        everywhere_ = node.function.empty()
                          ? std::vector<int>()
                          : first_of(i, [&](std::size_t k) { return form_.nodes[k].function == node.function; });
        for (std::size_t k = 0; k < node.alternatives.size(); ++k)
            add(i, {node.alternatives[k].c_str(), "", 1.1, {{}, int(k) + 1, {}}});
    }

    void add_flag(std::size_t i) {
        everywhere_.clear();
        add(i, {"true", "", 1.1, {{}, 0, [](double* x) { *x = 1; }}});
        add(i, {"false", "", 1.1, {{}, 0, [](double* x) { *x = 0; }}});
        add(i, {"!({0})", "", 1.15, {{}, 0, [](double* x) { *x = 1 - *x; }}});
    }

    /// "film" of "film.x"; the whole name where there is none.
    static std::string owner_of(const std::string& name) { return name.substr(0, name.rfind('.')); }

    /// How many steps a node lies within another; 0: it does not.
    int depth_within(int node, std::size_t whole) const {
        int best = 0;
        for (const int part : form_.nodes[whole].parts) {
            const std::size_t i = std::size_t(part - form_.first);
            const int deeper = part - form_.first == node ? 1 : depth_within(node, i);
            if (deeper > 0 && part - form_.first != node) best = best == 0 ? deeper + 1 : std::min(best, deeper + 1);
            if (part - form_.first == node) return 1;
        }
        return best;
    }

    /// That one value is taken for another costs less where that is a part of it, and more where it is a constant.
    double cost_of(const char* words, double cost, std::size_t node, const OtherValue& other) const {
        if (is_literal(form_.nodes[node].text)) return cost + 0.4;
        if (std::string_view(words) != "{1}") return cost;
        if (other.node < 0) return owner_of(other.name) == owner_of(form_.nodes[node].text) ? cost - 0.3 : cost;
        const int depth = depth_within(other.node, node);
        const double of_part =
            seen_[node] == Value::Kind::vector ? 1.05 : 0.8;  // of vectors, less is as it is by chance
        return depth > 0 ? of_part + 0.1 * depth : cost;
    }

    template <class Functions, class Make>
    void add_functions(std::size_t i, const Functions& functions, double more, Make make) {
        for (const auto& f : functions) {
            Mistake mistake{f.words, "", f.cost + more, {{}, 0, [make, &f](double* x) { make(f, x); }}};
            if constexpr (requires { f.usually; }) mistake.usually = f.usually;
            add(i, std::move(mistake));
        }
    }

    /// What is made of both, where the other one has a name of its own; else that it is taken in place of this one.
    template <class Functions, class Make>
    void add_functions_of_two(std::size_t i, const OtherValue& other, const Functions& functions, Make make) {
        const bool has_name = other.node < 0 || other.name != form_.nodes[std::size_t(other.node)].text;
        for (const auto& f : functions)
            if (has_name || std::string_view(f.words) == "{1}")
                add(i,
                    {f.words,
                     "",
                     cost_of(f.words, f.cost, i, other),
                     {{}, 0, [make, &f, &other, &asked = asked_](double* x) { make(f, x, asked.numbers_of(other)); }},
                     &other});
    }

    void add_number(std::size_t i) {
        set_everywhere(i);
        // a constant is rarely half of it, but an answer that is one may be another
        const bool is_answer = form_.nodes[i].context.ends_with("return " + form_.nodes[i].text);
        add_functions(i, scalar_functions, is_literal(form_.nodes[i].text) && !is_answer ? 0.4 : 0,
                      [is_whole = seen_[i] == Value::Kind::whole](const Function& f, double* x) {
                          const double value = f.value(*x);
                          if (!is_whole || value == std::floor(value)) *x = value;
                      });
        for (const OtherValue& other : asked_.others_)
            if (is_number(other.kind) && other.name != form_.nodes[i].name)
                add_functions_of_two(i, other, of_two_scalars,
                                     [](const TwoScalars& f, double* x, const double* y) { *x = f.value(*x, *y); });
    }

    void add_pair(std::size_t i) {
        set_everywhere(i);
        add_functions(i, std::span(pair_functions).subspan(1), 0,
                      [](const Function& f, double* x) { x[0] = f.value(x[0]), x[1] = f.value(x[1]); });
        add(i, {"{0} with x and y exchanged", "", 1.2, {{}, 0, [](double* x) { std::swap(x[0], x[1]); }}});
        for (const OtherValue& other : asked_.others_)
            if (other.kind == Value::Kind::pair && other.name != form_.nodes[i].name)
                add(i, {"{1}",
                        "",
                        cost_of("{1}", 1.3, i, other),
                        {{}, 0, [&other, &asked = asked_](double* x) { std::copy_n(asked.numbers_of(other), 2, x); }},
                        &other});
    }

    void add_vector(std::size_t i) {
        set_everywhere(i);
        const auto make = [](const VectorFunction& f, double* x) { put(x, f.value({x[0], x[1], x[2]})); };
        add_functions(i, vector_functions, 0, make), add_functions(i, color_functions, 0, make);
        const auto make_of_two = [](const TwoVectors& f, double* x, const double* y) {
            put(x, f.value({x[0], x[1], x[2]}, {y[0], y[1], y[2]}));
        };
        static constexpr TwoScalars factors[] = {{"{0} * {1}", 1.8, [](double, double y) { return y; }},
                                                 {"{0} / {1}", 1.8, [](double, double y) { return 1 / y; }}};
        for (const OtherValue& other : asked_.others_) {
            if (other.name == form_.nodes[i].name) continue;
            if (other.kind == Value::Kind::vector) {
                add_functions_of_two(i, other, of_two_vectors, make_of_two);
                add_functions_of_two(i, other, of_two_colors, make_of_two);
            } else if (other.kind == Value::Kind::number) {
                add_functions_of_two(i, other, factors, [](const TwoScalars& f, double* x, const double* y) {
                    put(x, f.value(0, *y) * vec3(x[0], x[1], x[2]));
                });
            }
        }
    }

    static void put(double* x, vec3 v) { x[0] = v.x, x[1] = v.y, x[2] = v.z; }

    Asked& asked_;
    const textbook::Form& form_;
    const Calls& calls_;
    std::vector<Value::Kind> seen_;
    std::vector<int> everywhere_;
    std::vector<Mistake> all_;
};

std::vector<Mistake> Asked::mistakes_in(const Calls& calls) { return MistakesMade(*this, calls).run(); }

}  // namespace grade
