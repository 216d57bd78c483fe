#include "files/stamp.h"

#include <fmt/format.h>

#include <algorithm>

#include "files/files.h"

namespace grade {

bool is_source(const fs::path& path) {
    return path.extension() == ".cpp" || path.extension() == ".h" || path.extension() == ".toml";
}

Stamp& Stamp::add(std::string_view text) {
    hash_ = (fnv1a(text, hash_) ^ text.size()) * 0x100000001b3;
    return *this;
}

Stamp& Stamp::add_files(const fs::path& source, std::vector<fs::path> files) {
    std::ranges::sort(files);
    for (const fs::path& file : files) add(fs::relative(file, source).string()).add(read_text(file).value_or(""));
    return *this;
}

Stamp& Stamp::add_sources(const fs::path& source, const std::vector<std::string>& folders) {
    std::vector<fs::path> files;
    for (const std::string& folder : folders)
        if (fs::is_directory(source / folder))
            for (const auto& entry : fs::recursive_directory_iterator(source / folder))
                if (is_source(entry.path())) files.push_back(entry.path());
    return add_files(source, std::move(files));
}

std::string Stamp::text() const { return fmt::format("{:016x}", hash_); }

}  // namespace grade
