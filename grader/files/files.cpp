#include "files/files.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <sys/statvfs.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <stdexcept>
#include <system_error>
#include <vector>

namespace grade {

std::optional<std::string> read_text(const fs::path& path, std::uint64_t most) {
    // not blocking: a FIFO would wait for its writer
    const int file = open(path.c_str(), O_RDONLY | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC);
    if (file < 0) return std::nullopt;
    struct stat facts {};
    std::optional<std::string> text;
    if (fstat(file, &facts) == 0 && S_ISREG(facts.st_mode) && std::uint64_t(facts.st_size) <= most) {
        text.emplace(std::size_t(facts.st_size), '\0');
        std::size_t have = 0;
        while (have < text->size()) {
            const ssize_t got = ::read(file, text->data() + have, text->size() - have);
            if (got <= 0) break;
            have += std::size_t(got);
        }
        text->resize(have);
    }
    close(file);
    return text;
}

void write_text(const fs::path& path, std::string_view text) {
    const fs::path draft = path.string() + fmt::format(".{}.tmp", getpid());
    const auto fail = [&](const char* what) {
        const int cause = errno;
        unlink(draft.c_str());
        throw std::runtime_error(fmt::format("{}: {}: {}", path.string(), what, std::strerror(cause)));
    };
    const int file = open(draft.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0644);
    if (file < 0) fail("cannot be written");
    while (!text.empty()) {
        const ssize_t sent = ::write(file, text.data(), text.size());
        if (sent < 0 && errno == EINTR) continue;
        if (sent <= 0) {
            close(file);
            fail("cannot be written");
        }
        text.remove_prefix(std::size_t(sent));
    }
    if (close(file) != 0 || rename(draft.c_str(), path.c_str()) != 0) fail("cannot be written");
}

void require_room(const fs::path& folder, std::uintmax_t bytes) {
    std::error_code error;
    const fs::space_info space = fs::space(folder, error);
    if (error || space.available >= bytes) return;
    throw std::runtime_error(fmt::format("{}: the disk is full: {} bytes are free; expected at least {}", folder.string(),
                                         space.available, bytes));
}

namespace {

/// Why programs cannot be put there and started; empty where they can.
std::string unfit(const fs::path& place) {
    struct statvfs system {};
    std::error_code error;
    if (!fs::is_directory(place, error)) return error && error != std::errc::no_such_file_or_directory ? error.message() : "no such folder";
    if (access(place.c_str(), W_OK | X_OK) != 0) return std::strerror(errno);
    if (statvfs(place.c_str(), &system) == 0 && (system.f_flag & ST_NOEXEC)) return "mounted noexec: no program runs there";
    return {};
}

fs::path find_temporary_place() {
    std::vector<fs::path> places;
    if (const char* chosen = std::getenv("TMPDIR"); chosen && *chosen) places.push_back(fs::absolute(chosen));
    std::error_code error;
    places.insert(places.end(), {"/tmp", "/var/tmp", fs::read_symlink("/proc/self/exe", error).parent_path()});
    if (const char* home = std::getenv("HOME"); home && *home) places.push_back(fs::absolute(home) / ".cache");
    std::string tried;
    for (const fs::path& place : places) {
        const std::string fault = unfit(place);
        if (fault.empty()) return place;
        tried += fmt::format("; {}: {}", place.string(), fault);
    }
    throw std::runtime_error("there is no folder for temporary files; expected one in TMPDIR" + tried);
}

}  // namespace

const fs::path& temporary_place() {
    static const fs::path place = find_temporary_place();
    return place;
}

TemporaryFolder::TemporaryFolder() {
    std::string pattern = (temporary_place() / "grade-XXXXXX").string();
    if (!mkdtemp(pattern.data()))
        throw std::runtime_error(fmt::format("{}: no such folder can be made: {}", pattern, std::strerror(errno)));
    path_ = pattern;
}

TemporaryFolder::~TemporaryFolder() {
    std::error_code ignored;
    if (!kept_) fs::remove_all(path_, ignored);
}

}  // namespace grade
