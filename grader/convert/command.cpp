#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <memory>

#include "convert/formats.h"
#include "convert/read_record.h"
#include "files/files.h"
#include "report/page.h"
#include "report/terminal.h"
#include "rt/files/scene_reader.h"
#include "studies/commands.h"
#include "studies/studies.h"

namespace grade {

std::string html_page(const Record& record) { return page(record, ""); }

std::string terminal(const Record& record) { return table(record, {}); }

namespace {

struct ConvertArguments {
    std::string record, format, out;
};

/// Throws rt::InputError for a record that is none or not complete.
int run_convert(const ConvertArguments& arguments) {
    require_file(arguments.out, "--out");
    const Record record = read_record(arguments.record);
    if (!record.is_complete())
        throw rt::InputError(fmt::format(
            "{}: this grading is not complete, it still runs or was stopped; expected one that ran to its end",
            arguments.record));
    const auto format = std::ranges::find(formats, arguments.format, &Format::name);
    const std::string text = format->name == "terminal" && arguments.out.empty() && has_colors()
                                 ? table(record, {.color = true})
                                 : format->write(record);
    if (arguments.out.empty())
        fmt::print("{}", text);
    else
        write_text(arguments.out, text);
    return 0;
}

}  // namespace

Command convert_command(CLI::App& app) {
    const auto arguments = std::make_shared<ConvertArguments>();
    std::vector<std::string> names;
    for (const Format& format : formats) names.emplace_back(format.name);
    CLI::App* convert = app.add_subcommand("convert", purpose_of("convert"));
    convert->add_option("RECORD", arguments->record, "as grade --json FILE writes it")->required();
    convert->add_option("--to", arguments->format, "the format")->required()->check(CLI::IsMember(names));
    convert->add_option("-o,--out", arguments->out, "where it goes; default: stdout")->type_name("FILE");
    return {convert, [arguments](const Context&) { return run_convert(*arguments); }, false};
}

}  // namespace grade
