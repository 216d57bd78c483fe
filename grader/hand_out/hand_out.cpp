#include "hand_out/hand_out.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <sys/utsname.h>

#include <array>
#include <sstream>

#include "assignment/strip.h"
#include "files/files.h"
#include "files/words.h"
#include "hand_out/libraries.h"
#include "programs/toolchain.h"
#include "report/describe.h"
#include "rt/files/scene_reader.h"

namespace grade {

namespace {

/// What is handed out, by name: nothing that somebody has put beside it.
constexpr std::array entries = {".editorconfig", ".vscode", "LICENSE", "assignment.toml", "scenes", "starter"};

constexpr const char* assignment_schema = "grader/assignment/assignment.schema.json";

/// Hidden files, what builds leave behind, what needs the solution, and the largest mesh, which only the README shows,
/// stay here.
bool is_left_out(const fs::path& path) {
    const std::string name = path.filename().string();
    return name.starts_with(".") || name.starts_with("build") || name.starts_with("__") || name == "render_pictures" ||
           name == "take_screenshot" || path.stem() == "knot" || name == "make_knot.py";
}

void copy_folder(const fs::path& from, const fs::path& to) {
    fs::create_directories(to);
    for (const auto& entry : fs::directory_iterator(from)) {
        const fs::path target = to / entry.path().filename();
        if (is_left_out(entry.path())) continue;
        if (entry.is_directory())
            copy_folder(entry.path(), target);
        else if (entry.is_regular_file())
            fs::copy_file(entry.path(), target);
    }
}

/// The object with nothing left to read but the name of its fragment and of what it calls: no debug information, no
/// names of its own helpers, no note of the compiler.
///
/// symbol  the fragment's, for the linker
void write_bare_object(const fs::path& object, const std::string& symbol, const fs::path& target) {
    const TemporaryFolder work;
    const std::string merged = (work.path() / "merged.o").string(), names = (work.path() / "names").string();
    // groups of sections that other objects hold as well must go before their symbols become private
    must_run({"/usr/bin/ld", "-r", "--force-group-allocation", object.string(), "-o", merged});
    must_run({"/usr/bin/objcopy", "--keep-global-symbol=" + symbol, "--strip-unneeded", "--remove-section=.comment",
              merged, target.string()});
    std::istringstream lines(must_run({"/usr/bin/nm", "--format=posix", "--defined-only", target.string()}));
    std::string renamed;
    int count = 0;
    for (std::string line; std::getline(lines, line);)
        if (const std::string name = line.substr(0, line.find(' ')); name != symbol)
            renamed += fmt::format("{} .L{}\n", name, count++);
    if (renamed.empty()) return;
    write_text(names, renamed);
    must_run({"/usr/bin/objcopy", "--redefine-syms=" + names, target.string()});
}

void write_bare_objects(const std::map<std::string, fs::path>& objects, const Toolchain& built,
                        const fs::path& folder) {
    fs::create_directories(folder);
    for (const auto& [name, object] : objects)
        write_bare_object(object, built.symbols.at(name), folder / (name + ".o"));
}

std::string quoted(const std::vector<std::string>& words) {
    return words.empty() ? "[]" : fmt::format("[\"{}\"]", fmt::join(words, "\", \""));
}

/// The toolchain file of a kit: relative to its folder, and without a compiler, which is found where it runs.
void write_toolchain(const Toolchain& built, const fs::path& machine, For whom) {
    std::vector<std::string> blanks, reference, libraries, plain;
    for (const auto& [name, object] : built.solution_objects) {
        reference.push_back("reference/" + name + ".o");
        blanks.push_back("blanks/" + name + ".o");
    }
    for (const auto& entry : fs::directory_iterator(machine / "lib"))
        libraries.push_back("lib/" + entry.path().filename().string());
    std::ranges::sort(libraries);
    for (const std::string& library : built.libraries)
        if (!library.starts_with("/")) plain.push_back(library);
    write_text(machine / "toolchain.toml",
               fmt::format("# How this kit's grader compiles and links.\nkit = true\nprocessor = \"{}\"\ncommit = "
                           "\"{}\"\nsource = \"../..\"\n"
                           "{}compile = {}\nincludes = [\"../../starter\", \"../include\"]\n"
                           "link = {}\narchives = [\"libchild.a\", \"librt.a\"]\nlibraries = {}\nkit_libraries = {}\n"
                           "blanks = \"../blanks\"\nblank_objects = {}\nsolution_objects = {}\n",
                           built.processor, built.commit, whom == For::students ? "cache = \"../../build\"\n" : "",
                           quoted(built.compile), quoted(built.link), quoted(plain), quoted(libraries), quoted(blanks),
                           quoted(reference)));
}

/// The folder that holds glm/, as the compiler finds it.
fs::path folder_of_glm(const Toolchain& built) {
    std::vector<std::string> command{built.compiler.string(), "-std=gnu++20", "-M", "-x", "c++"};
    for (const fs::path& include : built.includes) command.insert(command.end(), {"-I", include.string()});
    command.push_back((built.includes.front() / "rt/math.h").string());
    std::istringstream words(must_run(command));
    for (std::string word; words >> word;)
        if (const auto at = word.find("/glm/"); at != word.npos) return word.substr(0, at);
    throw std::runtime_error("GLM's headers are not found; expected glm/ among those of rt/math.h");
}

void write_machine(const Toolchain& built, const fs::path& program, const fs::path& machine, For whom) {
    fs::create_directories(machine);
    for (const char* part : {"", "_studies"})
        must_run({"/usr/bin/strip", "--strip-all", "--remove-section=.comment", program.string() + part, "-o",
                  (machine / "grade").string() + part});
    for (const auto& [archive, name] :
         {std::pair(built.archives.at(0), "libchild.a"), {built.archives.at(1), "librt.a"}})
        must_run({"/usr/bin/strip", "--strip-debug", "--remove-section=.comment", archive.string(), "-o",
                  (machine / name).string()});
    write_bare_objects(built.solution_objects, built, machine / "reference");
    write_bare_objects(built.blank_objects, built, machine / "blanks");
    write_libraries(program, built, machine);
    write_toolchain(built, machine, whom);
}

/// All that is handed out as it is; of the pictures those that the handout shows.
void copy_entries(const fs::path& project, const fs::path& folder, const std::string& handout) {
    for (const char* entry : entries) {
        const fs::path from = project / entry, to = folder / entry;
        if (fs::is_directory(from))
            copy_folder(from, to);
        else
            fs::copy_file(from, to);
    }
    std::vector<fs::path> unseen;
    for (const auto& picture : fs::directory_iterator(folder / "scenes/pictures"))
        if (handout.find(picture.path().filename().string()) == handout.npos) unseen.push_back(picture.path());
    for (const fs::path& picture : unseen) fs::remove(picture);
}

/// What a kit has as a student's repository.
void write_repository(const fs::path& project, const fs::path& folder) {
    fs::create_directories(folder / ".github/workflows");
    fs::copy_file(project / "grader/kit/github/grade.yml", folder / ".github/workflows/grade.yml");
    write_text(folder / ".gitignore", "build*/\n/pictures/\n");
    write_text(folder / ".gitattributes", "* text=auto eol=lf\n");  // a shell reads no CRLF
}

/// The graders of another hand-out, for other kinds of machines. They must be of the same assignment.
void add_machines(const fs::path& kit, const fs::path& folder) {
    for (const char* file : {"assignment.toml", "grade"})
        if (read_text(kit / file) != read_text(folder / file))
            throw rt::InputError(
                fmt::format("{}: its {} is another one; expected a hand-out of this very project", kit.string(), file));
    for (const auto& entry : fs::directory_iterator(kit / "grader")) {
        const fs::path target = folder / "grader" / entry.path().filename();
        if (fs::exists(entry.path() / "toolchain.toml") && !fs::exists(target))
            fs::copy(entry.path(), target, fs::copy_options::recursive);
    }
}

/// What has been handed out is not changed by a later call, whatever has changed since.
void require_empty(const fs::path& project, const fs::path& folder) {
    if (!fs::exists(folder) || fs::is_empty(folder)) return;
    std::string what;
    if (const auto there = read_text(folder / "assignment.toml"))
        what = there == read_text(project / "assignment.toml")
                   ? ": a kit of this assignment.toml"
                   : ": a kit of another assignment.toml than today's, which stays as it is";
    throw rt::InputError(fmt::format("{}: is not empty{}; expected a new folder", folder.string(), what));
}

}  // namespace

std::string kind_of_machine() {
    utsname names{};
    uname(&names);
    return lower(fmt::format("{}-{}", names.machine, names.sysname));
}

namespace {

void write_kit(const fs::path& project, const Assignment& assignment, const fs::path& built_toolchain,
               const fs::path& folder, const std::vector<fs::path>& others, For whom) {
    const Toolchain built = read_toolchain(built_toolchain);
    const fs::path program =
        built.archives.front().parent_path() / (whom == For::students ? "grade_kit" : "grade_installed");
    if (!fs::exists(program)) throw std::runtime_error(fmt::format("{}: not built yet", program.string()));
    const auto blanks = make_starter((project / "solution").string(), assignment.asked());
    // first, for it may be no handout of this assignment
    const std::string handout =
        handed_out(read_text(project / "handout.md").value_or(""), assignment, (project / "handout.md").string());

    fs::create_directories(folder);
    copy_entries(project, folder, handout);
    // the editor's settings name it
    fs::create_directories(folder / "grader/assignment");
    fs::copy_file(project / assignment_schema, folder / assignment_schema);
    write_text(folder / "handout.md", handout);
    // of this very text
    if (const fs::path page = built_toolchain.parent_path() / "handout.html";
        fs::exists(page) && read_text(built_toolchain.parent_path() / "handout.md") == handout)
        fs::copy_file(page, folder / "handout.html");
    fs::copy_file(project / "grader/kit/grade", folder / "grade");
    if (whom == For::students) write_repository(project, folder);
    write_starter(blanks, (folder / "starter/fragments").string());
    write_starter(blanks, (folder / "grader/blanks").string());
    copy_folder(folder_of_glm(built) / "glm", folder / "grader/include/glm");
    // of GLM, half a megabyte that no renderer needs: what is experimental, numbers in few bits, noise, all at once
    for (const char* part : {"gtx", "gtc/packing.hpp", "gtc/packing.inl", "gtc/noise.hpp", "gtc/noise.inl", "ext.hpp"})
        fs::remove_all(folder / "grader/include/glm" / part);
    write_machine(built, program, folder / "grader" / kind_of_machine(), whom);
    for (const fs::path& kit : others) add_machines(kit, folder);
}

/// Where the kit grows, beside its place. The tools that write it run in another folder.
fs::path draft_of(const fs::path& place) {
    fs::path draft = place;
    draft += ".part";
    if (fs::exists(draft))
        throw rt::InputError(
            fmt::format("{}: is there, of a call that was stopped; expected nothing: remove it", draft.string()));
    return draft;
}

}  // namespace

void hand_out(const fs::path& project, const Assignment& assignment, const fs::path& built_toolchain,
              const fs::path& folder, const std::vector<fs::path>& others, For whom) {
    require_empty(project, folder);
    fs::path place = fs::weakly_canonical(fs::absolute(folder));
    if (!place.has_filename()) place = place.parent_path();
    const fs::path draft = draft_of(place);
    try {
        write_kit(project, assignment, built_toolchain, draft, others, whom);
        fs::rename(draft, place);
    } catch (...) {
        remove_tree(draft);
        throw;
    }
}

}  // namespace grade
