#pragma once

#include <map>
#include <string>

#include "checks/kit/check.h"
#include "programs/toolchain.h"
#include "record/record.h"

namespace grade {

/// All that stays the same over the gradings of one process: but for the checks, which the seed makes.
Provenance find_provenance(const Toolchain& chain);

/// Of what is asked: scenes, samples, statistics with what must come out and how far off it may be.
std::string hash_of(const std::vector<Check>& checks);

/// Of the lines "HASH  NAME.cpp", as sha256sum prints them, of the texts in the order of the assignment.
std::string hash_of(const std::map<std::string, std::string>& texts, const Assignment& assignment);

/// As /proc/cpuinfo has it.
std::string name_of_processor();

/// "2026-01-31T12:00:00Z"
std::string now();

}  // namespace grade
