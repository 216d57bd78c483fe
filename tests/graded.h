#pragma once

#include "checks/kit/probe_check.h"
#include "files/files.h"
#include "judging/grading.h"
#include "protocol/rows.h"

/// Small gradings of three fragments, of which a test changes one.
namespace grade::small {

/// A check of one statistic, of calls with random arguments.
inline Check toy(const std::string& fragment, std::function<Rows(Generator&)> inputs, Statistic statistic) {
    return {"toy", fragment, Probe{fragment, std::move(inputs)}, {std::move(statistic)}};
}

/// A few small checks: one without noise, one with, one that is like the solution.
inline std::vector<Check> toy_checks() {
    const auto change_of_length = [](const Observation& seen) {
        double most = 0;
        for (std::size_t i = 0; i < seen.inputs.size(); ++i) {
            const auto d = from_row<rt::vec3>(seen.inputs[i]), r = from_row<rt::vec3>(seen.outputs[i]);
            most = std::max(most, std::abs(glm::length(d) - glm::length(r)));
        }
        return most;
    };
    const auto squared_radius = [](const Observation& seen) {
        double sum = 0;
        for (const Row& out : seen.outputs) {
            const auto sample = from_row<rt::DiskSample>(out);
            sum += rt::dot(sample.point, sample.point);
        }
        return sum / double(seen.outputs.size());
    };
    const auto directions = [](const Observation& seen) {
        rt::vec3 total(0);
        for (const Row& out : seen.outputs) total += rt::unit(from_row<rt::Ray>(out).direction);
        return total.x + 2 * total.y + 3 * total.z;
    };
    const auto keep = [](double, double) { return std::string("keep the length"); };
    return {toy("mirror_direction",
                rows_of(20,
                        [](Generator& random) {
                            const rt::vec3 d = box(random, -2, 2);
                            return row(d, direction(random));
                        }),
                {"M", "largest change of length [1]", change_of_length, 0.0, 0, 1e-12, true, keep}),
            toy("uniform_disk", rows_of(200, [](Generator& random) { return row(square(random)); }),
                {"D2", "mean squared radius [1]", squared_radius, 0.5, 0.002, 0.05, false, {}}),
            toy("camera_ray", rows_of(10, [](Generator& random) { return row(rt::Camera{}, 256.0 * square(random)); }),
                {"C", "sum of directions [1]", directions, std::nullopt, 0, 1e-9, true, {}})};
}

inline const std::vector<std::string> names{"mirror_direction", "uniform_disk", "camera_ray"};

inline const Toolchain& toolchain() {
    static const Toolchain chain = read_toolchain(GRADE_TOOLCHAIN);
    return chain;
}

inline std::string solution(const std::string& fragment) { return read_text("solution/" + fragment + ".cpp").value(); }

/// The solution of the three, with other texts for some.
inline Submission submission(const std::map<std::string, std::string>& changed) {
    Submission result{.name = "test"};
    for (const std::string& name : names)
        result.texts[name] = changed.contains(name) ? changed.at(name) : solution(name);
    return result;
}

inline Record graded(const Submission& submission) {
    GradingSettings settings;
    settings.only = {names.begin(), names.end()};
    settings.seed = 7;
    settings.build.jobs = 2;
    settings.time_limit = 1;
    return grade_submission(submission, read_assignment("assignment.toml"), toolchain(), ready(toy_checks()), settings);
}

inline const FragmentRecord& of(const Record& record, const std::string& name) {
    return *std::ranges::find(record.fragments, name, &FragmentRecord::name);
}

/// A text of mirror_direction with this body, and this before it.
inline std::string mirror(const std::string& body, const std::string& before = "") {
    return "#include \"rt/fragments.h\"\n#include <cstdlib>\n#include <cstdio>\n" + before +
           "namespace rt {\nvec3 mirror_direction(vec3 d, vec3 n) {\n" + body + "\n}\n}\n";
}

inline const std::string right = "return d - 2.0 * dot(d, n) * n;";

}  // namespace grade::small
