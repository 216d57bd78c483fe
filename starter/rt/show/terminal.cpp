#include "rt/show/terminal.h"

#include <fcntl.h>
#include <poll.h>
#include <sys/ioctl.h>
#include <termios.h>
#include <unistd.h>

#include <csignal>
#include <cstdlib>
#include <string>

namespace rt {
namespace {

using Clock = std::chrono::steady_clock;

/// Is a picture of one pixel welcome (kitty)? And what are you (everyone answers that)?
constexpr std::string_view question = "\033_Gi=31,s=1,v=1,a=q,t=d,f=24;AAAA\033\\\033[c";

/// Characters come one by one and unseen, and no signal ends the program, until this goes.
struct Unseen {
    int tty;
    termios before{};
    sigset_t signals{};

    explicit Unseen(int tty) : tty(tty) {
        sigset_t held;
        sigfillset(&held);
        pthread_sigmask(SIG_BLOCK, &held, &signals);
        tcgetattr(tty, &before);
        termios unseen = before;
        unseen.c_lflag &= tcflag_t(~(ICANON | ECHO));
        tcsetattr(tty, TCSANOW, &unseen);
    }
    ~Unseen() {
        tcsetattr(tty, TCSAFLUSH, &before);  // an answer that comes too late is nobody's input
        pthread_sigmask(SIG_SETMASK, &signals, nullptr);
    }
    Unseen(const Unseen&) = delete;
    Unseen& operator=(const Unseen&) = delete;
};

/// The answer ends with that to the second question: ESC [ ? numbers c.
bool is_complete(std::string_view answer) {
    const auto start = answer.rfind("\033[?");
    return start != std::string_view::npos && answer.find('c', start) != std::string_view::npos;
}

std::string ask(int tty, std::chrono::milliseconds patience) {
    const Unseen unseen(tty);
    std::string answer;
    if (write(tty, question.data(), question.size()) != ssize_t(question.size())) return answer;
    const Clock::time_point end = Clock::now() + patience;
    while (!is_complete(answer) && answer.size() < 4096) {
        const auto left = std::chrono::duration_cast<std::chrono::milliseconds>(end - Clock::now()).count();
        pollfd ready{tty, POLLIN, 0};
        if (left <= 0 || poll(&ready, 1, int(left)) <= 0) break;
        char bytes[256];
        const ssize_t got = read(tty, bytes, sizeof bytes);
        if (got <= 0) break;
        answer.append(bytes, std::size_t(got));
    }
    return answer;
}

}  // namespace

bool can_draw(int descriptor) {
    const char* kind = std::getenv("TERM");
    return isatty(descriptor) && kind && *kind && std::string_view(kind) != "dumb";
}

bool in_foreground(int descriptor) {
    const pid_t owner = tcgetpgrp(descriptor);
    return owner < 0 || owner == getpgrp();  // below 0: a terminal without jobs
}

TerminalSize size_of_terminal(int descriptor) {
    TerminalSize size;
    winsize told{};
    if (ioctl(descriptor, TIOCGWINSZ, &told) != 0 || told.ws_col == 0 || told.ws_row == 0) return size;
    size.columns = told.ws_col, size.rows = told.ws_row;
    if (told.ws_xpixel > 0) size.cell_width = told.ws_xpixel / told.ws_col;
    if (told.ws_ypixel > 0) size.cell_height = told.ws_ypixel / told.ws_row;
    return size;
}

Graphics ask_for_graphics(std::chrono::milliseconds patience) {
    const int tty = open("/dev/tty", O_RDWR | O_NOCTTY | O_CLOEXEC);
    if (tty < 0) return Graphics::blocks;
    const std::string answer = in_foreground(tty) ? ask(tty, patience) : std::string();
    close(tty);
    return graphics_of(answer);
}

Graphics graphics_of(std::string_view answer) {
    if (answer.find("\033_Gi=31;OK") != std::string_view::npos) return Graphics::kitty;
    auto start = answer.rfind("\033[?");
    if (start == std::string_view::npos) return Graphics::blocks;
    // The first number says which terminal it takes itself for; then come its attributes.
    for (start = answer.find(';', start); start != std::string_view::npos; start = answer.find(';', start + 1)) {
        const std::string_view number =
            answer.substr(start + 1, answer.find_first_not_of("0123456789", start + 1) - start - 1);
        if (number == "4") return Graphics::sixel;
    }
    return Graphics::blocks;
}

}  // namespace rt
