#include <unistd.h>

#include <fstream>
#include <iterator>
#include <string>

/// Answers whatever it is asked with the bytes of the file "answer" beside it, and ends.
int main(int, char** argv) {
    char first = 0;
    if (read(STDIN_FILENO, &first, 1) != 1) return 0;
    const std::string self = argv[0];
    std::ifstream file(self.substr(0, self.rfind('/') + 1) + "answer", std::ios::binary);
    const std::string bytes{std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
    for (std::size_t sent = 0; sent < bytes.size();) {
        const ssize_t now = write(3, bytes.data() + sent, bytes.size() - sent);
        if (now <= 0) return 1;
        sent += std::size_t(now);
    }
    return 0;
}
