#include "judging/picture_cost.h"

#include "statistics/error.h"

namespace grade {

void add_picture_costs(CheckRecord& record, const rt::Image& first, double seconds, Reference& reference) {
    const Halves halves{reference.image(1), reference.image(2)};
    record.cost = {squared_error(first, halves).mse, seconds};
    record.solution_cost = {squared_error(reference.image(0), halves).mse, reference.cpu_seconds()};
}

}  // namespace grade
