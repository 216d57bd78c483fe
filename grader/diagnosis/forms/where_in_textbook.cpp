#include "diagnosis/forms/where_in_textbook.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <map>
#include <memory>

#include "diagnosis/forms/asked.h"

namespace grade {

namespace {

bool has_word(const std::string& text, const std::string& word) {
    const auto is_letter = [&](std::size_t i) {
        return i < text.size() && (std::isalnum(static_cast<unsigned char>(text[i])) || text[i] == '_');
    };
    for (std::size_t at = text.find(word); at != text.npos; at = text.find(word, at + 1))
        if (!is_letter(at - 1) && !is_letter(at + word.size())) return true;
    return false;
}

/// The number variables of a form that every call computes, as arguments behind the call's.
class Variables {
public:
    Variables(const textbook::Form& form, Asked& asked, const Calls& calls) : asked_(asked) {
        for (std::size_t i = 0; i < form.nodes.size(); ++i)
            if (std::string_view(form.nodes[i].name) != form.nodes[i].text)
                nodes_.push_back(i), names_.push_back({"Real", form.nodes[i].name}),
                    formulas_.emplace(form.nodes[i].name, form.nodes[i].text);
        for (std::size_t k = 0; k < calls.size(); ++k) {
            take(calls.rows[k], calls.layouts[k]);
            for (std::size_t i = nodes_.size(); i-- > 0;)
                if (textbook::watch.values[nodes_[i]].kind != textbook::Value::Kind::number)
                    nodes_.erase(nodes_.begin() + std::ptrdiff_t(i)), names_.erase(names_.begin() + std::ptrdiff_t(i));
        }
    }

    const std::vector<Signature::Argument>& names() const { return names_; }

    Row take(Row row, const Layout& layout) const {
        asked_.answer(row, layout);
        for (const std::size_t i : nodes_) row.push_back(textbook::watch.values[i].x[0]);
        return row;
    }

    /// ", with `c = dot(f, f)`, and `f = a - b`" of those among the numbers that are variables, and of what these are
    /// made of.
    std::string formulas_of(std::vector<std::string> numbers) const {
        std::string all;
        for (std::size_t i = 0; i < numbers.size(); ++i) {
            const auto found = formulas_.find(numbers[i]);
            if (found == formulas_.end()) continue;
            all += fmt::format(", {} `{} = {}`", all.empty() ? "with" : "and", found->first, found->second);
            for (const auto& [name, formula] : formulas_)
                if (has_word(found->second, name) && std::ranges::count(numbers, name) == 0) numbers.push_back(name);
        }
        return all;
    }

private:
    Asked& asked_;
    std::vector<std::size_t> nodes_;
    std::vector<Signature::Argument> names_;
    std::map<std::string, std::string> formulas_;  // of all variables
};

/// In the variables of a form; none: they do not.
std::optional<WrongCalls> of_variables(const Calls& calls) {
    for (const textbook::Form& form : textbook::forms()) {
        if (form.fragment != calls.signature.fragment || !form.says.empty()) continue;
        const auto asked = std::make_shared<Asked>(form);
        const auto variables = std::make_shared<Variables>(form, *asked, calls);
        if (variables->names().empty()) continue;
        Calls all = calls;
        all.signature.arguments.insert(all.signature.arguments.end(), variables->names().begin(),
                                       variables->names().end());
        for (std::size_t k = 0; k < calls.size(); ++k) {
            all.rows[k] = variables->take(calls.rows[k], calls.layouts[k]);
            all.layouts[k] = all.signature.of_arguments(all.rows[k]);
        }
        WrongCalls region = where_wrong(all, false);
        const std::string formulas = variables->formulas_of(region.numbers);
        if (!region.is_exact || formulas.empty()) continue;
        region.words += formulas;
        region.holds = [holds = region.holds, asked, variables, signature = all.signature](
                           const Row& row, const Layout& layout, const Row& right) {
            const Row with_variables = variables->take(row, layout);
            return holds(with_variables, signature.of_arguments(with_variables), right);
        };
        return region;
    }
    return std::nullopt;
}

}  // namespace

WrongCalls region_of(const Calls& calls, bool is_known) {
    WrongCalls region = where_wrong(calls);
    if (is_known || (region.is_exact && !region.of_answers)) return region;
    return of_variables(calls).value_or(region);
}

}  // namespace grade
