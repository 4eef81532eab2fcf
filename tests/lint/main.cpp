// SPDX-License-Identifier: GPL-3.0-or-later
// kambara-lint ROOT [COMPILER WITH FLAGS]: prints what is against the rules; exit code 1 if any is.
#include <cstdio>
#include <string>

#include "tests/lint/lint.h"

int main(int argc, char** argv) {
    if (argc < 2) {
        std::fputs("usage: kambara-lint ROOT [COMPILER FLAGS...]\n", stderr);
        return 2;
    }
    auto faults = kambara::lint::faults_of_sources(argv[1]);
    if (argc > 2) {
        std::string compiler;
        for (int i = 2; i < argc; ++i) {
            compiler += std::string(i > 2 ? " " : "") + argv[i];
        }
        for (auto& fault : kambara::lint::faults_of_headers(argv[1], compiler)) {
            faults.push_back(std::move(fault));
        }
    }
    for (const auto& fault : faults) {
        std::printf("%s\n", kambara::lint::to_string(fault).c_str());
    }
    std::printf("%zu faults\n", faults.size());
    return faults.empty() ? 0 : 1;
}
