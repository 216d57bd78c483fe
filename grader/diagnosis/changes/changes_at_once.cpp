#include "diagnosis/calls/expressions.h"
#include "diagnosis/changes/changes_made.h"
#include "textbook/functions.h"

namespace grade {

void Changes::add_joint() {
    std::vector<std::vector<std::size_t>> groups;
    for (const std::size_t i : vectors_) {
        const std::string owner = name(i).substr(0, name(i).rfind('.'));
        if (owner == name(i)) continue;
        if (groups.empty() || name(groups.back().front()).substr(0, name(groups.back().front()).rfind('.')) != owner)
            groups.emplace_back();
        groups.back().push_back(i);
    }
    for (auto group : groups) {
        // a place is no direction
        std::erase_if(group, [&](std::size_t i) { return name(i).ends_with("center") || name(i).ends_with("eye"); });
        if (group.size() < 2) continue;
        const std::string first = name(group.front());
        std::string names = "`" + first + "`", same = ", and the same for ";
        for (std::size_t k = 1; k < group.size(); ++k) {
            names += ", `" + name(group[k]) + "`";
            same += (k == 1 ? "`" : k + 1 == group.size() ? " and `" : ", `") + name(group[k]) + "`";
        }
        for (const VectorFunction& f : vector_functions) {
            if (f.cost > 1.3) continue;
            add(in_place(filled(f.words, first), first) + same, f.cost + 0.3, [group, f](Row& row, const Layout& l) {
                for (const std::size_t i : group) put(row, l.parts[i].at, f.value(vector_at(row, l.parts[i].at)));
                return true;
            });
        }
        if (group.size() < 3) continue;
        const auto add_axes = [&](std::size_t count, const std::string& words, double cost) {
            add(words, cost, [group, count](Row& row, const Layout& l) {
                for (std::size_t k = 0; k < count; ++k) put(row, l.parts[group[k]].at, vec3(k == 0, k == 1, k == 2));
                return true;
            });
        };
        add_axes(3, fmt::format("the axes of the world in place of {}", names), 1.2);
        add_axes(2, fmt::format("the world's x and y in place of `{}` and `{}`", name(group[0]), name(group[1])), 1.25);
    }
}

void Changes::add_pairs() {
    for (std::size_t i = 0; i < layout_.parts.size(); ++i) {
        if (!is_told(i) || layout_.parts[i].kind != Kind::pair) continue;
        for (std::size_t j = 0; j < layout_.parts.size(); ++j) {
            if (layout_.parts[j].kind != Kind::pair) continue;
            for (const Function& f : pair_functions) {
                if (i != j && f.cost > 1.6) continue;
                // what stands in the formula in their place says more
                const double unusual = i == j && name(i) == "u" ? 0.5 : 0;
                add(filled(f.words, name(j)), name(i), f.cost + unusual + (i != j ? 0.2 : 0),
                    [i, j, f](Row& row, const Layout& l) {
                        for (std::size_t c = 0; c < 2; ++c) row[l.parts[i].at + c] = f.value(row[l.parts[j].at + c]);
                        return true;
                    });
            }
        }
    }
}

void Changes::add_lists() {
    if (layout_.lists.empty() || layout_.lists.front().stride == 0) return;
    for (const bool first : {true, false})
        add(first ? "the first element left out" : "the last element left out", 1.2,
            [first](Row& row, const Layout& l) {
                for (auto list = l.lists.rbegin(); list != l.lists.rend(); ++list) {
                    if (list->count < 1 || list->stride == 0) return false;
                    const auto start =
                        row.begin() + std::ptrdiff_t(list->at + 1 + (first ? 0 : (list->count - 1) * list->stride));
                    row.erase(start, start + std::ptrdiff_t(list->stride));
                    row[list->at] -= 1;
                }
                return true;
            });
    for (std::size_t which = 0; which < layout_.lists.size(); ++which)
        for (const Function& f : scalar_functions) {
            if (f.cost > 1.3) continue;
            const std::string each = layout_.lists[which].name + "[k]";
            add(filled(f.words, each), each, f.cost + 0.2, [which, f](Row& row, const Layout& l) {
                const List& list = l.lists[which];
                for (std::size_t k = 0; k < list.count * list.stride; ++k)
                    row[list.at + 1 + k] = f.value(row[list.at + 1 + k]);
                return true;
            });
        }
}

}  // namespace grade
