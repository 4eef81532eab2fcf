// SPDX-License-Identifier: GPL-3.0-or-later
// The levelling assistant on a simulated rig whose target is moved straight up and down.
#include <gtest/gtest.h>

#include <QComboBox>
#include <QTemporaryDir>
#include <cmath>

#include "core/base/angles.h"
#include "core/camera/rig_file.h"
#include "tests/ui/form_page.h"

namespace kambara {
namespace {

using testing_support::FormPage;
using testing_support::WindowPage;

ui::WindowOptions plumb() {
    ui::WindowOptions options = WindowPage::simulated(false);
    options.first.left = "sim:plumb";
    return options;
}

// What straight down is in the rig's frame, from where the target really goes.
Mount true_mount(const SimulatedWorld& world) {
    const RigidTransform T_rig_from_left = world.rig().left.T_camera_from_rig.inverse();
    const Eigen::Vector3d from = T_rig_from_left * world.T_left_from_target(0).t_mm;
    Eigen::Vector3d way = T_rig_from_left * world.T_left_from_target(60).t_mm - from;
    way = way.y() < 0.0 ? Eigen::Vector3d(-way) : way;
    return mount_of_down(way.normalized());
}

TEST(LevellingInTheWindow, FindsSavesAndShowsThePositionInTheVehiclesFrame) {
    QTemporaryDir folder;
    WindowPage page(plumb(), "plumb");
    ASSERT_TRUE(page.until_picture());
    FormPage form(page, "level", "levellingWindow");
    EXPECT_TRUE(WindowPage::until(
        [&] { return form.text("levelTarget").startsWith("No target is tracked"); }));
    EXPECT_FALSE(form.can_press("levelSave"));
    form.take("levelling_empty");
    auto& frames = page.part<QComboBox>("positionFrame");
    EXPECT_EQ(frames.findData("vehicle"), 3);
    page.drag(page.target());
    ASSERT_TRUE(page.until_state(TrackState::tracking));
    form.press("levelRecord");
    ASSERT_TRUE(WindowPage::until([&] { return form.number("levelCount") > 5; }));
    form.take("levelling_short");
    ASSERT_TRUE(WindowPage::until([&] { return form.number("levelExtent") > 400.0; }, 30));
    form.press("levelRecord");
    ASSERT_TRUE(WindowPage::until([&] { return form.can_press("levelSave"); }));
    form.take("levelling_found");
    const Mount truth = true_mount(page.world());
    EXPECT_NEAR(form.number("levelPitch"), deg_from_rad(truth.pitch_rad), 0.1);
    EXPECT_NEAR(form.number("levelRoll"), deg_from_rad(truth.roll_rad), 0.1);
    EXPECT_TRUE(form.text("levelPitch").contains(QChar(0x00B1)));
    EXPECT_EQ(form.text("levelWarning"), "");
    EXPECT_FALSE(form.window().unsaved().isEmpty());
    const QString file = folder.filePath("rig.yaml");
    form.type("levelSaveFile", file);
    form.press("levelSave");
    ASSERT_TRUE(WindowPage::until([&] { return form.said().startsWith("Saved"); }))
        << form.said().toStdString();
    EXPECT_TRUE(form.window().unsaved().isEmpty());
    const auto rig = read_rig_file(file.toStdString());
    ASSERT_TRUE(rig);
    ASSERT_TRUE(rig->mount);
    EXPECT_NEAR(rig->mount->pitch_rad, truth.pitch_rad, rad_from_deg(0.1));
    // The main window now tells positions in the vehicle's frame: forward is its x.
    frames.setCurrentIndex(3);
    ASSERT_TRUE(page.until([&] {
        const auto estimate = steered_estimate(page.shown());
        const QString said = page.text("positionX");
        const double told = said.left(said.indexOf(QChar(0x202F))).remove(',').toDouble();
        return estimate.position && std::abs(told - estimate.position->point_in_left_mm.z()) < 200;
    })) << page.text("positionX").toStdString();
    form.take("levelling_saved");
}

TEST(LevellingInTheWindow, ByAWallAsksForTheRollAndTooLittleIsRefused) {
    WindowPage page(WindowPage::simulated(false));
    ASSERT_TRUE(page.until_picture());
    FormPage form(page, "level", "levellingWindow");
    EXPECT_FALSE(form.shows("wallRoll"));
    form.choose("levelBy", 1);
    EXPECT_TRUE(form.shows("wallRoll"));
    page.drag(page.target());
    ASSERT_TRUE(page.until_state(TrackState::tracking));
    form.press("levelRecord");
    ASSERT_TRUE(WindowPage::until([&] { return form.number("levelCount") >= 3; }));
    EXPECT_TRUE(form.window().unsaved().contains("under way"));
    FormPage::answer("unsavedQuestion", "Keep it");
    form.window().close();
    EXPECT_TRUE(form.window().isVisible());
    form.press("levelRecord");
    // A few positions on a swimming path are no wall.
    ASSERT_TRUE(WindowPage::until([&] { return form.text("levelWarning") != ""; }));
    form.take("levelling_wall");
    EXPECT_FALSE(form.can_press("levelSave"));
    EXPECT_EQ(form.window().unsaved(), QString()) << "no angle was found that could be saved";
    form.window().close();
    EXPECT_FALSE(form.window().isVisible());
}

}  // namespace
}  // namespace kambara
