#include "diagnosis/source/effect.h"

namespace grade {

Effect effect_on(const Calls& calls, const Rows& answers) {
    Effect effect;
    effect.breaks = answers.size() != calls.size();
    for (std::size_t k = 0; k < calls.size() && !effect.breaks; ++k) {
        const bool is_wrong = calls.is_wrong(k), becomes_right = is_answer(calls.result, answers[k], calls.right[k]);
        effect.wrong += is_wrong, effect.put_right += is_wrong && becomes_right;
        effect.breaks = !is_wrong && !becomes_right;
    }
    return effect;
}

}  // namespace grade
