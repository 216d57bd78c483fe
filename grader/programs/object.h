#pragma once

#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace grade {

/// What the grader reads of an object that a compiler has made of a student's source.
struct ObjectFile {
    std::vector<std::string> sections;
    std::vector<std::string> defined;  // symbols for others, the first 500 characters of each
    bool runs_while_loaded = false;    // has a function that chooses another when the program is loaded (ifunc)
};

struct BadObject : std::runtime_error {
    using std::runtime_error::runtime_error;
};

/// Reads the tables of an ELF object of this kind of machine, and nothing that they point to. Throws BadObject where
/// they lead out of it, or it is something else.
ObjectFile read_object(std::string_view bytes);

/// Why an object goes no further: no tool reads one that holds what a compiler does not make of a fragment. Empty: it
/// does.
std::string object_fault(const ObjectFile& object);

}  // namespace grade
