#pragma once

#include "record/record.h"

/// Once a check has timed out, those after it in the record of its fragment are not run, and those before it count:
/// which ones are run does not depend on which of two processors is faster.
namespace grade {

/// Whether a check before this one has timed out.
bool is_late(const FragmentRecord& fragment, const CheckRecord& check);

/// A check that is late, as the record has it.
void leave_out(CheckRecord& check);

/// Of a fragment whose checks have all come back: what a single processor would not have run.
void leave_out_late(FragmentRecord& fragment);

}  // namespace grade
