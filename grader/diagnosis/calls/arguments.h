#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "checks/kit/check.h"

/// What the numbers of a row are, in the words of fragments.h.
namespace grade {

enum class Kind { number, whole, flag, choice, vector, color, pair, whole_pair };
std::size_t size_of(Kind kind);

/// An argument, or a field of one: "camera.tan_half_fov"; of a result, "direction", or nothing where it is no struct.
struct Field {
    std::string name;
    Kind kind = Kind::number;
    std::size_t at = 0;  // its first number in the row
};

/// An argument that is a list of elements of one size.
struct List {
    std::string name;
    std::size_t at = 0, count = 0, stride = 0;  // at: where its count stands
};

/// What a row holds. All rows of a fragment have the same parts in the same order.
struct Layout {
    std::vector<Field> parts;
    std::vector<List> lists;      // stride 0: strata
    std::vector<Field> formulas;  // functions: where they stand; the kind says nothing
};

/// The declaration of a fragment.
struct Signature {
    struct Argument {
        std::string type, name;
    };
    std::string fragment, result;
    std::vector<Argument> arguments;

    /// Throw std::out_of_range for a row that is too short.
    Layout of_arguments(const Row& row) const;
    Layout of_result(const Row& row) const;

    /// A row of defaults. Lists are empty.
    Row blank() const;
};

/// From the text of fragments.h, which has one declaration a line. None: it declares no such fragment.
std::optional<Signature> signature_of(const std::string& fragment, const std::string& header);

/// "Emitter::Kind", and the names of its values; none for what is no choice.
std::string choice_type(const Field& part);
const std::vector<std::string>& choices_of(const Field& part);

/// The types that are structs, with fields; whether one is.
std::vector<std::string> structures();
bool is_structure(const std::string& type);

/// A function's formula, as Integrand has it, whose parameters stand there.
std::string formula_in_words(const Row& row, std::size_t at, const std::function<std::string(double)>& number);

/// x, to so many digits; inf where that is too large for a number.
double rounded(double x, int digits);

/// "0.5", "inf", "1e-06"; digits 0: as many as it takes.
std::string number_in_words(double x, int digits = 6);

/// "(0, 0.5, 1)", "true", "disc"
std::string value_in_words(const Field& part, const Row& row, int digits = 6);

/// How arguments are printed.
struct Printing {
    std::vector<bool> told{};    // by part; what is not told is left out
    std::vector<bool> always{};  // by part; what is told always, is told at its default as well
    int digits = 6;              // of numbers; 0: as many as it takes
};

/// "camera.size = (2, 2), film = (0, 0)"; parts that are not told, and those at their defaults, are left out.
std::string arguments_in_words(const Signature& signature, const Row& row, const Printing& printing = {});

/// The call as C++ that can be pasted: what is not at its default is set. Empty where a list is too long.
std::string call_in_code(const Signature& signature, const Row& row);

/// Whether arguments_from_words can read them: there is no list and no function.
bool are_readable(const Signature& signature);

/// The inverse: what is not named has its default. Throws std::invalid_argument with what is wrong.
Row arguments_from_words(const Signature& signature, const std::string& words);

/// "direction = (0, 0, 1), density = 0.25", of what a fragment returns; told: by part.
std::string result_in_words(const Signature& signature, const Row& output, const std::vector<bool>& told = {});

}  // namespace grade
