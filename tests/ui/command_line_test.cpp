// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/kambara/command_line.h"

#include <gtest/gtest.h>

namespace kambara {
namespace {

QStringList given(std::initializer_list<const char*> arguments) {
    QStringList list{QStringLiteral("kambara")};
    for (const char* argument : arguments) {
        list.append(QLatin1String(argument));
    }
    return list;
}

TEST(CommandLine, WithoutOptionsItIsTheSimulatedRig) {
    const auto options = CommandLine::read(given({}));
    EXPECT_EQ(options.first.left, "sim:default");
    EXPECT_EQ(options.simulation.left, "sim:default");
    EXPECT_TRUE(options.with_gl);
}

TEST(CommandLine, NamesARecording) {
    const auto options = CommandLine::read(given(
        {"--left", "l.mkv", "--right=r.mkv", "--rig", "rig.yaml", "--rate", "25", "--no-3d"}));
    EXPECT_EQ(options.first, (ui::SourceRequest{"l.mkv", "r.mkv", "rig.yaml", 25.0}));
    EXPECT_FALSE(options.with_gl);
}

TEST(CommandLine, FindsTheLanguage) {
    EXPECT_EQ(CommandLine::language(given({"--no-3d", "--language", "de"})), "de");
    EXPECT_EQ(CommandLine::language(given({"--language=en_GB"})), "en_GB");
    EXPECT_EQ(CommandLine::language(given({"--language"})), "");
}

TEST(CommandLineDeathTest, RefusesWhatItDoesNotUnderstand) {
    testing::GTEST_FLAG(death_test_style) = "threadsafe";
    const auto ends = testing::ExitedWithCode(2);
    EXPECT_EXIT(CommandLine::read(given({"film.mkv"})), ends, "film.mkv is not understood");
    EXPECT_EXIT(CommandLine::read(given({"--right", "r.mkv"})), ends, "name them with --left");
    EXPECT_EXIT(CommandLine::read(given({"--left", "l", "--rate", "fast"})), ends, "no rate");
    EXPECT_EXIT(CommandLine::read(given({"--left", "l", "--rate", "0"})), ends, "no rate");
}

}  // namespace
}  // namespace kambara
