#include "convert/words.h"

#include <fmt/format.h>

#include "report/escape.h"
#include "report/terminal.h"

namespace grade {

std::string short_number(double x) {
    std::string text = fmt::format("{:.2f}", x);
    text.erase(text.find_last_not_of('0') + 1);
    if (text.ends_with('.')) text.pop_back();
    return text == "-0" ? "0" : text;
}

std::string words_on(const FragmentRecord& fragment) {
    std::string text = in_words(fragment.verdict);
    if (fragment.verdict == Verdict::passed) return text;
    const Diagnosis diagnosis = diagnose(fragment);
    if (!diagnosis.words.empty()) text += "\n" + printable(diagnosis.words);
    if (const std::string where = where_to_read(fragment.verdict, diagnosis); !where.empty()) text += "\n" + where;
    return text;
}

std::string score_in_words(const Record& record) {
    return fmt::format("{} of {} points", short_number(record.score()), short_number(record.max_score()));
}

}  // namespace grade
