#include "rt/files/obj_lines.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <fstream>
#include <iterator>
#include <system_error>

#include "rt/files/scene_reader.h"
#include "rt/files/toml_table.h"

namespace rt {
namespace {

constexpr const char* blanks = " \t\v\f";
constexpr std::string_view mark = "\xef\xbb\xbf";  // byte order mark

/// Words of the format that say nothing about triangles.
constexpr std::array ignored{"vt",     "vp",         "o",         "g",        "s",        "mg",   "usemtl",
                             "mtllib", "usemap",     "maplib",    "l",        "p",        "curv", "curv2",
                             "parm",   "trim",       "hole",      "scrv",     "sp",       "end",  "con",
                             "cstype", "deg",        "bmat",      "step",     "bevel",    "lod",  "ctech",
                             "stech",  "shadow_obj", "trace_obj", "c_interp", "d_interp", "csh",  "vc"};
/// Words that add to the shape what is not read here.
constexpr std::array unsupported{"surf", "bsp", "bzp", "cdc", "cdp", "call"};

std::string lower(std::string_view word) {
    std::string small(word);
    for (char& c : small)
        if (c >= 'A' && c <= 'Z') c = char(c - 'A' + 'a');
    return small;
}

std::string_view first_word(std::string_view line) {
    while (line.starts_with(mark)) line.remove_prefix(mark.size());
    line.remove_prefix(std::min(line.find_first_not_of(blanks), line.size()));
    return line.substr(0, line.find_first_of(blanks));
}

/// Where a comment starts; npos: nowhere. 1.#IND and its like are no numbers, and no comments.
std::size_t comment_in(std::string_view line) {
    std::size_t at = line.find('#');
    while (at != line.npos && at >= 2 && line.substr(at - 2, 2) == "1." && at + 1 < line.size() &&
           std::string_view("IQS").find(line[at + 1]) != line.npos)
        at = line.find('#', at + 1);
    return at;
}

/// Where the backslash is that continues a line; npos: nowhere.
std::size_t continuation(std::string_view line) {
    const std::size_t last = line.find_last_not_of(blanks);
    return last != line.npos && line[last] == '\\' ? last : line.npos;
}

}  // namespace

ObjWord obj_word(std::string_view word) {
    const std::string small = lower(word);
    if (small == "v") return ObjWord::vertex;
    if (small == "vn") return ObjWord::normal;
    if (small == "f" || small == "fo") return ObjWord::face;
    const auto among = [&](const auto& list) { return std::find(list.begin(), list.end(), small) != list.end(); };
    return among(ignored) ? ObjWord::ignored : among(unsupported) ? ObjWord::unsupported : ObjWord::unknown;
}

ObjLines::ObjLines(const std::string& path) : path_(path) {
    std::ifstream file(path, std::ios::binary);
    if (!file) throw std::system_error(errno, std::generic_category());
    file.peek();
    if (file.bad()) throw std::system_error(EISDIR, std::generic_category());
    text_.assign(std::istreambuf_iterator<char>(file), {});
    if (text_.starts_with("\xff\xfe") || text_.starts_with("\xfe\xff"))
        throw InputError(path_ + ":1:1: the file is UTF-16 text; expected UTF-8 or ASCII");
    refuse_binary();
}

void ObjLines::refuse_binary() const {
    const std::size_t nul = text_.find('\0');
    if (nul == text_.npos) return;
    const std::string_view before = std::string_view(text_).substr(0, nul);
    const std::size_t start = before.find_last_of("\r\n") + 1;
    auto line = 1 + std::count(before.begin(), before.end(), '\n');
    if (line == 1) line = 1 + std::count(before.begin(), before.end(), '\r');
    const std::string_view head = std::string_view(text_).substr(0, 64);
    const bool wide = std::count(head.begin(), head.end(), '\0') > int(head.size()) / 3;
    throw InputError(fmt::format("{}:{}:{}: {}; expected {}", path_, line, nul - start + 1,
                                 wide ? "every other byte is 0, as in UTF-16 text" : "there is a byte 0 in the file",
                                 wide ? "UTF-8 or ASCII" : "text: a Wavefront OBJ file"));
}

/// The next line of the file as it stands.
std::string_view ObjLines::physical_line() {
    const std::size_t end = std::min(text_.find_first_of("\r\n", next_), text_.size());
    const std::string_view line = std::string_view(text_).substr(next_, end - next_);
    next_ = end + (text_.compare(end, 2, "\r\n") == 0 ? 2 : 1);
    ++lines_;
    return line;
}

bool ObjLines::next() {
    while (next_ < text_.size()) {
        line_.clear(), pieces_.clear(), at_ = 0;
        bool goes_on = true;
        while (goes_on && (next_ < text_.size() || pieces_.empty())) {
            std::string_view line = physical_line();
            int column = 1;
            while (line.starts_with(mark)) line.remove_prefix(mark.size());
            pieces_.push_back({line_.size(), lines_, column});
            const std::string_view first = first_word(pieces_.size() == 1 ? line : std::string_view(line_));
            const std::size_t comment = comment_in(line), end = continuation(line);
            goes_on = end != line.npos;
            // Comments and names may end with a backslash that means nothing: a path, say.
            const bool counts = !first.starts_with('#') && obj_word(first) != ObjWord::ignored && comment == line.npos;
            if (goes_on && !counts) {
                const std::size_t stop = std::min(text_.find_first_of("\r\n", next_), text_.size());
                const std::string_view following = first_word(std::string_view(text_).substr(
                    std::min(next_, text_.size()), stop - std::min(next_, text_.size())));
                goes_on = !following.empty() && !following.starts_with('#') && obj_word(following) == ObjWord::unknown;
            }
            if (goes_on) line = line.substr(0, end);
            line_ += line;
            line_ += ' ';
        }
        if (const std::size_t comment = comment_in(line_); comment != line_.npos) line_.resize(comment);
        if (line_.find_first_not_of(blanks) != line_.npos) return true;
    }
    return false;
}

std::string_view ObjLines::word() {
    const std::string_view line = line_;
    const std::size_t start = std::min(line.find_first_not_of(blanks, at_), line.size());
    at_ = std::min(line.find_first_of(blanks, start), line.size());
    return line.substr(start, at_ - start);
}

void ObjLines::fail(std::string_view word, const std::string& wrong, const std::string& expected) const {
    const bool within = word.data() >= line_.data() && word.data() <= line_.data() + line_.size();
    const std::size_t at = within ? std::size_t(word.data() - line_.data()) : 0;
    Piece piece{0, std::max(lines_, 1), 1};
    for (const Piece& p : pieces_)
        if (p.at <= at) piece = p;
    throw InputError(fmt::format("{}:{}:{}: {}; expected {}", path_, piece.line, piece.column + int(at - piece.at),
                                 wrong, expected));
}

}  // namespace rt
