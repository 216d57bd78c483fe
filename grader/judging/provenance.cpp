#include "judging/provenance.h"

#include <fmt/format.h>
#include <sys/utsname.h>

#include <ctime>

#include "files/files.h"
#include "files/sha256.h"

namespace grade {

namespace {

constexpr std::uint64_t most = std::uint64_t(1) << 30;

/// The grader, also where this is the second program of it.
std::string hash_of_grader() {
    std::error_code error;
    fs::path program = fs::read_symlink("/proc/self/exe", error);
    const std::string name = program.filename().string();
    constexpr std::string_view ending = "_studies";
    if (name.ends_with(ending)) program.replace_filename(name.substr(0, name.size() - ending.size()));
    return sha256(read_text(program, most).value_or(""));
}

std::string hash_of_reference(const Toolchain& chain) {
    std::string lines;
    const auto add = [&](const std::string& name, const fs::path& file) {
        lines += sha256(read_text(file, most).value_or("")) + "  " + name + "\n";
    };
    for (const auto& [name, object] : chain.solution_objects) add(name, object);
    for (const fs::path& archive : chain.archives) add(archive.filename().string(), archive);
    return sha256(lines);
}

}  // namespace

std::string name_of_processor() {
    // nobody knows the length of a file in /proc
    std::string name, text;
    if (std::FILE* file = std::fopen("/proc/cpuinfo", "re")) {
        text.resize(4096);
        text.resize(std::fread(text.data(), 1, text.size(), file));
        std::fclose(file);
    }
    if (const auto at = text.find("model name"); at != text.npos)
        if (const auto colon = text.find(": ", at); colon != text.npos)
            name = text.substr(colon + 2, text.find('\n', colon) - colon - 2);
    if (!name.empty()) return name;
    utsname names{};
    uname(&names);
    return names.machine;
}

Provenance find_provenance(const Toolchain& chain) {
    Provenance p;
    p.version = PENUMBRA_VERSION, p.commit = chain.commit;
    p.program = hash_of_grader(), p.reference = hash_of_reference(chain);
    p.assignment = sha256(read_text(chain.source / "assignment.toml").value_or(""));
    p.toolchain = chain.description, p.flags = chain.compile;
    p.built_for = chain.processor, p.processor = name_of_processor();
    return p;
}

std::string hash_of(const std::vector<Check>& checks) {
    std::string text;
    for (const Check& check : checks) {
        text += fmt::format("{} {} {}\n", check.fragment, check.name, check.share);
        if (const auto* render = std::get_if<Render>(&check.experiment))
            text += fmt::format("{} {} {} {}\n{}\n", render->samples, render->sampler, render->size.x, render->size.y,
                                render->scene);
        for (const Statistic& s : check.statistics)
            text += fmt::format("{} {} {} {:.6g} {:.6g} {}\n", s.id, s.what,
                                s.truth ? fmt::format("{:.6g}", *s.truth) : "-", s.delta0, s.delta, s.exact);
    }
    return sha256(text);
}

std::string hash_of(const std::map<std::string, std::string>& texts, const Assignment& assignment) {
    std::string lines;
    for (const Fragment& fragment : assignment.fragments)
        if (const auto text = texts.find(fragment.name); text != texts.end() && !fragment.given)
            lines += fmt::format("{}  {}.cpp\n", sha256(text->second), fragment.name);
    return sha256(lines);
}

std::string now() {
    const std::time_t time = std::time(nullptr);
    std::tm parts{};
    gmtime_r(&time, &parts);
    char text[32];
    return {text, std::strftime(text, sizeof text, "%Y-%m-%dT%H:%M:%SZ", &parts)};
}

}  // namespace grade
