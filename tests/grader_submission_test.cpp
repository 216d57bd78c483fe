#include <archive.h>
#include <archive_entry.h>

#include "catch.h"
#include "files/files.h"
#include "submission/code_only.h"
#include "submission/near_name.h"
#include "submission/source_fault.h"
#include "submission/submission.h"

using namespace grade;

namespace {

const std::vector<std::string> fragments_of_hand_in{"moved", "phong", "whitted"};

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
std::vector<Entry> copies(int count) {
    std::vector<Entry> entries;
    for (int i = 0; i < count; ++i)
        entries.push_back({std::to_string(i) + "/moved.cpp", std::string(most_source_bytes, ' ')});
    return entries;
}

const std::string garcia = "HW3_Garc\u00eda";

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
        const Submission submission = read_submission(folder.path() / name, fragments_of_hand_in);
        REQUIRE(submission.texts.size() == 1);
        CHECK(submission.texts.at("moved") == "moved");
    }
}

TEST_CASE("edits of the framework are told, copies of it are not") {
    const TemporaryFolder folder;
    const std::string ray = read_text("starter/rt/ray.h").value();
    const std::vector<std::pair<std::string, std::string>> files{{"rt/ray.h", ray + "// mine\n"},
                                                                 {"rt/lamps/lamp_tree.h", "mine"},
                                                                 {"rt/math.h", read_text("starter/rt/math.h").value()},
                                                                 {"rt/own.h", "mine"},
                                                                 {"fragments/moved.cpp", "moved"}};
    std::vector<Entry> entries;
    for (const auto& [name, text] : files) {
        fs::create_directories((folder.path() / "work" / name).parent_path());
        write_text(folder.path() / "work" / name, text);
        entries.push_back({"work/" + name, text});
    }
    pack(folder.path() / "work.zip", entries, true);
    for (const char* name : {"work", "work.zip"}) {
        INFO(name);
        const auto notes = read_submission(folder.path() / name, fragments_of_hand_in, "starter").notes;
        REQUIRE(notes.size() == 1);
        CHECK(notes[0].find("rt/lamps/lamp_tree.h and 1 more: not as they were handed out") != std::string::npos);
    }
    const std::vector<std::string> one{"phong_lobe"};
    CHECK(read_submission("starter", one, "starter").notes.empty());
}

TEST_CASE("links, devices, large files and paths that lead out are not taken") {
    const TemporaryFolder folder;
    fs::create_directories(folder.path() / "a");
    write_text(folder.path() / "secret", "secret");
    write_text(folder.path() / "a/moved.cpp", "moved");
    fs::create_symlink(folder.path() / "secret", folder.path() / "a/phong.cpp");
    write_text(folder.path() / "a/whitted.cpp", std::string(most_source_bytes + 1, ' '));
    const Submission submission = read_submission(folder.path() / "a", fragments_of_hand_in);
    CHECK(submission.texts.size() == 1);
    CHECK(submission.complaints.at("phong").find("not a regular file") != std::string::npos);
    CHECK(submission.complaints.at("whitted").find("larger than 256 KiB") != std::string::npos);

    pack(folder.path() / "b.tar.gz",
         {{"f/moved.cpp", "moved"},
          {"f/phong.cpp", "/etc/passwd", AE_IFLNK},
          {"../whitted.cpp", "out"},
          {"/tmp/whitted.cpp", "out"}},
         false);
    const Submission archived = read_submission(folder.path() / "b.tar.gz", fragments_of_hand_in);
    CHECK(archived.texts.size() == 1);
    CHECK(archived.complaints.contains("phong"));
    CHECK_FALSE(archived.texts.contains("whitted"));
}

TEST_CASE("what is no submission is an error that fragments_of_hand_in it") {
    const TemporaryFolder folder;
    CHECK_THROWS_AS(read_submission(folder.path() / "none", fragments_of_hand_in), SubmissionError);
    CHECK_THROWS_AS(read_submission(folder.path(), fragments_of_hand_in), SubmissionError);
    write_text(folder.path() / "x.zip", "no archive");
    CHECK_THROWS_AS(read_submission(folder.path() / "x.zip", fragments_of_hand_in), SubmissionError);
}

TEST_CASE("an archive with thousands of copies of a fragment is refused before they fill the memory") {
    const TemporaryFolder folder;
    for (const bool zip : {true, false}) {
        pack(folder.path() / "many", copies(200), zip);
        CHECK_THROWS_WITH(read_submission(folder.path() / "many", fragments_of_hand_in),
                          Catch::Matchers::ContainsSubstring("named like fragments"));
    }
}

TEST_CASE("a folder that its owner may not read goes as well, and one that is in use stays") {
    fs::path gone;
    {
        const TemporaryFolder folder;
        gone = folder.path();
        fs::create_directories(gone / "deep/er");
        fs::permissions(gone / "deep/er", fs::perms::none);
        fs::permissions(gone / "deep", fs::perms::none);
    }
    CHECK_FALSE(fs::exists(gone));
}

TEST_CASE("a disk without room is an error") {
    const TemporaryFolder folder;
    CHECK_NOTHROW(require_room(folder.path(), 1));
    CHECK_THROWS_WITH(require_room(folder.path(), std::uintmax_t(-1)),
                      Catch::Matchers::ContainsSubstring("the disk is full"));
}

TEST_CASE("comments, white space, line ends and byte order marks are not code") {
    CHECK(code_only("a = 1; // one\n/* two\n*/ b") == "a=1;b");
    CHECK(code_only("\xef\xbb\xbf"
                    "a\r\n= b") == "a=b");
    CHECK(code_only("s = \"// a b\"; c = ' ';") == "s=\"// a b\";c=' ';");
    CHECK(code_only("1'000 // '\n+ 2") == "1'000+2");
    CHECK(code_only("\"\\\" // x\" y").size() == 10);
    CHECK(code_only("/* open") == "");
    CHECK(code_only("a b") != code_only("a c"));
}

TEST_CASE("each of the archives that were refused or misread is graded, or told what was nearly right",
          "[submission]") {
    const std::vector<std::string> all{"hit_sphere", "mirror_direction", "phong"};
    const auto read = [&](const char* name) { return read_submission(fs::path("tests/cases/archives") / name, all); };
    const Submission utf8 = read("name_of_student.zip");
    CHECK(utf8.texts.contains("hit_sphere"));
    CHECK(utf8.folder == garcia + "/fragments/");

    const Submission suffix = read("browser_suffix.zip");
    CHECK(suffix.texts.contains("mirror_direction"));
    CHECK(suffix.complaints.at("hit_sphere") ==
          "not in the submission; there is fragments/hit_sphere (1).cpp: rename it to hit_sphere.cpp");
    CHECK_FALSE(suffix.complaints.contains("phong"));
    CHECK(read("case.zip").complaints.at("hit_sphere").find("there is fragments/Hit_Sphere.cpp: rename it") !=
          std::string::npos);

    const Submission copies = read("old_copy.zip");
    CHECK(copies.folder == "starter/fragments/");
    CHECK(copies.texts.at("hit_sphere").size() == 1725);
    REQUIRE(copies.notes.size() == 1);
    CHECK(copies.notes[0] ==
          "hit_sphere.cpp, mirror_direction.cpp are in starter/fragments/ and in old/; what is in "
          "starter/fragments/ was taken: old/ looks set aside by its name");
}

TEST_CASE("names as browsers, learning systems and hands change them are near to their fragments'", "[submission]") {
    const std::vector<std::string> all{"hit_sphere", "hit_quad", "phong",      "phong_lobe",
                                       "moved",      "lens_ray", "camera_ray", "whitted"};
    for (const char* file : {"hit_sphere-1.cpp",
                             "hit_sphere (1).cpp",
                             "hit_sphere(2).cpp",
                             "Hit_Sphere.cpp",
                             "HIT_SPHERE.CPP",
                             "hitsphere.cpp",
                             "HitSphere.cpp",
                             "hit-sphere.cpp",
                             "hit sphere.cpp",
                             "hit_sphere.cpp.txt",
                             "hit_sphere.cc",
                             "hit_sphere.c",
                             "hit_sphere.h",
                             "hit_sphere.txt",
                             "hit_sphere_final.cpp",
                             "hit_sphere2.cpp",
                             "hit_sphere copy.cpp",
                             "hit_sphere - Copy.cpp",
                             "Copy of hit_sphere.cpp",
                             "Kopie von hit_sphere.cpp",
                             "garcia_4711_815_hit_sphere.cpp",
                             "hit_sphere.cpp.bak",
                             "hit_sphere.cpp (1)",
                             "hit_sphere.cpp~",
                             "hit_shpere.cpp",
                             "hit_spere.cpp",
                             "hit_spheres.cpp",
                             "hit_sphere_.cpp",
                             " hit_sphere.cpp",
                             "hit_sphere .cpp",
                             "hit_sphere\xe2\x80\x8b.cpp",
                             "hit_sphere_v2-3.cpp"}) {
        INFO(file);
        CHECK(nearly_named(file, all) == "hit_sphere");
    }
    CHECK(nearly_named("phong_lobe (1).cpp", all) == "phong_lobe");
    CHECK(nearly_named("phong-1.cpp", all) == "phong");
    for (const char* file :
         {"hit_sphere.cpp", "phong_lobe.cpp", "removed.cpp", "camera.cpp", "main.cpp", "hit_sphere.o", "hit_sphere.png",
          "report.txt", "._hit_sphere.cpp", "README.md", "Makefile", "ray.cpp", ""}) {
        INFO(file);
        CHECK_FALSE(nearly_named(file, all));
    }
}

TEST_CASE("of several copies one is taken, and it is said which and why", "[submission]") {
    const TemporaryFolder folder;
    const auto taken = [&](const std::vector<Entry>& entries) {
        pack(folder.path() / "c.zip", entries, true);
        return read_submission(folder.path() / "c.zip", fragments_of_hand_in);
    };
    // the folder's name, the number of fragments, the length of the path
    Submission s = taken({{"a/moved.cpp", "other"}, {"hw/fragments/moved.cpp", "moved"}});
    CHECK(s.texts.at("moved") == "moved");
    REQUIRE(s.notes.size() == 1);
    CHECK(s.notes[0].find("it is named fragments") != std::string::npos);
    s = taken({{"x/moved.cpp", "moved"}, {"x/phong.cpp", "phong"}, {"y/fragments/moved.cpp", "other"}});
    CHECK(s.texts.at("moved") == "moved");
    CHECK(s.notes.at(0) == "moved.cpp is in x/ and in y/fragments/; what is in x/ was taken: it holds more fragments");
    s = taken(
        {{"fragments_old/moved.cpp", "other"}, {"fragments_old/phong.cpp", "other"}, {"fragments/moved.cpp", "moved"}});
    CHECK(s.texts.at("moved") == "moved");
    CHECK(s.complaints.at("phong") == "not in fragments/; there is fragments_old/phong.cpp: put it there");
    s = taken({{"old/fragments/moved.cpp", "moved"}});  // the only one, whatever its name
    CHECK(s.texts.at("moved") == "moved");
    CHECK(s.notes.empty());
    s = taken({{"fragments/moved.cpp", "other"}, {"fragments/moved.cpp", "moved"}});
    CHECK(s.texts.at("moved") == "moved");
    CHECK(s.notes.at(0).find("is in the archive twice") != std::string::npos);
    s = taken({{"fragments/moved.cpp", "moved"}, {"fragments/moved (1).cpp", "other"}});
    CHECK(s.texts.at("moved") == "moved");
    CHECK(s.notes.at(0) == "fragments/moved (1).cpp was left out: moved.cpp is there as well");
    s = taken({{"hw\\fragments\\moved.cpp", "moved"}});
    CHECK(s.texts.at("moved") == "moved");
    s = taken({{"\xc3\xbc bung/\xe8\xaf\xbe/moved.cpp", "moved"},
               {"b\xe9"
                "b\xe9/notes.txt",
                "no UTF-8"}});
    CHECK(s.texts.at("moved") == "moved");
    CHECK_THROWS_WITH(taken({{"a/hw.zip", "zip"}}),
                      Catch::Matchers::ContainsSubstring("c.zip: holds no fragment; ") &&
                          Catch::Matchers::ContainsSubstring("c.zip/a/hw.zip: cannot be unpacked"));
    CHECK_THROWS_WITH(taken({{"a/hw.rar", "rar"}}),
                      Catch::Matchers::ContainsSubstring("another archive, a/hw.rar: unpack it"));
}

TEST_CASE("a change of what is handed out filled in is told", "[submission]") {
    const TemporaryFolder folder;
    for (const char* name : {"moved", "phong", "whitted"})
        write_text(folder.path() / (std::string(name) + ".cpp"), "a");
    Submission s{.name = "s", .folder = "fragments/"};
    s.texts = {{"moved", "a // as it was\n"}, {"phong", "b"}, {"whitted", "b"}};
    note_given(s, {"whitted"}, folder.path());
    REQUIRE(s.notes.size() == 1);
    CHECK(s.notes[0].starts_with("fragments/phong.cpp: handed out filled in, and changed; it is not graded"));
}

TEST_CASE("archives in a folder are looked into", "[submission]") {
    const TemporaryFolder folder;
    const fs::path top = folder.path() / "Jane Doe_111_assignsubmission_file_", zip = top / "work.zip";
    fs::create_directories(top);
    const auto read = [&] { return read_submission(top, fragments_of_hand_in, "starter"); };
    pack(folder.path() / "inner.tar.gz", {{"phong.cpp", "phong"}}, false);
    const std::string inner = read_text(folder.path() / "inner.tar.gz").value();
    pack(zip, {{"hw/fragments/moved.cpp", "moved"}, {"hw/rt/ray.h", "mine"}}, true);
    Submission s = read();
    CHECK(s.texts == std::map<std::string, std::string>{{"moved", "moved"}});
    CHECK(s.folder == "work.zip/hw/fragments/");
    REQUIRE(s.notes.size() == 1);
    CHECK(s.notes[0].starts_with("work.zip/hw/rt/ray.h: not as they were handed out"));
    pack(zip, {{"Moved.cpp", "moved"}, {"inner.tar.gz", inner}}, true);
    s = read();
    CHECK(s.texts == std::map<std::string, std::string>{{"phong", "phong"}});
    CHECK(s.complaints.at("moved").find("there is work.zip/Moved.cpp: rename it") != std::string::npos);
    CHECK(s.notes.empty());

    // within bounds, for all of them together
    pack(zip, copies(100), true);
    pack(top / "more.tar.gz", copies(100), false);
    CHECK_THROWS_WITH(read(), Catch::Matchers::ContainsSubstring("named like fragments"));
    fs::remove(top / "more.tar.gz");

    write_text(zip, "no archive");
    CHECK_THROWS_WITH(read(), Catch::Matchers::ContainsSubstring("work.zip: cannot be unpacked"));
    fs::remove(zip);
    fs::create_symlink(folder.path() / "inner.tar.gz", top / "inner.tar.gz");
    CHECK_THROWS_WITH(read(), Catch::Matchers::ContainsSubstring("holds no fragment; expected"));
    fs::remove(top / "inner.tar.gz");
    write_text(top / "inner.tar.gz", inner);
    write_text(top / "moved.cpp", "beside");
    s = read();
    CHECK(s.texts == std::map<std::string, std::string>{{"moved", "beside"}});
    CHECK(s.complaints.at("phong") == "not in the top folder; there is inner.tar.gz/phong.cpp: put it there");
}

TEST_CASE("of fragments and an archive beside them the fuller one is taken", "[submission]") {
    const TemporaryFolder folder;
    const fs::path top = folder.path() / "Jane Doe_111_assignsubmission_file_";
    fs::create_directories(top);
    const auto read = [&] { return read_submission(top, fragments_of_hand_in, "starter"); };
    const std::string blank = "namespace rt { vec3 moved(vec3 p) { return not_started(p); } }";
    write_text(top / "moved.cpp", "beside");
    pack(top / "work.zip", {{"hw/moved.cpp", "moved"}, {"hw/phong.cpp", "phong"}}, true);
    Submission s = read();
    CHECK(s.texts == std::map<std::string, std::string>{{"moved", "moved"}, {"phong", "phong"}});
    CHECK(s.notes == std::vector<std::string>{"moved.cpp is in work.zip/hw/ and in the top folder; what is in "
                                              "work.zip/hw/ was taken: it holds more fragments"});
    // what was handed out is not the fuller one, however many blanks it has
    pack(top / "work.zip", {{"hw/moved.cpp", blank}, {"hw/phong.cpp", blank}}, true);
    s = read();
    CHECK(s.texts.at("moved") == "beside");
    CHECK(s.notes.at(0).ends_with("what is in the top folder was taken: more of its fragments are filled in"));
    // what cannot be read, or is too large, is nobody's loss
    write_text(top / "work.zip", "PK\3\4");
    s = read();
    CHECK(s.texts == std::map<std::string, std::string>{{"moved", "beside"}});
    CHECK(s.notes.at(0).starts_with("work.zip was left out: work.zip: cannot be unpacked: it is cut off"));
    pack(top / "work.zip", copies(200), true);
    s = read();
    CHECK(s.texts == std::map<std::string, std::string>{{"moved", "beside"}});
    CHECK(s.notes.at(0).find("work.zip: holds more than 32 MiB") != std::string::npos);
}

namespace {

std::string fault_of(const fs::path& file) {
    return complaint_of([&] { read_submission(file, fragments_of_hand_in); });
}

void says(const fs::path& file, const char* words) {
    INFO(fault_of(file));
    CHECK(fault_of(file).find(words) != std::string::npos);
}

/// Which no compression makes much smaller.
std::string long_text() {
    std::string text;
    for (int i = 0; i < 5000; ++i) text += std::to_string(i * i);
    return text;
}

}  // namespace

TEST_CASE("an archive that is cut off, or none, is told as what it is", "[submission]") {
    const TemporaryFolder folder;
    const fs::path zip = folder.path() / "work.zip", tar = folder.path() / "work.tar.gz";
    const std::string text = long_text();
    pack(zip, {{"moved.cpp", text}, {"phong.cpp", text}}, true);
    pack(tar, {{"moved.cpp", text}, {"phong.cpp", text}}, false);
    REQUIRE(fault_of(zip) == "");
    REQUIRE(fault_of(tar) == "");
    const std::string whole_zip = read_text(zip).value(), whole_tar = read_text(tar).value();
    for (const double share : {0.01, 0.4, 0.7, 0.9}) {
        write_text(zip, whole_zip.substr(0, std::size_t(share * double(whole_zip.size()))));
        says(zip, "cannot be unpacked: it is cut off, its end is missing; expected the whole .zip");
        write_text(tar, whole_tar.substr(0, std::size_t(share * double(whole_tar.size()))));
        says(tar, "cannot be unpacked: it is cut off");
    }
    // between two files: whatever is read of it, it is said
    write_text(zip, whole_zip.substr(0, whole_zip.find("PK\3\4", 4)));
    if (fault_of(zip) == "")
        CHECK(read_submission(zip, fragments_of_hand_in).notes.at(0).find("it is cut off") != std::string::npos);
    else
        says(zip, "it is cut off");
    write_text(zip, whole_zip.substr(0, whole_zip.size() - 10));  // all is there but the end
    CHECK(read_submission(zip, fragments_of_hand_in).texts.size() == 2);
    CHECK(read_submission(zip, fragments_of_hand_in).notes.at(0).find("it is cut off") != std::string::npos);
    write_text(zip, "");
    says(zip, "it is empty: 0 bytes");
    write_text(zip, "<!doctype html><title>Sign in</title>");
    says(zip, "by its contents it is a page of the web; expected a .zip");
    write_text(zip, "Rar!\x1a\x07 and more");
    says(zip, "by its contents it is a .rar");
    write_text(zip, "my fragments are on a stick");
    says(zip, "by its contents it is no archive");
}

TEST_CASE("what leads out of an archive, or is broken within it, is left out", "[submission]") {
    const TemporaryFolder folder;
    const fs::path zip = folder.path() / "work.zip", outer = folder.path() / "outer.zip";
    const std::string text = long_text();
    pack(zip, {{"moved.cpp", text}, {"phong.cpp", text}}, true);
    const std::string whole_zip = read_text(zip).value();
    for (const char* name : {"../moved.cpp", "/home/me/moved.cpp", "..\\moved.cpp"}) {
        pack(zip, {{name, text}}, true);
        says(zip, "holds nothing that can be taken");
        says(zip, "moved.cpp leads out of the archive; expected files such as fragments/");
    }
    pack(zip, {{"moved.cpp", text}, {"../phong.cpp", text}}, true);
    const Submission s = read_submission(zip, fragments_of_hand_in);
    CHECK(s.texts.size() == 1);
    CHECK(s.notes == std::vector<std::string>{"1 file was left out: ../phong.cpp leads out of the archive"});
    pack(outer, {{"work.zip", whole_zip.substr(0, whole_zip.size() / 2)}}, true);
    CHECK(read_submission(outer, fragments_of_hand_in).notes ==
          std::vector<std::string>{"work.zip was read in part: it is cut off or broken"});
    pack(outer, {{"work.zip", whole_zip.substr(0, whole_zip.size() / 4)}}, true);
    says(outer, "outer.zip/work.zip: cannot be unpacked: it is cut off");
}

TEST_CASE("an unpacked archive is found in its only folder", "[submission]") {
    const TemporaryFolder folder;
    const fs::path fragments = folder.path() / garcia / "work/fragments";
    fs::create_directories(fragments);
    write_text(fragments / "moved.cpp", "moved");
    write_text(fragments / "Phong.cpp", "phong");
    const Submission s = read_submission(folder.path(), fragments_of_hand_in);
    CHECK(s.texts.at("moved") == "moved");
    CHECK(s.complaints.at("phong").find("Phong.cpp: rename it to phong.cpp") != std::string::npos);
}

TEST_CASE("what is no C++ at all is named in one sentence", "[submission]") {
    const auto fault = [](const std::string& text) { return source_fault(text, "f/moved.cpp"); };
    const std::string good =
        "#include \"rt/fragments.h\"\nnamespace rt {\nvec3 moved(vec3 p, vec3 v, Real t) { return p + t * v; }\n}\n";
    CHECK(fault(good) == "");
    CHECK(fault("\xef\xbb\xbf" + good) == "");
    CHECK(fault("const char* a = \"/*\"; char b = '\"'; // /* \nauto c = R\"x( /* \" )x\"; int d = 1'000; /* closed "
                "*/\n") == "");
    std::string wide = "\xff\xfe";
    for (const char c : good) wide += c, wide += '\0';
    CHECK(fault(wide) ==
          "f/moved.cpp:1:1: error: the file is UTF-16 text, which no compiler reads; expected UTF-8: save it again as "
          "such\n");
    CHECK(fault(wide.substr(2)).find("UTF-16") != std::string::npos);
    CHECK(fault(good + "/* the end") ==
          "f/moved.cpp:5:1: error: the comment that starts here has no end; expected */\n");
    CHECK(fault("int a; /* one\nint b;").starts_with("f/moved.cpp:1:8: "));
    CHECK(fault("a\n<<<<<<< HEAD\nb\n=======\nc\n>>>>>>> theirs\n")
              .starts_with("f/moved.cpp:2:1: error: a merge conflict is not resolved: git has left the line '<<<<<<< "
                           "HEAD'; expected one of"));
    CHECK(fault("<!DOCTYPE html>\n<html>").find("web page") != std::string::npos);
    CHECK(fault("{\\rtf1\\ansi").find("RTF") != std::string::npos);
    CHECK(fault("```cpp\n" + good + "```\n").find("Markdown") != std::string::npos);
    CHECK(fault(good + std::string("\0", 1)).find("a byte 0") != std::string::npos);
    // such a file is no blank, though no code is left of it
    CHECK_FALSE(is_blank("/* all of it\n" + good, "solution/moved.cpp"));
    CHECK(is_blank("/* all of it */\n", "solution/moved.cpp"));
}
