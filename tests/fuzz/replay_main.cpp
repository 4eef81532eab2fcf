// SPDX-License-Identifier: GPL-3.0-or-later
// Drives a fuzz target without libFuzzer: FOLDER ROUNDS. Every file of the folder as it is, then so
// many damaged copies, always the same ones.
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <random>
#include <string>
#include <vector>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

namespace {

void try_one(const std::string& input) {
    LLVMFuzzerTestOneInput(reinterpret_cast<const std::uint8_t*>(input.data()), input.size());
}

// Bytes changed, runs cut out, and runs said twice: what disks and editors do to files.
std::string damaged(std::string text, std::mt19937& random) {
    const auto below = [&](std::size_t n) { return n == 0 ? 0 : random() % n; };
    for (std::size_t i = 0, n = 1 + below(4); i < n; ++i) {
        const std::size_t at = below(text.size());
        const std::size_t length = below(std::min<std::size_t>(40, text.size() - at));
        switch (random() % 4) {
            case 0:
                if (!text.empty()) {
                    text[at] = static_cast<char>(random() % 256);
                }
                break;
            case 1:
                text.erase(at, length);
                break;
            case 2:
                text.insert(at, text.substr(below(text.size()), length));
                break;
            default:
                text.insert(at, std::string("-9e999 nan [{\"\\\n\t").substr(below(16), below(8)));
        }
    }
    return text;
}

}  // namespace

int main(int argc, char** argv) {
    if (argc != 3) {
        std::fputs("usage: FUZZ_TARGET FOLDER ROUNDS\n", stderr);
        return 2;
    }
    std::vector<std::string> corpus;
    for (const auto& entry : std::filesystem::directory_iterator(argv[1])) {
        std::ifstream file(entry.path(), std::ios::binary);
        corpus.emplace_back(std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>());
    }
    std::sort(corpus.begin(), corpus.end());
    if (corpus.empty()) {
        std::fputs("The corpus is empty.\n", stderr);
        return 1;
    }
    for (const std::string& input : corpus) {
        try_one(input);
    }
    std::mt19937 random(1);
    const int rounds = std::atoi(argv[2]);
    for (int i = 0; i < rounds; ++i) {
        try_one(damaged(corpus[random() % corpus.size()], random));
    }
    std::printf("%zu files, %d damaged copies\n", corpus.size(), rounds);
    return 0;
}
