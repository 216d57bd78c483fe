#include "hand_out/libraries.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <sstream>
#include <stdexcept>

#include "programs/process.h"

namespace grade {

namespace {

/// What every system with a C++ compiler has: the C and C++ libraries, and zlib, without which Debian has no dpkg.
constexpr std::array everywhere = {"linux-vdso.", "ld-linux", "libc.so.",   "libm.so.",      "libgcc_s.so.",
                                   "libdl.so.",   "librt.so", "libpthread", "libstdc++.so.", "libz.so."};

/// What is installed depends on the package of this one; a kit does not have it.
constexpr const char* archive_library = "libarchive.so.";

/// Headers that the grader or the framework is made of, and whose licences come along: no package owns their code here.
/// Boost's asks for nothing beside a compiled program.
constexpr std::array header_packages = {"libglm-dev", "libcli11-dev", "nlohmann-json3-dev"};

bool is_everywhere(const std::string& name) {
    return std::ranges::any_of(everywhere, [&](const char* start) { return name.starts_with(start); });
}

/// The libraries of a program that a plain system lacks, by the names under which the loader looks for them.
std::map<std::string, fs::path> libraries_of(const fs::path& program) {
    std::map<std::string, fs::path> all;
    std::istringstream lines(must_run({"/usr/bin/ldd", program.string()}));
    for (std::string line; std::getline(lines, line);) {
        std::istringstream words(line);
        std::string name, arrow, path;
        words >> name >> arrow >> path;
        if (arrow == "=>" && path == "not")
            throw std::runtime_error(fmt::format("{}: needs {}, which is not here", program.string(), name));
        if (arrow == "=>" && !is_everywhere(name)) all[name] = path;
    }
    return all;
}

/// Copies the text of a package's licence, where Debian's files are; elsewhere says where the library is from.
void write_licence(const std::string& package, const fs::path& folder) {
    const fs::path text = fs::path("/usr/share/doc") / package / "copyright";
    std::error_code error;
    if (const fs::path real = fs::canonical(text, error); !error)
        fs::copy_file(real, folder / (package + ".txt"), fs::copy_options::overwrite_existing);
}

/// The package of a file; empty where nobody knows.
std::string package_of(const fs::path& file) {
    std::error_code error;
    for (const fs::path& path : {fs::canonical(file, error), file})
        for (const fs::path& name : {path, fs::path("/usr") / path.relative_path()}) {
            const Ending said = run({"/usr/bin/dpkg-query", "--search", name.string()}, Limits{}, "/");
            if (said.good()) return said.out.substr(0, said.out.find(':'));
        }
    return {};
}

/// What a package of the system brings stays out: a library, with all that it needs.
void leave_to_package(const std::string& start, std::map<std::string, fs::path>& libraries) {
    const auto found = libraries.lower_bound(start);
    if (found == libraries.end() || !found->first.starts_with(start)) return;
    const auto [name, path] = *found;
    for (const auto& [needed, place] : libraries_of(path)) libraries.erase(needed);
    libraries.erase(name);
}

}  // namespace

std::string must_run(const std::vector<std::string>& command) {
    Limits limits;
    limits.output = 16u << 20;
    limits.file_size = 256u << 20;
    limits.cpu_seconds = limits.most_cpu_seconds = 60;
    const Ending ending = run(command, limits, "/");
    if (!ending.good())
        throw std::runtime_error(
            fmt::format("{}: {}", fmt::join(command, " "), ending.err.empty() ? "failed" : ending.err.substr(0, 600)));
    return ending.out;
}

void write_libraries(const fs::path& program, const Toolchain& built, const fs::path& machine) {
    fs::create_directories(machine / "lib");
    fs::create_directories(machine / "licences");
    std::map<std::string, fs::path> all = libraries_of(program);
    all.merge(libraries_of(program.string() + "_studies"));
    leave_to_package(archive_library, all);
    for (const std::string& library : built.libraries)
        if (library.starts_with("/")) {
            // under the name that it tells those who are linked with it
            const fs::path real = fs::canonical(library);
            std::string name = real.filename().string();
            std::istringstream lines(must_run({"/usr/bin/objdump", "-p", real.string()}));
            for (std::string line; std::getline(lines, line);)
                if (const auto at = line.find("SONAME"); at != line.npos)
                    name = line.substr(line.find_first_not_of(' ', at + 6));
            all[name] = real;
        }
    for (const auto& [name, path] : all) {
        must_run({"/usr/bin/strip", "--strip-unneeded", fs::canonical(path).string(), "-o",
                  (machine / "lib" / name).string()});
        if (const std::string package = package_of(path); !package.empty())
            write_licence(package, machine / "licences");
    }
    for (const char* package : header_packages) write_licence(package, machine / "licences");
}

}  // namespace grade
