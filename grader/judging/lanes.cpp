#include "judging/lanes.h"

#include <map>

namespace grade {

std::vector<Lane> lanes_of(const std::vector<Task>& tasks) {
    std::vector<Lane> lanes;
    std::map<const FragmentRecord*, std::vector<std::size_t>> own;
    std::map<const FragmentRecord*, std::size_t> seen;
    for (const Task& task : tasks) {
        std::vector<std::size_t>& two = own[task.fragment];
        const std::size_t which = seen[task.fragment]++ % 2;
        if (two.size() == which) two.push_back(lanes.size()), lanes.emplace_back();
        lanes[two[which]].tasks.push_back(task);
    }
    return lanes;
}

}  // namespace grade
