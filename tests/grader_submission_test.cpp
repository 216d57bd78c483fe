#include <archive.h>
#include <archive_entry.h>

#include "build/code_only.h"
#include "build/files.h"
#include "build/submission.h"
#include "catch.h"

using namespace grade;

namespace {

const std::vector<std::string> names{"moved", "phong", "whitted"};

struct Entry {
    std::string path, text;
    int type = AE_IFREG;
};

void pack(const fs::path& path, const std::vector<Entry>& entries, bool zip) {
    archive* out = archive_write_new();
    if (zip) {
        archive_write_set_format_zip(out);
    } else {
        archive_write_add_filter_gzip(out);
        archive_write_set_format_pax_restricted(out);
    }
    REQUIRE(archive_write_open_filename(out, path.c_str()) == ARCHIVE_OK);
    for (const Entry& entry : entries) {
        archive_entry* item = archive_entry_new();
        archive_entry_set_pathname(item, entry.path.c_str());
        archive_entry_set_filetype(item, unsigned(entry.type));
        archive_entry_set_perm(item, 0644);
        if (entry.type == AE_IFLNK) archive_entry_set_symlink(item, entry.text.c_str());
        else archive_entry_set_size(item, la_int64_t(entry.text.size()));
        archive_write_header(out, item);
        if (entry.type == AE_IFREG) archive_write_data(out, entry.text.data(), entry.text.size());
        archive_entry_free(item);
    }
    archive_write_close(out);
    archive_write_free(out);
}

}  // namespace

TEST_CASE("a folder of fragments, a starter, and archives of either are read alike") {
    const TemporaryFolder folder;
    fs::create_directories(folder.path() / "flat");
    write_text(folder.path() / "flat/moved.cpp", "moved");
    fs::create_directories(folder.path() / "copy/fragments");
    write_text(folder.path() / "copy/fragments/moved.cpp", "moved");
    write_text(folder.path() / "copy/CMakeLists.txt", "ignored");
    pack(folder.path() / "a.zip", {{"me/fragments/moved.cpp", "moved"}, {"__MACOSX/me/fragments/moved.cpp", "junk"}},
         true);
    pack(folder.path() / "a.tar.gz", {{"./fragments/moved.cpp", "moved"}, {"./rt/math.h", "ignored"}}, false);
    for (const char* name : {"flat", "copy", "a.zip", "a.tar.gz"}) {
        INFO(name);
        const Submission submission = read_submission(folder.path() / name, names);
        REQUIRE(submission.texts.size() == 1);
        CHECK(submission.texts.at("moved") == "moved");
    }
}

TEST_CASE("links, devices, large files and paths that lead out are not taken") {
    const TemporaryFolder folder;
    fs::create_directories(folder.path() / "a");
    write_text(folder.path() / "secret", "secret");
    write_text(folder.path() / "a/moved.cpp", "moved");
    fs::create_symlink(folder.path() / "secret", folder.path() / "a/phong.cpp");
    write_text(folder.path() / "a/whitted.cpp", std::string(most_source_bytes + 1, ' '));
    const Submission submission = read_submission(folder.path() / "a", names);
    CHECK(submission.texts.size() == 1);
    CHECK(submission.complaints.at("phong").find("not a regular file") != std::string::npos);
    CHECK(submission.complaints.at("whitted").find("larger than 256 KiB") != std::string::npos);

    pack(folder.path() / "b.tar.gz",
         {{"f/moved.cpp", "moved"},
          {"f/phong.cpp", "/etc/passwd", AE_IFLNK},
          {"../whitted.cpp", "out"},
          {"/tmp/whitted.cpp", "out"}},
         false);
    const Submission archived = read_submission(folder.path() / "b.tar.gz", names);
    CHECK(archived.texts.size() == 1);
    CHECK(archived.complaints.contains("phong"));
    CHECK_FALSE(archived.texts.contains("whitted"));
}

TEST_CASE("what is no submission is an error that names it") {
    const TemporaryFolder folder;
    CHECK_THROWS_AS(read_submission(folder.path() / "none", names), SubmissionError);
    CHECK_THROWS_AS(read_submission(folder.path(), names), SubmissionError);
    write_text(folder.path() / "x.zip", "no archive");
    CHECK_THROWS_AS(read_submission(folder.path() / "x.zip", names), SubmissionError);
}

TEST_CASE("a disk without room is an error") {
    const TemporaryFolder folder;
    CHECK_NOTHROW(require_room(folder.path(), 1));
    CHECK_THROWS_WITH(require_room(folder.path(), std::uintmax_t(-1)), Catch::Matchers::ContainsSubstring("the disk is full"));
}

TEST_CASE("comments, white space, line ends and byte order marks are not code") {
    CHECK(code_only("a = 1; // one\n/* two\n*/ b") == "a=1;b");
    CHECK(code_only("\xef\xbb\xbf" "a\r\n= b") == "a=b");
    CHECK(code_only("s = \"// a b\"; c = ' ';") == "s=\"// a b\";c=' ';");
    CHECK(code_only("1'000 // '\n+ 2") == "1'000+2");
    CHECK(code_only("\"\\\" // x\" y").size() == 10);
    CHECK(code_only("/* open") == "");
    CHECK(code_only("a b") != code_only("a c"));
}
