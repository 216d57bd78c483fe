#pragma once

#include "diagnosis/changes/relation.h"

namespace grade {

constexpr std::size_t most_of_textbook = 400'000;  // answers of forms that one explanation may take

/// A mistake in one expression of a textbook's form of the fragment, by which it answers as the calls do: in all of
/// them, or in many of the wrong ones. None: none was found, or no form is the solution in these calls.
///
/// sampled  other random numbers give as good an answer; no mistake: a form that samples so gives these answers
/// left     answers of forms that it may take, of most_of_textbook
std::optional<Relation> relation_of_textbook(const Calls& calls, bool sampled, std::size_t& left);

/// A form that is wrong as a whole, whose answers are these in all calls that are wrong.
std::optional<Relation> known_mistake(const Calls& calls, bool sampled);

/// Two mistakes, of which one may be a change of an argument.
std::optional<Relation> two_of_textbook(const Calls& calls, std::size_t& left);

}  // namespace grade
