#pragma once

#include <archive.h>
#include <archive_entry.h>

#include "catch.h"
#include "submission/submission.h"

/// Archives that hold fragments.
namespace grade {

inline const std::vector<std::string> fragments_of_hand_in{"moved", "phong", "whitted"};

struct PackedFile {
    std::string path, text;
    int type = AE_IFREG;
};

inline void pack(const fs::path& path, const std::vector<PackedFile>& entries, bool zip) {
    archive* out = archive_write_new();
    if (zip) {
        archive_write_set_format_zip(out);
    } else {
        archive_write_add_filter_gzip(out);
        archive_write_set_format_pax_restricted(out);
    }
    REQUIRE(archive_write_open_filename(out, path.c_str()) == ARCHIVE_OK);
    for (const PackedFile& entry : entries) {
        archive_entry* item = archive_entry_new();
        archive_entry_set_pathname(item, entry.path.c_str());
        archive_entry_set_filetype(item, unsigned(entry.type));
        archive_entry_set_perm(item, 0644);
        if (entry.type == AE_IFLNK)
            archive_entry_set_symlink(item, entry.text.c_str());
        else
            archive_entry_set_size(item, la_int64_t(entry.text.size()));
        archive_write_header(out, item);
        if (entry.type == AE_IFREG) archive_write_data(out, entry.text.data(), entry.text.size());
        archive_entry_free(item);
    }
    archive_write_close(out);
    archive_write_free(out);
}

/// So many copies of a fragment, as large as they may be.
inline std::vector<PackedFile> copies(int count) {
    std::vector<PackedFile> entries;
    for (int i = 0; i < count; ++i)
        entries.push_back({std::to_string(i) + "/moved.cpp", std::string(most_source_bytes, ' ')});
    return entries;
}

}  // namespace grade
