#pragma once

#include "calibration/pool.h"
#include "calibration/real.h"
#include "calibration/workshop.h"

/// Where the steps of a calibration leave their results, and with which seeds.
namespace grade::calibration {

/// The grading seed of one part of the replicates.
inline std::uint64_t pool_seed(int part) { return 1001 + std::uint64_t(part); }

inline fs::path pool_file(const Workshop& workshop, const std::string& variant, const Check& check,
                          std::uint64_t seed) {
    return workshop.results(check.fragment) / "pools" / variant / (key_of(check) + "-" + std::to_string(seed));
}

inline std::vector<Bundle> wrong_bundles(const Workshop& workshop) {
    return bundles(workshop.variants(Variant::Kind::wrong), "wrong", true);
}

inline std::vector<Bundle> right_bundles(const Workshop& workshop) {
    return bundles(workshop.variants(Variant::Kind::right), "right", false);
}

/// One of each kind: a grading of all checks is much work for a machine that is busy on purpose.
inline std::vector<Bundle> bundles_under_load(const Workshop& workshop) {
    std::vector<Bundle> list;
    for (const auto& all : {right_bundles(workshop), wrong_bundles(workshop)})
        if (!all.empty()) list.push_back(all.front());
    return list;
}

inline std::vector<std::uint64_t> seeds_from_1(int count) {
    std::vector<std::uint64_t> seeds;
    for (int i = 1; i <= count; ++i) seeds.push_back(std::uint64_t(i));
    return seeds;
}

inline std::vector<std::uint64_t> wrong_seeds(const Workshop& workshop) {
    return seeds_from_1(workshop.amount().wrong_seeds);
}

/// So many that all bundles together have the wanted number of gradings.
inline std::vector<std::uint64_t> right_seeds(const Workshop& workshop) {
    const int count = std::max(1, int(right_bundles(workshop).size()));
    return seeds_from_1((workshop.amount().gradings + count - 1) / count);
}

inline fs::path real_file(const Workshop& workshop, const Bundle& bundle, std::uint64_t seed) {
    return workshop.results() / "real" / (bundle.name + "-" + std::to_string(seed) + ".json");
}

inline fs::path peer_file(const Workshop& workshop, const Variant& variant) {
    return workshop.results(variant.fragment) / "peers" / (variant.name + ".json");
}

/// Of a dose, or of what is confined to a few pixels.
inline fs::path result_file(const Workshop& workshop, const Variant& variant) {
    return workshop.results() / (variant.name + ".json");
}

inline fs::path load_file(const Workshop& workshop, const Bundle& bundle) {
    return workshop.results() / "load" / (bundle.name + ".json");
}

}  // namespace grade::calibration
