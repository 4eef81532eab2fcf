// SPDX-License-Identifier: GPL-3.0-or-later
#include "hardware/visca/pseudo_terminal.h"

#include <fcntl.h>
#include <stdlib.h>
#include <termios.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <utility>

namespace kambara::visca {
namespace {

namespace fs = std::filesystem;

Error cant_make(const std::string& name, const std::string& why) {
    return {"The pseudo-terminal " + name + " can't be made (" + why + ").",
            "Give a name that is free, in a folder that may be written to."};
}

}  // namespace

Result<PseudoTerminal> PseudoTerminal::open(const std::string& name) {
    const int ours = ::posix_openpt(O_RDWR | O_NOCTTY | O_CLOEXEC);
    char path[128];
    if (ours < 0 || ::grantpt(ours) != 0 || ::unlockpt(ours) != 0 ||
        ::ptsname_r(ours, path, sizeof path) != 0) {
        const std::string why = std::strerror(errno);
        if (ours >= 0) {
            ::close(ours);
        }
        return cant_make(name, why);
    }
    const int theirs = ::open(path, O_RDWR | O_NOCTTY | O_CLOEXEC);
    PseudoTerminal terminal("", ours, theirs);
    termios settings{};
    if (theirs < 0 || ::tcgetattr(theirs, &settings) != 0) {
        return cant_make(name, std::strerror(errno));
    }
    ::cfmakeraw(&settings);
    ::cfsetspeed(&settings, B9600);
    ::tcsetattr(theirs, TCSANOW, &settings);
    std::error_code code;
    if (fs::is_symlink(fs::symlink_status(name, code))) {
        fs::remove(name, code);  // left behind by one that was ended by force
    }
    fs::create_symlink(path, name, code);
    if (code) {
        return cant_make(name, code.message());
    }
    terminal.name_ = name;
    return terminal;
}

PseudoTerminal::PseudoTerminal(PseudoTerminal&& other) noexcept
    : name_(std::exchange(other.name_, std::string())),
      ours_(std::exchange(other.ours_, -1)),
      theirs_(std::exchange(other.theirs_, -1)) {}

PseudoTerminal::~PseudoTerminal() {
    for (const int descriptor : {ours_, theirs_}) {
        if (descriptor >= 0) {
            ::close(descriptor);
        }
    }
    if (!name_.empty()) {
        std::error_code ignored;
        fs::remove(name_, ignored);
    }
}

int PseudoTerminal::take_descriptor() {
    return std::exchange(ours_, -1);
}

}  // namespace kambara::visca
