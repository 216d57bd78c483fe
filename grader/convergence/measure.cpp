#include "convergence/measure.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <memory>

#include "convergence/measured.h"
#include "convergence/reference.h"
#include "files/files.h"
#include "files/stamp.h"
#include "rt/files/scene_reader.h"

namespace grade::convergence {

namespace {

/// The work on one scene.
class Measurement {
public:
    Measurement(const fs::path& file, const Bench& bench, const Amounts& amounts, double budget)
        : bench_(bench), amounts_(amounts), budget_(budget), file_(file) {
        const rt::Scene scene = rt::read_scene(file.string());
        record_.name = file.stem().string();
        record_.file = file.string();
        record_.size = size_of(scene, amounts.side);
        text_ = read_text(file).value_or("");
    }

    SceneRecord run() {
        halves_ = reference_of(file_, bench_, amounts_, budget_, record_);
        begin();
        for (const int samples : amounts_.samples)
            if (!run_level(samples)) break;
        for (Series& series : series_) {
            Measured& measured = series.measured;
            Curve curve{series.who, series.sampler, std::move(measured.levels), {}, {}};
            if (!measured.means[0].pixels.empty() && !measured.means[1].pixels.empty())
                curve.bias = picture_bias(measured.means[0], measured.means[1], halves_);
            record_.curves.push_back(std::move(curve));
        }
        analyse(record_);
        return record_;
    }

private:
    /// One sampler of one program.
    struct Series {
        Who who;
        std::string sampler;
        fs::path file;  // where what is measured is kept
        Measured measured{};
    };

    void begin() {
        const std::string size = fmt::format("{}x{}", record_.size.x, record_.size.y);
        const std::string levels = fmt::format("{}", fmt::join(amounts_.samples, " "));
        const std::string name =
            Stamp().add(text_ + size + levels).add(bench_.solution_stamp).add(bench_.submission_stamp).text();
        for (const std::string& sampler : amounts_.samplers)
            for (const Who who : {Who::submission, Who::solution}) {
                const fs::path& program = who == Who::submission ? bench_.submission : bench_.solution;
                if (program.empty()) continue;
                const char* suffix = who == Who::submission ? "submission" : "solution";
                Series series{
                    who, sampler,
                    bench_.results / fmt::format("{}-{}", record_.name, name) / fmt::format("{}-{}", sampler, suffix)};
                if (!bench_.fresh) series.measured = read_kept(series.file, measured_of).value_or(Measured{});
                series_.push_back(std::move(series));
            }
        for (const fs::path* program : {&bench_.submission, &bench_.solution})
            if (!program->empty())
                runners_[program == &bench_.solution] = std::make_unique<Runner>(
                    bench_.copy(*program), bench_.sandbox, fs::absolute(file_).parent_path(), amounts_.time_limit);
    }

    /// How many replicates of a level there can be; 0: too dear.
    int affordable(int samples) const {
        int count = amounts_.replicates;
        if (last_samples_ == 0) return count;
        const double of_one = last_seconds_ * samples / last_samples_;  // of one replicate of all
        while (count > 0 && spent_ + count * of_one > budget_) --count;
        return count >= std::min(least_replicates, amounts_.replicates) ? count : 0;
    }

    bool run_level(int samples) {
        const int replicates = affordable(samples);
        double seconds = 0;
        for (int replicate = 0; replicate < replicates; ++replicate)
            // A B, then B A: what changes with time is the same for both
            for (std::size_t k = 0; k < series_.size(); ++k) {
                Series& series = series_[replicate % 2 == 0 ? k : series_.size() - 1 - k];
                // a pattern without randomness gives the same picture again
                if (series.sampler == "uniform" && replicate > 0) continue;
                if (!run_one(series, samples, replicate)) return false;
                const double one = series.measured.find(samples, replicate)->cpu_seconds;
                seconds += one, spent_ += one;
            }
        if (replicates > 0) last_samples_ = samples, last_seconds_ = seconds / replicates;
        return replicates > 0;
    }

    /// false: the submission's program has broken down.
    bool run_one(Series& series, int samples, int replicate) {
        if (series.measured.find(samples, replicate)) return true;
        const bool solution = series.who == Who::solution;
        if (bench_.progress)
            bench_.progress(std::min(spent_ / budget_, 1.0),
                            fmt::format("{}: {}, {} samples", record_.name, series.sampler, samples));
        Runner& runner = *runners_[solution];
        auto outcome = picture(runner, {text_, samples, series.sampler, record_.size}, seed_of(samples, replicate));
        if (const Fault* fault = std::get_if<Fault>(&outcome)) {
            record_.fault = fmt::format("{}, {} samples: {}", series.sampler, samples, fault->message);
            if (solution)
                throw std::runtime_error(fmt::format("{}: the solution itself: {}", file_.string(), record_.fault));
            return false;
        }
        const rt::Image& image = std::get<rt::Image>(outcome);
        const SquaredError error = squared_error(image, halves_);
        series.measured.add(samples, replicate, {error.mse, error.relative, runner.seconds(), runner.rays()}, image);
        write_kept(series.file, to_kept(series.measured));
        return true;
    }

    const Bench& bench_;
    const Amounts& amounts_;
    double budget_, spent_ = 0;
    fs::path file_;
    std::string text_;
    SceneRecord record_;
    Halves halves_;
    std::vector<Series> series_;
    std::array<std::unique_ptr<Runner>, 2> runners_;  // of the submission, of the solution
    int last_samples_ = 0;
    double last_seconds_ = 0;  // of one replicate of the last level, all samplers and programs
};

}  // namespace

SceneRecord measure(const fs::path& scene, const Bench& bench, const Amounts& amounts, double budget) {
    return Measurement(scene, bench, amounts, budget).run();
}

}  // namespace grade::convergence
