// SPDX-License-Identifier: GPL-3.0-or-later
// kambara-lint ROOT [--without FOLDER]... [COMPILER WITH FLAGS]: prints what is against the rules;
// exit code 1 if any is. With a compiler, every header outside those folders is compiled.
#include <cstdio>
#include <string>
#include <vector>

#include "tests/lint/lint.h"

int main(int argc, char** argv) {
    if (argc < 2) {
        std::fputs("usage: kambara-lint ROOT [--without FOLDER]... [COMPILER FLAGS...]\n", stderr);
        return 2;
    }
    auto faults = kambara::lint::faults_of_sources(argv[1]);
    int next = 2;
    std::vector<std::string> without;
    for (; next + 1 < argc && std::string(argv[next]) == "--without"; next += 2) {
        without.emplace_back(argv[next + 1]);
    }
    if (next < argc) {
        std::string compiler = argv[next];
        for (++next; next < argc; ++next) {
            compiler += std::string(" ") + argv[next];
        }
        for (auto& fault : kambara::lint::faults_of_headers(argv[1], compiler, without)) {
            faults.push_back(std::move(fault));
        }
    }
    for (const auto& fault : faults) {
        std::printf("%s\n", kambara::lint::to_string(fault).c_str());
    }
    std::printf("%zu faults\n", faults.size());
    return faults.empty() ? 0 : 1;
}
