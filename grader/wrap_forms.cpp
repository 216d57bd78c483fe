#include <fmt/format.h>

#include <exception>
#include <filesystem>
#include <iostream>
#include <map>

#include "files/files.h"
#include "textbook/wrap.h"

namespace {

namespace fs = std::filesystem;
using grade::textbook::Wrapped;

/// As a literal.
std::string quoted(const std::string& text) { return "\"" + text + "\""; }

std::string as_code(const grade::textbook::WrappedNode& node) {
    std::string alternatives;
    for (const std::string& one : node.alternatives) alternatives += quoted(one) + ", ";
    std::string parts;
    for (const int part : node.parts) parts += fmt::format("{}, ", part);
    return fmt::format("{{{}, {}, {}, {}, {{{}}}, {{{}}}}},\n", quoted(node.text), quoted(node.name),
                       quoted(node.context), quoted(node.function), parts, alternatives);
}

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
        defined += fmt::format("namespace any {{\n[[maybe_unused]] static {} {{ return form_{}::{}({}); }}\n}}\n",
                               forms[i].head, i, name, parameters_of(forms[i]));
    int node = 0;
    for (std::size_t i = 0; i < forms.size(); ++i) {
        std::string nodes;
        for (const auto& one : forms[i].nodes) nodes += as_code(one);
        listed += fmt::format("{{{}, {}, {}, {{\n{}}}, caller(rt::form_{}::{})}},\n", quoted(forms[i].fragment),
                              quoted(forms[i].says), node, nodes, i, forms[i].fragment);
        node += int(forms[i].nodes.size());
    }
    return fmt::format(
        "#pragma GCC diagnostic ignored \"-Wunused-parameter\"\n#include \"protocol/caller.h\"\n#include "
        "\"rt/fragments.h\"\n#include \"textbook/form.h\"\n\nnamespace rt {{\n"
        "namespace textbook = grade::textbook;\nnamespace any {{\n{}}}\n{}}}\n\nnamespace grade::textbook {{\n\nconst "
        "std::vector<Form>& forms() {{\n    static const std::vector<Form> all{{\n{}}};\n    return all;\n}}\n\n}}\n",
        declared, defined, listed);
}

}  // namespace

/// wrap_forms OUT FORM... -- SOLUTION... : writes forms.cpp, for form.h, of files with a function each; of those of one
/// fragment, the first is what other fragments call. A solution that it cannot read is left out, with a word.
int main(int argc, char** argv) try {
    std::vector<std::string> files(argv + std::min(argc, 2), argv + argc), fragments;
    for (const bool is_again : {false, true}) {
        std::vector<Wrapped> forms;
        int node = 0;
        bool may_fail = false;
        for (const std::string& file : files) {
            if (file == "--") may_fail = true;
            if (file == "--") continue;
            const auto text = grade::read_text(file);
            if (!text) throw std::runtime_error(file + ": cannot be read; expected a file with a function");
            try {
                forms.push_back(grade::textbook::wrap(file, *text, fragments, node));
            } catch (const std::exception& error) {
                if (!may_fail) throw;
                if (is_again)
                    std::cerr << error.what() << "; without a textbook's form its hints know no expressions\n";
                continue;
            }
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
