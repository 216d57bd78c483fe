
#include <cstdlib>
#include <nlohmann/json.hpp>

#include "convert/formats.h"
#include "convert/words.h"

namespace grade {

namespace {

/// Scores are whole numbers there.
long hundredths(double points) { return std::lround(100 * points); }

/// What its runner says, else what nobody takes for an address.
std::string said(const char* variable, const char* otherwise = "unknown") {
    const char* text = std::getenv(variable);
    return text && *text ? text : otherwise;
}

}  // namespace

std::string classroom50(const Record& record) {
    using Json = nlohmann::ordered_json;
    Json json;
    json["schema"] = "classroom50/result/v1";
    for (const auto& [key, variable] : {std::pair("classroom", "CLASSROOM"),
                                        {"assignment", "ASSIGNMENT"},
                                        {"submission", "SUBMISSION_TAG"},
                                        {"commit", "COMMIT_URL"},
                                        {"release", "RELEASE_URL"}})
        json[key] = said(variable);
    json["review"] = said("REVIEW_URL", said("COMMIT_URL").c_str());
    // the runner puts the commit's time there
    json["datetime"] = record.date;
    json["graded_at"] = record.date;
    long score = 0, most = 0;
    Json tests = Json::array();
    for (const FragmentRecord& fragment : record.fragments) {
        const long have = hundredths(fragment.points), all = hundredths(fragment.max_points);
        score += have, most += all;
        tests.push_back({{"test-name", fragment.name},
                         {"passed", fragment.verdict == Verdict::passed},
                         {"score", have},
                         {"max-score", all},
                         {"output", words_on(fragment)}});
    }
    json["score"] = score;
    json["max-score"] = most;
    json["tests"] = tests;
    return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace grade
