// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include "hardware/visca/packet.h"

namespace kambara::visca {

/// One call to libvisca as recorded: what it sent, what was answered, what it made of that.
struct Vector {
    std::string call;
    Bytes sent;
    std::vector<Bytes> replies;
    std::string result;
};

inline std::filesystem::path vector_file() {
    return std::filesystem::path(KAMBARA_DATA) / "visca" / "d30_vectors.tsv";
}

inline std::vector<Vector> read_vectors() {
    std::vector<Vector> vectors;
    std::ifstream file(vector_file());
    for (std::string line; std::getline(file, line);) {
        if (line.empty() || line[0] == '#') {
            continue;
        }
        std::istringstream columns(line);
        Vector vector;
        std::string sent, replies;
        std::getline(columns, vector.call, '\t');
        std::getline(columns, sent, '\t');
        std::getline(columns, replies, '\t');
        std::getline(columns, vector.result);
        vector.sent = bytes_from_hex(sent).value_or(Bytes{});
        vector.replies = PacketReader().read(bytes_from_hex(replies).value_or(Bytes{}));
        vectors.push_back(vector);
    }
    return vectors;
}

}  // namespace kambara::visca
