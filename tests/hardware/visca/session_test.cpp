// SPDX-License-Identifier: GPL-3.0-or-later
#include "hardware/visca/session.h"

#include <gtest/gtest.h>

#include "tests/hardware/visca/simulated_line.h"

namespace kambara::visca {
namespace {

using Kind = Session::Outcome::Kind;
constexpr std::int64_t ms = 1'000'000;

// Against a script: what is sent is looked at, what is answered is said.
class ScriptedSession : public testing::Test {
  protected:
    void begin(const Session::Options& options = {}) {
        session_.emplace(options);
        session_->open(now_ns_);
    }
    std::string sent() {
        std::string all;
        for (const Bytes& bytes : session_->take_output()) {
            all += (all.empty() ? "" : " | ") + hex_from_bytes(bytes);
        }
        return all;
    }
    void say(const char* hex) { session_->receive(*bytes_from_hex(hex), now_ns_); }
    void wait_ms(std::int64_t time_ms) {
        for (std::int64_t i = 0; i < time_ms; ++i) {
            now_ns_ += ms;
            session_->tick(now_ns_);
        }
    }
    void make_ready() {
        begin();
        say("88 30 02 FF");
        say("88 01 00 01 FF");
        say("90 50 00 20 04 02 01 01 02 FF");
        say("90 50 00 20 04 02 01 01 02 FF");
        ASSERT_TRUE(session_->ready());
        session_->take_output();
        session_->take_notes();
    }
    std::vector<Kind> outcomes() {
        std::vector<Kind> kinds;
        for (const auto& outcome : session_->take_outcomes()) {
            kinds.push_back(outcome.kind);
            last_ = outcome;
        }
        return kinds;
    }
    std::string notes() {
        std::string all;
        for (const HeadNote& note : session_->take_notes()) {
            all += note.text + "\n";
        }
        return all;
    }

    std::int64_t now_ns_ = 5'000 * ms;
    std::optional<Session> session_;
    Session::Outcome last_;
};

using Kinds = std::vector<Kind>;

TEST_F(ScriptedSession, StartsUpInItsOrder) {
    begin();
    EXPECT_EQ(sent(), "88 30 01 FF");
    EXPECT_FALSE(session_->free(now_ns_));
    say("88 30 02 FF");
    EXPECT_EQ(sent(), "88 01 00 01 FF");
    say("88 01 00 01 FF");
    EXPECT_EQ(sent(), "81 09 00 02 FF");
    say("90 50 00 20 04 02 01 01 02 FF");
    EXPECT_EQ(sent(), "81 09 00 02 FF") << "what is new is asked twice";
    say("90 50 00 20 04 02 01 01 02 FF");
    EXPECT_TRUE(session_->free(now_ns_));
    EXPECT_EQ(session_->identity(), (Identity{0x20, 0x402, 0x101, 2}));
    EXPECT_EQ(notes(), "The head answers.\n");
}

TEST_F(ScriptedSession, KeepsTryingToStart) {
    begin();
    sent();
    wait_ms(81);
    EXPECT_EQ(sent(), "88 30 01 FF");
    wait_ms(400);
    EXPECT_EQ(sent(), "88 30 01 FF | 88 30 01 FF | 88 30 01 FF | 88 30 01 FF | 88 30 01 FF");
    EXPECT_NE(notes().find("does not answer"), std::string::npos);
    wait_ms(1000);
    EXPECT_EQ(notes(), "") << "said once";
    // A network change that comes first is not taken for the reply.
    sent();
    say("90 38 FF");
    EXPECT_EQ(sent(), "88 30 01 FF");
    say("88 30 02 FF");
    say("90 50 FF");
    sent();
    // Stuck at the version: begins again.
    wait_ms(245);
    EXPECT_EQ(sent(), "81 09 00 02 FF | 81 09 00 02 FF | 88 30 01 FF");
}

TEST_F(ScriptedSession, SaysThatTheAddressIsNotThere) {
    Session::Options options;
    options.address = 3;
    begin(options);
    say("88 30 02 FF");
    EXPECT_NE(notes().find("no camera 3"), std::string::npos);
}

TEST_F(ScriptedSession, FollowsACommandToItsEnd) {
    make_ready();
    const auto id = session_->send({Op::home}, now_ns_);
    EXPECT_EQ(sent(), "81 01 06 04 FF");
    EXPECT_FALSE(session_->free(now_ns_)) << "until it is acknowledged";
    say("90 41 FF");
    EXPECT_EQ(outcomes(), Kinds{Kind::acknowledged});
    EXPECT_EQ(session_->socket_of(id), 1);
    EXPECT_TRUE(session_->free(now_ns_));
    session_->send({Op::zoom_direct, {100}}, now_ns_);
    say("90 42 FF");
    EXPECT_FALSE(session_->socket_free());
    outcomes();
    // Out of their order.
    say("90 52 FF 90 51 FF");
    EXPECT_EQ(outcomes(), (Kinds{Kind::completed, Kind::completed}));
    EXPECT_EQ(last_.message.op, Op::home);
    EXPECT_TRUE(session_->socket_free());
}

TEST_F(ScriptedSession, AsksAndIsAnswered) {
    make_ready();
    session_->send({Op::ask_position}, now_ns_);
    say("90 50 0F 0E");
    say("00 0C 00 00 03 0C FF");
    EXPECT_EQ(outcomes(), Kinds{Kind::answered});
    EXPECT_EQ(last_.values, (std::vector{-500, 60}));
    // An answer of another shape is another inquiry's, come late.
    session_->send({Op::ask_zoom}, now_ns_);
    say("90 50 0F 0E 00 0C 00 00 03 0C FF");
    EXPECT_EQ(outcomes(), Kinds{});
    say("90 50 00 01 02 03 FF");
    EXPECT_EQ(outcomes(), Kinds{Kind::answered});
    EXPECT_EQ(last_.values, std::vector{0x123});
}

TEST_F(ScriptedSession, SendsAgainWhatHadNoReply) {
    make_ready();
    session_->send({Op::absolute, {1, 1, 0, 0}}, now_ns_);
    const std::string first = sent();
    wait_ms(81);
    EXPECT_EQ(sent(), first);
    say("90 41 FF");
    EXPECT_EQ(outcomes(), Kinds{Kind::acknowledged});
    EXPECT_FALSE(session_->free(now_ns_)) << "the other acknowledgement may still come";
    say("90 42 FF");
    EXPECT_EQ(outcomes(), Kinds{});
    wait_ms(61);
    EXPECT_TRUE(session_->free(now_ns_));
    say("90 52 FF 90 51 FF");
    EXPECT_EQ(outcomes(), Kinds{Kind::completed});
    EXPECT_TRUE(session_->socket_free());
}

TEST_F(ScriptedSession, DoesNotSendAgainWhatWouldAddUp) {
    make_ready();
    session_->send({Op::relative, {1, 1, 10, 0}}, now_ns_);
    sent();
    wait_ms(400);
    EXPECT_EQ(sent(), "");
    EXPECT_EQ(outcomes(), Kinds{Kind::unanswered});
    EXPECT_TRUE(session_->free(now_ns_));
}

TEST_F(ScriptedSession, StartsAnewWhereNothingIsAnswered) {
    make_ready();
    session_->send({Op::home}, now_ns_);
    say("90 41 FF");
    session_->send({Op::ask_position}, now_ns_);
    wait_ms(300);
    EXPECT_EQ(outcomes(), (Kinds{Kind::acknowledged, Kind::unanswered}));
    EXPECT_TRUE(session_->ready()) << "it may only be late";
    wait_ms(200);
    session_->send({Op::ask_position}, now_ns_);
    wait_ms(100);
    EXPECT_EQ(outcomes(), (Kinds{Kind::unanswered, Kind::forgotten}));
    EXPECT_EQ(session_->state(), Session::State::addressing);
    notes();
    say("88 30 02 FF");
    say("90 50 00 20 04 02 01 01 02 FF");
    EXPECT_EQ(notes(), "The head answers again.\n");
}

TEST_F(ScriptedSession, AHeadThatIsKnownIsAskedAtOnceAgainAndToldWhatIsWanted) {
    make_ready();
    session_->set_wish(Message{Op::home});
    session_->close();
    session_->open(now_ns_);
    EXPECT_EQ(sent(), "81 09 00 02 FF | 81 01 06 04 FF");
    say("90 60 02 FF");  // damaged on its way
    EXPECT_EQ(sent(), "81 09 00 02 FF | 81 01 06 04 FF");
    say("90 50 00 20 04 02 01 01 02 FF");
    EXPECT_TRUE(session_->ready());
}

TEST_F(ScriptedSession, ANetworkChangeForgetsAll) {
    make_ready();
    session_->send({Op::home}, now_ns_);
    say("90 41 FF");
    session_->send({Op::ask_position}, now_ns_);
    sent();
    say("90 38 FF");
    EXPECT_EQ(outcomes(), (Kinds{Kind::acknowledged, Kind::forgotten, Kind::forgotten}));
    EXPECT_EQ(sent(), "88 30 01 FF");
}

TEST_F(ScriptedSession, NamesWhatIsRefused) {
    make_ready();
    const std::pair<const char*, Fault> all[] = {{"90 60 01 FF", Fault::message_length},
                                                 {"90 60 02 FF", Fault::syntax},
                                                 {"90 60 03 FF", Fault::buffer_full},
                                                 {"90 61 41 FF", Fault::not_executable}};
    for (const auto& [reply, fault] : all) {
        session_->send({Op::home}, now_ns_);
        say(reply);
        EXPECT_EQ(outcomes(), Kinds{Kind::refused});
        EXPECT_EQ(last_.fault, fault);
        EXPECT_NE(notes().find(name_of(fault)), std::string::npos);
    }
}

TEST_F(ScriptedSession, Cancels) {
    make_ready();
    session_->send({Op::home}, now_ns_);
    say("90 42 FF");
    outcomes();
    session_->send({Op::cancel, {2}}, now_ns_);
    say("90 62 04 FF");
    EXPECT_EQ(outcomes(), (Kinds{Kind::refused, Kind::completed}));
    EXPECT_TRUE(session_->socket_free());
    session_->send({Op::cancel, {1}}, now_ns_);
    say("90 61 05 FF");
    EXPECT_EQ(outcomes(), Kinds{Kind::completed}) << "there was nothing to cancel";
}

TEST_F(ScriptedSession, GivesUpACompletionThatDoesNotCome) {
    make_ready();
    session_->send({Op::home}, now_ns_, {2'000 * ms});
    say("90 41 FF");
    wait_ms(1999);
    EXPECT_EQ(outcomes(), Kinds{Kind::acknowledged});
    wait_ms(2);
    EXPECT_EQ(outcomes(), Kinds{Kind::incomplete});
    EXPECT_TRUE(session_->socket_free());
}

TEST_F(ScriptedSession, UnderstandsACameraWithoutSockets) {
    make_ready();
    session_->send({Op::home}, now_ns_);
    say("90 40 FF 90 50 FF");
    EXPECT_EQ(outcomes(), (Kinds{Kind::acknowledged, Kind::completed}));
    session_->send({Op::home}, now_ns_);
    say("90 51 FF");
    EXPECT_EQ(outcomes(), Kinds{Kind::completed}) << "without an acknowledgement";
    EXPECT_TRUE(session_->free(now_ns_));
}

TEST_F(ScriptedSession, PassesOverWhatIsNotForIt) {
    make_ready();
    session_->send({Op::home}, now_ns_);
    say("00 17 FF A0 41 FF 90 99 FF 90 41 FF");
    EXPECT_EQ(outcomes(), Kinds{Kind::acknowledged});
    const std::string said = notes();
    EXPECT_NE(said.find("3 bytes"), std::string::npos);
    EXPECT_NE(said.find("A0 41 FF"), std::string::npos);
    EXPECT_NE(said.find("90 99 FF"), std::string::npos);
}

class SonySession : public ScriptedSession {
  protected:
    void make_ready() {
        Session::Options options;
        options.wiring = Wiring::udp_sony;
        begin(options);
        EXPECT_EQ(sent(), "02 00 00 01 00 00 00 00 01");
        say("02 01 00 01 00 00 00 00 01");
        EXPECT_EQ(sent(), "01 20 00 05 00 00 00 01 81 01 00 01 FF");
        say("01 11 00 03 00 00 00 01 90 50 FF");
        EXPECT_EQ(sent(), "01 20 00 05 00 00 00 02 81 09 00 02 FF");
        say("01 11 00 0A 00 00 00 02 90 50 00 20 04 02 01 01 02 FF");
        sent();
        say("01 11 00 0A 00 00 00 03 90 50 00 20 04 02 01 01 02 FF");
        ASSERT_TRUE(session_->ready());
        session_->take_notes();
    }
};

TEST_F(SonySession, NumbersItsMessages) {
    make_ready();
    session_->send({Op::home}, now_ns_);
    EXPECT_EQ(sent(), "01 00 00 05 00 00 00 04 81 01 06 04 FF");
    say("01 11 00 03 00 00 00 02 90 42 FF");
    EXPECT_EQ(outcomes(), Kinds{}) << "another message's";
    say("01 11 00 03 00 00 00 04 90 41 FF");
    session_->send({Op::ask_position}, now_ns_);
    EXPECT_EQ(sent(), "01 10 00 05 00 00 00 05 81 09 06 12 FF");
    say("01 11 00 03 00 00 00 04 90 51 FF");
    EXPECT_EQ(outcomes(), (Kinds{Kind::acknowledged, Kind::completed}));
    say("90 50 00 00 00 01 00 00 00 02 FF");
    EXPECT_EQ(outcomes(), Kinds{Kind::answered}) << "without the header";
}

TEST_F(SonySession, RepeatsUnderTheSameNumberAndLearnsThatItWasDone) {
    make_ready();
    session_->send({Op::home}, now_ns_);
    const std::string first = sent();
    wait_ms(81);
    EXPECT_EQ(sent(), first);
    say("02 01 00 02 00 00 00 04 0F 01");
    EXPECT_EQ(outcomes(), Kinds{Kind::acknowledged});
    say("01 11 00 03 00 00 00 04 90 51 FF");
    EXPECT_EQ(outcomes(), Kinds{Kind::completed});
    // An inquiry whose answer was lost is asked under a new number.
    session_->send({Op::ask_power}, now_ns_);
    sent();
    wait_ms(81);
    EXPECT_EQ(sent(), "01 10 00 05 00 00 00 05 81 09 04 00 FF");
    say("02 01 00 02 00 00 00 05 0F 01");
    EXPECT_EQ(sent(), "01 10 00 05 00 00 00 06 81 09 04 00 FF");
    say("01 11 00 04 00 00 00 06 90 50 02 FF");
    EXPECT_EQ(outcomes(), Kinds{Kind::answered});
}

TEST_F(SonySession, ResetsANumberThatIsOutOfStep) {
    make_ready();
    session_->send({Op::home}, now_ns_);
    sent();
    say("02 01 00 02 00 00 00 04 0F 01");
    EXPECT_EQ(sent(), "02 00 00 01 00 00 00 00 01");
    EXPECT_EQ(outcomes(), Kinds{Kind::forgotten});
}

TEST_F(SonySession, TellsAHeadThatDoesNotAnswerWhatIsWished) {
    make_ready();
    session_->set_wish(Message{Op::home});
    for (int i = 0; i < 10 && session_->ready(); ++i) {
        session_->send({Op::ask_power}, now_ns_, {0, false});
        wait_ms(100);
    }
    ASSERT_FALSE(session_->ready());
    sent();
    wait_ms(100);
    EXPECT_EQ(sent(), "02 00 00 01 00 00 00 00 01 | 01 00 00 05 00 00 00 01 81 01 06 04 FF");
    say("02 01 00 01 00 00 00 00 01");
    EXPECT_EQ(sent(),
              "01 20 00 05 00 00 00 02 81 01 00 01 FF | 01 00 00 05 00 00 00 03 81 01 06 04 FF");
}

// With the simulated camera, on a line of 9600 baud.
TEST(ViscaSession, WorksWithTheSimulatedCamera) {
    std::int64_t now_ns = 0;
    SimulatedLine line(now_ns);
    Session session({});
    session.open(now_ns);
    std::vector<Kind> kinds;
    std::int64_t ready_ns = 0;
    std::int64_t done_ns = 0;
    bool moved = false;
    for (; now_ns < 4'000 * ms; now_ns += ms) {
        for (const Bytes& bytes : line.advance(now_ns)) {
            session.receive(bytes, now_ns);
        }
        session.tick(now_ns);
        if (session.ready() && !moved) {
            ready_ns = now_ns;
            moved = true;
            session.send({Op::absolute, {0x18, 0x14, 440, -100}}, now_ns);
        }
        for (const Bytes& bytes : session.take_output()) {
            line.send(bytes, now_ns);
        }
        for (const auto& outcome : session.take_outcomes()) {
            kinds.push_back(outcome.kind);
            done_ns = now_ns;
        }
    }
    EXPECT_EQ(kinds, (std::vector{Kind::acknowledged, Kind::completed}));
    EXPECT_LT(ready_ns, 150 * ms);
    EXPECT_NEAR(static_cast<double>(done_ns - ready_ns) / ms, 825.0, 60.0)
        << "50 degrees at 80 degrees/s, up to speed and down";
    EXPECT_EQ(session.identity(), (Identity{0x20, 0x402, 0x101, 2}));
    EXPECT_EQ(session.take_notes().size(), 1U) << "nothing but that it answers";
}

}  // namespace
}  // namespace kambara::visca
