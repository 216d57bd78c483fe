#include "textbook/form.h"

#include "textbook/hidden.h"

namespace grade::textbook {

std::vector<Form> read_forms(std::span<const unsigned char> texts, std::span<const std::uint32_t> numbers,
                             std::vector<Compiled> codes) {
    std::string shown_texts;
    for (const unsigned char c : texts) shown_texts += shown(c);
    std::size_t at = 0;
    const auto text = [&] { return std::string(&shown_texts[numbers[at++]]); };
    std::vector<Form> all;
    int first = 0;
    for (Compiled& code : codes) {
        Form form{text(),
                  text(),
                  numbers[at++] != 0,
                  first,
                  std::vector<Node>(numbers[at++]),
                  std::move(code.answer),
                  {},
                  code.begin,
                  code.end};
        for (std::uint32_t left = numbers[at++]; left > 0; --left) form.calls.insert(text());
        for (Node& node : form.nodes) {
            node.text = text(), node.name = text(), node.context = text(), node.function = text();
            node.parts.resize(numbers[at++]);
            for (int& part : node.parts) part = int(numbers[at++]);
            node.alternatives.resize(numbers[at++]);
            for (std::string& alternative : node.alternatives) alternative = text();
        }
        first += int(form.nodes.size());
        all.push_back(std::move(form));
    }
    return all;
}

}  // namespace grade::textbook
