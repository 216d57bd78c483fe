#pragma once

#include "rt/stages/stages.h"

/// Which lanes go on in which way, and their rays. Nobody needs this file for the assignment.
namespace rt {

/// The lanes that go on in one way, and what each carries on.
struct Leaving {
    int count = 0;
    Index lane[lanes];
    Colors weight;

    void add(int i, Color w) { lane[count] = i, weight.set(count++, w); }
};

/// Of each way.
struct AllLeaving {
    Leaving by_way[5];

    Leaving& operator[](WayOn way) { return by_way[int(way)]; }
    const Leaving& operator[](WayOn way) const { return by_way[int(way)]; }
    void clear() {
        for (Leaving& way : by_way) way.count = 0;
    }
};

/// Sends the rays of the lanes that go on in one way; those that carry anything go to next.
template <WayOn way>
void follow(const Wave& wave, const AllLeaving& leaving, Queue& next, Chunk& chunk);

/// Likewise mirror and glass, where both are followed. Two paths may then add to one sample: their rays go to next lane
/// by lane, so that the order of the sum does not depend on what else is in the batch.
void follow_both(const Wave& wave, const AllLeaving& leaving, Queue& next, Chunk& chunk);

}  // namespace rt
