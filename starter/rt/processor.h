#pragma once

/// The processors that a program is built for: RT_MARCH in cmake/flags.cmake. Nobody needs this file for the
/// assignment.
namespace rt {

/// Whether this processor is of a kind, "x86-64-v3", say, or better. "" is any.
bool processor_is(const char* kind);

/// Ends the program with a sentence and exit code 3 where this processor is not of the kind that the program is built
/// for. A program that calls this anywhere does so before all else, even the initialisers of its libraries.
void require_processor();

}  // namespace rt
