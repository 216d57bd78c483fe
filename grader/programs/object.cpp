#include "programs/object.h"

#include <elf.h>
#include <fmt/format.h>

#include <algorithm>
#include <cstring>

namespace grade {

namespace {

[[noreturn]] void broken(const char* what) { throw BadObject(fmt::format("no object that can be read: {}", what)); }

template <class Entry>
Entry entry_at(std::string_view bytes, std::uint64_t offset) {
    if (offset > bytes.size() || bytes.size() - offset < sizeof(Entry)) broken("a table leads out of it");
    Entry entry;
    std::memcpy(&entry, bytes.data() + offset, sizeof entry);
    return entry;
}

std::string_view part(std::string_view bytes, const Elf64_Shdr& section) {
    if (section.sh_type == SHT_NOBITS) return {};
    if (section.sh_offset > bytes.size() || bytes.size() - section.sh_offset < section.sh_size)
        broken("a section leads out of it");
    return bytes.substr(section.sh_offset, section.sh_size);
}

std::string_view name_at(std::string_view names, std::uint64_t offset) {
    if (offset >= names.size()) broken("a name leads out of it");
    const std::size_t end = names.find('\0', offset);
    if (end == names.npos) broken("a name without an end");
    return names.substr(offset, end - offset);
}

/// Sections that compilers make of C++, whole names; and those of which each function and variable may have one.
constexpr std::string_view whole[] = {"",
                                      ".group",
                                      ".symtab",
                                      ".symtab_shndx",
                                      ".strtab",
                                      ".shstrtab",
                                      ".comment",
                                      ".eh_frame",
                                      ".note.GNU-stack",
                                      ".note.gnu.property",
                                      ".init_array",
                                      ".fini_array",
                                      ".llvm_addrsig",
                                      "asan_globals",
                                      ".linker-options"};
constexpr std::string_view begun[] = {
    ".text",       ".rodata",     ".data",    ".bss",   ".tdata", ".tbss", ".gcc_except_table",
    ".init_array", ".fini_array", ".lrodata", ".ldata", ".lbss"};

bool is_begun(std::string_view name, std::string_view begin) {
    return name.starts_with(begin) && (name.size() == begin.size() || name[begin.size()] == '.');
}

bool is_usual(std::string_view name) {
    for (const std::string_view relocations : {".rela", ".rel"})
        if (name.starts_with(relocations) && name.size() > relocations.size())
            return is_usual(name.substr(relocations.size()));
    return std::ranges::count(whole, name) > 0 || name.starts_with(".debug_") ||
           std::ranges::any_of(begun, [&](std::string_view begin) { return is_begun(name, begin); });
}

}  // namespace

ObjectFile read_object(std::string_view bytes) {
    constexpr std::size_t most_sections = 20'000, longest_name = 500;
    const auto head = entry_at<Elf64_Ehdr>(bytes, 0);
    if (std::memcmp(head.e_ident, ELFMAG, SELFMAG) != 0 || head.e_ident[EI_CLASS] != ELFCLASS64 ||
        head.e_type != ET_REL)
        broken("it is of another kind");
    if (head.e_shentsize != sizeof(Elf64_Shdr) || head.e_shnum == 0 || head.e_shnum > most_sections ||
        head.e_shstrndx >= head.e_shnum)
        broken("its table of sections");
    std::vector<Elf64_Shdr> sections;
    for (std::uint64_t i = 0; i < head.e_shnum; ++i)
        sections.push_back(entry_at<Elf64_Shdr>(bytes, head.e_shoff + i * sizeof(Elf64_Shdr)));
    const std::string_view names = part(bytes, sections[head.e_shstrndx]);

    ObjectFile object;
    for (const Elf64_Shdr& section : sections) {
        object.sections.emplace_back(name_at(names, section.sh_name).substr(0, longest_name));
        if (section.sh_type != SHT_SYMTAB) continue;
        if (section.sh_link >= sections.size()) broken("its table of symbols");
        const std::string_view symbols = part(bytes, section), words = part(bytes, sections[section.sh_link]);
        for (std::size_t at = 0; at + sizeof(Elf64_Sym) <= symbols.size(); at += sizeof(Elf64_Sym)) {
            const auto symbol = entry_at<Elf64_Sym>(symbols, at);
            object.runs_while_loaded |= ELF64_ST_TYPE(symbol.st_info) == STT_GNU_IFUNC;
            if (ELF64_ST_BIND(symbol.st_info) == STB_LOCAL || symbol.st_shndx == SHN_UNDEF) continue;
            object.defined.emplace_back(name_at(words, symbol.st_name).substr(0, longest_name));
        }
    }
    return object;
}

std::string object_fault(const ObjectFile& object) {
    for (const std::string& name : object.sections)
        if (!is_usual(name))
            return fmt::format(
                "a section {} is made in it; a fragment is C++, without asm and without section attributes", name);
    if (object.runs_while_loaded)  // before child/main.cpp has locked the program in
        return "a function of it runs while the program is loaded (ifunc); a fragment is C++, without such attributes";
    return {};
}

}  // namespace grade
