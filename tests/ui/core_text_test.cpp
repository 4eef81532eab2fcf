// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/base/core_text.h"

#include <gtest/gtest.h>

#include <QCoreApplication>
#include <QTranslator>
#include <cmath>
#include <limits>

#include "core/calibration/rig_calibrator.h"
#include "core/calibration/target_detector.h"
#include "core/stereo/range_experiment.h"
#include "ui/base/quantities.h"
#include "ui/tracking/heat_colours.h"

namespace kambara::ui {
namespace {

// Says what it was asked for, in brackets.
class Brackets : public QTranslator {
  public:
    bool isEmpty() const override { return false; }
    QString translate(const char* context, const char* source, const char*, int) const override {
        return qstrcmp(context, "core") == 0 ? QStringLiteral("[%1]").arg(QLatin1String(source))
                                             : QString();
    }
};

TEST(CoreText, TranslatesPhrasesAndKeepsTheirNumbers) {
    Brackets brackets;
    QCoreApplication::installTranslator(&brackets);
    EXPECT_EQ(translated(std::string("the match is right with a probability of only 63 %")),
              "[the match is right with a probability of only 63 %]");
    EXPECT_EQ(translated(std::string("Tracking -> Lost: not found in the right picture")),
              "[[Tracking] -> [Lost]: [not found in the right picture]]");
    EXPECT_EQ(translated(std::string("Target 2: Tracking -> Lost: not found in the right picture")),
              "[Target 2: [[Tracking] -> [Lost]: [not found in the right picture]]]");
    EXPECT_EQ(translated(std::string("nothing known")), "nothing known");
    EXPECT_EQ(translated(Error{"There is no pan-tilt head.", "Pray."}),
              "[There is no pan-tilt head.] Pray.");
    EXPECT_EQ(translated(Error{"No file fits the pattern /a/%06d.png.", "Check the name."}),
              "[No file fits the pattern /a/%06d.png.] [Check the name.]");
    EXPECT_EQ(name_of(TrackState::lost), "[Lost]");
    EXPECT_EQ(name_of(TrackState::template_set), "[Template set]");
    EXPECT_EQ(translated(std::string("Idle -> TemplateSet")), "[[Idle] -> [Template set]]");
    QCoreApplication::removeTranslator(&brackets);
    EXPECT_EQ(translated(std::string("given up: not found in the right picture")),
              "given up: not found in the right picture");
}

TEST(CoreText, KnowsWhatARangeExperimentRefuses) {
    Brackets brackets;
    QCoreApplication::installTranslator(&brackets);
    const auto refused =
        judge_ranges({{{0.0, 0.0, 1000.0}, {{0.0, 0.0, 1485.0}}}}, {450.0, std::nullopt, false});
    ASSERT_FALSE(refused);
    EXPECT_EQ(translated(refused.error()).count(QLatin1Char('[')), 2)
        << translated(refused.error()).toStdString();
    QCoreApplication::removeTranslator(&brackets);
}

// Sentences as core says them today: a changed one must not fall out of the translation.
TEST(CoreText, KnowsWhatACalibrationSays) {
    Brackets brackets;
    QCoreApplication::installTranslator(&brackets);
    RigCalibratorOptions options;
    options.cameras = {PictureSize{640, 480}, PictureSize{640, 480}};
    const CalibrationReport report = calibrate_rig({}, two_plane_24(), options);
    ASSERT_FALSE(report.reasons.empty());
    for (const std::string& reason : report.reasons) {
        EXPECT_TRUE(translated(reason).startsWith(QLatin1Char('['))) << reason;
    }
    const Image dark(640, 480);
    for (const Target& target : {Target(two_plane_24()), Target(ChessboardTarget{9, 6, 30.0}),
                                 Target(CharucoTarget{5, 7, 40.0, 20.0, "DICT_6X6_250"})}) {
        const auto found = detect_target(dark, target);
        ASSERT_FALSE(found);
        EXPECT_TRUE(translated(found.error().cause).startsWith(QLatin1Char('[')))
            << found.error().cause;
        EXPECT_TRUE(translated(found.error().remedy).startsWith(QLatin1Char('[')))
            << found.error().remedy;
    }
    for (const char* name : {"chessboard:1x1:3", "charuco:5x7:40:60:DICT_6X6_250", "cube"}) {
        const auto target = parse_target(name);
        ASSERT_FALSE(target);
        const QString said = translated(target.error());
        EXPECT_TRUE(said.startsWith(QLatin1Char('[')) && said.endsWith(QLatin1Char(']')))
            << said.toStdString();
    }
    QCoreApplication::removeTranslator(&brackets);
}

TEST(Quantities, CarryTheirUnits) {
    EXPECT_EQ(millimetres(1234.56), QString::fromUtf8("1234.6\u202Fmm"));
    EXPECT_EQ(degrees(-1.0, 0), QString::fromUtf8("-57\u202F\u00B0"));
    EXPECT_EQ(percent(0.934), QString::fromUtf8("93\u202F%"));
    EXPECT_EQ(hertz(std::nan("")), QString::fromUtf8("\u2013"));
    EXPECT_EQ(pixels(std::numeric_limits<double>::infinity()), QString::fromUtf8("\u2013"));
}

TEST(HeatColours, GrowLighterAllTheWay) {
    for (int i = 1; i <= 100; ++i) {
        EXPECT_GE(qGray(heat_colour(0.01 * i)), qGray(heat_colour(0.01 * (i - 1)))) << i;
    }
    EXPECT_EQ(heat_colour(-3.0), heat_colour(0.0));
    EXPECT_EQ(heat_colour(7.0), heat_colour(1.0));
}

}  // namespace
}  // namespace kambara::ui
