// SPDX-License-Identifier: GPL-3.0-or-later
// The tables of 1999 from their raw records (resources/records), as the program prints them.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "app/cli/calibration_statistics_command.h"
#include "tests/support/process.h"

namespace kambara {
namespace {

namespace fs = std::filesystem;
using cli::run_calibration_statistics;
using nlohmann::json;

const fs::path records = fs::path(KAMBARA_SOURCE) / "resources" / "records";

json statistics_of_file(const fs::path& file) {
    const auto outcome = run_calibration_statistics({file});
    EXPECT_FALSE(outcome.failure) << outcome.failure->text();
    EXPECT_FALSE(outcome.summary.empty());
    return json::parse(outcome.json);
}

const json& group(const json& all, const std::string& environment, const std::string& camera) {
    for (const json& one : all["groups"]) {
        if (one["environment"] == environment && one["camera"] == camera) {
            return one;
        }
    }
    throw std::out_of_range(environment + camera);
}

const std::vector<std::string> names{"focal_length_mm", "kappa1_per_mm2", "cx_px", "cy_px", "sx"};

// A row of five as printed: mean, half-width and percentage, each to its last printed digit.
struct Printed {
    std::string environment;
    std::string camera;
    std::vector<double> mean;
    std::vector<double> half_width;
    std::vector<double> percentage;
};

const std::vector<Printed> printed{{"laboratory",
                                    "0",
                                    {2.846366, 0.037709, 337.796844, 240.503407, 1.030092},
                                    {0.0152, 0.0026, 6.2077, 1.0110, 0.0011},
                                    {1.069, 13.536, 3.675, 0.841, 0.212}},
                                   {"laboratory",
                                    "1",
                                    {6.258867, 0.019131, 329.743668, 255.606562, 1.293961},
                                    {0.474978, 0.006799, 16.558347, 15.988919, 0.013251},
                                    {15.178, 71.075, 10.043, 12.511, 2.048}},
                                   {"underwater",
                                    "0",
                                    {3.808516, 0.007852, 340.722355, 241.853594, 1.031134},
                                    {0.046373, 0.002017, 5.182598, 3.204416, 0.000928},
                                    {2.435, 51.378, 3.042, 2.650, 0.180}},
                                   {"underwater",
                                    "2",
                                    {3.814817, 0.007799, 300.620906, 233.137488, 1.030247},
                                    {0.024588, 0.001565, 7.697915, 4.135454, 0.001279},
                                    {1.289, 40.127, 5.121, 3.548, 0.248}}};

TEST(CalibrationStatistics, TheTablesOf1999ComeOutOfTheirRecords) {
    const json all = statistics_of_file(records / "1999-intrinsic.csv");
    for (const Printed& table : printed) {
        const json& parameters = group(all, table.environment, table.camera)["parameters"];
        const double half_digits = table.camera == "0" && table.environment == "laboratory"
                                       ? 6e-5     // printed to four decimals
                                       : 1.1e-6;  // to six, from records rounded to six
        for (std::size_t i = 0; i < names.size(); ++i) {
            const json& one = parameters[names[i]];
            EXPECT_NEAR(one["mean"].get<double>(), table.mean[i], 1.1e-6) << names[i];
            const json& old = one["with_t_2_776"];
            EXPECT_NEAR(old["half_width"].get<double>(), table.half_width[i], half_digits)
                << table.environment << table.camera << names[i];
            EXPECT_NEAR(old["percentage_error"].get<double>(), table.percentage[i],
                        0.0006 + 1e-4 * table.percentage[i])
                << table.environment << table.camera << names[i];
        }
    }
}

TEST(CalibrationStatistics, ARawTableGivesDeviationAndLimits) {
    const json all = statistics_of_file(records / "1999-intrinsic.csv");
    // Camera 2 in the laboratory: the raw table, which its own records bear out.
    const json& lab = group(all, "laboratory", "2")["parameters"];
    const std::vector<double> half{0.015809, 0.002466, 4.914722, 2.754884, 0.001647};
    const std::vector<double> lower{2.868403, 0.033151, 288.503196, 230.021929, 1.028780};
    const std::vector<double> percentage{1.096, 13.847, 3.350, 2.367, 0.320};
    for (std::size_t i = 0; i < names.size(); ++i) {
        const json& old = lab[names[i]]["with_t_2_776"];
        EXPECT_NEAR(old["half_width"].get<double>(), half[i], 1.1e-6) << names[i];
        EXPECT_NEAR(old["lower"].get<double>(), lower[i], 2e-6) << names[i];
        EXPECT_NEAR(old["percentage_error"].get<double>(), percentage[i], 1e-3) << names[i];
    }
    const std::vector<double> deviation{0.057867, 0.002517, 6.467235, 3.998712, 0.001157};
    const json& wet = group(all, "underwater", "0")["parameters"];
    for (std::size_t i = 0; i < names.size(); ++i) {
        EXPECT_NEAR(wet[names[i]]["deviation"].get<double>(), deviation[i], 1.1e-6) << names[i];
    }
    EXPECT_EQ(wet["sx"]["n"], 12);
}

TEST(CalibrationStatistics, TheRightTStandsBesideThatOf1999) {
    const json all = statistics_of_file(records / "1999-intrinsic.csv");
    const json& f = group(all, "laboratory", "0")["parameters"]["focal_length_mm"];
    EXPECT_NEAR(f["t"].get<double>(), 2.364624, 1e-6);
    EXPECT_EQ(f["with_t_2_776"]["t"], 2.776);
    EXPECT_NEAR(f["half_width"].get<double>() / f["with_t_2_776"]["half_width"].get<double>(),
                2.364624 / 2.776, 1e-6);
}

TEST(CalibrationStatistics, DuplicatesAreFlaggedAndTakenOut) {
    const json all = statistics_of_file(records / "1999-intrinsic.csv");
    const json expected = json::array({{"2", "4"}, {"3", "5"}});
    EXPECT_EQ(group(all, "laboratory", "0")["duplicates"], expected);
    EXPECT_EQ(group(all, "laboratory", "1")["duplicates"], expected);
    EXPECT_TRUE(group(all, "laboratory", "2")["duplicates"].empty());
    const json& f = group(all, "laboratory", "0")["parameters"]["focal_length_mm"];
    EXPECT_EQ(f["without_duplicates"]["n"], 6);
    EXPECT_GT(f["without_duplicates"]["half_width"], f["half_width"]);
}

TEST(CalibrationStatistics, WaterAgainstAirStandsBesideTheFirstOrder) {
    const json all = statistics_of_file(records / "1999-intrinsic.csv");
    ASSERT_EQ(all["air_and_water"].size(), 2U);  // camera 1 was not calibrated in water
    const json& left = all["air_and_water"][0];
    const json& right = all["air_and_water"][1];
    EXPECT_NEAR(left["f_ratio"].get<double>(), 1.338, 5e-4);
    EXPECT_NEAR(right["f_ratio"].get<double>(), 1.323, 5e-4);
    EXPECT_EQ(left["predicted_f_ratio"], 1.333);
    EXPECT_NEAR(left["predicted_kappa1_per_mm2"].get<double>(), 0.0107, 5e-5);
    EXPECT_NEAR(right["predicted_kappa1_per_mm2"].get<double>(), 0.0093, 5e-5);
    EXPECT_NEAR(left["kappa1_in_water_per_mm2"].get<double>(), 0.0079, 5e-5);
}

TEST(CalibrationStatistics, BaselinesAreNamedForWhatTheyAre) {
    const json all = statistics_of_file(records / "1999-extrinsic.csv");
    const std::vector<double> lab{412.68575, 426.85729, 426.85729, 423.06713, 486.92141};
    const json& dry = group(all, "laboratory", "");
    for (std::size_t i = 0; i < lab.size(); ++i) {
        const json& one = dry["baselines"][i];
        EXPECT_NEAR(one["norm_t0_minus_t2_mm"].get<double>(), lab[i], 1e-5);
        EXPECT_FALSE(one.contains("baseline_mm"));  // without rotations there is none
        EXPECT_EQ(one["attempt"], std::to_string(i + 1));
    }
    EXPECT_EQ(dry["duplicates"], json::array({{"2", "3"}}));
    EXPECT_NEAR(dry["norm_t0_minus_t2_statistics"]["mean"].get<double>(), 435.27777, 1e-4);
    EXPECT_NEAR(group(all, "underwater", "")["norm_t0_minus_t2_statistics"]["mean"].get<double>(),
                476.67703, 1e-4);
    EXPECT_NE(dry["norm_t0_minus_t2_note"].get<std::string>().find("same rotation"),
              std::string::npos);
}

TEST(CalibrationStatistics, BadTablesAreRefusedByLine) {
    const fs::path folder = testing_support::fresh_folder("bad_statistics");
    const auto cause = [&](const std::string& text) {
        const fs::path file = folder / "records.csv";
        std::ofstream(file) << text;
        const auto outcome = run_calibration_statistics({file});
        return outcome.failure ? outcome.failure->cause : std::string();
    };
    EXPECT_NE(cause("").find("no records"), std::string::npos);
    EXPECT_NE(cause("record,f_mm\n").find("no records"), std::string::npos);
    EXPECT_NE(cause("record,f_mm\n1,2.8\n2,2.9x\n").find("Line 3"), std::string::npos);
    EXPECT_NE(cause("record,f_mm\n1,2.8,3\n").find("Line 2"), std::string::npos);
    EXPECT_NE(cause("record,f_mm\n1,nan\n").find("Line 2"), std::string::npos);
    EXPECT_NE(cause("1,2.8\n2,2.9\n").find("header"), std::string::npos);
    EXPECT_NE(cause("f_mm,f_mm\n1,2\n").find("twice"), std::string::npos);
    EXPECT_FALSE(run_calibration_statistics({folder / "none.csv"}).failure->remedy.empty());
    fs::remove_all(folder);
}

}  // namespace
}  // namespace kambara
