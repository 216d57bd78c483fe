#include <sys/mman.h>
#include <unistd.h>

#include <cstdint>
#include <string>

#include "require.h"
#include "submission/archive.h"
#include "submission/submission.h"

/// A file is a submission whose fragments are short and whose names stay within it, or an error that says why it is
/// none.
namespace {

const std::vector<std::string> fragments = {"camera_ray", "hit_sphere", "phong", "uniform_disk"};

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    static const int file = memfd_create("submission", MFD_CLOEXEC);
    static const std::string path = "/proc/self/fd/" + std::to_string(file);
    require(ftruncate(file, 0) == 0 && pwrite(file, data, size, 0) == ssize_t(size), "no memory");
    try {
        const grade::Found found = grade::look_into_archive(path, fragments, "starter");
        for (const auto& [name, text] : found.texts) {
            require(text.size() <= grade::most_source_bytes, "a fragment that is too long");
            require(!name.starts_with("/") && !name.starts_with(".."), "a name that leads out of the archive");
        }
        const grade::Submission submission = grade::read_submission(path, fragments);
        require(submission.texts.size() + submission.complaints.size() > 0, "a submission of nothing");
        require(submission.notes.size() < 50'000, "too many notes");
    } catch (const grade::SubmissionError&) {}
    return 0;
}
