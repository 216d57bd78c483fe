#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

namespace grade {

namespace fs = std::filesystem;

/// The text of a regular file of at most that many bytes; links are not followed. None: it is not there, is no such
/// file, or is larger.
std::optional<std::string> read_text(const fs::path& path, std::uint64_t most = 16u << 20);

/// Writes a file so that its old text stays whole until the new one is complete. Throws std::runtime_error that names
/// the path and the cause.
void write_text(const fs::path& path, std::string_view text);

/// Throws rt::InputError for a file that an option names and that cannot be written: its folder is not there, or it is
/// a folder itself. An empty name is none.
void require_file(const std::string& file, const char* option);

/// Makes a folder that an option names. Throws rt::InputError where a file is in its place, std::runtime_error where
/// one may not write there.
void make_folder(const fs::path& folder, const char* option);

/// Throws std::runtime_error where the disk of a folder has less room than so many bytes.
void require_room(const fs::path& folder, std::uintmax_t bytes);

/// A folder for temporary files, whose programs can be started: TMPDIR, /tmp, /var/tmp, that of this program, ~/.cache;
/// the first that serves. Throws std::runtime_error that says what is wrong with each where none does.
const fs::path& temporary_place();

/// Removes a folder with all that is in it, also what its owner may not read.
void remove_tree(const fs::path& folder);

/// A new folder that goes, with all that is in it, when this object does; or, where the program is killed, when the
/// next one of this user makes its first.
class TemporaryFolder {
public:
    /// Throws std::runtime_error.
    TemporaryFolder();
    ~TemporaryFolder();
    TemporaryFolder(const TemporaryFolder&) = delete;
    TemporaryFolder& operator=(const TemporaryFolder&) = delete;

    const fs::path& path() const { return path_; }

private:
    fs::path path_;
    int lock_ = -1;  // held as long as the folder is in use
};

}  // namespace grade
