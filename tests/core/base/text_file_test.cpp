// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/text_file.h"

#include <gtest/gtest.h>

#include <iterator>
#include <string>

namespace kambara {
namespace {

namespace fs = std::filesystem;

class TextFile : public testing::Test {
  protected:
    void SetUp() override {
        fs::remove_all(folder);
        fs::create_directories(folder);
    }
    void TearDown() override { fs::remove_all(folder); }

    std::ptrdiff_t files_in_folder() const {
        return std::distance(fs::directory_iterator(folder), fs::directory_iterator());
    }

    const fs::path folder =
        fs::path(testing::TempDir()) /
        (std::string("kambara_") + testing::UnitTest::GetInstance()->current_test_info()->name());
};

TEST_F(TextFile, WritesReplacesAndLeavesNothingElseBehind) {
    const fs::path path = folder / "a.txt";
    ASSERT_TRUE(write_text_file_atomically(path, "old"));
    const std::string bytes("new\0\r\n\xff", 7);
    ASSERT_TRUE(write_text_file_atomically(path, bytes));
    EXPECT_EQ(*read_text_file(path), bytes);
    EXPECT_EQ(files_in_folder(), 1);
}

TEST_F(TextFile, AFailureLeavesTheOldContent) {
    // The longest name there can be: no room for the temporary file's, so that writing fails.
    const fs::path path = folder / std::string(255, 'a');
    {
        const fs::path brief = folder / "brief";
        ASSERT_TRUE(write_text_file_atomically(brief, "old"));
        fs::rename(brief, path);
    }
    const auto written = write_text_file_atomically(path, "new");
    ASSERT_FALSE(written);
    EXPECT_NE(written.error().cause.find("can't be written"), std::string::npos);
    EXPECT_EQ(*read_text_file(path), "old");
    EXPECT_EQ(files_in_folder(), 1);
}

TEST_F(TextFile, RefusesFoldersAndMissingFolders) {
    EXPECT_FALSE(write_text_file_atomically(folder, "x"));
    EXPECT_FALSE(write_text_file_atomically(folder / "none" / "a.txt", "x"));
    EXPECT_EQ(files_in_folder(), 0);
}

TEST_F(TextFile, ALinkStaysALink) {
    ASSERT_TRUE(write_text_file_atomically(folder / "real", "old"));
    fs::create_symlink("real", folder / "link");
    ASSERT_TRUE(write_text_file_atomically(folder / "link", "new"));
    EXPECT_TRUE(fs::is_symlink(folder / "link"));
    EXPECT_EQ(*read_text_file(folder / "real"), "new");
}

TEST_F(TextFile, ReadingNamesWhatIsWrong) {
    EXPECT_NE(read_text_file(folder / "none").error().cause.find("no file"), std::string::npos);
    EXPECT_NE(read_text_file(folder).error().cause.find("is not a file"), std::string::npos);
    ASSERT_TRUE(write_text_file_atomically(folder / "long", "12345"));
    EXPECT_TRUE(read_text_file(folder / "long", 5));
    EXPECT_NE(read_text_file(folder / "long", 4).error().cause.find("5 bytes"), std::string::npos);
}

}  // namespace
}  // namespace kambara
