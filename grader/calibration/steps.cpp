#include <fmt/format.h>

#include <atomic>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <thread>

#include "calibration/peers.h"
#include "calibration/pool.h"
#include "calibration/real.h"
#include "calibration/results.h"
#include "files/files.h"
#include "judging/experiment.h"

namespace grade::calibration {

namespace {

using Json = nlohmann::ordered_json;

constexpr double patience_with_picture = 30;  // CPU seconds of a picture
constexpr int pictures_of_a_variant = 16, pictures_of_the_solution = 64;
constexpr std::size_t gradings_at_once = 25;  // of one compilation

void write_json(const fs::path& path, const Json& json) {
    fs::create_directories(path.parent_path());
    write_text(path, json.dump(1) + "\n");
}

/// The replicates of one fragment's checks, under one of the grading seeds.
Step pool_step(const Workshop& workshop, const Variant* variant, const std::string& fragment, int part) {
    const std::string name = variant ? variant->name : "solution";
    const std::uint64_t seed = pool_seed(part);
    const int replicates = workshop.amount().replicates / workshop.amount().seeds;
    Step step{fmt::format("replicates of {}, {}", name, fragment), {}, {}};
    for (const Check* check : workshop.checks(seed, fragment))
        step.results.push_back(pool_file(workshop, name, *check, seed));
    step.run = [=, &workshop] {
        const fs::path program = variant ? workshop.program(*variant) : workshop.solution_program();
        for (const Check* check : workshop.checks(seed, fragment)) {
            const fs::path file = pool_file(workshop, name, *check, seed);
            const Pool before = read_pool(file).value_or(Pool{});
            if (before.has(replicates)) continue;
            write_pool(file, collect(*check, seed, replicates, program, workshop.solution_program(), workshop.sandbox(),
                                     workshop.meshes(), before));
        }
    };
    step.is_whole = [replicates](const fs::path& file) { return read_pool(file).value_or(Pool{}).has(replicates); };
    return step;
}

std::vector<Step> pool_steps(const Workshop& workshop, int part) {
    std::vector<Step> steps;
    for (const std::string& fragment : workshop.fragments())
        steps.push_back(pool_step(workshop, nullptr, fragment, part));
    for (const auto kind : {Variant::Kind::right, Variant::Kind::wrong})
        for (const Variant* variant : workshop.variants(kind))
            steps.push_back(pool_step(workshop, variant, variant->fragment, part));
    return steps;
}

/// Real gradings of a bundle with these seeds.
Step real_step(const Workshop& workshop, const Bundle& bundle, std::vector<std::uint64_t> seeds) {
    Step step{"gradings of " + bundle.name, {}, {}};
    for (const std::uint64_t seed : seeds) step.results.push_back(real_file(workshop, bundle, seed));
    step.run = [=, &workshop] {
        std::vector<std::uint64_t> open;
        for (const std::uint64_t seed : seeds)
            if (!fs::exists(real_file(workshop, bundle, seed))) open.push_back(seed);
        const auto gradings = grade_changed(workshop, changed_texts(bundle, workshop), open, workshop.fragments(), 1);
        for (std::size_t i = 0; i < open.size(); ++i) write_grading(real_file(workshop, bundle, open[i]), gradings[i]);
    };
    return step;
}

std::vector<Step> wrong_steps(const Workshop& workshop) {
    std::vector<Step> steps;
    for (const Bundle& bundle : wrong_bundles(workshop))
        steps.push_back(real_step(workshop, bundle, wrong_seeds(workshop)));
    return steps;
}

std::vector<Step> right_steps(const Workshop& workshop) {
    std::vector<Step> steps;
    const auto seeds = right_seeds(workshop);
    for (std::size_t first = 0; first < seeds.size(); first += gradings_at_once) {
        const std::size_t last = std::min(first + gradings_at_once, seeds.size());
        for (const Bundle& bundle : right_bundles(workshop))
            steps.push_back(real_step(workshop, bundle,
                                      {seeds.begin() + std::ptrdiff_t(first), seeds.begin() + std::ptrdiff_t(last)}));
    }
    return steps;
}

/// The mean of so many pictures of a check; none where the program fails.
std::optional<PixelMoments> pictures_of(const Workshop& workshop, const Check& check, const fs::path& program,
                                        int count, int first) {
    Runner runner(program, workshop.sandbox(), workshop.meshes(), patience_with_picture);
    PixelMoments moments;
    for (int k = 0; k < count; ++k) {
        auto outcome = observe(runner, check, replicate_seed(pool_seed(0), check, Stream::submission, first + k));
        if (!std::holds_alternative<Observation>(outcome)) return std::nullopt;
        moments.add(std::get<Observation>(outcome).image);
    }
    return moments;
}

/// What the rules of others say about the pictures of the variants of one fragment: caught by one of them is caught.
Step peer_step(const Workshop& workshop, const std::string& fragment) {
    std::vector<const Variant*> variants;
    for (const auto kind : {Variant::Kind::wrong, Variant::Kind::right})
        for (const Variant* variant : workshop.variants(kind))
            if (variant->fragment == fragment) variants.push_back(variant);
    Step step{"rules of others: " + fragment, {}, {}};
    for (const Variant* variant : variants) step.results.push_back(peer_file(workshop, *variant));
    step.run = [&workshop, variants, fragment] {
        std::vector<PeerRules> rules(variants.size());
        int pictures = 0;
        for (const Check* check : workshop.checks(pool_seed(0), fragment)) {
            if (!std::holds_alternative<Render>(check->experiment)) continue;
            ++pictures;
            const auto theirs = pictures_of(workshop, *check, workshop.solution_program(), pictures_of_the_solution,
                                            pictures_of_a_variant);
            for (std::size_t i = 0; i < variants.size(); ++i) {
                const auto own =
                    pictures_of(workshop, *check, workshop.program(*variants[i]), pictures_of_a_variant, 0);
                const PeerRules one =
                    own && theirs ? judged_by_peers(own->mean, own->count, *theirs) : PeerRules{false, false, false};
                rules[i].z_test = rules[i].z_test && one.z_test;
                rules[i].mean_difference = rules[i].mean_difference && one.mean_difference;
                rules[i].global_mean = rules[i].global_mean && one.global_mean;
            }
        }
        for (std::size_t i = 0; i < variants.size(); ++i)
            write_json(peer_file(workshop, *variants[i]), {{"pictures", pictures},
                                                           {"z_test", rules[i].z_test},
                                                           {"mean_difference", rules[i].mean_difference},
                                                           {"global_mean", rules[i].global_mean}});
    };
    return step;
}

Json verdicts_of(const Workshop& workshop, const std::string& fragment, const std::string& text) {
    Json verdicts = Json::array();
    for (const RealGrading& grading : grade_changed(workshop, {{fragment, text}}, wrong_seeds(workshop), {fragment}, 1))
        verdicts.push_back(name(grading.fragments.at(0).verdict));
    return verdicts;
}

/// A mistake of several sizes: which of them is found?
Step dose_step(const Workshop& workshop, const Variant& variant) {
    const fs::path file = result_file(workshop, variant);
    return {"sizes of " + variant.name, {file}, [&workshop, &variant, file] {
                Json json;
                for (const std::string& dose : variant.doses)
                    json[dose] =
                        verdicts_of(workshop, variant.fragment, changed_text(variant, workshop.chain().source, dose));
                write_json(file, json);
            }};
}

/// A mistake in a few pixels: in how many of its scene, and is it found?
Step confined_step(const Workshop& workshop, const Variant& variant) {
    const fs::path file = result_file(workshop, variant);
    return {"pixels of " + variant.name, {file}, [&workshop, &variant, file] {
                const Render render{read_text(workshop.chain().source / variant.scene).value(), 64, "stratified"};
                Runner right(workshop.solution_program(), workshop.sandbox(), workshop.meshes(), patience_with_picture);
                Runner wrong(workshop.program(variant), workshop.sandbox(), workshop.meshes(), patience_with_picture);
                const auto a = right.render(render, 1), b = wrong.render(render, 1);
                if (!std::holds_alternative<rt::Image>(a) || !std::holds_alternative<rt::Image>(b))
                    throw std::runtime_error(variant.name + ": " + variant.scene + " cannot be rendered");
                const rt::Image &x = std::get<rt::Image>(a), &y = std::get<rt::Image>(b);
                int changed = 0;
                for (std::size_t i = 0; i < x.pixels.size(); ++i) changed += x.pixels[i] != y.pixels[i];
                write_json(file, {{"changed", changed},
                                  {"pixels", x.pixels.size()},
                                  {"verdicts", verdicts_of(workshop, variant.fragment,
                                                           changed_text(variant, workshop.chain().source))}});
            }};
}

/// One grading on a quiet machine and again on a busy one, with other numbers of jobs.
Step load_step(const Workshop& workshop, const Bundle& bundle) {
    const fs::path file = load_file(workshop, bundle);
    return {"the same grading under load: " + bundle.name, {file}, [&workshop, bundle, file] {
                const auto texts = changed_texts(bundle, workshop);
                const std::string calm = grade_changed(workshop, texts, {1}, workshop.fragments(), 1).at(0).record;
                std::atomic<bool> on = true;
                std::string busy;
                {
                    std::vector<std::jthread> load;
                    for (unsigned i = 0; i < std::thread::hardware_concurrency(); ++i)
                        load.emplace_back([&] {
                            while (on) {}
                        });
                    busy = grade_changed(workshop, texts, {1}, workshop.fragments(), 7).at(0).record;
                    on = false;
                }
                write_json(file, {{"same", calm == busy}});
            }};
}

}  // namespace

std::vector<Step> steps_of(const Workshop& workshop) {
    std::vector<Step> steps;
    const auto add = [&](std::vector<Step> more) { std::ranges::move(more, std::back_inserter(steps)); };
    for (const Variant* variant : workshop.variants(Variant::Kind::dose))
        steps.push_back(dose_step(workshop, *variant));
    for (const Variant* variant : workshop.variants(Variant::Kind::confined))
        steps.push_back(confined_step(workshop, *variant));
    for (const std::string& fragment : workshop.fragments()) steps.push_back(peer_step(workshop, fragment));
    add(wrong_steps(workshop));
    for (const Bundle& bundle : bundles_under_load(workshop)) steps.push_back(load_step(workshop, bundle));
    add(right_steps(workshop));
    for (int part = 0; part < workshop.amount().seeds; ++part) add(pool_steps(workshop, part));
    return steps;
}

}  // namespace grade::calibration
