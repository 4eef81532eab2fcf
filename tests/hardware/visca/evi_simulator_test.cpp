// SPDX-License-Identifier: GPL-3.0-or-later
#include "hardware/visca/evi_simulator.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/hardware/visca/vectors.h"

namespace kambara::visca {
namespace {

constexpr std::int64_t ms = 1'000'000;
constexpr double field_ms = 16.683333;
constexpr int full_pan = 0x18;
constexpr int full_tilt = 0x14;

struct Heard {
    std::string packet;
    double ms = 0.0;
};

class EviSimulatorTest : public testing::Test {
  protected:
    void send(const Message& message, int address = 1) { send(encode(message, address)); }
    void send(const Bytes& packet) { simulator_.receive(packet, 7, now_ns_); }

    std::vector<Heard> wait_ms(std::int64_t time_ms) {
        now_ns_ += time_ms * ms;
        std::vector<Heard> heard;
        for (const auto& output : simulator_.advance(now_ns_)) {
            EXPECT_EQ(output.tag, 7U);
            heard.push_back({hex_from_bytes(output.packet),
                             static_cast<double>(output.time_ns - start_ns_) * 1e-6});
        }
        return heard;
    }
    std::vector<std::string> packets(std::int64_t time_ms) {
        std::vector<std::string> all;
        for (const Heard& heard : wait_ms(time_ms)) {
            all.push_back(heard.packet);
        }
        return all;
    }
    /// Sends, and gives back what is heard until half a second later.
    std::vector<std::string> said_to(const Message& message, std::int64_t time_ms = 500) {
        send(message);
        return packets(time_ms);
    }
    std::vector<int> asked(Op inquiry) {
        send(Message{inquiry});
        const auto heard = packets(40);
        EXPECT_EQ(heard.size(), 1U);
        const auto reply = decode_reply(*bytes_from_hex(heard.at(0)));
        return decode_answer(inquiry, std::get<Completed>(reply.value().reply).data).value();
    }

    // Not at a round number, as a machine's clock would be.
    const std::int64_t start_ns_ = 987'654'321'000;
    std::int64_t now_ns_ = start_ns_;
    EviSimulator simulator_{start_ns_};
};

using Texts = std::vector<std::string>;
const Texts done{"90 41 FF", "90 51 FF"};

TEST_F(EviSimulatorTest, SaysTheRecordedBytes) {
    if (!std::filesystem::exists(vector_file())) {
        GTEST_SKIP() << "skipped: no " << vector_file();
    }
    const auto vectors = read_vectors();
    ASSERT_EQ(vectors.size(), 36U);
    for (const Vector& vector : vectors) {
        SCOPED_TRACE(vector.call);
        simulator_ = EviSimulator(now_ns_);
        if (vector.call.starts_with("get_pantilt_mode")) {
            // Initialising, at the left end: during a reset, where the tilt is still above its end.
            send({Op::absolute, {full_pan, full_tilt, -880, 300}});
            wait_ms(2500);
            send(Message{Op::reset});
            wait_ms(20);
        } else if (vector.call.starts_with("get_pantilt_position")) {
            send({Op::absolute, {full_pan, full_tilt, -500, 60}});
            wait_ms(2000);
        } else if (vector.call.starts_with("set_focus")) {
            send({Op::focus_mode, {3}});
            wait_ms(50);
        } else if (vector.call.starts_with("[address 3]")) {
            send({Op::address_set, {3}}, broadcast_address);
            wait_ms(50);
        }
        send(vector.sent);
        Texts expected;
        for (const Bytes& bytes : vector.replies) {
            expected.push_back(hex_from_bytes(bytes));
        }
        EXPECT_EQ(packets(vector.call.starts_with("get") ? 30 : 60000), expected);
    }
}

TEST_F(EviSimulatorTest, AcknowledgesWithinAFieldAndCompletesWhenTheMotionEnds) {
    // 100 degrees at 80 degrees/s, and up to speed and down again at 400 degrees/s².
    send({Op::absolute, {full_pan, 1, 880, 0}});
    const auto heard = wait_ms(3000);
    ASSERT_EQ(heard.size(), 2U);
    EXPECT_EQ(heard[0].packet, "90 41 FF");
    EXPECT_LE(heard[0].ms, field_ms + 0.001);
    EXPECT_EQ(heard[1].packet, "90 51 FF");
    EXPECT_NEAR(heard[1].ms - heard[0].ms, 1e3 * (100.0 / 80.0 + 80.0 / 400.0), 8.0);
    EXPECT_EQ(asked(Op::ask_position), (std::vector{880, 0}));

    // 50 degrees of tilt at half speed, 25 degrees/s.
    send({Op::absolute, {full_pan, full_tilt, 880, -300}});
    wait_ms(2000);
    const double began_ms = static_cast<double>(now_ns_ - start_ns_) * 1e-6;
    send({Op::absolute, {1, full_tilt / 2, 880, 300}});
    const auto tilted = wait_ms(4000);
    ASSERT_EQ(tilted.size(), 2U);
    EXPECT_NEAR(tilted[1].ms - began_ms, 1e3 * (50.0 / 25.0 + 25.0 / 400.0), 8.0 + field_ms);
}

TEST_F(EviSimulatorTest, MovesSmoothlyAndNeverFasterThanItCan) {
    send({Op::absolute, {full_pan, full_tilt, -880, 300}});
    double last_pan = 0.0;
    double last_speed = 0.0;
    for (int i = 0; i < 2000; ++i) {
        wait_ms(1);
        const double pan = simulator_.state().pan_steps;
        const double speed = (pan - last_pan) * 1e3 / 8.8;
        EXPECT_LE(std::abs(speed), 80.0 + 1e-6);
        // But for the last piece of the way, which is no change at all to the eye.
        EXPECT_LE(std::abs(speed - last_speed), 2.0 * 0.4 + 1e-6) << i;
        EXPECT_GE(pan, -880.0);
        last_pan = pan;
        last_speed = speed;
    }
    EXPECT_EQ(last_pan, -880.0);
    EXPECT_EQ(simulator_.state().tilt_steps, 300.0);
}

TEST_F(EviSimulatorTest, DoesNotDependOnHowOftenItIsAsked) {
    EviSimulator other(start_ns_);
    const Bytes move = encode({Op::absolute, {9, 5, 500, -200}}, 1);
    simulator_.receive(move, 7, start_ns_ + 3 * ms);
    other.receive(move, 7, start_ns_ + 3 * ms);
    for (int i = 0; i < 700; ++i) {
        other.advance(start_ns_ + 3 * ms + i * 1'300'000);
    }
    now_ns_ = start_ns_ + 3 * ms + 699 * 1'300'000;
    wait_ms(0);
    EXPECT_EQ(simulator_.state().pan_steps, other.state().pan_steps);
    EXPECT_NE(other.state().pan_steps, 0.0);
}

TEST_F(EviSimulatorTest, HasTwoSockets) {
    send({Op::absolute, {1, 1, 880, 0}});
    send({Op::zoom_direct, {0x3FF}});
    send({Op::back_light, {2}});
    send(Message{Op::ask_power});
    EXPECT_EQ(packets(80), (Texts{"90 41 FF", "90 42 FF", "90 60 03 FF", "90 50 02 FF"}));
    EXPECT_EQ(simulator_.state().sockets_in_use, 2);
    EXPECT_EQ(packets(3000), Texts{"90 52 FF"}) << "the zoom is there first";
    EXPECT_EQ(said_to({Op::back_light, {2}}, 50), (Texts{"90 42 FF", "90 52 FF"}));
    EXPECT_EQ(packets(40000), Texts{"90 51 FF"});
}

TEST_F(EviSimulatorTest, CancelsWhatIsUnderWay) {
    send({Op::absolute, {full_pan, full_tilt, 880, 0}});
    packets(400);
    const double pan = simulator_.state().pan_steps;
    EXPECT_EQ(said_to({Op::cancel, {1}}), Texts{"90 61 04 FF"});
    EXPECT_FALSE(simulator_.state().moving);
    EXPECT_LT(simulator_.state().pan_steps, pan + 88.0 + 15.0) << "it brakes";
    EXPECT_EQ(said_to({Op::cancel, {1}}), Texts{"90 61 05 FF"});
    EXPECT_EQ(said_to({Op::cancel, {5}}), Texts{"90 65 05 FF"});
}

TEST_F(EviSimulatorTest, ANewerPositionTakesOver) {
    send({Op::absolute, {full_pan, full_tilt, 880, 0}});
    packets(300);
    send({Op::absolute, {full_pan, full_tilt, -100, 50}});
    EXPECT_EQ(packets(50), (Texts{"90 42 FF", "90 51 FF"}));
    EXPECT_EQ(packets(2500), Texts{"90 52 FF"});
    EXPECT_EQ(asked(Op::ask_position), (std::vector{-100, 50}));
}

TEST_F(EviSimulatorTest, RefusesWhatItsModeForbids) {
    EXPECT_EQ(said_to({Op::focus, {2}}), Texts{"90 61 41 FF"}) << "autofocus is on";
    EXPECT_EQ(said_to({Op::iris, {2}}), Texts{"90 61 41 FF"}) << "automatic exposure";
    send({Op::absolute, {1, 1, 880, 0}});
    packets(50);
    EXPECT_EQ(said_to({Op::drive, {5, 5, 3, 3}}, 50), Texts{"90 62 41 FF"}) << "in a move";
    simulator_ = EviSimulator(now_ns_);
    EXPECT_EQ(said_to({Op::power, {3}}), done);
    EXPECT_EQ(said_to({Op::home}), Texts{"90 61 41 FF"}) << "standby";
    EXPECT_EQ(asked(Op::ask_power), std::vector{3});
    EXPECT_EQ(said_to({Op::power, {2}}, 100), Texts{"90 41 FF"});
    EXPECT_EQ(packets(10000), Texts{"90 51 FF"}) << "it has turned around once";
    EXPECT_EQ(asked(Op::ask_position), (std::vector{0, 0}));
    EXPECT_EQ(asked(Op::ask_status), std::vector{0x2800});
}

TEST_F(EviSimulatorTest, RefusesWhatItDoesNotKnow) {
    const Texts syntax{"90 60 02 FF"};
    EXPECT_EQ(said_to({Op::digital_zoom, {2}}), syntax) << "of later models";
    EXPECT_EQ(said_to({Op::memory_recall, {6}}), syntax);
    EXPECT_EQ(said_to({Op::absolute, {0x19, 1, 0, 0}}), syntax);
    EXPECT_EQ(said_to({Op::absolute, {0, 1, 0, 0}}), syntax);
    EXPECT_EQ(said_to({Op::drive, {0, 0, 1, 3}}), syntax);
    EXPECT_EQ(said_to({Op::drive, {0, 0, 3, 3}}), done) << "a stop may be without speeds";
    send(*bytes_from_hex("81 01 06 99 FF"));
    EXPECT_EQ(packets(50), syntax);
    simulator_.receive_too_long(7, now_ns_);
    EXPECT_EQ(packets(50), Texts{"90 60 01 FF"});
    send({Op::home}, 2);
    EXPECT_EQ(packets(50), Texts{}) << "another camera's";
}

TEST_F(EviSimulatorTest, DrivesToItsLimits) {
    EXPECT_EQ(said_to({Op::limit_set, {1, 200, 100}}), done);
    EXPECT_EQ(said_to({Op::limit_set, {0, -50, -40}}), done);
    EXPECT_EQ(said_to({Op::drive, {full_pan, full_tilt, 2, 1}}, 3000), done);
    EXPECT_EQ(asked(Op::ask_position), (std::vector{200, 100}));
    EXPECT_EQ(asked(Op::ask_status).at(0) & 0xF, 2 | 4);
    EXPECT_EQ(said_to({Op::absolute, {full_pan, full_tilt, -800, -300}}, 3000), done);
    EXPECT_EQ(asked(Op::ask_position), (std::vector{-50, -40}));
    EXPECT_EQ(said_to({Op::limit_clear, {1}}), done);
    EXPECT_EQ(said_to({Op::relative, {full_pan, full_tilt, 500, 400}}, 3000), done);
    EXPECT_EQ(asked(Op::ask_position), (std::vector{450, 300}));
    EXPECT_EQ(said_to({Op::drive, {2, 2, 1, 2}}, 1000), done);
    EXPECT_EQ(said_to({Op::drive, {2, 2, 3, 3}}, 1000), done);
    const auto slow = asked(Op::ask_position);
    EXPECT_NEAR(slow[0], 450 - 2 * 80.0 / 24 * 8.8, 3.0) << "1 s at 2 of 24 of full speed";
    EXPECT_NEAR(slow[1], 300 - 2 * 50.0 / 20 * 12.0, 3.0);
}

TEST_F(EviSimulatorTest, KeepsPresetsAndTurnsHome) {
    said_to({Op::absolute, {full_pan, full_tilt, 300, -100}}, 2000);
    said_to({Op::zoom_direct, {500}}, 3000);
    EXPECT_EQ(said_to({Op::memory_set, {4}}), done);
    EXPECT_EQ(said_to({Op::home}, 2000), done);
    EXPECT_EQ(asked(Op::ask_position), (std::vector{0, 0}));
    EXPECT_EQ(said_to({Op::memory_recall, {4}}, 3000), done);
    EXPECT_EQ(asked(Op::ask_position), (std::vector{300, -100}));
    EXPECT_EQ(asked(Op::ask_zoom), std::vector{500});
    EXPECT_EQ(asked(Op::ask_memory), std::vector{4});
    EXPECT_EQ(said_to({Op::reset}, 6000), done);
    EXPECT_EQ(asked(Op::ask_position), (std::vector{0, 0}));
}

TEST_F(EviSimulatorTest, TracksInNameOnly) {
    EXPECT_EQ(said_to({Op::at_mode, {2}}), done);
    EXPECT_EQ(said_to({Op::atmd_start_stop}), done);
    EXPECT_EQ(asked(Op::ask_atmd_mode), std::vector{1});
    EXPECT_EQ(asked(Op::ask_at_object), (std::vector{0, 0, 2})) << "it sees nothing";
    EXPECT_EQ(said_to({Op::md_mode, {0x10}}), done);
    EXPECT_EQ(asked(Op::ask_atmd_mode), std::vector{2});
    EXPECT_EQ(asked(Op::ask_md_object), (std::vector{0, 0, 1}));
}

TEST_F(EviSimulatorTest, IsAddressedAndCleared) {
    send({Op::address_set, {1}}, broadcast_address);
    send({Op::if_clear}, broadcast_address);
    EXPECT_EQ(packets(50), (Texts{"88 30 02 FF", "88 01 00 01 FF"}));
    send({Op::absolute, {1, 1, 880, 0}});
    packets(50);
    EXPECT_EQ(said_to({Op::if_clear}), Texts{"90 50 FF"}) << "no acknowledgement";
    EXPECT_EQ(simulator_.state().sockets_in_use, 0);
    EXPECT_FALSE(simulator_.state().moving);
}

TEST_F(EviSimulatorTest, TellsThatThePowerCameBack) {
    said_to({Op::absolute, {full_pan, full_tilt, 300, -100}}, 100);
    simulator_.power_cycle(7, now_ns_);
    EXPECT_EQ(packets(10000), Texts{"90 38 FF"}) << "the old command is forgotten";
    EXPECT_EQ(asked(Op::ask_position), (std::vector{0, 0}));
}

}  // namespace
}  // namespace kambara::visca
