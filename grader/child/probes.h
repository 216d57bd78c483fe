#pragma once

#include <span>
#include <string_view>
#include <vector>

#include "protocol/rows.h"

/// A probe calls one fragment on one row of numbers. The row holds the arguments of the fragment's declaration one
/// after the other, each as rows.h writes its type; the output holds what the fragment returns, and then for each
/// function among the arguments, as an Integrand, three numbers: how often it was called, and the least and greatest x
/// (inf and -inf where it was not called). A span is a list.
///
/// A check builds a row with row(material, fresnel), and reads an output with from_row<rt::Outgoing>(output).
namespace grade {

/// Calls a fragment. Throws std::invalid_argument for a name that is no fragment's, std::out_of_range for a row that is
/// too short, std::domain_error for one with numbers left over.
std::vector<double> probe(std::string_view fragment, std::span<const double> row);

}  // namespace grade
