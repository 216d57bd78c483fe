#pragma once

#include "diagnosis/changes/changes.h"
#include "diagnosis/changes/relation.h"

namespace grade {

/// Calls with which a change is sifted.
constexpr std::size_t few = 10;

/// Of what is found where nothing explains all.
constexpr double best_cost = 100;

/// For a relation of answers, among the changes of arguments or of steps.
class Search {
public:
    Search(const Calls& calls, const Ask& right, bool sampled);
    std::optional<Relation> run();

private:
    /// One mistake in calls of one kind, or of some: of a disc, say.
    std::optional<Relation> by_choice() const;
    std::optional<Relation> one_mistake();
    /// One change where the right answer is neither 0 nor inf: what happens there may be a second mistake.
    std::optional<Relation> where_it_is_not_nothing();
    /// The right answers for changed arguments, to the calls of `scope`.
    std::optional<Rows> answers_in(const Change& first, const Change* second,
                                   const std::vector<std::size_t>& scope) const;
    /// Elsewhere, those that are right.
    std::optional<Rows> answers(const Change& first, const Change* second, const std::vector<std::size_t>& scope) const;
    bool all_equal(const Rows& right, const std::vector<std::size_t>& scope) const;
    /// A relation of all parts that are wrong, if it costs less than the best one.
    void consider(const Rows& right, const std::string& change, double cost, const std::vector<std::size_t>& scope,
                  bool only_simple, const std::string& usually = {});
    /// Whether the changed answers differ from right ones as often as mine do, and not by one number only, unless it is
    /// told in which calls they are left as they are.
    bool tells(const Rows& changed, const std::vector<std::size_t>& scope) const;
    /// Calls with which a change is sifted.
    std::vector<std::size_t> some_wrong(const std::vector<std::size_t>& scope) const;
    bool may_be(const Rows& right, const std::vector<std::size_t>& sample) const;
    void one_change(const Change& base, const std::vector<std::size_t>& scope);
    /// The change that explains most of the wrong calls, where it explains nearly all that it changes: the rest is
    /// another mistake.
    void one_of_several();
    /// Which parts of the answer are right, and which are not.
    std::optional<Relation> which_parts() const;
    const Calls& calls_;
    const Ask& ask_;
    bool sampled_;
    std::string region_;  // of which a relation is looked for: "where ..., "
    const Change same_{"", 0, [](Row&, const Layout&) { return true; }, {}};
    std::vector<std::size_t> all_, wrong_;
    std::vector<const Field*> parts_;  // of the answer, that are wrong somewhere
    std::vector<Change> changes_;
    std::optional<Relation> best_;
};

}  // namespace grade
