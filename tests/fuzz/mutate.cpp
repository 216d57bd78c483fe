#include "mutate.h"

#include <algorithm>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

/// fuzz [--seed N] [--cases N] [--seconds N] [--only N] FOLDER...: feeds mutations of all files of these folders to
/// LLVMFuzzerTestOneInput, the unchanged files first. A case that fails is named, with the way to repeat it.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

namespace {

namespace fs = std::filesystem;

std::uint64_t seed = 1, number = 0;

void name_the_case(int signal) {
    char words[160];
    const int length = std::snprintf(
        words, sizeof words, "signal %d in case %llu of seed %llu: --seed %llu --only %llu repeats it\n", signal,
        (unsigned long long)number, (unsigned long long)seed, (unsigned long long)seed, (unsigned long long)number);
    std::fwrite(words, 1, std::size_t(length), stderr);
    std::_Exit(1);
}

const std::vector<std::string> words = {"nan",
                                        "inf",
                                        "-inf",
                                        "1e400",
                                        "-0.0",
                                        "0",
                                        "-1",
                                        "1e-320",
                                        "1e308",
                                        "9223372036854775807",
                                        "0x7fffffff",
                                        "true",
                                        "\"\"",
                                        "[]",
                                        "[[shape]]",
                                        "[camera]",
                                        "[render]",
                                        "[materials.",
                                        "[[light]]",
                                        "type = ",
                                        "radius = ",
                                        "= [",
                                        "\n",
                                        "\0",
                                        "\xff",
                                        "\"sphere\"",
                                        "\"mesh\"",
                                        "vfov = 180",
                                        "size = [1, 65536]",
                                        "focus = 0",
                                        "material = ",
                                        "samples = 2147483648"};

}  // namespace

int main(int argc, char** argv) {
    std::uint64_t cases = 0, only = 0;
    double seconds = 0;
    bool one = false;
    std::vector<std::string> corpus;
    for (int i = 1; i < argc; ++i) {
        const std::string word = argv[i];
        const bool more = i + 1 < argc;
        if (word == "--seed" && more)
            seed = std::strtoull(argv[++i], nullptr, 10);
        else if (word == "--cases" && more)
            cases = std::strtoull(argv[++i], nullptr, 10);
        else if (word == "--seconds" && more)
            seconds = std::atof(argv[++i]);
        else if (word == "--only" && more)
            only = std::strtoull(argv[++i], nullptr, 10), one = true;
        else if (fs::is_directory(word)) {
            std::vector<fs::path> paths;
            for (const auto& entry : fs::directory_iterator(word))
                if (entry.is_regular_file() && entry.file_size() < 16384) paths.push_back(entry.path());
            std::sort(paths.begin(), paths.end());
            for (const fs::path& path : paths) {
                std::ifstream file(path, std::ios::binary);
                corpus.emplace_back(std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>());
            }
        } else {
            std::fprintf(stderr, "%s: expected --seed N, --cases N, --seconds N, --only N or a folder\n", argv[i]);
            return 2;
        }
    }
    if (corpus.empty()) {
        std::fprintf(stderr, "no files to start from\n");
        return 2;
    }
    for (const int signal : {SIGSEGV, SIGABRT, SIGFPE, SIGBUS, SIGILL}) std::signal(signal, name_the_case);

    const std::clock_t start = std::clock();
    const auto elapsed = [&] { return double(std::clock() - start) / CLOCKS_PER_SEC; };
    for (number = one ? only : 0;
         one ? number == only : (cases == 0 || number < cases) && (seconds == 0 || elapsed() < seconds); ++number) {
        const std::string text = number < corpus.size() ? corpus[number] : fuzz::mutated(corpus, words, seed, number);
        if (one) std::printf("%s\n", text.c_str());
        LLVMFuzzerTestOneInput(reinterpret_cast<const std::uint8_t*>(text.data()), text.size());
        if (cases == 0 && seconds == 0 && number + 1 == corpus.size()) break;
    }
    std::printf("%llu cases of seed %llu from %zu files in %.1f s\n", (unsigned long long)number,
                (unsigned long long)seed, corpus.size(), elapsed());
    return 0;
}
