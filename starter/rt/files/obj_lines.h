#pragma once

#include <string>
#include <string_view>
#include <vector>

/// Nobody needs this file for the assignment.
namespace rt {

/// The lines of an OBJ file, without comments, and with those put together that a backslash continues. Lines end with
/// LF, CR or both; byte order marks are no text.
class ObjLines {
public:
    /// Reads the file. Throws std::system_error where it cannot be read, InputError where it is no text.
    explicit ObjLines(const std::string& path);

    /// The next line with a word in it. False: there is none.
    bool next();

    /// The next word of the line; empty: there is none.
    std::string_view word();

    int number() const { return pieces_.empty() ? 1 : pieces_.back().line; }

    /// Throws InputError at a word of this line.
    [[noreturn]] void fail(std::string_view word, const std::string& wrong, const std::string& expected) const;

private:
    struct Piece {
        std::size_t at;  // in line_
        int line, column;
    };
    std::string path_, text_, line_;
    std::size_t next_ = 0, at_ = 0;  // in text_, in line_
    int lines_ = 0;
    std::vector<Piece> pieces_;  // of line_, as they stand in the file

    std::string_view physical_line();
    void refuse_binary() const;
};

/// What a statement of an OBJ file may start with.
enum class ObjWord { vertex, normal, face, ignored, unsupported, unknown };
ObjWord obj_word(std::string_view word);

}  // namespace rt
