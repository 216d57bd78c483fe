#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <exception>
#include <iostream>
#include <map>
#include <span>
#include <stdexcept>

#include "files/files.h"
#include "textbook/hidden.h"
#include "textbook/wrap.h"

namespace {

using grade::textbook::Wrapped;

/// What form.cpp reads: texts, each of them once, and numbers that say where they stand.
class Tables {
public:
    void add(const Wrapped& form) {
        numbers_.insert(numbers_.end(),
                        {place_of(form.fragment), place_of(form.says), std::uint32_t(form.has_other_order),
                         std::uint32_t(form.nodes.size()), std::uint32_t(form.calls.size())});
        for (const std::string& other : form.calls) numbers_.push_back(place_of(other));
        for (const auto& node : form.nodes) {
            for (const std::string& text : {node.text, node.name, node.context, node.function})
                numbers_.push_back(place_of(text));
            numbers_.push_back(std::uint32_t(node.parts.size()));
            for (const int part : node.parts) numbers_.push_back(std::uint32_t(part));
            numbers_.push_back(std::uint32_t(node.alternatives.size()));
            for (const std::string& text : node.alternatives) numbers_.push_back(place_of(text));
        }
    }

    std::string code() const {
        std::string texts, numbers;
        for (const char c : texts_) texts += fmt::format("{},", int(grade::textbook::hidden(c)));
        for (const std::uint32_t n : numbers_) numbers += fmt::format("{},", n);
        return fmt::format("constexpr unsigned char texts[] = {{{}}};\nconstexpr std::uint32_t numbers[] = {{{}}};\n",
                           texts, numbers);
    }

private:
    std::uint32_t place_of(const std::string& text) {
        const auto [found, is_new] = places_.emplace(text, std::uint32_t(texts_.size()));
        if (is_new) texts_ += text + '\0';
        return found->second;
    }

    std::map<std::string, std::uint32_t> places_;
    std::string texts_;
    std::vector<std::uint32_t> numbers_;
};

/// "sphere, ray" of "Real hit_sphere(const Sphere& sphere, const Ray& ray)"
std::string parameters_of(const Wrapped& form) {
    std::string all;
    for (std::size_t at = form.head.find('('), next; at != form.head.size() - 1; at = next) {
        next = std::min(form.head.find(',', at + 1), form.head.size() - 1);
        const std::size_t name = form.head.rfind(' ', next) + 1;
        all += (all.empty() ? "" : ", ") + form.head.substr(name, next - name);
    }
    return all;
}

std::string code_of(const std::vector<Wrapped>& forms) {
    std::string declared, defined, listed;
    std::map<std::string, std::size_t> first;
    for (std::size_t i = 0; i < forms.size(); ++i) {
        defined += fmt::format("namespace form_{} {{\nstatic {} {}\n}}\n", i, forms[i].head, forms[i].code);
        if (first.emplace(forms[i].fragment, i).second) declared += "[[maybe_unused]] static " + forms[i].head + ";\n";
    }
    for (const auto& [name, i] : first)
        defined += fmt::format(
            "namespace any {{\nstatic thread_local auto* {0}_now = &form_{1}::{0};\n[[maybe_unused]] static {2} {{\n"
            "auto* const now = {0}_now;\nconst textbook::Restored restored({0}_now, &form_{1}::{0});\n"
            "return now({3});\n}}\n}}\n",
            name, i, forms[i].head, parameters_of(forms[i]));
    Tables tables;
    for (std::size_t i = 0; i < forms.size(); ++i) {
        tables.add(forms[i]);
        listed += fmt::format(
            "{{caller(rt::form_{0}::{1}), [] {{ rt::any::{1}_now = &rt::form_{0}::{1}; }}, "
            "[] {{ rt::any::{1}_now = &rt::form_{2}::{1}; }}}},\n",
            i, forms[i].fragment, first.at(forms[i].fragment));
    }
    return fmt::format(
        "#pragma GCC diagnostic ignored \"-Wunused-parameter\"\n#include \"protocol/caller.h\"\n"
        "#include \"rt/fragments.h\"\n#include \"textbook/form.h\"\n\nnamespace rt {{\n"
        "namespace textbook = grade::textbook;\nnamespace any {{\n{}}}\n{}}}\n\nnamespace grade::textbook "
        "{{\n\nnamespace {{\n{}}}\n\nconst std::vector<Form>& forms() {{\n    static const std::vector<Form> all = "
        "read_forms(texts, numbers, {{\n{}}});\n    return all;\n}}\n\n}}\n",
        declared, defined, tables.code(), listed);
}

}  // namespace

/// wrap_forms OUT FORM... : writes forms.cpp, for form.h, of files with a function each; of those of one fragment, the
/// first is what other fragments call.
int main(int argc, char** argv) try {
    std::vector<std::string> fragments;
    std::vector<Wrapped> forms;
    for (const bool is_again : {false, true}) {  // which names are fragments', is known after the first time
        forms.clear();
        int node = 0;
        for (const std::string file : std::span(argv + std::min(argc, 2), argv + argc)) {
            const auto text = grade::read_text(file);
            if (!text) throw std::runtime_error(file + ": cannot be read; expected a file with a function");
            forms.push_back(grade::textbook::wrap(file, *text, fragments, node));
            node += int(forms.back().nodes.size());
        }
        for (const Wrapped& form : forms) fragments.push_back(form.fragment);
        if (is_again) grade::write_text(argv[1], code_of(forms));
    }
    return 0;
} catch (const std::exception& error) {
    std::cerr << error.what() << "\n";
    return 2;
}
