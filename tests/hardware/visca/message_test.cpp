// SPDX-License-Identifier: GPL-3.0-or-later
#include "hardware/visca/message.h"

#include <gtest/gtest.h>

#include <map>
#include <random>
#include <set>
#include <stdexcept>

#include "hardware/visca/ip_header.h"
#include "hardware/visca/message_table.h"
#include "hardware/visca/reply.h"

namespace kambara::visca {
namespace {

std::string hex(const Message& message, int address = 1, const Dialect& dialect = {}) {
    return hex_from_bytes(encode(message, address, dialect));
}

TEST(ViscaMessage, TheTableIsInTheOrderOfItsNames) {
    const auto table = message_table();
    for (std::size_t i = 0; i < table.size(); ++i) {
        EXPECT_EQ(static_cast<std::size_t>(table[i].op), i) << table[i].name;
    }
    EXPECT_EQ(table.back().op, Op::ask_md_status);
}

TEST(ViscaMessage, SaysWhatTheManualsSay) {
    // The worked example of the command sheet, and one of each form.
    EXPECT_EQ(hex({Op::absolute, {0x18, 0x14, -880, 300}}),
              "81 01 06 02 18 14 0F 0C 09 00 00 01 02 0C FF");
    EXPECT_EQ(hex({Op::address_set, {1}}, broadcast_address), "88 30 01 FF");
    EXPECT_EQ(hex({Op::if_clear}, broadcast_address), "88 01 00 01 FF");
    EXPECT_EQ(hex({Op::cancel, {2}}, 7), "87 22 FF");
    EXPECT_EQ(hex({Op::zoom_tele_variable, {7}}), "81 01 04 07 27 FF");
    EXPECT_EQ(hex({Op::zoom_focus_direct, {0x4000, 0x1234}}),
              "81 01 04 47 04 00 00 00 01 02 03 04 FF");
    EXPECT_EQ(hex({Op::shutter_direct, {0x1B}}), "81 01 04 4A 00 00 01 0B FF");
    EXPECT_EQ(hex({Op::limit_clear, {0}}), "81 01 06 07 01 00 07 0F 0F 0F 07 0F 0F 0F FF");
    EXPECT_EQ(hex({Op::notify, {0x21}}), "81 01 06 20 07 21 FF");
    EXPECT_EQ(hex({Op::ask_max_speed}), "81 09 06 11 FF");
    EXPECT_EQ(hex({Op::memory_recall, {5}}), "81 01 04 3F 02 05 FF");
}

TEST(ViscaMessage, BrcSaysPanInFiveHalves) {
    const Dialect brc{5};
    // BRC-H700's ends: 08A58 on the left, F75A8 on the right.
    EXPECT_EQ(hex({Op::absolute, {0x18, 0, 0x08A58, 0x493D}}, 1, brc),
              "81 01 06 02 18 00 00 08 0A 05 08 04 09 03 0D FF");
    EXPECT_EQ(hex({Op::absolute, {0x18, 0, -0x08A58, -0x186A}}, 1, brc),
              "81 01 06 02 18 00 0F 07 05 0A 08 0E 07 09 06 FF");
    const auto data = bytes_from_hex("0F 07 05 0A 08 0E 07 09 06");
    EXPECT_EQ(decode_answer(Op::ask_position, *data, brc), (std::vector{-0x08A58, -0x186A}));
    EXPECT_FALSE(decode_answer(Op::ask_position, *data).has_value());
}

TEST(ViscaMessage, TheRefreshTimeHasTheCodeOfTheDialect) {
    EXPECT_EQ(hex({Op::md_refresh_time, {4}}), "81 01 07 0B 00 04 FF");
    const Dialect other{4, 0x11};
    EXPECT_EQ(hex({Op::md_refresh_time, {4}}, 1, other), "81 01 07 11 00 04 FF");
    const auto read = decode_message(*bytes_from_hex("8101071100 04FF"), other);
    ASSERT_TRUE(read.has_value());
    EXPECT_EQ(read->message.op, Op::md_refresh_time);
}

TEST(ViscaMessage, WhatDoesNotFitIsABrokenInvariant) {
    EXPECT_THROW(encode({Op::absolute, {1, 1, 40000, 0}}, 1), std::invalid_argument);
    EXPECT_THROW(encode({Op::absolute, {1, 1, 0}}, 1), std::invalid_argument);
    EXPECT_THROW(encode({Op::home, {1}}, 1), std::invalid_argument);
    EXPECT_THROW(encode({Op::power, {7}}, 1), std::invalid_argument);
    EXPECT_THROW(encode({Op::home}, 9), std::invalid_argument);
}

TEST(ViscaMessage, ForeignBytesAreNoMessage) {
    for (const char* text :
         {"81 01 06 99 FF", "81 01 04 00 04 FF", "81 01 06 02 18 14 0F 0C 09 00 00 01 02 FF",
          "81 01 06 02 18 14 1F 0C 09 00 00 01 02 0C FF", "90 41 FF", "81 FF", "81 01 06 04", ""}) {
        EXPECT_FALSE(decode_message(*bytes_from_hex(text)).has_value()) << text;
    }
}

// Every message with random values is read as what was written, but for the two that have the same
// bytes.
TEST(ViscaMessage, EveryMessageComesBack) {
    std::mt19937 random(3);
    std::map<Op, int> tried;
    for (int round = 0; round < 400000; ++round) {
        const Op op = message_table()[random() % message_table().size()].op;
        std::vector<int> values;
        for (std::size_t i = 0, n = random() % 5; i < n; ++i) {
            values.push_back(random() % 3 == 0 ? static_cast<int>(random() % 0x10000) - 0x8000
                                               : static_cast<int>(random() % 8));
        }
        Bytes packet;
        try {
            packet = encode({op, values}, 1 + static_cast<int>(random() % 7));
        } catch (const std::invalid_argument&) {
            continue;
        }
        const auto read = decode_message(packet);
        ASSERT_TRUE(read.has_value()) << hex_from_bytes(packet);
        if (op == Op::md_refresh_time) {
            EXPECT_EQ(read->message.op, Op::md_y_level);
        } else {
            EXPECT_EQ(read->message.op, op);
        }
        EXPECT_EQ(read->message.values, values) << hex_from_bytes(packet);
        ++tried[op];
    }
    // A notice's values, 0x20 and 0x21, are not among those tried.
    EXPECT_EQ(tried.size(), message_table().size() - 1);
}

TEST(ViscaReply, EachKindHasItsBytes) {
    const std::pair<const char*, ReplyFrom> all[] = {
        {"88 30 02 FF", {AddressesSet{2}, broadcast_address}},
        {"88 01 00 01 FF", {InterfaceCleared{}, broadcast_address}},
        {"90 38 FF", {NetworkChanged{}, 1}},
        {"F0 41 FF", {Acknowledged{1}, 7}},
        {"A0 52 FF", {Completed{2, {}}, 2}},
        {"90 50 FF", {Completed{0, {}}, 1}},
        {"90 50 02 FF", {Completed{0, {2}}, 1}},
        {"90 60 01 FF", {Refused{0, Fault::message_length}, 1}},
        {"90 60 02 FF", {Refused{0, Fault::syntax}, 1}},
        {"90 60 03 FF", {Refused{0, Fault::buffer_full}, 1}},
        {"90 61 04 FF", {Refused{1, Fault::cancelled}, 1}},
        {"90 62 05 FF", {Refused{2, Fault::no_socket}, 1}},
        {"90 61 41 FF", {Refused{1, Fault::not_executable}, 1}},
    };
    for (const auto& [text, reply] : all) {
        EXPECT_EQ(hex_from_bytes(encode(reply)), text);
        EXPECT_EQ(decode_reply(*bytes_from_hex(text)), reply) << text;
    }
    for (const char* text : {"81 01 06 04 FF", "80 41 FF", "90 61 42 FF", "90 41 00 FF", "90 FF",
                             "98 41 FF", "90 38 00 FF", "88 30 09 FF", "90 70 FF"}) {
        EXPECT_FALSE(decode_reply(*bytes_from_hex(text)).has_value()) << text;
    }
    std::set<std::string> names;
    for (const Fault fault : {Fault::message_length, Fault::syntax, Fault::buffer_full,
                              Fault::cancelled, Fault::no_socket, Fault::not_executable}) {
        names.insert(name_of(fault));
    }
    EXPECT_EQ(names.size(), 6U);
}

TEST(ViscaIpHeader, IsAsCaptured) {
    // Captured from libvisca's link over IP.
    EXPECT_EQ(hex_from_bytes(encode(sequence_reset())), "02 00 00 01 00 00 00 00 01");
    const Bytes clear = encode({Op::if_clear}, 1);
    EXPECT_EQ(hex_from_bytes(encode(Datagram{type_of_packet(clear), 1, clear})),
              "01 20 00 05 00 00 00 01 81 01 00 01 FF");
    const auto reply = decode_datagram(*bytes_from_hex("01 11 00 03 00 00 00 03 90 41 FF"));
    ASSERT_TRUE(reply.has_value());
    EXPECT_EQ(*reply, (Datagram{PayloadType::reply, 3, {0x90, 0x41, 0xFF}}));
    EXPECT_EQ(type_of_packet(encode({Op::home}, 1)), PayloadType::command);
    EXPECT_EQ(type_of_packet(encode({Op::ask_position}, 1)), PayloadType::inquiry);
    EXPECT_EQ(type_of_packet(encode({Op::ask_version}, 1)), PayloadType::device_setting);
    const Datagram complaining = complaint(ControlFault::sequence_abnormal, 0xFFFFFFFF);
    EXPECT_EQ(hex_from_bytes(encode(complaining)), "02 01 00 02 FF FF FF FF 0F 01");
    EXPECT_EQ(control_fault(complaining), ControlFault::sequence_abnormal);
    EXPECT_FALSE(control_fault(*reply).has_value());
}

TEST(ViscaIpHeader, WhatHasNoneIsLeftAlone) {
    for (const char* text : {"90 41 FF", "90 50 0F 0E 00 0C 00 00 03 0C FF",
                             "01 11 00 04 00 00 00 03 90 41 FF", "03 00 00 00 00 00 00 00", ""}) {
        EXPECT_FALSE(decode_datagram(*bytes_from_hex(text)).has_value()) << text;
    }
}

}  // namespace
}  // namespace kambara::visca
