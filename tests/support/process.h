// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace kambara::testing_support {

struct Finished {
    int exit_code = -1;
    std::string output;
    std::string errors;
};

/// Runs a program with arguments, in `folder`, and waits for its end.
Finished run_program(const std::string& program, const std::vector<std::string>& arguments,
                     const std::filesystem::path& folder);

std::string text_of(const std::filesystem::path& file);

/// A fresh, empty folder for a test, named after it.
std::filesystem::path fresh_folder(const std::string& name);

/// The rows of a CSV file without its header, cut at commas outside quotes.
std::vector<std::vector<std::string>> rows_of_csv(const std::filesystem::path& file);

}  // namespace kambara::testing_support
