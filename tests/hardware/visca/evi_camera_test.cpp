// SPDX-License-Identifier: GPL-3.0-or-later
// The camera as the program uses it, with threads, real lines and the machine's clock, against the
// simulated one.
#include "hardware/visca/evi_camera.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <chrono>
#include <cmath>
#include <filesystem>
#include <thread>

#include "hardware/visca/evi_server.h"

namespace kambara::visca {
namespace {

using std::chrono::milliseconds;

HeadAngles degrees(double pan, double tilt) {
    return {rad_from_deg(pan), rad_from_deg(tilt)};
}

class EviCameraTest : public testing::Test {
  protected:
    void serve(EviServerOptions options) {
        options.pty = pty_;
        options.udp_port = 0;
        options.tcp_port = 0;
        auto opened = EviServer::open(options, clock_);
        ASSERT_TRUE(opened.ok()) << opened.error().text();
        server_ = std::move(*opened);
        serving_ = std::jthread([this](std::stop_token stop) { server_->run(stop, {}, false); });
    }
    void TearDown() override {
        if (serving_.joinable()) {
            serving_.request_stop();
            serving_.join();
        }
        server_.reset();
        EXPECT_FALSE(std::filesystem::exists(std::filesystem::symlink_status(pty_)));
    }
    /// Waits until the head is said to be there; how long that took.
    double seconds_until_at(EviCamera& camera, const HeadAngles& angles, double most_s = 5.0) {
        const auto began = std::chrono::steady_clock::now();
        while (true) {
            const std::chrono::duration<double> took = std::chrono::steady_clock::now() - began;
            const auto status = camera.status();
            const bool there = status && !status->moving &&
                               std::abs(status->angles.pan_rad - angles.pan_rad) < 0.002 &&
                               std::abs(status->angles.tilt_rad - angles.tilt_rad) < 0.002;
            if (there || took.count() > most_s) {
                EXPECT_TRUE(there);
                return took.count();
            }
            std::this_thread::sleep_for(milliseconds(2));
        }
    }

    const std::string pty_ = (std::filesystem::temp_directory_path() /
                              ("kambara-evi-" + std::to_string(::getpid()) + "-" +
                               testing::UnitTest::GetInstance()->current_test_info()->name()))
                                 .string();
    SteadyClock clock_;
    std::unique_ptr<EviServer> server_;
    std::jthread serving_;
};

// What waits for time-outs on the machine's clock.
class EviCameraSlow : public EviCameraTest {};

TEST_F(EviCameraTest, WorksOverEveryKindOfLine) {
    serve({});
    const std::string udp = std::to_string(server_->udp_port());
    double pan = 10.0;
    for (const std::string& uri :
         {"visca:" + pty_, "visca-udp:127.0.0.1:" + udp, "visca-udp-raw:127.0.0.1:" + udp,
          "visca-tcp:127.0.0.1:" + std::to_string(server_->tcp_port())}) {
        SCOPED_TRACE(uri);
        auto camera = open_evi_camera(uri, clock_);
        ASSERT_TRUE(camera.ok()) << camera.error().text();
        EXPECT_EQ((*camera)->name(), uri);
        EXPECT_EQ((*camera)->limits(), HeadLimits{});
        ASSERT_TRUE((*camera)->move_to(degrees(pan, -5.0)).ok());
        // 20 degrees take 0.45 s at most.
        EXPECT_LT(seconds_until_at(**camera, degrees(pan, -5.0)), 2.0);
        pan = -pan;
        for (const HeadNote& note : (*camera)->take_notes()) {
            EXPECT_EQ(note.kind, HeadNote::Kind::note) << note.text;
        }
    }
}

TEST_F(EviCameraTest, NoCallWaitsForTheLine) {
    EviServerOptions options;
    options.baud = 1200;  // a position takes an eighth of a second to be told
    serve(options);
    auto camera = open_evi_camera("visca:" + pty_ + "?baud=1200&timeout=500", clock_);
    ASSERT_TRUE(camera.ok()) << camera.error().text();
    const auto began = std::chrono::steady_clock::now();
    for (int i = 0; i < 200; ++i) {
        ASSERT_TRUE((*camera)->move_to(degrees(0.1 * i, 0.0)).ok());
        ASSERT_TRUE((*camera)->status().ok());
    }
    ASSERT_TRUE((*camera)->zoom_to(0.5).ok());
    const std::chrono::duration<double> took = std::chrono::steady_clock::now() - began;
    EXPECT_LT(took.count(), 0.1);
    seconds_until_at(**camera, degrees(19.9, 0.0));
}

TEST_F(EviCameraTest, AHaltIsToldBeforeItGoes) {
    serve({});
    const std::string uri = "visca:" + pty_;
    auto camera = open_evi_camera(uri, clock_);
    ASSERT_TRUE(camera.ok()) << camera.error().text();
    const auto look_later = [&] {
        std::this_thread::sleep_for(milliseconds(300));
        return (*camera)->status();
    };
    ASSERT_TRUE((*camera)->drive(rad_from_deg(10.0), 0.0).ok());
    ASSERT_TRUE(look_later()->moving);
    ASSERT_TRUE((*camera)->halt().ok());
    const auto began = std::chrono::steady_clock::now();
    camera->reset();
    const std::chrono::duration<double> took = std::chrono::steady_clock::now() - began;
    EXPECT_LT(took.count(), 0.5);
    camera = open_evi_camera(uri, clock_);
    ASSERT_TRUE(camera.ok()) << camera.error().text();
    const auto then = look_later();
    const auto later = look_later();
    ASSERT_TRUE(then.ok() && later.ok());
    EXPECT_EQ(then->angles, later->angles) << "it turns on";
    EXPECT_GT(later->angles.pan_rad, 0.0);
}

TEST_F(EviCameraTest, RefusesWhatCannotBe) {
    serve({});
    const auto camera = open_evi_camera("visca:" + pty_, clock_);
    ASSERT_TRUE(camera.ok()) << camera.error().text();
    for (const HeadAngles& beyond : {degrees(100.1, 0), degrees(0, -25.1), degrees(NAN, 0)}) {
        const auto refused = (*camera)->move_to(beyond);
        ASSERT_FALSE(refused.ok());
        EXPECT_NE(refused.error().remedy.find("100"), std::string::npos);
    }
    EXPECT_FALSE((*camera)->zoom_to(1.1).ok());
    EXPECT_FALSE((*camera)->focus_to(-0.1).ok());
    EXPECT_FALSE((*camera)->keep_preset(6).ok());
    EXPECT_FALSE((*camera)->recall_preset(-1).ok());
    EXPECT_FALSE((*camera)->drive(NAN, 0.0).ok());
}

TEST_F(EviCameraSlow, SaysWhyItCannotBeOpened) {
    serve({});
    const std::pair<std::string, const char*> all[] = {
        {"visca:/dev/no-such-line", "/dev/no-such-line"},
        {"visca-tcp:127.0.0.1:1", "127.0.0.1:1"},
        {"visca:" + pty_ + "?address=3", "no camera 3"},
        {"visca:" + pty_ + "?model=evi-d99", "evi-d30"},
        {"visca:" + pty_ + "?heads=/no/such/file", "/no/such/file"},
        {"visca:" + pty_ + "?address=9", "1 to 7"},
        {"visca:" + pty_ + "?colour=red", "colour"},
        {"visca:", "where"},
        {"visca-usb:1", "visca-udp"},
    };
    for (const auto& [uri, text] : all) {
        const auto camera = open_evi_camera(uri, clock_);
        ASSERT_FALSE(camera.ok()) << uri;
        EXPECT_NE(camera.error().text().find(text), std::string::npos) << camera.error().text();
    }
}

TEST_F(EviCameraSlow, SurvivesARealUnplugging) {
    EviServerOptions options;
    options.faults.unplug_every_s = 2.5;
    options.faults.unplug_for_s = 0.7;
    serve(options);
    const auto began = std::chrono::steady_clock::now();
    for (const std::string& uri :
         {"visca:" + pty_, "visca-tcp:127.0.0.1:" + std::to_string(server_->tcp_port())}) {
        SCOPED_TRACE(uri);
        auto camera = open_evi_camera(uri, clock_);
        ASSERT_TRUE(camera.ok()) << camera.error().text();
        while ((*camera)->status()) {
            std::this_thread::sleep_for(milliseconds(5));
            ASSERT_LT(std::chrono::steady_clock::now() - began, std::chrono::seconds(8));
        }
        ASSERT_TRUE((*camera)->move_by_hand(degrees(15.0, 5.0)).ok());
        // What is left of 0.7 s, then what the return and the motion take.
        EXPECT_LT(seconds_until_at(**camera, degrees(15.0, 5.0)), 0.7 + 1.0);
        std::string notes;
        for (const HeadNote& note : (*camera)->take_notes()) {
            notes += note.text + "\n";
        }
        EXPECT_NE(notes.find("was lost"), std::string::npos) << notes;
        EXPECT_NE(notes.find("is there again"), std::string::npos) << notes;
        ASSERT_TRUE((*camera)->move_by_hand(degrees(0.0, 0.0)).ok());
        seconds_until_at(**camera, degrees(0.0, 0.0));
    }
}

TEST_F(EviCameraTest, ANameThatIsTakenIsLeftAlone) {
    const std::filesystem::path file = pty_ + ".txt";
    {
        std::FILE* made = std::fopen(file.c_str(), "w");
        std::fclose(made);
    }
    EviServerOptions options;
    options.pty = file;
    const auto opened = EviServer::open(options, clock_);
    ASSERT_FALSE(opened.ok());
    EXPECT_NE(opened.error().cause.find(file.string()), std::string::npos);
    EXPECT_TRUE(std::filesystem::is_regular_file(file));
    std::filesystem::remove(file);
}

}  // namespace
}  // namespace kambara::visca
