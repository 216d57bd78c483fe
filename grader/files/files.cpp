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

void require_file(const std::string& file, const char* option) {
    std::error_code error;
    const fs::path folder = fs::path(file).parent_path();
    if (!folder.empty() && !fs::is_directory(folder, error))
        throw rt::InputError(
            fmt::format("{} {}: there is no folder {}; expected one that is there", option, file, folder.string()));
    if (fs::is_directory(file, error))
        throw rt::InputError(fmt::format("{} {}: is a folder; expected the name of a file", option, file));
}

void make_folder(const fs::path& folder, const char* option) {
    std::error_code error, ignored;
    fs::create_directories(folder, error);
    if (fs::is_directory(folder, ignored)) {
        if (access(folder.c_str(), W_OK | X_OK) == 0) return;
        error.assign(errno, std::generic_category());
    }
    if (!error || error == std::errc::not_a_directory || error == std::errc::file_exists)
        throw rt::InputError(fmt::format("{} {}: a file is in its place; expected a folder", option, folder.string()));
    throw std::runtime_error(
        fmt::format("{} {}: {}; expected a folder that one may write to", option, folder.string(), error.message()));
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
constexpr const char* lock_end = ".lock";

/// A lock stands beside its folder, is there before it and goes after it: what is half removed is still found.
fs::path lock_file_of(const fs::path& folder) { return folder.string() + lock_end; }

/// Locks a file that nobody else has locked, and that is still there and one's own.
bool is_locked(int file) {
    struct stat facts {};
    return flock(file, LOCK_EX | LOCK_NB) == 0 && fstat(file, &facts) == 0 && facts.st_nlink > 0 &&
           facts.st_uid == geteuid();
}

/// Where a folder cannot be removed whole, its lock stays for the next to try.
void remove_with_lock(const fs::path& folder) {
    std::error_code error;
    remove_tree(folder);
    if (!fs::exists(fs::symlink_status(folder, error))) fs::remove(lock_file_of(folder), error);
}

/// What programs that were killed have left.
void sweep() {
    std::error_code error;
    for (fs::directory_iterator at(temporary_place(), error), end; !error && at != end; at.increment(error)) {
        const fs::path file = at->path();
        if (!file.filename().string().starts_with(folder_begin) || file.extension() != lock_end) continue;
        const int lock = open(file.c_str(), O_RDWR | O_NOFOLLOW | O_CLOEXEC);
        if (lock < 0) continue;
        // a link in a folder for all may be somebody else's
        const fs::path folder = fs::path(file).replace_extension();
        if (is_locked(lock) && !fs::is_symlink(folder, error)) remove_with_lock(folder);
        close(lock);
    }
}

/// Gives its owner all rights to all folders of a tree.
void open_up(const fs::path& folder) {
    std::error_code error;
    fs::permissions(folder, fs::perms::owner_all, fs::perm_options::add, error);
    for (fs::recursive_directory_iterator at(folder, fs::directory_options::skip_permission_denied, error), end;
         !error && at != end; at.increment(error))
        // before it is entered
        if (at->symlink_status(error).type() == fs::file_type::directory)
            fs::permissions(at->path(), fs::perms::owner_all, fs::perm_options::add, error);
}

}  // namespace

void remove_tree(const fs::path& folder) {
    // a program that is about to die may still write there
    for (int tries = 0; tries < 5; ++tries) {
        std::error_code error;
        if (fs::remove_all(folder, error) != std::uintmax_t(-1)) return;
        open_up(folder);
    }
}

TemporaryFolder::TemporaryFolder() {
    static const bool swept = (sweep(), true);
    (void)swept;
    const std::string pattern = (temporary_place() / fmt::format("{}XXXXXX", folder_begin)).string();
    const auto fail = [&](const char* what) {
        const int cause = errno;
        throw std::runtime_error(fmt::format("{}: {}: {}", pattern, what, std::strerror(cause)));
    };
    // a sweep between the two steps of a lock takes it away
    for (int tries = 0; tries < 10 && lock_ < 0; ++tries) {
        std::string name = pattern + lock_end;
        const int file = mkostemps(name.data(), std::strlen(lock_end), O_CLOEXEC);
        if (file < 0) fail("no such folder can be made");
        path_ = fs::path(name).replace_extension();
        if (is_locked(file)) {
            lock_ = file;
        } else {
            const int cause = errno;
            unlink(name.c_str());
            close(file);
            errno = cause;
        }
    }
    if (lock_ < 0) fail("cannot be locked");
    if (mkdir(path_.c_str(), 0700) == 0) return;
    const int cause = errno;
    unlink(lock_file_of(path_).c_str());
    close(lock_);
    errno = cause;
    fail("no such folder can be made");
}

TemporaryFolder::~TemporaryFolder() {
    remove_with_lock(path_);
    close(lock_);
}

}  // namespace grade
