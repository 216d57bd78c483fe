#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "convert/formats.h"
#include "convert/words.h"
#include "report/escape.h"

namespace grade {

std::string prairielearn(const Record& record) {
    using Json = nlohmann::ordered_json;
    Json json;
    json["gradable"] = true;
    json["score"] = record.max_score() > 0 ? std::clamp(record.score() / record.max_score(), 0.0, 1.0) : 0.0;
    json["message"] = score_in_words(record);
    std::string notes;
    for (const std::string& note : record.notes) notes += "Note: " + printable_line(note) + "\n";
    json["output"] = notes + fmt::format("seed {}; {}\n", record.seed, record.sandbox);
    json["tests"] = Json::array();
    for (const FragmentRecord& fragment : record.fragments)
        if (fragment.visibility == "visible")
            json["tests"].push_back({{"name", fragment.name},
                                     {"description", fragment.part},
                                     {"points", fragment.points},
                                     {"max_points", fragment.max_points},
                                     {"message", words_on(fragment)},
                                     {"output", ""},
                                     {"images", Json::array()}});
    return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace grade
