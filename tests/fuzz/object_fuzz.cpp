#include <cstdint>

#include "programs/object.h"
#include "require.h"

/// An object's tables are read within its bounds, or it is none.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    try {
        const grade::ObjectFile object = grade::read_object({reinterpret_cast<const char*>(data), size});
        for (const std::string& name : object.defined) require(name.size() <= size, "a name longer than the object");
        grade::object_fault(object);
    } catch (const grade::BadObject&) {}
    return 0;
}
