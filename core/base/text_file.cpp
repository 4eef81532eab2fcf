// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/text_file.h"

#include <atomic>
#include <fstream>
#include <iterator>
#include <random>

namespace kambara {
namespace {

std::filesystem::path temporary_name_beside(const std::filesystem::path& path) {
    static std::atomic<unsigned> counter{std::random_device{}()};
    return path.string() + ".part" + std::to_string(counter++);
}

// False where not everything arrived.
bool write_all(const std::filesystem::path& path, std::string_view text) {
    std::ofstream file(path, std::ios::binary | std::ios::trunc);
    file.write(text.data(), static_cast<std::streamsize>(text.size()));
    file.flush();
    return static_cast<bool>(file);
}

}  // namespace

Result<std::string> read_text_file(const std::filesystem::path& path, std::size_t limit_bytes) {
    std::error_code code;
    const auto status = std::filesystem::status(path, code);
    if (!std::filesystem::exists(status)) {
        return Error{"There is no file " + path.string() + ".", "Check the name and the folder."};
    }
    if (!std::filesystem::is_regular_file(status)) {
        return Error{path.string() + " is not a file.", "Name the file itself, not its folder."};
    }
    const auto size = std::filesystem::file_size(path, code);
    if (!code && size > limit_bytes) {
        return Error{path.string() + " has " + std::to_string(size) + " bytes, more than the " +
                         std::to_string(limit_bytes) + " this kind of file can have.",
                     "Check that it is the right file."};
    }
    std::ifstream file(path, std::ios::binary);
    if (!file) {
        return Error{"The file " + path.string() + " can't be opened for reading.",
                     "Check its permissions."};
    }
    std::string text{std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
    if (file.bad()) {
        return Error{"Reading " + path.string() + " failed.", "Check the disk and try again."};
    }
    return text;
}

Result<Done> write_text_file_atomically(const std::filesystem::path& path, std::string_view text) {
    const Error unwritable{"The file " + path.string() + " can't be written.",
                           "Check that its folder exists, may be written to and has room."};
    std::error_code code;
    const auto status = std::filesystem::status(path, code);
    if (std::filesystem::is_directory(status)) {
        return Error{path.string() + " is a folder.", "Name a file to write."};
    }
    if (std::filesystem::exists(status) && !std::filesystem::is_regular_file(status)) {
        return write_all(path, text) ? Result<Done>(Done{}) : Result<Done>(unwritable);
    }
    const bool linked = std::filesystem::is_symlink(std::filesystem::symlink_status(path, code));
    const auto target = linked ? std::filesystem::weakly_canonical(path, code) : path;
    const auto temporary = temporary_name_beside(target);
    if (!write_all(temporary, text)) {
        std::filesystem::remove(temporary, code);
        return unwritable;
    }
    std::filesystem::rename(temporary, target, code);
    if (code) {
        const auto reason = code.message();
        std::filesystem::remove(temporary, code);
        return Error{"The file " + path.string() + " can't be replaced (" + reason + ").",
                     "Check its permissions."};
    }
    return Done{};
}

}  // namespace kambara
