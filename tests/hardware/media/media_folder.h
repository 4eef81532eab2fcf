// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <gtest/gtest.h>

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

#include "core/image/image.h"

namespace kambara {

/// A folder of its own for each test, removed afterwards.
class MediaFolderTest : public testing::Test {
  protected:
    MediaFolderTest() {
        const auto* test = testing::UnitTest::GetInstance()->current_test_info();
        folder_ = std::filesystem::path(testing::TempDir()) /
                  (std::string("media_") + test->test_suite_name() + "_" + test->name());
        std::filesystem::remove_all(folder_);
        std::filesystem::create_directories(folder_);
    }
    ~MediaFolderTest() override { std::filesystem::remove_all(folder_); }

    std::string path(const std::string& name) const { return (folder_ / name).string(); }

    std::string bytes_of(const std::string& name) const {
        std::ifstream stream(path(name), std::ios::binary);
        return {std::istreambuf_iterator<char>(stream), {}};
    }

    void write_bytes(const std::string& name, const std::string& bytes) const {
        std::ofstream(path(name), std::ios::binary) << bytes;
    }

    // A copy of the file's first part.
    void cut(const std::string& from, const std::string& to, double part) const {
        const std::string whole = bytes_of(from);
        write_bytes(to, whole.substr(
                            0, static_cast<std::size_t>(part * static_cast<double>(whole.size()))));
    }

    std::filesystem::path folder_;
};

/// A textured picture that no two seeds share.
inline Image textured_picture(int width, int height, int channels, std::uint32_t seed) {
    Image picture(width, height, channels);
    std::uint32_t state = seed * 2654435761U + 1U;
    for (int y = 0; y < height; ++y) {
        for (int i = 0; i < width * channels; ++i) {
            state = state * 1664525U + 1013904223U;
            picture.row(y)[i] = static_cast<std::uint8_t>(state >> 24);
        }
    }
    return picture;
}

}  // namespace kambara
