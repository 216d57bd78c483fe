#include "diagnosis/forms/mistakes.h"

#include <algorithm>
#include <cmath>

#include "diagnosis/calls/expressions.h"
#include "diagnosis/calls/scalars.h"
#include "textbook/functions.h"
#include "textbook/operators.h"

namespace grade {

using textbook::Made;
using textbook::Value;

namespace {

/// Whether one is the other without brackets.
bool lacks_brackets(std::string text, std::string alternative) {
    for (std::string* one : {&text, &alternative}) std::erase_if(*one, [](char c) { return c == '(' || c == ')'; });
    return text == alternative;
}

/// Makes the list.
class MistakesMade {
public:
    MistakesMade(const Expressions& all, const Layout& arguments, const std::vector<bool>& told)
        : nodes_(all.nodes), first_(all.first), seen_(all.seen) {
        see(arguments, told);
    }

    std::vector<Mistake> run() {
        for (std::size_t i = 0; i < seen_.size(); ++i) {
            if (seen_[i] == Value::Kind::none) continue;
            add_alternatives(i);
            if (!nodes_[i].function.empty()) continue;  // its value is that of the call's own node
            if (seen_[i] == Value::Kind::flag) add_flag(i);
            if (is_number(seen_[i])) add_number(i);
            if (seen_[i] == Value::Kind::pair) add_pair(i);
            if (seen_[i] == Value::Kind::vector) add_vector(i);
        }
        return by_cost();
    }

private:
    static constexpr std::size_t most = 100'000;  // mistakes

    static bool is_number(Value::Kind kind) { return kind == Value::Kind::number || kind == Value::Kind::whole; }
    /// "0.5", "1e-3", "vec2(1)"
    static bool is_literal(std::string_view text) {
        for (const std::string_view type : {"vec2(", "vec3(", "Color("})
            if (text.starts_with(type)) text.remove_prefix(type.size());
        if (text.empty() || std::string_view("0123456789.").find(text.front()) == text.npos) return false;
        return text.find_first_not_of("0123456789.eE+-f)") == text.npos;
    }

    /// What can be taken in place of others.
    void see(const Layout& layout, const std::vector<bool>& told) {
        for (std::size_t i = 0; i < seen_.size(); ++i)
            if (seen_[i] != Value::Kind::none && seen_[i] != Value::Kind::flag && !is_literal(nodes_[i].text) &&
                !nodes_[i].varies && nodes_[i].function.empty())
                others_.push_back({nodes_[i].name, seen_[i], int(i)});
        for (const Scalar& s : scalars_of(layout, told))
            others_.push_back({s.name, s.whole ? Value::Kind::whole : Value::Kind::number, -1, s.at(layout)});
        for (std::size_t i = 0; i < layout.parts.size(); ++i) {
            const Field& part = layout.parts[i];
            const bool is_pair = part.kind == Kind::pair;
            has_colors_ = has_colors_ || part.kind == Kind::color;
            if (told[i] && (is_pair || part.kind == Kind::vector || part.kind == Kind::color))
                others_.push_back({part.name, is_pair ? Value::Kind::pair : Value::Kind::vector, -1, part.at,
                                   part.kind == Kind::color});
        }
    }

    bool is_argument(std::string_view name) const {
        return std::ranges::any_of(others_,
                                   [&](const OtherValue& other) { return other.node < 0 && other.name == name; });
    }

    /// The nodes of which `is_alike` holds, if this one is the first of them; else none.
    template <class Alike>
    std::vector<int> first_of(std::size_t node, Alike is_alike) const {
        std::vector<int> all;
        for (std::size_t i = 0; i < nodes_.size(); ++i)
            if (is_alike(i)) all.push_back(first_ + int(i));
        return all.size() > 1 && all.front() == first_ + int(node) ? all : std::vector<int>();
    }

    /// Whether what a mistake takes can be written there.
    bool is_known(const Mistake& mistake, int where) const {
        const int other = mistake.made.other_node;
        return other < 0 || nodes_[std::size_t(other)].is_known_at(nodes_[std::size_t(where - first_)]);
    }

    void add(std::size_t node, Mistake mistake) {
        if (all_.size() >= most || !is_known(mistake, first_ + int(node))) return;
        const auto is_known_there = [&](int where) { return is_known(mistake, where); };
        if (!everywhere_.empty() && std::ranges::all_of(everywhere_, is_known_there)) {
            Mistake all = mistake;
            all.made.nodes = everywhere_, all.cost += 0.1;
            all_.push_back(std::move(all));
        }
        mistake.made.nodes = {first_ + int(node)};
        all_.push_back(std::move(mistake));
    }

    /// The mistakes that are added next are also made wherever the same is written.
    void set_everywhere(std::size_t node) {
        const std::string_view text = nodes_[node].text;
        everywhere_ = is_argument(text) ? std::vector<int>() : first_of(node, [&](std::size_t i) {
            return text == nodes_[i].text && seen_[i] == seen_[node];
        });
    }

    /// There may be many: each moves once.
    std::vector<Mistake> by_cost() {
        std::vector<std::pair<double, std::size_t>> order;
        for (std::size_t i = 0; i < all_.size(); ++i) order.emplace_back(all_[i].cost, i);
        std::ranges::sort(order);
        std::vector<Mistake> sorted;
        sorted.reserve(all_.size());
        for (const auto& [cost, i] : order) sorted.push_back(std::move(all_[i]));
        return sorted;
    }

    void add_alternatives(std::size_t i) {
        const textbook::Node& node = nodes_[i];
        everywhere_ = node.function.empty()
                          ? std::vector<int>()
                          : first_of(i, [&](std::size_t k) { return nodes_[k].function == node.function; });
        // vectors that are exchanged are more likely than a sign elsewhere that does the same, and brackets that are
        // forgotten than a factor
        for (std::size_t k = 0; k < node.alternatives.size(); ++k) {
            const bool is_likely =
                textbook::is_cross_product(node.function) || lacks_brackets(node.text, node.alternatives[k]);
            add(i, {node.alternatives[k], "", is_likely ? 0.95 : 1.1, {{}, int(k) + 1}});
        }
    }

    void add_flag(std::size_t i) {
        everywhere_.clear();
        if (textbook::is_jump(nodes_[i].text)) return;  // its alternative is added
        // that one value in it is another is no simpler where the condition holds always, or never
        add(i, {"true", "", 0.97, {{}, 0, Made::yes}});
        add(i, {"false", "", 0.97, {{}, 0, Made::no}});
        add(i, {"!({0})", "", 1.15, {{}, 0, Made::opposite}});
    }

    /// "film" of "film.x"; the whole name where there is none.
    static std::string owner_of(const std::string& name) { return name.substr(0, name.rfind('.')); }

    /// How many steps a node lies within another; 0: it does not.
    int depth_within(int node, std::size_t whole) const {
        int best = 0;
        for (const int part : nodes_[whole].parts) {
            const std::size_t i = std::size_t(part - first_);
            const int deeper = part - first_ == node ? 1 : depth_within(node, i);
            if (deeper > 0 && part - first_ != node) best = best == 0 ? deeper + 1 : std::min(best, deeper + 1);
            if (part - first_ == node) return 1;
        }
        return best;
    }

    /// That one value is taken for another costs less where that is a part of it, and more where it is a constant.
    double cost_of(const char* words, double cost, std::size_t node, const OtherValue& other) const {
        if (is_literal(nodes_[node].text)) return cost + 0.4;
        if (std::string_view(words) != "{1}") return cost;
        if (other.node < 0) return owner_of(other.name) == owner_of(nodes_[node].text) ? cost - 0.3 : cost;
        const int depth = depth_within(other.node, node);
        const double of_part =
            seen_[node] == Value::Kind::vector ? 1.05 : 0.8;  // of vectors, less is as it is by chance
        return depth > 0 ? of_part + 0.1 * depth : cost;
    }

    template <class Functions>
    void add_functions(std::size_t i, const Functions& functions, double more, Made made, std::size_t from = 0) {
        for (std::size_t f = from; f < std::size(functions); ++f) add_function(i, functions[f], more, made, f);
    }

    template <class Function>
    void add_function(std::size_t i, const Function& function, double more, Made made, std::size_t f) {
        const bool is_sign = std::string_view(function.words) == "-{}";  // of a constant, it is rarely lost
        Mistake mistake{function.words, "", function.cost + (is_sign ? 2 : 1) * more, {{}, 0, made, f}};
        const bool is_zero = std::string_view(function.words) == "0";  // where a loop begins
        const bool is_constant = is_literal(nodes_[i].text);
        if (is_zero && is_constant && seen_[i] == Value::Kind::whole) mistake.cost = 1;
        if (is_sign && nodes_[i].text.starts_with('-')) mistake.cost -= 0.05;  // one too many, rather than two
        if constexpr (requires { function.usually; })
            if (!is_constant) mistake.usually = function.usually;
        add(i, std::move(mistake));
    }

    /// Of a constant, another positive whole number in place of one is likely, whatever it is made by; what else is
    /// made of it, rarely meant.
    void add_functions_of_literal(std::size_t i, double value) {
        const auto is_whole = [](double x) { return std::isfinite(x) && x >= 1 && x == std::floor(x); };
        for (std::size_t f = 0; f < std::size(scalar_functions); ++f) {
            const double other = scalar_functions[f].value(value);
            if (!is_whole(value) || !is_whole(other)) {
                constexpr double rarely = 0.4;
                add_function(i, scalar_functions[f], rarely, Made::number, f);
            } else if (other != value) {
                constexpr double sooner = 0.05;  // than the same made of what stands beside it
                add_function(i, scalar_functions[f], -sooner, Made::number, f);
            }
        }
    }

    /// What is made of both, where the other one has a name of its own; else that it is taken in place of this one.
    template <class Functions>
    void add_functions_of_two(std::size_t i, const OtherValue& other, const Functions& functions, Made made) {
        const bool has_name = other.node < 0 || other.name != nodes_[std::size_t(other.node)].text;
        for (std::size_t f = 0; f < std::size(functions); ++f)
            if (has_name || std::string_view(functions[f].words) == "{1}")
                add_other(i, functions[f].words, functions[f].cost, other, {{}, 0, made, f});
    }

    void add_other(std::size_t i, const char* words, double cost, const OtherValue& other, textbook::Mistake made) {
        made.other_node = other.node, made.other_at = other.at;
        add(i, {words, "", cost_of(words, cost, i, other), std::move(made), other.name});
    }

    void add_number(std::size_t i) {
        set_everywhere(i);
        // a constant is rarely half of it, but an answer that is one may be another
        const bool is_answer = nodes_[i].context.ends_with("return " + nodes_[i].text);
        const std::string& written = nodes_[i].literal.empty() ? nodes_[i].text : nodes_[i].literal;
        const bool is_constant = is_literal(written);
        if (is_constant && !is_answer)
            add_functions_of_literal(i, std::strtod(written.c_str(), nullptr));
        else
            add_functions(i, scalar_functions, 0, Made::number);
        constexpr double small = 0.1, near_one = 0.9, above_one = 1.3, large = 50;
        const double value = is_constant ? std::strtod(written.c_str(), nullptr) : 1;
        const bool is_tolerance = is_constant && value > 0 && value <= small;
        if (is_tolerance) add_functions(i, tolerance_functions, 0, Made::tolerance);
        if (value >= large) add_functions(i, limit_functions, 0, Made::limit);
        if (is_constant && value >= near_one && value <= above_one && value != 1)
            add_functions(i, share_functions, 0, Made::share);
        for (const OtherValue& other : others_) {
            if (!is_number(other.kind) || other.name == nodes_[i].name) continue;
            add_functions_of_two(i, other, of_two_scalars, Made::number_with);
            if (is_tolerance) add_functions_of_two(i, other, relative_tolerances, Made::tolerance_with);
        }
    }

    void add_pair(std::size_t i) {
        set_everywhere(i);
        add_functions(i, pair_functions, 0, Made::pair, 1);
        add(i, {"{0} with x and y exchanged", "", 1.2, {{}, 0, Made::exchanged}});
        for (const OtherValue& other : others_)
            if (other.kind == Value::Kind::pair && other.name != nodes_[i].name)
                add_other(i, "{1}", 1.3, other, {{}, 0, Made::pair_with});
    }

    void add_vector(std::size_t i) {
        set_everywhere(i);
        add_functions(i, vector_functions, 0, Made::vector);
        const std::string_view text = nodes_[i].text;
        const bool is_color = text.starts_with("Color(") || (has_colors_ && !text.starts_with("vec3("));
        if (is_color) add_functions(i, color_functions, 0, Made::color);
        for (const OtherValue& other : others_) {
            if (other.name == nodes_[i].name) continue;
            if (other.kind == Value::Kind::vector && other.is_color && text.starts_with("vec3(")) continue;
            if (other.kind == Value::Kind::vector) {
                add_functions_of_two(i, other, of_two_vectors, Made::vector_with);
                if (is_color) add_functions_of_two(i, other, of_two_colors, Made::color_with);
            } else if (other.kind == Value::Kind::number) {
                add_functions_of_two(i, other, vector_scales, Made::scaled_with);
            }
        }
    }

    std::span<const textbook::Node> nodes_;
    int first_;
    std::vector<Value::Kind> seen_;
    std::vector<OtherValue> others_;
    std::vector<int> everywhere_;
    bool has_colors_ = false;
    std::vector<Mistake> all_;
};

}  // namespace

bool Expressions::holds(int whole, int node) const {
    return std::ranges::any_of(this->node(whole).parts, [&](int part) { return part == node || holds(part, node); });
}

bool Expressions::overlap(const textbook::Mistake& a, const textbook::Mistake& b) const {
    return std::ranges::any_of(a.nodes, [&](int one) {
        return std::ranges::any_of(b.nodes,
                                   [&](int other) { return one == other || holds(one, other) || holds(other, one); });
    });
}

std::vector<Mistake> mistakes_in(const Expressions& all, const Layout& arguments, const std::vector<bool>& told) {
    return MistakesMade(all, arguments, told).run();
}

}  // namespace grade
