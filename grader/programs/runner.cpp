#include "programs/runner.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <csignal>
#include <cstring>
#include <stdexcept>

#include "protocol/bytes.h"
#include "protocol/protocol.h"
#include "protocol/width.h"
#include "rt/files/scene_reader.h"
#include "rt/scene.h"

namespace grade {

struct Runner::Answer {
    FrameKind kind;
    std::string payload;
};

namespace {

constexpr std::size_t most_error_bytes = 4096;
constexpr std::size_t most_shown =
    200;  // of what a program says: enough for a sentence, too little to carry others' code out
constexpr std::size_t most_checked = 16384;    // of what sanitizers say, which is read and not shown
constexpr std::size_t most_traced = 4u << 20;  // bytes of a pixel's trace
constexpr std::uint64_t most_memory = 2ull << 30;

std::string too_much_memory() { return fmt::format("uses more than {} GB of memory", most_memory >> 30); }

Fault forged() { return {Verdict::crashed, "the fragment wrote into the grader's channel", {}}; }

/// Whether numbers of the child's own account, as of seconds, can be any.
bool are_amounts(std::span<const double> numbers) {
    return std::ranges::all_of(numbers, [](double x) { return std::isfinite(x) && x >= 0; });
}

int sampler_of(const std::string& name) {
    if (const auto sampler = rt::sampler_named(name)) return int(*sampler);
    throw rt::InputError(
        fmt::format("no sampler is named \"{}\"; expected {}", name, fmt::join(rt::sampler_names, ", ")));
}

RenderRequest request_of(const Render& experiment, std::uint64_t seed, rt::ivec2 size, bool one_of_many) {
    return {seed, experiment.samples, sampler_of(experiment.sampler), size.x, size.y, one_of_many};
}

}  // namespace

Runner::Runner(const fs::path& program, const Sandbox& sandbox, const fs::path& meshes, double seconds, bool checked)
    : meshes_(meshes), limit_(seconds), most_shown_(checked ? most_checked : most_shown) {
    Step step{{program.string(), fmt::format("{}", seconds), (meshes / "check.toml").string()},
              {},
              program.parent_path(),
              {},
              false};
    // one's own code may need other programs: sanitizers ask one for lines
    if (sandbox.kind != Sandbox::Kind::limits_only) step.command.emplace_back("locked");
    step.limits.cpu_seconds = seconds;
    step.limits.most_cpu_seconds = 600;
    step.limits.memory = checked ? 0 : most_memory;
    step.sees_itself = checked;
    step.limits.file_size = 1u << 20;
    if (access(program.c_str(), X_OK) != 0)  // before any fragment has run: the machine's doing
        throw std::runtime_error(
            fmt::format("{}: cannot be started: {}; expected TMPDIR to name a folder whose programs run",
                        program.string(), std::strerror(errno)));
    if (fs::exists(meshes)) step.readable.push_back(meshes);
    process_ = start(sandbox, step);
}

Fault Runner::broken() {
    const Ending ending = process_->finish(in_seconds(0.2));
    const std::string excerpt = (ending.err.empty() ? ending.out : ending.err).substr(0, most_shown_);
    if (ending.how == Ending::How::timed_out) {
        if (ending.waited)
            return {Verdict::timed_out, fmt::format("waits for something: no answer came within {:g} s", patience()),
                    excerpt};
        return {Verdict::timed_out, fmt::format("ran longer than {:g} s", limit_), excerpt, Trouble::endless};
    }
    if (ending.how == Ending::How::signalled && ending.code == SIGSYS)
        return {Verdict::crashed, "starts other programs or processes: a fragment only computes", excerpt};
    if (ending.err.find("bad_alloc") != ending.err.npos) return {Verdict::crashed, too_much_memory(), excerpt};
    if (ending.how == Ending::How::signalled)
        return {Verdict::crashed, "ended by " + signal_in_words(ending.code), excerpt};
    return {Verdict::crashed,
            fmt::format("the program ended by itself with code {}: a fragment must return, not exit", ending.code),
            excerpt};
}

Fault Runner::thrown(const std::string& what) {
    if (what == "std::bad_alloc") return {Verdict::crashed, too_much_memory(), {}};
    std::string line = what.substr(0, most_shown);
    std::ranges::replace(line, '\n', ' ');  // a line of its own may be a command to whoever shows it
    return {Verdict::crashed, "threw an exception: " + line, {}};
}

void Runner::begin_count() {
    answers_seconds_ = 0, own_delay_before_ = own_delay();
    spent_before_ = spent_ = process_->times();
}

double Runner::seconds_in_all() {
    if (answers_seconds_ < 1) return answers_seconds_;
    const Times now = process_->times();  // which are nothing of who has ended
    spent_ = {std::max(spent_.computed, now.computed), std::max(spent_.delayed, now.delayed)};
    const double waited = spent_.delayed - spent_before_.delayed + own_delay() - own_delay_before_;
    return std::max(spent_.computed - spent_before_.computed, answers_seconds_ - waited);
}

Outcome<Runner::Answer> Runner::exchange(const std::string& request, std::size_t most_bytes) {
    const auto start = Clock::now();
    auto outcome = exchange_once(request, most_bytes);
    exchange_seconds_ = std::chrono::duration<double>(Clock::now() - start).count();
    answers_seconds_ += exchange_seconds_;
    has_answered_ = has_answered_ || std::holds_alternative<Answer>(outcome);
    return outcome;
}

Outcome<Runner::Answer> Runner::exchange_once(const std::string& request, std::size_t most_bytes) {
    // a process that waits for something uses no CPU time: the wall clock ends it
    const auto deadline = in_seconds(patience());
    if (!process_->send(request, deadline)) return broken();
    const auto head = process_->receive(sizeof(FrameHeader), deadline);
    if (!head) return broken();
    FrameHeader header{};
    std::memcpy(&header, head->data(), sizeof header);
    if (header.check != FrameHeader{}.check || header.bytes > std::max(most_bytes, most_error_bytes)) return forged();
    auto payload = process_->receive(header.bytes, deadline);
    if (!payload) return broken();
    return Answer{header.kind, std::move(*payload)};
}

std::optional<Fault> Runner::tell(const std::string& request) {
    const auto outcome = exchange(request, 0);
    if (const Fault* fault = std::get_if<Fault>(&outcome)) return *fault;
    const Answer& answer = std::get<Answer>(outcome);
    if (answer.kind == FrameKind::done) return std::nullopt;
    return thrown(answer.payload);
}

Outcome<std::vector<double>> Runner::ask(const std::string& request, int kind, std::size_t most_numbers) {
    auto outcome = exchange(request, most_numbers * sizeof(double));
    if (const Fault* fault = std::get_if<Fault>(&outcome)) return *fault;
    const Answer& answer = std::get<Answer>(outcome);
    if (answer.kind == FrameKind::error) return thrown(answer.payload);
    if (int(answer.kind) != kind || answer.payload.size() % sizeof(double) != 0) return forged();
    return numbers_of_bytes(answer.payload);
}

/// Tells the child which scene the next requests are about.
std::optional<Fault> Runner::show(const Render& experiment) {
    if (experiment.scene == scene_) return std::nullopt;
    const rt::Scene scene = rt::parse_scene(experiment.scene, (meshes_ / "check.toml").string());
    size_ = scene.camera.size;
    if (const auto fault = tell(frame(FrameKind::scene, experiment.scene))) return fault;
    scene_ = experiment.scene;
    return std::nullopt;
}

Outcome<rt::Image> Runner::render(const Render& experiment, std::uint64_t seed, bool one_of_many) {
    if (const auto fault = show(experiment)) return *fault;
    const rt::ivec2 size = experiment.size.x > 0 ? experiment.size : size_;
    const RenderRequest request = request_of(experiment, seed, size, one_of_many);
    const std::size_t pixels = std::size_t(size.x) * std::size_t(size.y), count = image_head + 3 * pixels;
    auto outcome = ask(frame(FrameKind::render, bytes_of<RenderRequest>({&request, 1})), int(FrameKind::image), count);
    if (const Fault* fault = std::get_if<Fault>(&outcome)) return *fault;

    const auto& numbers = std::get<std::vector<double>>(outcome);
    if (numbers.size() != count || numbers[0] != size.x || numbers[1] != size.y)
        return Fault{Verdict::failed, "a picture of the wrong size came back", {}};
    if (!are_amounts(std::span(numbers).subspan(2, image_head - 2))) return forged();
    last_seconds_ = std::min(numbers[2], exchange_seconds_);
    last_rays_.assign(numbers.begin() + 3, numbers.begin() + image_head);
    rt::Image image(size.x, size.y);
    for (std::size_t i = 0; i < pixels; ++i)
        image.pixels[i] = {numbers[image_head + 3 * i], numbers[image_head + 1 + 3 * i],
                           numbers[image_head + 2 + 3 * i]};
    return image;
}

Outcome<std::string> Runner::trace(const Render& experiment, std::uint64_t seed, rt::ivec2 pixel) {
    if (const auto fault = show(experiment)) return *fault;
    const rt::ivec2 size = experiment.size.x > 0 ? experiment.size : size_;
    const TraceRequest request{request_of(experiment, seed, size, true), pixel.x, pixel.y};
    const auto outcome = exchange(frame(FrameKind::trace, bytes_of<TraceRequest>({&request, 1})), most_traced);
    if (const Fault* fault = std::get_if<Fault>(&outcome)) return *fault;
    const Answer& answer = std::get<Answer>(outcome);
    if (answer.kind == FrameKind::text) return answer.payload;
    if (answer.kind == FrameKind::error) return thrown(answer.payload);
    return forged();
}

Outcome<std::vector<double>> Runner::swarm(const SwarmRequest& request) {
    auto outcome =
        ask(frame(FrameKind::swarm, bytes_of<SwarmRequest>({&request, 1})), int(FrameKind::rows), 1 + request.count);
    if (const Fault* fault = std::get_if<Fault>(&outcome)) return *fault;
    auto& numbers = std::get<std::vector<double>>(outcome);
    if (numbers.size() != 1 + request.count || !are_amounts({numbers.data(), 1})) return forged();
    last_seconds_ = std::min(numbers.front(), exchange_seconds_);
    numbers.erase(numbers.begin());
    return std::move(numbers);
}

Outcome<Rows> Runner::probe(const std::string& fragment, const Rows& rows) {
    const std::size_t width = width_of(fragment);
    auto outcome = answers(FrameKind::rows, fragment, rows, width);
    const Rows* all = std::get_if<Rows>(&outcome);
    // what measures them takes their number as given
    const bool are_whole = !all || std::ranges::all_of(*all, [&](const Row& row) { return row.size() == width; });
    return are_whole ? outcome : forged();
}

Outcome<Rows> Runner::edited(const std::string& fragment, const Rows& calls, std::size_t most_results) {
    return answers(FrameKind::edit, fragment, calls, most_results);
}

Outcome<Rows> Runner::answers(FrameKind kind, const std::string& fragment, const Rows& rows, std::size_t most_results) {
    if (fragment != fragment_) {
        if (const auto fault = tell(frame(FrameKind::fragment, fragment))) return *fault;
        fragment_ = fragment;
    }
    const std::vector<double> flat = flatten(rows);
    auto outcome = ask(frame(kind, bytes_of<double>(flat)), int(FrameKind::rows), 2 + rows.size() * (1 + most_results));
    if (const Fault* fault = std::get_if<Fault>(&outcome)) return *fault;

    const auto& numbers = std::get<std::vector<double>>(outcome);
    Rows results;
    if (numbers.empty() || !are_amounts({numbers.data(), 1}) || !unflatten(std::span(numbers).subspan(1), results) ||
        results.size() != rows.size())
        return forged();
    last_seconds_ = std::min(numbers[0], exchange_seconds_);
    return results;
}

}  // namespace grade
