#include "theory/theory.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "report/escape.h"
#include "rt/files/scene_reader.h"
#include "rt/files/toml_table.h"

namespace grade {

namespace {

constexpr double tolerance = 0.01;

/// The same question for another name whose answer is another.
Question other_than(const Question& question, std::size_t place) {
    for (int k = 0;; ++k) {
        Question other = questions_of(fmt::format("example {}", k))[place];
        if (std::abs(other.answer - question.answer) > 2 * tolerance * std::abs(question.answer)) return other;
    }
}

std::string in_unit(const Question& question) { return question.unit.empty() ? "" : " [" + question.unit + "]"; }

bool is_blank(const std::string& name) {
    return std::ranges::all_of(name, [](unsigned char c) { return c <= ' '; });
}

/// The name as the file will have it, by which its questions are drawn. What is no letter, such as the end of a line,
/// becomes a space.
std::string plain_name(std::string name) {
    std::ranges::replace_if(
        name, [](unsigned char c) { return c < ' ' || c == 127; }, ' ');
    if (is_blank(name)) throw rt::InputError("--name: is empty; expected your name");
    constexpr std::size_t most = 200;
    if (name.size() > most) throw rt::InputError(fmt::format("--name: is longer than {} bytes; expected a name", most));
    if (printable_line(name) != name)
        throw rt::InputError("--name: holds bytes that are no letters; expected a name in UTF-8");
    return name;
}

/// As a string of TOML.
std::string quoted(const std::string& text) {
    std::string escaped;
    for (const char c : text) {
        if (c == '"' || c == '\\') escaped += '\\';
        escaped += c;
    }
    return '"' + escaped + '"';
}

bool is_right(double given, double right) { return std::abs(given - right) <= tolerance * std::abs(right); }

/// A usual slip; empty: none.
std::string slip(double given, const Question& question) {
    const bool is_angle = question.unit == "degrees";
    return is_angle && is_right(given * 180 / std::numbers::pi, question.answer) ? " That is the angle in radians."
                                                                                 : "";
}

std::string told(const Answered& answered, std::size_t place) {
    const Question& question = answered.question;
    if (!answered.answer) return "no answer yet\n";
    const std::string given = fmt::format("{:g}{}", *answered.answer, in_unit(question));
    if (answered.right) return fmt::format("{}: right. {}\n", given, question.worked);
    const Question other = other_than(question, place);
    return fmt::format("{}: wrong.{} With other numbers: {}\n    {}\n", given, slip(*answered.answer, question),
                       other.text, other.worked);
}

}  // namespace

int Theory::right() const { return int(std::ranges::count(answers, true, &Answered::right)); }

std::string empty_theory(const std::string& typed) {
    const std::string name = plain_name(typed);
    std::string text =
        "# Answers to the theory part. Take the # away before a key and write a number behind its =, with three "
        "digits.\n"
        "# ./grade theory says which are right. The numbers belong to the name.\n\nname = " +
        quoted(name) + "\n";
    int number = 0;
    for (const Question& question : questions_of(name))
        text += fmt::format("\n# {}. {}{}\n#{} = \n", ++number, question.text, in_unit(question), question.key);
    return text;
}

namespace {

rt::Table parsed(const std::string& text, const std::string& path) try {
    return rt::Table::parse(text, path);
} catch (const rt::InputError& error) {
    throw rt::InputError(std::string(error.what()) + "; an answer is a number, worked out: 41.8");
}

}  // namespace

Theory read_theory(const std::string& text, const std::string& path) {
    const rt::Table file = parsed(text, path);
    Theory theory{file.text("name"), {}};
    if (is_blank(theory.name)) file.fail("name", "is empty", "your name");
    std::vector<std::string> keys = {"name"};
    for (Question& question : questions_of(theory.name)) {
        keys.push_back(question.key);
        Answered answered{std::move(question), {}, false};
        const std::string& key = answered.question.key;
        if (file.has(key)) {
            answered.answer = file.number(key, rt::any_number);
            answered.right = is_right(*answered.answer, answered.question.answer);
        }
        theory.answers.push_back(std::move(answered));
    }
    for (const std::string& key : file.keys())
        if (std::ranges::count(keys, key) == 0) {
            const auto nearest = rt::nearest_word(key, keys);
            file.fail(key, "\"" + key + "\" is no question",
                      nearest ? *nearest + "?" : "a key that the file came with");
        }
    return theory;
}

std::string told(const Theory& theory, double points) {
    std::string text;
    for (std::size_t k = 0; k < theory.answers.size(); ++k) {
        const Answered& answered = theory.answers[k];
        text += fmt::format("{}. {}: {}{}\n    {}", k + 1, answered.question.key, answered.question.text,
                            in_unit(answered.question), told(answered, k));
    }
    // before the name, which is the student's choice
    return text + fmt::format("\n{} of {} right, {:.3g} of {:g} points: {}\n", theory.right(), theory.answers.size(),
                              points * theory.right() / double(theory.answers.size()), points,
                              printable_line(theory.name, 200));
}

}  // namespace grade
