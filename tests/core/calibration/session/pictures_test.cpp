// SPDX-License-Identifier: GPL-3.0-or-later
// The session before pictures: the simulated rig's, and rendered ones of the target held where the
// session asks for it.
#include <gtest/gtest.h>

#include "hardware/simulated/simulated_world.h"
#include "tests/core/calibration/session/session_samples.h"
#include "tests/support/box_scene.h"

namespace kambara {
namespace {

using namespace testing_support;

// What left and right see; the seed is of their noise.
PictureSet pictures_of(const Rig& rig, const Target& target,
                       const RigidTransform& T_left_from_target, unsigned seed) {
    PictureSet pictures;
    const auto cameras = cameras_of(rig);
    for (std::size_t c = 0; c < 2; ++c) {
        BoxScene scene;
        scene.target = target;
        scene.camera_from_target = cameras[c]->T_camera_from_rig *
                                   rig.left.T_camera_from_rig.inverse() * T_left_from_target;
        scene.lens = cameras[c]->lens;
        scene.blur_px = 0.6;
        scene.seed = 2 * seed + static_cast<unsigned>(c);
        pictures[c] = std::make_shared<Image>(rendered(scene));
    }
    return pictures;
}

TEST(SessionPictures, TwelveSuggestedViewsOfBoxesMakeAGoodRig) {
    const Rig rig = built_rig(false);
    CaptureRules rules;
    rules.stillness.pairs = 1;
    const SessionSetup setup = setup_for(rig, two_plane_24(), LensModel::tsai);
    auto session = CalibrationSession::begin(setup, rules);
    ASSERT_TRUE(session);
    std::mt19937 random(5);
    int poses = 0;
    while (session->shots().size() < 12 && poses < 40) {
        const std::size_t shots = session->shots().size();
        if (shots >= 4 && shots % 2 == 0) {
            ASSERT_TRUE(session->learn(session->problem().solve()));
        }
        const auto next = session->what_next();
        ASSERT_TRUE(next);
        const RigidTransform held = held_about(next->T_left_from_target, setup.target, random);
        ++poses;
        const auto seed = static_cast<unsigned>(2 * poses);
        if (poses <= 3) {
            ASSERT_TRUE(session->look(pictures_of(rig, setup.target, held, seed)));
            ASSERT_TRUE(session->look(pictures_of(rig, setup.target, held, seed + 1)));
            EXPECT_LE(session->shots().size(), static_cast<std::size_t>(poses));
        } else {
            const PictureSet pictures = pictures_of(rig, setup.target, held, seed);
            ASSERT_TRUE(session->capture(find_in_all(pictures, setup.target), pictures));
        }
    }
    EXPECT_LE(poses, 15);  // hands are off, and then a part lies outside at times
    const auto report = session->problem().solve();
    EXPECT_EQ(report.verdict, Verdict::good);
    EXPECT_LT(true_range_error(rig, report.rig), 0.0005);
    EXPECT_NEAR(report.pairs[1]->baseline_mm, baseline_mm(rig),
                4.0 * report.pairs[1]->baseline_sigma_mm);
}

TEST(SessionPictures, TheSimulatedRigsBoardIsCapturedOncePerPose) {
    const auto profile = simulated_profile("chessboard?rate=2&seed=4");
    ASSERT_TRUE(profile);
    const SimulatedWorld world(*profile);
    SessionSetup setup = setup_for(world.rig(), *profile->calibration_target, LensModel::tsai);
    setup.cameras[2].reset();
    CaptureRules rules;
    rules.stillness.pairs = 1;
    auto session = CalibrationSession::begin(setup, rules);
    ASSERT_TRUE(session);
    int first_of_pose = 0;
    for (int frame = 0; frame < 20; ++frame) {
        const PictureSet pictures{std::make_shared<Image>(world.picture(FixedCamera::left, frame)),
                                  std::make_shared<Image>(world.picture(FixedCamera::right, frame)),
                                  nullptr};
        const auto look = session->look(pictures);
        ASSERT_TRUE(look);
        EXPECT_NE(look->shot.has_value(), !look->why_not.empty());
        first_of_pose += look->shot && frame % 2 == 0 ? 1 : 0;
    }
    EXPECT_EQ(first_of_pose, 0);
    EXPECT_GE(session->shots().size(), 6U);
    const auto report = session->problem().solve();
    EXPECT_NE(report.verdict, Verdict::refused);
    ASSERT_TRUE(report.pairs[1]);
    EXPECT_NEAR(report.pairs[1]->baseline_mm, baseline_mm(world.rig()),
                4.0 * report.pairs[1]->baseline_sigma_mm);
}

}  // namespace
}  // namespace kambara
