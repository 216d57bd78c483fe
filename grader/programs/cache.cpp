#include "programs/cache.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <unistd.h>

#include <cstdlib>
#include <map>
#include <mutex>
#include <random>

#include "files/files.h"
#include "files/stamp.h"
#include "programs/process.h"

namespace grade {

namespace {

bool can_write(const fs::path& folder) {
    std::error_code error;
    fs::create_directories(folder, error);
    return !error && access(folder.c_str(), W_OK) == 0;
}

/// Of all that the compiled header is made from.
std::string stamp_of(const Toolchain& chain) {
    const fs::path header = chain.includes.front() / "rt/fragments.h";
    return Stamp()
        .add(fmt::format("{} {} {} {}", header.string(), chain.compiler.string(), chain.description,
                         fmt::join(chain.compile, " ")))
        .add_sources(chain.includes.front(), {"rt"})
        .text();
}

bool make_header(const Toolchain& chain, const fs::path& folder) {
    const fs::path header = folder / "rt/fragments.h", compiled = header.string() + ".gch";
    fs::create_directories(header.parent_path());
    // a header that includes the real one: a fragment may include that, and others, a second time. Without the special
    // functions of libstdc++, which every unit would instantiate anew, a third of its time
    write_text(header, fmt::format("#pragma once\n#include <cstddef>\n#undef _GLIBCXX_USE_STD_SPEC_FUNCS\n"
                                   "#include \"{}\"\n",
                                   (chain.includes.front() / "rt/fragments.h").string()));
    const fs::path draft = compiled.string() + fmt::format(".{}-{:08x}.tmp", getpid(), std::random_device()());
    std::vector<std::string> command{chain.compiler.string()};
    command.insert(command.end(), chain.compile.begin(), chain.compile.end());
    command.emplace_back("-w");
    for (const fs::path& include : chain.includes) command.insert(command.end(), {"-I", include.string()});
    command.insert(command.end(), {"-x", "c++-header", header.string(), "-o", draft.string()});
    Limits limits;
    limits.cpu_seconds = limits.most_cpu_seconds = 60;
    limits.wall_seconds = 600;
    limits.file_size = 512u << 20;
    std::error_code error;
    if (!run(command, limits, folder.string()).good()) return fs::remove(draft, error), false;
    fs::rename(draft, compiled, error);
    return !error;
}

}  // namespace

std::optional<fs::path> cache_folder(const Toolchain& chain) {
    if (!chain.cache.empty() && can_write(chain.cache)) return chain.cache;
    const char* cache = std::getenv("XDG_CACHE_HOME");
    const char* home = std::getenv("HOME");
    if (!cache && !home) return std::nullopt;
    const fs::path own = (cache && *cache ? fs::path(cache) : fs::path(home) / ".cache") / "penumbra" /
                         Stamp().add(chain.source.string()).text();
    return can_write(own) ? std::optional(own) : std::nullopt;
}

fs::path page_folder(const std::string& asked, bool own, const Toolchain& chain) {
    if (!asked.empty() || !own) return asked;
    const auto cache = cache_folder(chain);
    return cache ? *cache / "report" : fs::path();
}

fs::path precompiled_header(const Toolchain& chain) try {
    if (chain.checked || !chain.is_gcc) return {};  // one call is not worth it
    static std::mutex lock;
    static std::map<std::string, fs::path> made;
    const std::string stamp = stamp_of(chain);
    const std::scoped_lock guard(lock);
    if (const auto before = made.find(stamp); before != made.end()) return before->second;
    const auto cache = cache_folder(chain);
    if (!cache) return made[stamp] = fs::path();
    const fs::path folder = *cache / "precompiled", note = folder / "stamp";
    if (read_text(note) == stamp) return made[stamp] = folder;
    std::error_code error;
    fs::remove(note, error);
    if (!make_header(chain, folder)) {
        fs::remove_all(folder, error);
        return made[stamp] = fs::path();
    }
    write_text(note, stamp);
    return made[stamp] = folder;
} catch (const std::exception&) {
    return {};  // all the same, only slower
}

}  // namespace grade
