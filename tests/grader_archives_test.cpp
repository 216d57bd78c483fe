#include <fmt/format.h>

#include "catch.h"
#include "files/files.h"
#include "packed.h"
#include "submission/submission.h"

using namespace grade;

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

TEST_CASE("an archive with thousands of copies of a fragment is refused before they fill the memory") {
    const TemporaryFolder folder;
    for (const bool zip : {true, false}) {
        pack(folder.path() / "many", copies(200), zip);
        CHECK_THROWS_WITH(read_submission(folder.path() / "many", fragments_of_hand_in),
                          Catch::Matchers::ContainsSubstring("named like fragments"));
    }
}

TEST_CASE("pictures or a build folder beside fragments cost no points", "[submission]") {
    const TemporaryFolder folder;
    const fs::path file = folder.path() / "work";
    std::vector<PackedFile> pictures, objects;
    for (int i = 0; i < 9; ++i) pictures.push_back({fmt::format("pictures/{}.exr", i), std::string(30u << 20, ' ')});
    for (int i = 0; i < 20'001; ++i) objects.push_back({fmt::format("object{}.o", i), ""});
    for (const bool zip : {true, false})
        for (const auto& [others, why] : {std::pair(&pictures, "work unpacks to more than 256 MiB"),
                                          {&objects, "work holds more than 20000 files"}}) {
            std::vector<PackedFile> all = *others;
            pack(file, all, zip);
            says(file, "holds no fragment; work ");
            says(file, ", and the rest was not read; expected files such as fragments/moved.cpp alone");
            all.insert(all.begin(), {"fragments/moved.cpp", "mine"});
            pack(file, all, zip);
            const Submission s = read_submission(file, fragments_of_hand_in);
            CHECK(s.texts == std::map<std::string, std::string>{{"moved", "mine"}});
            REQUIRE(s.notes.size() == 1);
            CHECK(s.notes[0] == std::string(why) + "; what was read until then was taken; expected fragments/ alone");
        }
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
