#include "textbook/wrap.h"

#include "textbook/statements.h"

namespace grade::textbook {

namespace {

class FormReader : StatementReader {
public:
    FormReader(const std::string& file, const std::string& text, const std::vector<std::string>& fragments, int first)
        : StatementReader(file, text, fragments, first) {}

    Wrapped run() {
        Wrapped all;
        const std::size_t start = at_;
        std::size_t name = at_;
        while (!is("(")) {
            if (now().kind == Token::Kind::end) fail("no function; expected one");
            name = at_++;
        }
        all.fragment = tokens_[name].text;
        skip_to({"{"});
        all.head = joined(start, at_);
        count_uses();
        all.code = block();
        all.nodes = std::move(nodes_), all.calls = std::move(calls_);
        return all;
    }
};

}  // namespace

Wrapped wrap(const std::string& file, const std::string& text, const std::vector<std::string>& fragments, int first) {
    Wrapped all = FormReader(file, text, fragments, first).run();
    for (const std::string_view says : {"// says: ", "// says, reordered: "})
        if (text.starts_with(says)) all.says = text.substr(says.size(), text.find('\n') - says.size());
    all.has_other_order = text.starts_with("// says, ");
    return all;
}

}  // namespace grade::textbook
