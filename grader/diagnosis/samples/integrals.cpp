#include "diagnosis/samples/integrals.h"

#include <algorithm>
#include <cmath>
#include <random>

#include "diagnosis/calls/scalars.h"

namespace grade {

namespace {

/// The places of u in a row; empty: there is none. Numbers of the sample among n are drawn with it.
std::vector<std::size_t> numbers_of(const Layout& arguments) {
    std::vector<std::size_t> places;
    for (const Field& part : arguments.parts)
        if (part.name == "u")
            for (std::size_t c = 0; c < size_of(part.kind); ++c) places.push_back(part.at + c);
    return places;
}

/// Where the number of the sample, or that of all samples, stands; none: there is no such argument.
std::optional<std::size_t> place_of(const Layout& arguments, std::string_view name) {
    const auto part = std::ranges::find(arguments.parts, name, &Field::name);
    return part == arguments.parts.end() ? std::nullopt : std::optional(part->at);
}

/// The call with numbers of a grid; of samples in cells, with each sample.
Rows over_grid(const Row& call, const std::vector<std::size_t>& u, std::optional<std::size_t> sample, int samples,
               std::size_t side) {
    Rows rows;
    const std::size_t count = u.size() == 1 ? side * side : side;
    // not the middles, whose sums are off by what lies at the rim
    std::mt19937_64 random(1);
    const auto within = [&](std::size_t i) { return (double(i) + double(random() >> 11) * 0x1p-53) / double(count); };
    for (int one = 0; one < samples; ++one)
        for (std::size_t i = 0; i < side * side; ++i) {
            rows.push_back(call);
            if (sample) rows.back()[*sample] = one;
            rows.back()[u[0]] = within(i % count);
            if (u.size() > 1) rows.back()[u[1]] = within(i / count);
        }
    return rows;
}

bool has_unit_length(const Row& row, std::size_t at) { return std::abs(glm::length(vector_at(row, at)) - 1) < 1e-6; }

}  // namespace

std::optional<Integrals> Integrals::of(const Calls& calls, const Ask& right, std::size_t bases, std::size_t side,
                                       double close) {
    if (calls.size() == 0) return std::nullopt;
    Integrals all;
    all.result_ = calls.result, all.close_ = close;
    const std::vector<std::size_t> u = numbers_of(calls.layouts.front());
    const auto sample = place_of(calls.layouts.front(), "i");
    const auto count = sample ? place_of(calls.layouts.front(), "n") : std::nullopt;
    if (u.empty() || u.size() > 2 || (sample && !count)) return std::nullopt;
    for (std::size_t base = 0; base < bases; ++base) {
        Row call = calls.rows[base * calls.size() / bases];
        constexpr int few = 5;  // cells, of which columns hold different numbers
        if (count) call[*count] = few;
        const Rows rows =
            over_grid(call, u, sample, sample ? few : 1, sample ? std::max<std::size_t>(side / 2, 2) : side);
        all.each_ = rows.size(), all.of_sample_ = sample ? rows.size() / few : rows.size();
        all.rows_.insert(all.rows_.end(), rows.begin(), rows.end());
    }
    all.solution_ = right(all.rows_);
    const Rows& due = all.solution_;
    if (due.empty() || due.size() != all.rows_.size()) return std::nullopt;
    all.width_ = due.front().size();
    const bool in_several_ways =
        std::ranges::any_of(calls.layouts.front().parts, [](const Field& part) { return part.kind == Kind::choice; });
    for (const Field& part : all.result_.parts) {
        const auto is_unit = [&](const Row& row) { return has_unit_length(row, part.at); };
        if (part.kind == Kind::vector && std::ranges::all_of(due, is_unit)) all.directions_.push_back(part.at);
        for (std::size_t c = 0; c < size_of(part.kind); ++c) {
            const std::size_t at = part.at + c;
            const bool is_number = std::ranges::all_of(due, [&](const Row& row) { return std::isfinite(row[at]); });
            const bool is_density = part.name == "density";
            if (is_density ? in_several_ways : is_measure(part))
                all.measures_.push_back(at), all.is_density_ = is_density;
            else if (is_number)
                all.places_.push_back(at);
        }
    }
    for (std::size_t base = 0; base < bases; ++base) {
        all.middles_.emplace_back();
        for (const std::size_t at : all.places_) {
            double sum = 0;
            for (std::size_t k = base * all.each_; k < (base + 1) * all.each_; ++k) sum += due[k][at];
            all.middles_.back().push_back(sum / double(all.each_));
        }
        all.due_.push_back(all.moments(due, base)), all.within_.push_back(all.within_samples(due, base));
    }
    return all.find_tolerances(u, right) ? std::optional(all) : std::nullopt;
}

bool Integrals::find_tolerances(const std::vector<std::size_t>& u, const Ask& right) {
    Rows mirrored = rows_;
    for (Row& row : mirrored)
        for (const std::size_t at : u) row[at] = 1 - row[at];
    const Rows answers = right(mirrored);
    if (answers.size() != rows_.size()) return false;
    for (std::size_t base = 0; base < due_.size(); ++base) {
        const std::vector<Moment> again = moments(answers, base);
        tolerances_.emplace_back();
        for (std::size_t i = 0; i < again.size(); ++i)
            tolerances_.back().push_back(close_ * (std::sqrt(due_[base][i].square) + 1e-9) +
                                         3 * std::abs(again[i].mean - due_[base][i].mean));
    }
    return true;
}

std::vector<Integrals::Moment> Integrals::moments(const Rows& answers, std::size_t base) const {
    std::vector<Moment> all;
    std::size_t next = 0;
    const auto add = [&](double x) {
        if (next == all.size()) all.emplace_back();
        all[next].mean += x / double(each_), all[next].square += x * x / double(each_), ++next;
    };
    for (std::size_t k = base * each_; k < (base + 1) * each_; ++k) {
        const Row& row = answers[k];
        const auto measure = [&](std::size_t at) { return is_density_ ? (row[at] > 0 ? 1 / row[at] : 0) : row[at]; };
        next = 0;
        for (const std::size_t at : measures_) add(measure(at));
        const double share = measures_.empty() ? 1 : measure(measures_.front());
        for (std::size_t i = 0; i < places_.size(); ++i) {
            const auto from_middle = [&](std::size_t place) { return row[places_[place]] - middles_[base][place]; };
            const double x = share == 0 ? 0 : share * from_middle(i);  // a sample that does not count may be anywhere
            add(x);
            for (std::size_t j = 0; j <= i; ++j) add(x == 0 ? 0 : x * from_middle(j));
        }
    }
    return all;
}

double Integrals::within_samples(const Rows& answers, std::size_t base) const {
    double all = 0;
    for (std::size_t begin = base * each_; begin < (base + 1) * each_; begin += of_sample_)
        for (const std::size_t at : places_) {
            double mean = 0;
            for (std::size_t k = begin; k < begin + of_sample_; ++k) mean += answers[k][at] / double(of_sample_);
            for (std::size_t k = begin; k < begin + of_sample_; ++k) all += rt::sqr(answers[k][at] - mean);
        }
    return all;
}

bool Integrals::are_right(const Rows& answers) const {
    if (answers.size() != rows_.size()) return false;
    for (const Row& row : answers) {
        if (row.size() != width_) return false;
        for (const std::size_t at : directions_)
            if (!has_unit_length(row, at) && vector_at(row, at) != rt::vec3(0)) return false;
    }
    for (std::size_t base = 0; base < due_.size(); ++base) {
        constexpr double about = 0.2;
        if (of_sample_ < each_ && !(std::abs(within_samples(answers, base) - within_[base]) <= about * within_[base]))
            return false;
        const std::vector<Moment> all = moments(answers, base);
        for (std::size_t i = 0; i < all.size(); ++i)
            if (!(std::abs(all[i].mean - due_[base][i].mean) <= tolerances_[base][i])) return false;
    }
    return true;
}

bool Integrals::are_elsewhere(const Rows& answers) const {
    constexpr double least = 0.25;  // a place that is right but for some percent is the same one, and wrong
    bool any = false;
    for (std::size_t base = 0; base < due_.size(); ++base) {
        if (due_[base].front().square == 0) continue;
        double apart = 0, spread = 0;
        for (std::size_t k = base * each_; k < (base + 1) * each_; ++k)
            for (std::size_t i = 0; i < places_.size(); ++i) {
                const std::size_t at = places_[i];
                apart += std::abs(answers[k][at] - solution_[k][at]);
                spread += std::abs(solution_[k][at] - middles_[base][i]);
            }
        if (!(apart > least * spread)) return false;
        any = true;
    }
    return any;
}

}  // namespace grade
