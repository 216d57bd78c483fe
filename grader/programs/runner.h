#pragma once

#include <algorithm>
#include <memory>
#include <numeric>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "checks/kit/check.h"
#include "programs/process.h"
#include "programs/sandbox.h"
#include "protocol/protocol.h"
#include "protocol/swarm.h"
#include "statistics/verdict.h"

namespace grade {

/// Why there is nothing to measure.
struct Fault {
    Verdict verdict;      // crashed, timed_out, not_finite or failed
    std::string message;  // what happened, and what to do
    std::string excerpt;  // of what the program printed; untrusted
    Trouble trouble = Trouble::none;
};

template <class Value>
using Outcome = std::variant<Value, Fault>;

/// A child program that is running: renders and answers probes until it breaks down.
class Runner {
public:
    /// program  linked by link_child
    /// meshes   where scenes look for meshes
    /// seconds  CPU time for one answer
    /// checked  by sanitizers, which need any number of addresses, and have more to say
    Runner(const fs::path& program, const Sandbox& sandbox, const fs::path& meshes, double seconds,
           bool checked = false);

    /// one_of_many  a replicate: one sample a pixel is random then, too
    /// Throws rt::InputError for a scene that is none.
    Outcome<rt::Image> render(const Render& experiment, std::uint64_t seed, bool one_of_many = true);
    /// What each fragment answers along the paths of a pixel of that picture. Untrusted text.
    Outcome<std::string> trace(const Render& experiment, std::uint64_t seed, rt::ivec2 pixel);
    Outcome<Rows> probe(const std::string& fragment, const Rows& rows);
    /// Calls as textbook::row_of makes them, of a program whose expressions can be changed; each answer has at most so
    /// many numbers.
    Outcome<Rows> edited(const std::string& fragment, const Rows& calls, std::size_t most_results);

    /// Calls whose arguments the child makes up.
    Outcome<std::vector<double>> swarm(const SwarmRequest& request);

    /// CPU time of the last answer, by the child's own account, and no longer than the answer took.
    double seconds() const { return last_seconds_; }

    /// What all answers have taken since the count began, also one that did not come: their CPU time or, where that is
    /// more, the time by the clock without what the program, and the grader here, waited for a processor.
    double seconds_in_all();
    void begin_count();

    /// Whether an answer has ever come.
    bool has_answered() const { return has_answered_; }

    /// Rays of all kinds in the last picture, likewise.
    double rays() const { return std::accumulate(last_rays_.begin(), last_rays_.end(), 0.0); }
    const std::vector<double>& rays_of_each_kind() const { return last_rays_; }

private:
    struct Answer;
    Outcome<Rows> answers(FrameKind kind, const std::string& fragment, const Rows& rows, std::size_t most_results);
    Outcome<std::vector<double>> ask(const std::string& request, int kind, std::size_t most_numbers);
    std::optional<Fault> tell(const std::string& request);
    std::optional<Fault> show(const Render& experiment);
    Outcome<Answer> exchange(const std::string& request, std::size_t most_bytes);
    Outcome<Answer> exchange_once(const std::string& request, std::size_t most_bytes);
    Fault broken();
    static Fault thrown(const std::string& what);
    double patience() const { return 3 * limit_ + 2; }  // wall time for one answer

    fs::path meshes_;
    double limit_;
    std::size_t most_shown_;
    std::unique_ptr<Process> process_;
    std::string scene_, fragment_;  // what the child was told last
    rt::ivec2 size_{0};             // of that scene's image
    double last_seconds_ = 0, exchange_seconds_ = 0, answers_seconds_ = 0;
    Times spent_{}, spent_before_{};  // at the last look; as the count began
    double own_delay_before_ = 0;
    bool has_answered_ = false;
    std::vector<double> last_rays_;
};

}  // namespace grade
