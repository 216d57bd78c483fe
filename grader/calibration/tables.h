#pragma once

#include <string>

#include "calibration/summary.h"

/// What the report is put together from: tables in Markdown.
namespace grade::calibration {

/// A share as a rate with its bounds.
std::string rate(long hits, long all);

/// A share in percent.
std::string share(long hits, long all);

/// Sum of what `value` gives of each row.
template <class Rows, class Value>
auto total(const Rows& rows, Value value) {
    decltype(value(rows[0])) sum{};
    for (const auto& row : rows) sum += value(row);
    return sum;
}

/// Shares of replayed gradings.
double failed_rate(const VariantSummary& v);
double open_rate(const VariantSummary& v);

/// What was to be shown beside what was measured; what was not measured is named once, below.
class GoalTable {
public:
    /// measured  as rate and share give it
    void row(const std::string& what, const std::string& goal, const std::string& measured);

    std::string text() const;

private:
    std::string rows_, open_;
};

/// What was to be shown, and what was.
std::string goals(const Summary& s);

bool has_run(const std::vector<Budget>& budgets);
std::string budget_table(const std::vector<Budget>& budgets, const std::string& heading);
std::string variant_table(const std::vector<VariantSummary>& rows, bool wrong);

/// How often each rule is right, over variants that have pictures.
std::string peer_table(const Summary& s);

std::string dose_list(const Summary& s);
std::string confined_table(const Summary& s);
std::string nominal_table(const Summary& s);

/// How good hints are, over real gradings of wrong variants that were found.
std::string hint_table(const Summary& s);

}  // namespace grade::calibration
