#include "catch.h"
#include "files/files.h"
#include "packed.h"
#include "submission/near_name.h"
#include "submission/submission.h"

using namespace grade;

namespace {

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
    std::vector<PackedFile> entries;
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
    const auto taken = [&](const std::vector<PackedFile>& entries) {
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
