#include "report/page.h"

namespace grade {

std::string page(const Record& record, const Assignment&) { return record.submission; }

}  // namespace grade
