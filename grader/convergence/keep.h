#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <vector>

#include "files/files.h"
#include "rt/files/image.h"

namespace grade {

/// A result as it is kept: a line of JSON, then pictures as the machine has them.
struct KeptResult {
    nlohmann::ordered_json head;
    std::vector<rt::Image> images;
};

/// Throws std::runtime_error.
void write_kept(const fs::path& path, const KeptResult& kept);

/// None: there is no such file, or it is not whole.
std::optional<KeptResult> read_kept(const fs::path& path);

}  // namespace grade
