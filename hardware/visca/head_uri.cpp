// SPDX-License-Identifier: GPL-3.0-or-later
#include "hardware/visca/head_uri.h"

#include <charconv>
#include <optional>

namespace kambara::visca {
namespace {

struct Scheme {
    std::string_view name;
    Wiring wiring;
    int port;
};

constexpr Scheme schemes[] = {{"visca:", Wiring::serial, 0},
                              {"visca-udp:", Wiring::udp_sony, 52381},
                              {"visca-udp-raw:", Wiring::udp, 1259},
                              {"visca-tcp:", Wiring::tcp, 5678}};

Error misread(std::string_view text, const std::string& why) {
    return {"The head " + std::string(text) + " can't be understood: " + why + ".",
            "Write visca:/dev/ttyS0?address=1, visca-udp:HOST:PORT, visca-udp-raw:HOST:PORT or "
            "visca-tcp:HOST:PORT."};
}

std::optional<int> number_in(std::string_view text, int least, int most) {
    int value = 0;
    const auto [end, fault] = std::from_chars(text.data(), text.data() + text.size(), value);
    const bool good = fault == std::errc() && end == text.data() + text.size();
    return good && value >= least && value <= most ? std::optional(value) : std::nullopt;
}

// What is wrong with a setting; empty where nothing is.
std::string apply(std::string_view key, std::string_view value, HeadUri& uri) {
    const auto take = [&](int least, int most, int& where) {
        const auto number = number_in(value, least, most);
        where = number.value_or(where);
        return number ? std::string()
                      : std::string(key) + " is a number from " + std::to_string(least) + " to " +
                            std::to_string(most);
    };
    if (key == "address") {
        return take(1, most_cameras, uri.address);
    }
    if (key == "baud" && uri.wiring == Wiring::serial) {
        return take(1200, 115200, uri.baud);
    }
    if (key == "timeout") {
        return take(10, 10000, uri.timeout_ms);
    }
    if (key == "model" && !value.empty()) {
        uri.model = value;
        return {};
    }
    if (key == "heads" && !value.empty()) {
        uri.heads = value;
        return {};
    }
    if (key == "sequence" && uri.wiring == Wiring::udp_sony && value == "any") {
        uri.checks_sequence = false;
        return {};
    }
    return "there is no setting " + std::string(key) + "=" + std::string(value) + " here";
}

}  // namespace

bool names_a_visca_head(std::string_view text) {
    return text.starts_with("visca:") || text.starts_with("visca-");
}

Result<HeadUri> parse_head_uri(std::string_view text) {
    const Scheme* scheme = nullptr;
    for (const Scheme& one : schemes) {
        scheme = text.starts_with(one.name) ? &one : scheme;
    }
    if (scheme == nullptr) {
        return misread(text, "it begins with no way to a head");
    }
    HeadUri uri;
    uri.text = text;
    uri.wiring = scheme->wiring;
    uri.port = scheme->port;
    std::string_view rest = text.substr(scheme->name.size());
    const auto question = rest.find('?');
    std::string_view settings =
        question == std::string_view::npos ? std::string_view() : rest.substr(question + 1);
    const std::string_view place = rest.substr(0, question);
    if (uri.wiring == Wiring::serial) {
        uri.device = place;
    } else {
        const auto colon = place.rfind(':');
        uri.host = place.substr(0, colon);
        if (colon != std::string_view::npos) {
            const auto port = number_in(place.substr(colon + 1), 1, 65535);
            if (!port) {
                return misread(text, "the port is a number from 1 to 65535");
            }
            uri.port = *port;
        }
        // An IPv6 address stands in brackets.
        if (uri.host.size() > 2 && uri.host.front() == '[' && uri.host.back() == ']') {
            uri.host = uri.host.substr(1, uri.host.size() - 2);
        }
    }
    if (uri.device.empty() && uri.host.empty()) {
        return misread(text, "it does not say where the head is");
    }
    while (!settings.empty()) {
        const std::string_view one = settings.substr(0, settings.find('&'));
        settings.remove_prefix(std::min(settings.size(), one.size() + 1));
        const auto equals = one.find('=');
        const std::string wrong = equals == std::string_view::npos
                                      ? "a setting is written key=value"
                                      : apply(one.substr(0, equals), one.substr(equals + 1), uri);
        if (!wrong.empty()) {
            return misread(text, wrong);
        }
    }
    return uri;
}

}  // namespace kambara::visca
