// SPDX-License-Identifier: GPL-3.0-or-later
// The session before the simulated rig's pictures.
#include <gtest/gtest.h>

#include "core/calibration/session/calibration_session.h"
#include "hardware/simulated/simulated_world.h"

namespace kambara {
namespace {

// Looks at every picture of so many poses, held a second each, until so many shots are taken.
CalibrationReport from_pictures(const std::string& profile_text, int poses, int wanted) {
    const auto profile = simulated_profile(profile_text);
    EXPECT_TRUE(profile);
    const SimulatedWorld world(*profile);
    SessionSetup setup;
    setup.target = *profile->calibration_target;
    setup.model = LensModel::tsai;
    setup.sensor = std::get<TsaiLens>(world.rig().left.lens).sensor;
    setup.cameras = {PictureSize{640, 480}, PictureSize{640, 480}, std::nullopt};
    CaptureRules rules;
    rules.stillness.pairs = 1;
    auto session = CalibrationSession::begin(setup, rules);
    EXPECT_TRUE(session);
    const int frames = static_cast<int>(poses * profile->rate_hz);
    for (int frame = 0; frame < frames && static_cast<int>(session->shots().size()) < wanted;
         ++frame) {
        const PictureSet pictures{std::make_shared<Image>(world.picture(FixedCamera::left, frame)),
                                  std::make_shared<Image>(world.picture(FixedCamera::right, frame)),
                                  nullptr};
        const auto look = session->look(pictures);
        EXPECT_TRUE(look);
        EXPECT_NE(look->shot.has_value(), !look->why_not.empty());
    }
    EXPECT_GE(static_cast<int>(session->shots().size()), wanted);
    EXPECT_GT(session->coverage().pictures[0].share, 0.3);
    return session->problem().solve();
}

TEST(SessionPictures, BoxesReachATrustworthyRig) {
    const auto report = from_pictures("two-plane-24?rate=2&seed=4", 20, 14);
    EXPECT_NE(report.verdict, Verdict::refused);
    ASSERT_TRUE(report.pairs[1]);
    EXPECT_NEAR(report.pairs[1]->baseline_mm, 450.0, 4.0 * report.pairs[1]->baseline_sigma_mm);
    for (const auto& reason : report.reasons) {
        std::printf("%s\n", reason.c_str());
    }
}

TEST(SessionPictures, ABoardReachesATrustworthyRig) {
    const auto report = from_pictures("chessboard?rate=2&seed=4", 24, 14);
    EXPECT_NE(report.verdict, Verdict::refused);
    ASSERT_TRUE(report.pairs[1]);
    EXPECT_NEAR(report.pairs[1]->baseline_mm, 450.0, 4.0 * report.pairs[1]->baseline_sigma_mm);
    for (const auto& reason : report.reasons) {
        std::printf("%s\n", reason.c_str());
    }
}

}  // namespace
}  // namespace kambara
