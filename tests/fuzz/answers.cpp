#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <stdexcept>

#include "files/files.h"
#include "mutate.h"
#include "programs/runner.h"
#include "protocol/protocol.h"

/// answers FAKE_CHILD CASES [SEED]: children that answer with mutated bytes. What comes back is what was asked for, or
/// a fault, and soon.
namespace {

using namespace grade;

std::string rows_frame(const std::vector<std::vector<double>>& rows) {
    std::vector<double> numbers = flatten(rows);
    numbers.insert(numbers.begin(), 0.25);
    return frame(FrameKind::rows, bytes_of<double>(numbers));
}

std::string image_frame(double width, double height, std::size_t pixels) {
    std::vector<double> numbers{width, height, 0.25};
    numbers.resize(image_head + 3 * pixels, 0.5);
    return frame(FrameKind::image, bytes_of<double>(numbers));
}

const std::string scene = "[camera]\neye = [0, 0, 5]\ntarget = [0, 0, 0]\nvfov = 40\nsize = [2, 2]\n";

}  // namespace

int main(int argc, char** argv) {
    if (argc < 3) return std::fprintf(stderr, "answers FAKE_CHILD CASES [SEED]\n"), 2;
    const std::uint64_t cases = std::strtoull(argv[2], nullptr, 10),
                        seed = argc > 3 ? std::strtoull(argv[3], nullptr, 10) : 1;
    const std::string done = frame(FrameKind::done, {});
    const std::vector<std::string> corpus = {done + rows_frame({{1, 2, 3}, {4, 5, 6}}),
                                             done + rows_frame({{1, 2, 3}}),
                                             done + rows_frame({}),
                                             done + image_frame(2, 2, 4),
                                             done + image_frame(2, 2, 3),
                                             done + image_frame(1e9, 1e9, 4),
                                             done + frame(FrameKind::error, "a word"),
                                             frame(FrameKind::error, std::string(5000, 'x')),
                                             frame(FrameKind::swarm, "x"),
                                             "",
                                             "\1\2\3"};
    const double numbers[] = {1e308, -1, 0, 2, 1.0 / 0.0, 0.0 / 0.0, 0x1p63};
    std::vector<std::string> words;
    for (const double& x : numbers) words.push_back(std::string(reinterpret_cast<const char*>(&x), sizeof x));

    const TemporaryFolder work;
    const Sandbox sandbox = find_sandbox(true);
    fs::copy_file(argv[1], work.path() / "child");
    int answers = 0, faults = 0;
    for (std::uint64_t i = 0; i < cases; ++i) {
        write_text(work.path() / "answer", i < corpus.size() ? corpus[i] : fuzz::mutated(corpus, words, seed, i));
        const auto start = std::chrono::steady_clock::now();
        try {
            Runner runner(work.path() / "child", sandbox, work.path(), 1);
            bool right = false;
            if (i % 2) {
                const auto outcome = runner.probe("moved", {{0, 0, 0, 1, 1, 1, 2}, {0, 0, 0, 1, 1, 1, 3}});
                const auto* rows = std::get_if<Rows>(&outcome);
                right = !rows || rows->size() == 2;
                ++(rows ? answers : faults);
            } else {
                const auto outcome = runner.render({scene, 1, "random"}, 1);
                const auto* image = std::get_if<rt::Image>(&outcome);
                right = !image || (image->width == 2 && image->height == 2 && image->pixels.size() == 4);
                ++(image ? answers : faults);
            }
            const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
            if (!right || seconds > 15)
                throw std::runtime_error(right ? "it took too long" : "an answer of the wrong size counts");
        } catch (const std::exception& error) {
            std::fprintf(stderr, "case %llu of seed %llu: %s\n", (unsigned long long)i, (unsigned long long)seed,
                         error.what());
            return 1;
        }
    }
    std::printf("%d answers taken, %d refused\n", answers, faults);
    return answers > 0 && faults > 0 ? 0 : 1;
}
