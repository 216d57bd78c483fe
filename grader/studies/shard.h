#pragma once

#include <fmt/format.h>

#include <cstdio>
#include <string>

#include "rt/files/scene_reader.h"

namespace grade {

/// One of several parts of the work, from 0; all: the whole.
struct Shard {
    int which = 0, all = 1;
};

/// "2/4": the second of four. Throws rt::InputError.
inline Shard shard_of(const std::string& text) {
    int which = 0, all = 0, length = 0;
    if (std::sscanf(text.c_str(), "%d/%d%n", &which, &all, &length) != 2 || length != int(text.size()) || which < 1 ||
        which > all)
        throw rt::InputError(fmt::format("--shard {}: not a part of a whole; expected one like 2/4", text));
    return {which - 1, all};
}

}  // namespace grade
