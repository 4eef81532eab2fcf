// SPDX-License-Identifier: GPL-3.0-or-later
#include "hardware/visca/packet.h"

#include <gtest/gtest.h>

namespace kambara::visca {
namespace {

std::vector<std::string> read(PacketReader& reader, const char* hex) {
    std::vector<std::string> packets;
    for (const Bytes& packet : reader.read(bytes_from_hex(hex).value())) {
        packets.push_back(hex_from_bytes(packet));
    }
    return packets;
}

using Texts = std::vector<std::string>;

TEST(ViscaPacket, HexGoesBothWays) {
    EXPECT_EQ(bytes_from_hex("81 01fF"), (Bytes{0x81, 0x01, 0xFF}));
    EXPECT_EQ(hex_from_bytes(Bytes{0x81, 0x01, 0xFF}), "81 01 FF");
    EXPECT_FALSE(bytes_from_hex("8").has_value());
    EXPECT_FALSE(bytes_from_hex("8g").has_value());
}

TEST(ViscaPacket, ComeInPartsAndSeveralAtOnce) {
    PacketReader reader;
    EXPECT_EQ(read(reader, "90 41"), Texts{});
    EXPECT_EQ(read(reader, "FF 90 51 FF 90"), (Texts{"90 41 FF", "90 51 FF"}));
    EXPECT_EQ(read(reader, "50 02 FF"), Texts{"90 50 02 FF"});
    EXPECT_EQ(reader.bytes_thrown_away(), 0U);
}

TEST(ViscaPacket, AfterDamageTheNextOneIsReadRight) {
    PacketReader reader;
    EXPECT_EQ(read(reader, "41 FF 90 51 FF"), Texts{"90 51 FF"}) << "the header was lost";
    EXPECT_EQ(reader.bytes_thrown_away(), 2U);
    EXPECT_EQ(read(reader, "FF 90 FF 90 52 FF"), Texts{"90 52 FF"}) << "too short";
    EXPECT_EQ(reader.bytes_thrown_away(), 5U);
    EXPECT_EQ(read(reader, "90 00 01 02 03 04 05 06 07 08 09 0A 0B 0C 0D 0E 0F 10 FF 90 41 FF"),
              Texts{"90 41 FF"})
        << "too long";
    EXPECT_EQ(reader.too_long(), 1U);
    EXPECT_EQ(read(reader, "90 00 01 02 03 04 05 06 07 08 09 0A 0B 0C 0D FF"),
              Texts{"90 00 01 02 03 04 05 06 07 08 09 0A 0B 0C 0D FF"})
        << "16 bytes are allowed";
    EXPECT_EQ(read(reader, "90 41"), Texts{});
    reader.reset();
    EXPECT_EQ(read(reader, "90 42 FF"), Texts{"90 42 FF"});
}

}  // namespace
}  // namespace kambara::visca
