#include "hand_out/gradescope.h"

#include <fmt/format.h>

#include "files/files.h"
#include "submission/archive.h"

namespace grade {

void write_gradescope(const fs::path& project, const fs::path& kit, std::uint64_t seed, const fs::path& zip) {
    const fs::path scripts = project / "grader/kit/gradescope";
    const TemporaryFolder work;
    write_text(work.path() / "seed", fmt::format("{}\n", seed));
    write_zip(zip, {{"setup.sh", scripts / "setup.sh"},
                    {"run_autograder", scripts / "run_autograder"},
                    {"seed", work.path() / "seed"},
                    {"kit", kit}});
}

}  // namespace grade
