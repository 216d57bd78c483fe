#include "files/files.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <sys/statvfs.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <random>
#include <stdexcept>
#include <system_error>
#include <vector>

#include "rt/files/scene_reader.h"

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
    // by chance as well: machines that share the folder have processes of the same number
    const fs::path draft = path.string() + fmt::format(".{}-{:08x}.tmp", getpid(), std::random_device()());
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

void require_folder_of(const std::string& file, const char* option) {
    const fs::path folder = fs::path(file).parent_path();
    if (!folder.empty() && !fs::is_directory(folder))
        throw rt::InputError(fmt::format("{} {}: there is no folder {}", option, file, folder.string()));
}

void require_room(const fs::path& folder, std::uintmax_t bytes) {
    std::error_code error;
    const fs::space_info space = fs::space(folder, error);
    if (error || space.available >= bytes) return;
    throw std::runtime_error(fmt::format("{}: the disk is full: {} bytes are free; expected at least {}",
                                         folder.string(), space.available, bytes));
}

namespace {

/// Why programs cannot be put there and started; empty where they can.
std::string unfit(const fs::path& place) {
    struct statvfs system {};
    std::error_code error;
    if (!fs::is_directory(place, error))
        return error && error != std::errc::no_such_file_or_directory ? error.message() : "no such folder";
    if (access(place.c_str(), W_OK | X_OK) != 0) return std::strerror(errno);
    if (statvfs(place.c_str(), &system) == 0 && (system.f_flag & ST_NOEXEC))
        return "mounted noexec: no program runs there";
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

namespace {

constexpr const char* folder_begin = "grade-";
constexpr const char* lock_name = ".lock";

/// Locks a folder that nobody else has locked, and that is still there. -1: somebody has.
int lock_of(const fs::path& folder, int flags) {
    const int file = open((folder / lock_name).c_str(), O_RDWR | O_NOFOLLOW | O_CLOEXEC | flags, 0600);
    struct stat facts {};
    if (file >= 0 && flock(file, LOCK_EX | LOCK_NB) == 0 && fstat(file, &facts) == 0 && facts.st_nlink > 0 &&
        facts.st_uid == geteuid())
        return file;
    if (file >= 0) close(file);
    return -1;
}

/// What programs that were killed have left.
void sweep() {
    std::error_code error;
    for (fs::directory_iterator at(temporary_place(), error), end; !error && at != end; at.increment(error)) {
        if (!at->path().filename().string().starts_with(folder_begin) || at->is_symlink(error)) continue;
        const int lock = lock_of(at->path(), 0);
        if (lock < 0) continue;
        remove_tree(at->path());
        close(lock);
    }
}

}  // namespace

void remove_tree(const fs::path& folder) {
    std::error_code error;
    if (fs::remove_all(folder, error) != std::uintmax_t(-1)) return;
    const auto open_up = [&](const fs::path& path) {
        fs::permissions(path, fs::perms::owner_all, fs::perm_options::add, error);
    };
    open_up(folder);
    for (fs::recursive_directory_iterator at(folder, fs::directory_options::skip_permission_denied, error), end;
         at != end;) {
        // before it is entered
        if (at->symlink_status(error).type() == fs::file_type::directory) open_up(at->path());
        at.increment(error);
        if (error) break;
    }
    fs::remove_all(folder, error);
}

TemporaryFolder::TemporaryFolder() {
    static const bool swept = (sweep(), true);
    (void)swept;
    // a sweep between the two steps takes it away
    for (int tries = 0; tries < 10 && lock_ < 0; ++tries) {
        std::string pattern = (temporary_place() / fmt::format("{}XXXXXX", folder_begin)).string();
        if (!mkdtemp(pattern.data()))
            throw std::runtime_error(fmt::format("{}: no such folder can be made: {}", pattern, std::strerror(errno)));
        path_ = pattern;
        lock_ = lock_of(path_, O_CREAT);
        if (lock_ < 0 && (errno == EMFILE || errno == ENFILE || errno == ENOSPC || errno == EDQUOT)) break;
    }
    if (lock_ >= 0) return;
    const int cause = errno;
    remove_tree(path_);
    throw std::runtime_error(fmt::format("{}: cannot be locked: {}", path_.string(), std::strerror(cause)));
}

TemporaryFolder::~TemporaryFolder() {
    remove_tree(path_);
    close(lock_);
}

}  // namespace grade
