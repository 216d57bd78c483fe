#include "commands/last_run.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "build/files.h"
#include "report/terminal.h"

namespace grade {

void compare_with_last(Record& record, const std::filesystem::path& file) {
    auto last = nlohmann::json::parse(read_text(file).value_or(""), nullptr, false);
    if (!last.is_object()) last = nlohmann::json::object();
    for (const FragmentRecord& fragment : record.fragments) {
        auto& before = last[fragment.name];
        const std::string verdict = in_words(fragment.verdict);
        if (before.is_object() && before.value("verdict", "").size() > 0) {
            const double gained = fragment.points - before.value("points", 0.0);
            const std::string was = before.value("verdict", "");
            if (gained != 0 || was != verdict)
                record.changes.push_back(fmt::format("{}: {}, was {}{}", fragment.name, verdict, was,
                                                     gained != 0 ? fmt::format(" ({:+g} points)", gained) : ""));
        }
        before = {{"verdict", verdict}, {"points", fragment.points}};
    }
    write_text(file, last.dump(1) + "\n");
}

}  // namespace grade
