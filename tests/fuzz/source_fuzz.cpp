#include <algorithm>
#include <cstdint>
#include <stdexcept>
#include <string>

#include "require.h"
#include "textbook/expressions.h"
#include "textbook/source.h"

/// A student's source is read for the diagnosis, or refused: its expressions stand in lines that it has.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::string text(reinterpret_cast<const char*>(data), size);
    try {
        const auto source = grade::textbook::editable(text);
        const auto lines = 1 + std::count(text.begin(), text.end(), '\n');
        for (const auto& node : source.nodes)
            require(node.line >= 1 && node.line <= lines && !node.text.empty(), "an expression in no line");
    } catch (const std::runtime_error&) {
    } catch (const grade::textbook::TooLong&) {}
    return 0;
}
