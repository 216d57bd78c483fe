#pragma once

#include "diagnosis/calls/expressions.h"
#include "diagnosis/calls/scalars.h"
#include "diagnosis/changes/changes.h"

namespace grade {

/// The changes as they are made.
class Changes {
public:
    Changes(const Layout& layout, const std::vector<bool>& told);

    std::vector<Change> take() { return std::move(all_); }

private:
    void add(std::string words, double cost, std::function<bool(Row&, const Layout&)> make) {
        all_.push_back({std::move(words), cost, std::move(make), {}});
    }

    /// An expression in place of a name.
    void add(const std::string& expression, const std::string& replaced, double cost,
             std::function<bool(Row&, const Layout&)> make) {
        add(in_place(expression, replaced), cost, std::move(make));
    }

    const std::string& name(std::size_t part) const { return layout_.parts[part].name; }

    bool is_told(std::size_t part) const { return part >= told_.size() || told_[part]; }

    void add_flag(std::size_t i);
    void add_scalar(const Scalar& s);
    template <class Functions, class TwoFunctions>
    void add_vector(std::size_t i, const std::vector<std::size_t>& others, const Functions& functions,
                    const TwoFunctions& of_two);
    /// A vector or colour times a power of a quantity, or of the ratio of two.
    void add_scaled(std::size_t i, double cost);

    /// The same to each vector of one struct; to each of a camera's axes.
    void add_joint();
    /// A pair changed in both coordinates, or another one in its place, as of an extent's corners.
    void add_pairs();
    void add_lists();

    const Layout& layout_;
    const std::vector<bool>& told_;
    std::vector<Scalar> scalars_;
    std::vector<std::size_t> vectors_, colors_;
    std::vector<Change> all_;
};

}  // namespace grade
