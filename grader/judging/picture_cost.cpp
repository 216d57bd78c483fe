#include "judging/picture_cost.h"

#include "convergence/error.h"

namespace grade {

void add_picture_costs(CheckRecord& record, const rt::Image& first, double seconds, Reference& reference) {
    const auto theirs = reference.image(0), one = reference.image(1), other = reference.image(2);
    if (!theirs || !one || !other) return;
    const Halves halves{*one, *other};
    record.cost = {squared_error(first, halves).mse, seconds};
    record.solution_cost = {squared_error(*theirs, halves).mse, reference.cpu_seconds().value_or(0)};
}

}  // namespace grade
