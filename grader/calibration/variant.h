#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace grade::calibration {

namespace fs = std::filesystem;

/// One of the solution's fragments, changed: wrong, or right in another way. A patch whose first lines say what it is:
///
///     # 31 no surface cosine
///     # fragment: direct_light
///     # says: cos|n . d             words of which the first hint must hold one
///     # scene: scenes/sun.toml      where what is confined shows
///     # doses: 0.001 0.002 0.005    put in place of the word DOSE, one after the other
struct Variant {
    enum class Kind { right, wrong, dose, confined };
    Kind kind = Kind::right;
    std::string name;  // "wrong/31_no_surface_cosine": its path
    std::string what;  // its first line
    std::string fragment;
    std::vector<std::string> says, doses;
    std::string scene;
    std::string patch;  // the whole file
};

/// Every patch of tests/variants, by folder, those with numbers in their order. Throws rt::InputError for a patch that
/// lacks its head.
std::vector<Variant> read_variants(const fs::path& folder);

/// The fragment's text with the change.
///
/// source  the project's folder
/// dose    for a patch that has doses
/// Throws rt::InputError where the patch does not apply any more.
std::string changed_text(const Variant& variant, const fs::path& source, const std::string& dose = {});

}  // namespace grade::calibration
