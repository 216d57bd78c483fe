#include "diagnosis/rules/rule.h"

#include <fmt/format.h>

#include "diagnosis/where/simpler_values.h"
#include "protocol/rows.h"

namespace grade {

namespace {

/// A value that a sum takes: how often, and where, or of which sample.
struct Taken {
    double weight = 0, at = 0;
};

/// A call of a sum of f, which f is asked for.
using With = std::function<Row(const Integrand& f)>;

constexpr double lowest = -5, highest = 10;  // beyond all places where a sum may be asked to take f

/// The sums of functions that are 1 below an edge and 0 above it.
std::vector<double> sums_below(const std::vector<double>& edges, const With& with, const Ask& ask) {
    Rows rows;
    for (const double edge : edges) rows.push_back(with({Integrand::Kind::step, {edge, 1, 0}}));
    std::vector<double> sums;
    for (const Row& answer : ask(rows)) sums.push_back(answer.front());
    return sums;
}

/// Where such sums jump: each jump is a value that is taken, found by grids that become finer.
std::vector<Taken> jumps(double from, double to, int rounds, const With& with, const Ask& ask) {
    constexpr int count = 60;
    constexpr std::size_t most = 8;
    std::vector<double> edges;
    for (int i = 0; i <= count; ++i) edges.push_back(from + (to - from) * i / count);
    const auto sums = sums_below(edges, with, ask);
    std::vector<Taken> all;
    for (std::size_t i = 1; i < sums.size() && all.size() <= most; ++i) {
        if (!(std::abs(sums[i] - sums[i - 1]) > 1e-9)) continue;
        const double at = (edges[i] + edges[i - 1]) / 2;
        if (rounds == 0)
            all.push_back({sums[i] - sums[i - 1], std::abs(at) < 1e-3 ? 0 : rounded(at, 3)});
        else
            for (const Taken& term : jumps(edges[i - 1], edges[i], rounds - 1, with, ask)) all.push_back(term);
    }
    return all;
}

std::string in_words(const std::vector<Taken>& terms, const char* of, int digits) {
    std::string text;
    for (const Taken& term : terms) {
        const std::string weight = number_in_words(std::abs(term.weight), 4),
                          value = fmt::format(fmt::runtime(of), number_in_words(term.at, digits));
        text += text.empty() ? term.weight < 0 ? "-" : "" : term.weight < 0 ? " - " : " + ";
        text += weight == "1" ? value : weight + " * " + value;
    }
    return text.empty() ? "0" : text;
}

std::string if_other(const std::string& arguments, const std::string& mine, const std::string& right) {
    if (mine == right) return {};
    return fmt::format("for {} the sum is {}; it must be {}", arguments, mine, right);
}

std::string of_function(const std::string& arguments, const With& with, const Ask& mine, const Ask& right) {
    constexpr int rounds = 2;
    return if_other(arguments, in_words(jumps(lowest, highest, rounds, with, mine), "f({})", 6),
                    in_words(jumps(lowest, highest, rounds, with, right), "f({})", 6));
}

/// What each sample adds where all others are black; empty: together they add something else.
std::string of_samples(const std::vector<double>& weights, const Ask& ask) {
    Rows rows;
    for (std::size_t i = 0; i < weights.size(); ++i) {
        std::vector<rt::Color> radiance(weights.size(), rt::Color(0));
        radiance[i] = rt::Color(1);
        rows.push_back(row(radiance, weights));
    }
    std::vector<Taken> terms;
    double sum = 0;
    for (const Row& answer : ask(rows)) terms.push_back({answer.front(), double(terms.size())}), sum += answer.front();
    const std::vector<rt::Color> white(weights.size(), rt::Color(1));
    const Rows of_all = ask({row(white, weights)});
    if (of_all.empty() || of_all[0].empty()) return {};     // it has ended
    if (!(std::abs(of_all[0][0] - sum) < 1e-9)) return {};  // it is no sum
    std::erase_if(terms, [](const Taken& term) { return term.weight == 0; });
    return in_words(terms, "radiance[{}]", 6);
}

/// How often a function is asked, and between which places, as it stands behind an answer.
std::string use_in_words(const Row& answer, std::size_t at) {
    if (answer.at(at) == 0) return "never asked";
    return fmt::format("asked {} times, from {} to {}", answer.at(at), number_in_words(answer.at(at + 1)),
                       number_in_words(answer.at(at + 2)));
}

/// Another function than the one that is summed, as a density, that is asked elsewhere.
std::string wrong_use(const Calls& calls) {
    constexpr std::size_t numbers = 3;
    const auto& formulas = calls.layouts.front().formulas;
    for (std::size_t i = 1; i < formulas.size(); ++i)
        for (std::size_t k = 0; k < calls.size(); ++k) {
            const std::size_t at = 1 + numbers * i;
            const std::string mine = use_in_words(calls.mine[k], at), right = use_in_words(calls.right[k], at);
            if (calls.right[k].at(at) > 1 && mine != right)
                return fmt::format("for {} `{}` is {}; it must be {}",
                                   arguments_in_words(calls.signature, calls.rows[k]), formulas[i].name, mine, right);
        }
    return {};
}

}  // namespace

std::string wrong_rule(const Calls& calls, const Ask& mine, const Ask& right) {
    const std::string& name = calls.signature.fragment;
    if (const std::string use = wrong_use(calls); !use.empty()) return use;
    if (name == "integrate_uniform")
        return of_function(
            "a = 0, b = 3, n = 3", [](const Integrand& f) { return row(f, 0.0, 3.0, 3); }, mine, right);
    if (name == "integrate_monte_carlo") {
        const Integrand density{Integrand::Kind::power, {1, -1}};
        const std::vector<double> x = {0.5, 1, 2};
        return of_function(
            "x = [0.5, 1, 2], density(x) = 1 / x", [=](const Integrand& f) { return row(f, density, x); }, mine, right);
    }
    if (name == "integrate_stratified") {
        const std::vector<StratumOf> strata = {{0, 1, {0.25, 0.5}}, {1, 3, {0.5}}};
        return of_function(
            "strata = [{0, 1, {0.25, 0.5}}, {1, 3, {0.5}}]", [=](const Integrand& f) { return row(f, strata); }, mine,
            right);
    }
    if (name == "pixel_mean") {
        const std::vector<double> weights = {1, 2, 4};
        const std::string own = of_samples(weights, mine);
        return own.empty() ? own : if_other("weight = [1, 2, 4]", own, of_samples(weights, right));
    }
    return {};
}

}  // namespace grade
