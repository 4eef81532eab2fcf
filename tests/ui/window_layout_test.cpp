// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/shell/window_layout.h"

#include <gtest/gtest.h>

#include "ui/shell/open_recording_dialog.h"

namespace kambara::ui {
namespace {

const QRect first(0, 0, 1920, 1080);
const QRect second(1920, 0, 1280, 1024);

TEST(WindowLayout, AWindowOnAScreenStaysWhereItIs) {
    const QRect window(2000, 100, 800, 600);
    EXPECT_EQ(onto_screens(window, {first, second}), window);
}

TEST(WindowLayout, AWindowOnAScreenThatIsGoneComesBack) {
    EXPECT_EQ(onto_screens({2000, 100, 800, 600}, {first}), QRect(1120, 100, 800, 600));
    EXPECT_EQ(onto_screens({-3000, -3000, 800, 600}, {first, second}), QRect(0, 0, 800, 600));
    EXPECT_EQ(onto_screens({-100, 900, 4000, 3000}, {first}), first);
}

TEST(DroppedFiles, AreToldApartByTheirNames) {
    const SourceRequest request =
        request_of_files({"/a/right.mkv", "/a/rig.yaml", "/a/cam_left.mkv"});
    EXPECT_EQ(request.left, "/a/cam_left.mkv");
    EXPECT_EQ(request.right, "/a/right.mkv");
    EXPECT_EQ(request.rig, "/a/rig.yaml");
    const SourceRequest numbered = request_of_files({"/a/cam1.mkv", "/a/cam0.mkv"});
    EXPECT_EQ(numbered.left, "/a/cam0.mkv");
    EXPECT_EQ(numbered.right, "/a/cam1.mkv");
    EXPECT_TRUE(numbered.rig.empty());
    EXPECT_TRUE(request_of_files({}).left.empty());
}

}  // namespace
}  // namespace kambara::ui
