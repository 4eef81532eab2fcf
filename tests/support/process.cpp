// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/process.h"

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdlib>
#include <fstream>
#include <iterator>
#include <sstream>

namespace kambara::testing_support {
namespace {

namespace fs = std::filesystem;

std::string quoted(const std::string& text) {
    std::string result = "'";
    for (const char c : text) {
        result += c == '\'' ? std::string("'\\''") : std::string(1, c);
    }
    return result + "'";
}

}  // namespace

Finished run_program(const std::string& program, const std::vector<std::string>& arguments,
                     const fs::path& folder) {
    const fs::path out = folder / ".out";
    const fs::path err = folder / ".err";
    std::string command = "cd " + quoted(folder.string()) + " && " + quoted(program);
    for (const std::string& argument : arguments) {
        command += " " + quoted(argument);
    }
    command += " >" + quoted(out.string()) + " 2>" + quoted(err.string()) + " </dev/null";
    const int status = std::system(command.c_str());
    Finished finished;
    finished.exit_code = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
    finished.output = text_of(out);
    finished.errors = text_of(err);
    fs::remove(out);
    fs::remove(err);
    return finished;
}

std::string text_of(const fs::path& file) {
    std::ifstream stream(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
}

fs::path fresh_folder(const std::string& name) {
    // Tests run side by side, each in a process of its own.
    const fs::path folder =
        fs::path(testing::TempDir()) / ("kambara_" + name + "_" + std::to_string(getpid()));
    fs::remove_all(folder);
    fs::create_directories(folder);
    return folder;
}

std::vector<std::vector<std::string>> rows_of_csv(const fs::path& file) {
    std::vector<std::vector<std::string>> rows;
    std::istringstream lines(text_of(file));
    std::string line;
    std::getline(lines, line);
    while (std::getline(lines, line)) {
        std::vector<std::string> row(1);
        bool quoted_part = false;
        for (const char c : line) {
            if (c == '"') {
                quoted_part = !quoted_part;
            } else if (c == ',' && !quoted_part) {
                row.emplace_back();
            } else {
                row.back() += c;
            }
        }
        rows.push_back(std::move(row));
    }
    return rows;
}

}  // namespace kambara::testing_support
