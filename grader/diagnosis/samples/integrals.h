#pragma once

#include <optional>

#include "diagnosis/calls/calls.h"

namespace grade {

/// What the samples of some calls integrate over all random numbers u: their measure, and where they are, from the
/// middle of all, and that squared. Samples that are right integrate what the solution's do, wherever each of them
/// lies.
///
/// The measure is the weight, or 1 / density of a lamp, which may be sampled in several ways, or 1; else a density is
/// one more coordinate. The random numbers are a point in each cell of a grid.
class Integrals {
public:
    /// Of a fragment with random numbers; none: it has none, or what the solution integrates is no number.
    ///
    /// calls  whose arguments are taken, `bases` of them
    /// side   of the grid
    /// close  how far off an integral may be, as a share of the integrand's root mean square
    static std::optional<Integrals> of(const Calls& calls, const Ask& right, std::size_t bases, std::size_t side,
                                       double close);

    const Rows& rows() const { return rows_; }
    /// Whether these are right: an answer for each row.
    bool are_right(const Rows& answers) const;
    /// Whether right ones lie elsewhere than the solution's for the same random numbers, in every call in which
    /// anything is sampled.
    bool are_elsewhere(const Rows& answers) const;

private:
    struct Moment {
        double mean = 0, square = 0;
    };
    /// How far answers are from the middle of those of the same sample: samples in cells must not lie all over.
    double within_samples(const Rows& answers, std::size_t base) const;
    std::vector<Moment> moments(const Rows& answers, std::size_t base) const;
    /// Of the moments: also what the grid leaves, by the solution's with each number u in the place of 1 - u; false: it
    /// does not answer.
    bool find_tolerances(const std::vector<std::size_t>& u, const Ask& right);

    Layout result_;
    Rows rows_, solution_;                              // and its answers
    std::size_t each_ = 0, of_sample_ = 0, width_ = 0;  // rows of a base, and of a sample; numbers of an answer
    double close_ = 0;
    std::vector<std::size_t> places_, measures_;  // numbers of an answer
    std::vector<std::size_t> directions_;         // where vectors of length 1 begin
    bool is_density_ = false;
    std::vector<std::vector<double>> middles_;  // of each base: the mean of each place
    std::vector<double> within_;
    std::vector<std::vector<Moment>> due_;
    std::vector<std::vector<double>> tolerances_;
};

}  // namespace grade
