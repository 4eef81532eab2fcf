// SPDX-License-Identifier: GPL-3.0-or-later
#include "hardware/visca/message.h"

#include <algorithm>
#include <stdexcept>
#include <string_view>
#include <utility>

#include "hardware/visca/message_table.h"

namespace kambara::visca {
namespace {

constexpr std::uint8_t controller_header = 0x80;

struct Field {
    enum class Kind { literal, byte, half, nibbles, word, pan, refresh };
    Kind kind = Kind::literal;
    std::uint8_t upper = 0;  // the literal, or what stands above a half
    int nibbles = 0;
    bool has_sign = false;
    std::vector<std::pair<int, int>> allowed = {};
};

using Pattern = std::vector<Field>;

int hex_number(std::string_view text) {
    return std::stoi(std::string(text), nullptr, 16);
}

std::vector<std::pair<int, int>> parse_allowed(std::string_view text) {
    std::vector<std::pair<int, int>> allowed;
    while (!text.empty()) {
        const std::string_view item = text.substr(0, text.find(','));
        const auto dash = item.find('-');
        const int least = hex_number(item.substr(0, dash));
        allowed.emplace_back(
            least, dash == std::string_view::npos ? least : hex_number(item.substr(dash + 1)));
        text.remove_prefix(std::min(text.size(), item.size() + 1));
    }
    return allowed;
}

Field parse_field(std::string_view token) {
    using Kind = Field::Kind;
    const auto bracket = token.find('[');
    if (bracket != std::string_view::npos) {
        const auto allowed = parse_allowed(token.substr(bracket + 1, token.size() - bracket - 2));
        if (bracket == 0) {
            return {Kind::byte, 0, 0, false, allowed};
        }
        return {Kind::half, static_cast<std::uint8_t>(hex_number(token.substr(0, 1)) << 4), 0,
                false, allowed};
    }
    if (token == "u2" || token == "u4") {
        return {Kind::nibbles, 0, token == "u2" ? 2 : 4, false};
    }
    if (token == "s4" || token == "tilt") {
        return {Kind::nibbles, 0, 4, true};
    }
    if (token == "pan") {
        return {Kind::pan, 0, 0, true};
    }
    if (token == "w") {
        return {Kind::word};
    }
    if (token == "refresh") {
        return {Kind::refresh};
    }
    return {Kind::literal, static_cast<std::uint8_t>(hex_number(token))};
}

Pattern parse_pattern(std::string_view text) {
    Pattern pattern;
    while (!text.empty()) {
        const std::string_view token = text.substr(0, text.find(' '));
        pattern.push_back(parse_field(token));
        text.remove_prefix(std::min(text.size(), token.size() + 1));
    }
    return pattern;
}

struct Row {
    const MessageRow* row;
    Pattern message;
    Pattern answer;
};

const std::vector<Row>& table() {
    static const std::vector<Row> parsed = [] {
        std::vector<Row> all;
        for (const MessageRow& row : message_table()) {
            all.push_back({&row, parse_pattern(row.pattern),
                           row.answer != nullptr ? parse_pattern(row.answer) : Pattern{}});
        }
        return all;
    }();
    return parsed;
}

const Row& row_of(Op op) {
    return table().at(static_cast<std::size_t>(op));
}

// Nibble counts and literals that the dialect decides, put in.
Field resolved(Field field, const Dialect& dialect) {
    if (field.kind == Field::Kind::pan) {
        field.kind = Field::Kind::nibbles;
        field.nibbles = dialect.pan_nibbles;
    } else if (field.kind == Field::Kind::refresh) {
        field.kind = Field::Kind::literal;
        field.upper = dialect.md_refresh_time_code;
    }
    return field;
}

bool is_allowed(const Field& field, int value) {
    return std::any_of(field.allowed.begin(), field.allowed.end(), [&](const auto& range) {
        return value >= range.first && value <= range.second;
    });
}

void require(bool fits) {
    if (!fits) {
        throw std::invalid_argument("kambara::visca: a value the message has no room for");
    }
}

void write_number(int value, const Field& field, Bytes& bytes) {
    const int bits = 4 * field.nibbles;
    const int low = field.has_sign ? -(1 << (bits - 1)) : 0;
    const int high = field.has_sign ? (1 << (bits - 1)) - 1 : (1 << bits) - 1;
    require(value >= low && value <= high);
    for (int shift = bits - 4; shift >= 0; shift -= 4) {
        bytes.push_back(static_cast<std::uint8_t>((static_cast<unsigned>(value) >> shift) & 0x0F));
    }
}

void write_value(int value, const Field& field, Bytes& bytes) {
    switch (field.kind) {
        case Field::Kind::nibbles:
            write_number(value, field, bytes);
            break;
        case Field::Kind::word:
            require(value >= 0 && value <= 0xFFFF);
            bytes.push_back(static_cast<std::uint8_t>(value >> 8));
            bytes.push_back(static_cast<std::uint8_t>(value & 0xFF));
            break;
        default:
            require(is_allowed(field, value));
            bytes.push_back(static_cast<std::uint8_t>(field.upper | value));
    }
}

void write(const Pattern& pattern, const std::vector<int>& values, const Dialect& dialect,
           Bytes& bytes) {
    auto value = values.begin();
    for (const Field& any : pattern) {
        const Field field = resolved(any, dialect);
        if (field.kind == Field::Kind::literal) {
            bytes.push_back(field.upper);
        } else {
            require(value != values.end());
            write_value(*value++, field, bytes);
        }
    }
    require(value == values.end());
}

std::optional<int> read_number(const Field& field, std::span<const std::uint8_t> bytes) {
    int value = 0;
    for (const std::uint8_t byte : bytes) {
        if (byte > 0x0F) {
            return std::nullopt;
        }
        value = value * 16 + byte;
    }
    const int range = 1 << (4 * field.nibbles);
    return field.has_sign && value >= range / 2 ? value - range : value;
}

// Empty where the bytes do not fit.
std::optional<std::vector<int>> read(const Pattern& pattern, std::span<const std::uint8_t> bytes,
                                     const Dialect& dialect) {
    std::vector<int> values;
    for (const Field& any : pattern) {
        const Field field = resolved(any, dialect);
        const std::size_t size = field.kind == Field::Kind::nibbles
                                     ? static_cast<std::size_t>(field.nibbles)
                                     : (field.kind == Field::Kind::word ? 2 : 1);
        if (bytes.size() < size) {
            return std::nullopt;
        }
        std::optional<int> value;
        switch (field.kind) {
            case Field::Kind::literal:
                if (bytes[0] != field.upper) {
                    return std::nullopt;
                }
                break;
            case Field::Kind::nibbles:
                value = read_number(field, bytes.first(size));
                break;
            case Field::Kind::word:
                value = bytes[0] * 256 + bytes[1];
                break;
            case Field::Kind::half:
                value = (bytes[0] & 0xF0) == field.upper ? bytes[0] & 0x0F : -1;
                break;
            default:
                value = bytes[0];
        }
        if (field.kind != Field::Kind::literal) {
            if (!value || (!field.allowed.empty() && !is_allowed(field, *value))) {
                return std::nullopt;
            }
            values.push_back(*value);
        }
        bytes = bytes.subspan(size);
    }
    return bytes.empty() ? std::optional(std::move(values)) : std::nullopt;
}

}  // namespace

bool is_inquiry(Op op) {
    return row_of(op).row->answer != nullptr;
}

bool is_motion(Op op) {
    return op == Op::drive || op == Op::absolute || op == Op::relative || op == Op::home ||
           op == Op::reset || op == Op::memory_recall;
}

std::string name_of(Op op) {
    return row_of(op).row->name;
}

bool known_to_d30(Op op) {
    return row_of(op).row->d30;
}

std::vector<Op> all_ops() {
    std::vector<Op> ops;
    for (const MessageRow& row : message_table()) {
        ops.push_back(row.op);
    }
    return ops;
}

Bytes encode(const Message& message, int address, const Dialect& dialect) {
    require(address >= 1 && address <= broadcast_address);
    Bytes bytes{static_cast<std::uint8_t>(controller_header | address)};
    write(row_of(message.op).message, message.values, dialect, bytes);
    bytes.push_back(terminator);
    return bytes;
}

std::optional<Addressed> decode_message(std::span<const std::uint8_t> packet,
                                        const Dialect& dialect) {
    if (packet.size() < shortest_packet || packet.size() > longest_packet ||
        packet.back() != terminator || packet[0] <= controller_header ||
        packet[0] > controller_header + broadcast_address) {
        return std::nullopt;
    }
    const int address = packet[0] & 0x0F;
    for (const Row& row : table()) {
        if (auto values = read(row.message, packet.subspan(1, packet.size() - 2), dialect)) {
            return Addressed{{row.row->op, std::move(*values)}, address};
        }
    }
    return std::nullopt;
}

std::optional<std::vector<int>> decode_answer(Op inquiry, std::span<const std::uint8_t> data,
                                              const Dialect& dialect) {
    return is_inquiry(inquiry) ? read(row_of(inquiry).answer, data, dialect) : std::nullopt;
}

Bytes encode_answer(Op inquiry, const std::vector<int>& values, const Dialect& dialect) {
    Bytes bytes;
    write(row_of(inquiry).answer, values, dialect, bytes);
    return bytes;
}

}  // namespace kambara::visca
