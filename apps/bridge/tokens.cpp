#include "bridge/tokens.h"

#include "bridge/net/doorkeeper.h"

#include "rtcore/platform/error.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstring>

namespace bridge {

namespace {

using rtcore::FailureKind;
using rtcore::FileError;

struct Descriptor {
    int number;
    ~Descriptor() {
        if (number >= 0) ::close(number);
    }
};

bool isToken(const std::string& text) {
    constexpr std::size_t kLeast = 22, kMost = 128;
    const bool plain = text.find_first_not_of("ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789-_") == std::string::npos;
    return plain && text.size() >= kLeast && text.size() <= kMost;
}

Tokens readTokens(int file, const std::string& path) {
    struct stat facts {};
    ::fstat(file, &facts);
    if (!S_ISREG(facts.st_mode) || facts.st_uid != ::getuid() || (facts.st_mode & 077U) != 0)
        throw FileError(FailureKind::BadData, path, "others may read the tokens; 'chmod 600' it");
    std::array<char, 512> bytes{};
    const ssize_t count = ::read(file, bytes.data(), bytes.size());
    const std::string text(bytes.data(), count > 0 ? static_cast<std::size_t>(count) : 0);
    const std::size_t line = std::min(text.find('\n'), text.size());
    const std::string rest = line < text.size() ? text.substr(line + 1) : "";
    const Tokens tokens{text.substr(0, line), rest.substr(0, rest.find('\n'))};
    if (!isToken(tokens.driver) || !isToken(tokens.viewer) || tokens.driver == tokens.viewer)
        throw FileError(FailureKind::BadData, path, "it takes two lines, the driver's and the viewer's token, of at least 22 letters, digits, - or _");
    return tokens;
}

void writeTokens(const Tokens& tokens, const std::string& path) {
    const Descriptor file{::open(path.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0600)};
    const std::string text = tokens.driver + "\n" + tokens.viewer + "\n";
    if (file.number < 0 || ::write(file.number, text.data(), text.size()) != static_cast<ssize_t>(text.size()))
        throw FileError(FailureKind::CannotWrite, path, std::strerror(errno));
}

Tokens tokensOf(const std::string& path) {
    const Descriptor file{::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK)};
    if (file.number >= 0) return readTokens(file.number, path);
    if (errno != ENOENT) throw FileError(FailureKind::NoInput, path, std::strerror(errno));
    const Tokens tokens{newToken(), newToken()};
    writeTokens(tokens, path);
    return tokens;
}

} // namespace

Tokens openTokens(const std::optional<std::filesystem::path>& file, bool viewOnly) {
    Tokens tokens = file ? tokensOf(file->string()) : Tokens{newToken(), newToken()};
    if (viewOnly) tokens.driver.clear();
    return tokens;
}

} // namespace bridge
