// SPDX-License-Identifier: GPL-3.0-or-later
// The bytes that libvisca sends and reads, recorded: ours are the same, and mean the same.
#include "tests/hardware/visca/vectors.h"

#include <gtest/gtest.h>

#include <map>

#include "hardware/visca/message.h"
#include "hardware/visca/reply.h"

namespace kambara::visca {
namespace {

// What each call means in our words.
const std::map<std::string, Message>& meanings() {
    static const std::map<std::string, Message> all{
        {"set_address (broadcast AddressSet)", {Op::address_set, {1}}},
        {"get_camera_info (CAM_VersionInq)", {Op::ask_version}},
        {"set_power 3(off)", {Op::power, {3}}},
        {"set_pantilt_down 1 1", {Op::drive, {1, 1, 3, 2}}},
        {"set_pantilt_right 5 6", {Op::drive, {5, 6, 2, 3}}},
        {"set_pantilt_upright 7 8", {Op::drive, {7, 8, 2, 1}}},
        {"set_pantilt_downright 7 8", {Op::drive, {7, 8, 2, 2}}},
        {"set_pantilt_absolute_position 5 5 -500 -200", {Op::absolute, {5, 5, -500, -200}}},
        {"set_pantilt_absolute_position 18 14 500 200", {Op::absolute, {18, 14, 500, 200}}},
        {"set_pantilt_absolute_position 1 1 0 0", {Op::absolute, {1, 1, 0, 0}}},
        {"set_pantilt_absolute_position 24 20 880 -300", {Op::absolute, {24, 20, 880, -300}}},
        {"set_pantilt_absolute_position 18 14 -880 300", {Op::absolute, {18, 14, -880, 300}}},
        {"set_pantilt_absolute_position 10 10 1 -1", {Op::absolute, {10, 10, 1, -1}}},
        {"set_pantilt_absolute_position 10 10 -1 1", {Op::absolute, {10, 10, -1, 1}}},
        {"set_pantilt_absolute_position 3 4 255 -256", {Op::absolute, {3, 4, 255, -256}}},
        {"set_pantilt_absolute_position 3 4 4095 -4096", {Op::absolute, {3, 4, 4095, -4096}}},
        {"set_pantilt_home", {Op::home}},
        {"set_pantilt_limit_upright 880 300", {Op::limit_set, {1, 880, 300}}},
        {"set_pantilt_limit_upright_clear", {Op::limit_clear, {1}}},
        {"set_zoom_tele", {Op::zoom, {2}}},
        {"set_zoom_stop", {Op::zoom, {0}}},
        {"set_zoom_wide_speed 2", {Op::zoom_wide_variable, {2}}},
        {"set_zoom_value 0x03FF", {Op::zoom_direct, {0x3FF}}},
        {"set_focus_far", {Op::focus, {2}}},
        {"set_focus_stop", {Op::focus, {0}}},
        {"set_focus_auto 3", {Op::focus_mode, {3}}},
        {"memory_set 0", {Op::memory_set, {0}}},
        {"memory_reset 3", {Op::memory_reset, {3}}},
        {"set_irreceive_off", {Op::ir_receive, {3}}},
        {"set_datascreen_off", {Op::data_screen, {3}}},
        {"set_at_mode 3 (D30)", {Op::at_mode, {3}}},
        {"set_atmd_startstop (D30)", {Op::atmd_start_stop}},
        {"get_pantilt_position", {Op::ask_position}},
        {"get_pantilt_mode", {Op::ask_status}},
        {"get_focus_value", {Op::ask_focus}},
        {"[address 3] set_pantilt_home", {Op::home}},
    };
    return all;
}

// What the answers of the inquiries mean, and how libvisca's words say it.
const std::map<Op, std::pair<std::vector<int>, std::string>>& answers() {
    static const std::map<Op, std::pair<std::vector<int>, std::string>> all{
        {Op::ask_version,
         {{0x20, 0x402, 0x101, 2}, "0 vendor=0x0020 model=0x0402 rom=0x0101 socket=0x02"}},
        {Op::ask_position, {{-500, 60}, "0 pan=-500 tilt=60"}},
        {Op::ask_status, {{0x1001}, "0 mode=0x1001"}},
        {Op::ask_focus, {{0x1000}, "0 focus=0x1000"}},
    };
    return all;
}

class RecordedVectors : public testing::Test {
  protected:
    void SetUp() override {
        if (!std::filesystem::exists(vector_file())) {
            GTEST_SKIP() << "skipped: no " << vector_file();
        }
        vectors_ = read_vectors();
        ASSERT_EQ(vectors_.size(), meanings().size());
    }
    std::vector<Vector> vectors_;
};

TEST_F(RecordedVectors, AreWrittenAndReadTheSame) {
    for (const Vector& vector : vectors_) {
        SCOPED_TRACE(vector.call);
        ASSERT_TRUE(meanings().contains(vector.call));
        const Message& meant = meanings().at(vector.call);
        const int address = meant.op == Op::address_set              ? broadcast_address
                            : vector.call.starts_with("[address 3]") ? 3
                                                                     : 1;
        EXPECT_EQ(hex_from_bytes(encode(meant, address)), hex_from_bytes(vector.sent));
        const auto read = decode_message(vector.sent);
        ASSERT_TRUE(read.has_value());
        EXPECT_EQ(read->message, meant);
        EXPECT_EQ(read->address, address);
    }
}

TEST_F(RecordedVectors, RepliesAreReadAndWrittenTheSame) {
    for (const Vector& vector : vectors_) {
        SCOPED_TRACE(vector.call);
        const Message& meant = meanings().at(vector.call);
        std::vector<Reply> replies;
        for (const Bytes& bytes : vector.replies) {
            const auto reply = decode_reply(bytes);
            ASSERT_TRUE(reply.has_value());
            EXPECT_EQ(encode(*reply), bytes);
            EXPECT_EQ(reply->address, meant.op == Op::address_set              ? broadcast_address
                                      : vector.call.starts_with("[address 3]") ? 3
                                                                               : 1);
            replies.push_back(reply->reply);
        }
        if (meant.op == Op::address_set) {
            EXPECT_EQ(replies, (std::vector<Reply>{AddressesSet{2}}));
        } else if (is_inquiry(meant.op)) {
            const auto& [values, words] = answers().at(meant.op);
            ASSERT_EQ(replies.size(), 1U);
            const auto* done = std::get_if<Completed>(&replies[0]);
            ASSERT_NE(done, nullptr);
            EXPECT_EQ(done->socket, 0);
            EXPECT_EQ(decode_answer(meant.op, done->data), values);
            EXPECT_EQ(encode_answer(meant.op, values), done->data);
            EXPECT_EQ(vector.result, words);
        } else {
            EXPECT_EQ(replies, (std::vector<Reply>{Acknowledged{1}, Completed{1, {}}}));
        }
    }
}

}  // namespace
}  // namespace kambara::visca
