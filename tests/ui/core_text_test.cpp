// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/base/core_text.h"

#include <gtest/gtest.h>

#include <QCoreApplication>
#include <QTranslator>
#include <cmath>
#include <limits>

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
    EXPECT_EQ(translated(std::string("the match is only 63 % alike")),
              "[the match is only 63 % alike]");
    EXPECT_EQ(translated(std::string("Tracking -> Lost: not found in the right picture")),
              "[[Tracking] -> [Lost]: [not found in the right picture]]");
    EXPECT_EQ(translated(std::string("Target 2: Tracking -> Lost: not found in the right picture")),
              "[Target 2: [[Tracking] -> [Lost]: [not found in the right picture]]]");
    EXPECT_EQ(translated(std::string("nothing known")), "nothing known");
    EXPECT_EQ(translated(Error{"There is no pan-tilt head.", "Pray."}),
              "[There is no pan-tilt head.] Pray.");
    EXPECT_EQ(name_of(TrackState::lost), "[Lost]");
    QCoreApplication::removeTranslator(&brackets);
    EXPECT_EQ(translated(std::string("given up: not found in the right picture")),
              "given up: not found in the right picture");
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
