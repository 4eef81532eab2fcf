// SPDX-License-Identifier: GPL-3.0-or-later
// A real head by its URI, from the command line and for the main job; the simulated EVI-D30 is at
// the other end of the line.
#include <gtest/gtest.h>

#include <atomic>
#include <nlohmann/json.hpp>
#include <string>
#include <thread>

#include "app/cli/live_command.h"
#include "app/cli/pan_tilt_command.h"
#include "app/cli/simulate_evi_command.h"
#include "app/sources/heads.h"
#include "app/sources/sources.h"
#include "core/base/clock.h"
#include "hardware/visca/evi_server.h"
#include "tests/support/process.h"

namespace kambara {
namespace {

class RealHeadTest : public testing::Test {
  protected:
    void serve(const visca::LineFaults& faults = {}) {
        visca::EviServerOptions options;
        options.pty = (testing_support::fresh_folder("real_head") / "evi").string();
        options.udp_port = 0;
        options.faults = faults;
        auto opened = visca::EviServer::open(options, clock_);
        ASSERT_TRUE(opened.ok()) << opened.error().text();
        server_ = std::move(*opened);
        serial_ = "visca:" + options.pty;
        udp_ = "visca-udp:127.0.0.1:" + std::to_string(server_->udp_port());
        serving_ = std::jthread([this](std::stop_token stop) { server_->run(stop, {}, false); });
    }
    nlohmann::json told(const std::string& action, const std::string& value = "") {
        const auto outcome = cli::run_pan_tilt({serial_, action, value});
        EXPECT_FALSE(outcome.failure.has_value()) << outcome.failure->text();
        return nlohmann::json::parse(outcome.json);
    }
    void TearDown() override {
        serving_ = {};
        server_.reset();
    }

    SteadyClock clock_;
    std::unique_ptr<visca::EviServer> server_;
    std::string serial_;
    std::string udp_;
    std::jthread serving_;
};

TEST_F(RealHeadTest, IsDrivenFromTheCommandLine) {
    serve();
    const auto moved = told("move", "12,-6");
    EXPECT_NEAR(moved["pan_deg"].get<double>(), 12.0, 0.06);
    EXPECT_NEAR(moved["tilt_deg"].get<double>(), -6.0, 0.05);
    EXPECT_FALSE(moved["moving"].get<bool>());
    EXPECT_EQ(told("home")["pan_deg"], 0.0);
    // Half a second at 20 degrees a second, and then it stands.
    cli::PanTiltOptions drive{serial_, "drive", "20,0"};
    drive.seconds = 0.5;
    const auto driven = nlohmann::json::parse(cli::run_pan_tilt(drive).json);
    EXPECT_FALSE(driven["moving"].get<bool>());
    EXPECT_NEAR(driven["pan_deg"].get<double>(), 10.0, 4.0);
    EXPECT_EQ(told("home")["pan_deg"], 0.0);
    const auto refused = cli::run_pan_tilt({serial_, "move", "101,0"});
    ASSERT_TRUE(refused.failure.has_value());
    EXPECT_FALSE(refused.wrong_usage);
    for (const auto& [action, value] :
         {std::pair("move", "12"), {"jump", ""}, {"zoom", ""}, {"home", "3"}}) {
        EXPECT_TRUE(cli::run_pan_tilt({serial_, action, value}).wrong_usage) << action;
    }
}

TEST_F(RealHeadTest, FollowsTheTargetLive) {
    serve();
    for (const std::string& uri : {serial_, udp_}) {
        const auto outcome = cli::run_live({"default?particles=0", uri, 3.0});
        ASSERT_FALSE(outcome.failure.has_value()) << outcome.failure->text();
        const auto json = nlohmann::json::parse(outcome.json);
        EXPECT_GE(json["tracked_fraction"].get<double>(), 0.9) << uri;
        // The head begins at home.
        EXPECT_GE(json["head_within_1_deg_fraction"].get<double>(), 0.6) << uri;
    }
}

TEST_F(RealHeadTest, WhatHappensToItIsInTheLog) {
    visca::LineFaults faults;
    faults.unplug_every_s = 2.5;
    faults.unplug_for_s = 0.5;
    serve(faults);
    SourceOptions options;
    options.left = "sim:default?particles=0";
    options.pan_tilt = serial_;
    options.live = true;
    auto sources = open_sources(options, clock_);
    ASSERT_TRUE(sources.ok()) << sources.error().text();
    EXPECT_TRUE(sources->real_head);
    auto system = open_vision_system(std::move(sources->parts), {}, clock_);
    ASSERT_TRUE(system.ok()) << system.error().text();
    std::atomic<int> lost = 0;
    std::atomic<int> back = 0;
    const auto observed = (*system)->observe_events([&](const Event& event) {
        lost += event.text.find("was lost") != std::string::npos ? 1 : 0;
        back += event.text.find("answers again") != std::string::npos ||
                        event.text.find("is there again") != std::string::npos
                    ? 1
                    : 0;
    });
    ASSERT_TRUE((*system)->execute(Flow{Flow::Kind::run}).ok());
    for (int i = 0; i < 800 && back == 0; ++i) {
        std::this_thread::sleep_for(std::chrono::milliseconds(5));
    }
    EXPECT_EQ(lost, 1);
    EXPECT_GE(back, 1);
}

TEST(RealHead, SimulationsThatRunAheadOfTimeRefuseIt) {
    SteadyClock clock;
    SourceOptions options;
    options.left = "sim:default";
    options.pan_tilt = "visca:/dev/ttyS0";
    const auto refused = open_sources(options, clock);
    ASSERT_FALSE(refused.ok());
    EXPECT_NE(refused.error().remedy.find("live"), std::string::npos);
    options.pan_tilt = "gpio:7";
    EXPECT_NE(open_sources(options, clock).error().text().find("visca:"), std::string::npos);
    EXPECT_FALSE(open_head("gpio:7", clock).ok());
    EXPECT_TRUE(cli::run_simulate_evi({}).wrong_usage);
}

}  // namespace
}  // namespace kambara
