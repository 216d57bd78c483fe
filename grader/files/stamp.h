#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace grade {

namespace fs = std::filesystem;

/// FNV-1a. Source: Fowler, Noll, Vo, "The FNV Non-Cryptographic Hash Algorithm", RFC 9923.
inline std::uint64_t fnv1a(std::string_view text, std::uint64_t start = 0xcbf29ce484222325) {
    for (const char c : text) start = (start ^ static_cast<unsigned char>(c)) * 0x100000001b3;
    return start;
}

/// A short name for a state of texts and files: results that are kept under it are never taken for those of another.
class Stamp {
public:
    /// With its length, so that no two lists of texts are one.
    Stamp& add(std::string_view text);

    /// Names, relative to `source`, and texts of files, in the order of their names.
    Stamp& add_files(const fs::path& source, std::vector<fs::path> files);

    /// All sources below these folders: .cpp, .h and .toml.
    Stamp& add_sources(const fs::path& source, const std::vector<std::string>& folders);

    /// 16 hexadecimal digits.
    std::string text() const;

private:
    std::uint64_t hash_ = fnv1a("");
};

/// Whether a stamp of sources counts this file.
bool is_source(const fs::path& path);

}  // namespace grade
