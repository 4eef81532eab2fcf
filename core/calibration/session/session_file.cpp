// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/calibration/session/session_file.h"

#include <yaml-cpp/yaml.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "core/base/digits.h"
#include "core/base/text_file.h"
#include "core/calibration/target_file.h"
#include "core/calibration/yaml_fields.h"
#include "core/camera/rig_file.h"

namespace kambara {
namespace {

namespace fs = std::filesystem;

constexpr const char* remedy = "Mend the file, or begin a new session in another folder.";

using calibration_yaml::Fault;
using calibration_yaml::number_of;

double positive(const YAML::Node& node, const std::string& key) {
    const double value = number_of(node, key);
    if (!(value > 0.0)) {
        throw Fault{key + " is not above 0"};
    }
    return value;
}

std::vector<double> positives(const YAML::Node& node, const std::string& key, std::size_t count) {
    if (!node || !node.IsSequence() || node.size() != count) {
        throw Fault{key + " does not have " + std::to_string(count) + " numbers"};
    }
    std::vector<double> values;
    for (const YAML::Node& item : node) {
        values.push_back(positive(item, key));
    }
    return values;
}

std::string word_of(const YAML::Node& node, const std::string& key, const std::string& one,
                    const std::string& other) {
    std::string word = node && node.IsScalar() ? node.Scalar() : "";
    if (word != one && word != other) {
        throw Fault{key + " is neither " + one + " nor " + other};
    }
    return word;
}

// A file's text as YAML, through a reader that throws faults.
template <class Read>
Result<Done> read_yaml(const fs::path& path, const Read& read) {
    const auto text = read_text_file(path);
    if (!text) {
        return text.error();
    }
    try {
        read(YAML::Load(*text));
        return Done{};
    } catch (const Fault& fault) {
        return Error{path.string() + ": " + fault.what + ".", remedy};
    } catch (const YAML::Exception& fault) {
        return Error{path.string() + " is not valid YAML (" + fault.what() + ").", remedy};
    }
}

std::string setup_text(const SessionSetup& setup) {
    YAML::Emitter out;
    const auto key = [&out](const std::string& name) -> YAML::Emitter& {
        return out << YAML::Key << name << YAML::Value;
    };
    out << YAML::BeginMap;
    key("kambara_calibration_session") << 1;
    key("model") << (setup.model == LensModel::brown ? "brown" : "tsai");
    key("medium") << (setup.medium == Medium::air ? "air" : "water");
    if (setup.model == LensModel::tsai) {
        key("sensor") << YAML::Flow << YAML::BeginSeq << digits(setup.sensor.dx_mm)
                      << digits(setup.sensor.dy_mm) << digits(setup.sensor.ncx)
                      << digits(setup.sensor.nfx) << YAML::EndSeq;
    }
    if (setup.baseline) {
        key("baseline_mm") << digits(setup.baseline->baseline_mm);
        key("baseline_sigma_mm") << digits(setup.baseline->sigma_mm);
    }
    key("cameras") << YAML::BeginMap;
    for (std::size_t c = 0; c < most_cameras; ++c) {
        if (setup.cameras[c]) {
            key(camera_names[c]) << YAML::Flow
                                 << std::vector<int>{setup.cameras[c]->width_px,
                                                     setup.cameras[c]->height_px};
        }
    }
    out << YAML::EndMap << YAML::EndMap;
    return std::string(out.c_str()) + "\n";
}

void read_setup(const YAML::Node& root, SessionSetup& setup) {
    if (!root.IsMap() ||
        number_of(root["kambara_calibration_session"], "kambara_calibration_session") != 1) {
        throw Fault{"kambara_calibration_session is a version that this program does not know"};
    }
    setup.model = word_of(root["model"], "model", "brown", "tsai") == "brown" ? LensModel::brown
                                                                              : LensModel::tsai;
    setup.medium =
        word_of(root["medium"], "medium", "air", "water") == "air" ? Medium::air : Medium::water;
    if (setup.model == LensModel::tsai) {
        const auto v = positives(root["sensor"], "sensor", 4);
        setup.sensor = {v[0], v[1], v[2], v[3]};
    }
    if (root["baseline_mm"]) {
        setup.baseline = KnownBaseline{positive(root["baseline_mm"], "baseline_mm"),
                                       positive(root["baseline_sigma_mm"], "baseline_sigma_mm")};
    }
    const YAML::Node cameras = root["cameras"];
    if (!cameras || !cameras.IsMap() || !cameras["left"]) {
        throw Fault{"cameras has no left one"};
    }
    for (std::size_t c = 0; c < most_cameras; ++c) {
        if (cameras[camera_names[c]]) {
            const auto size = positives(cameras[camera_names[c]], camera_names[c], 2);
            setup.cameras[c] = PictureSize{static_cast<int>(size[0]), static_cast<int>(size[1])};
        }
    }
}

std::string state_text(const SessionContent& content) {
    YAML::Emitter out;
    out << YAML::BeginMap << YAML::Key << "noise_px" << YAML::Value << digits(content.noise_px);
    out << YAML::Key << "decisions" << YAML::Value << YAML::BeginSeq;
    for (const Decision& decision : content.decisions) {
        out << YAML::Flow << YAML::BeginMap << YAML::Key << "shot" << YAML::Value << decision.shot
            << YAML::Key << "kept" << YAML::Value << decision.kept << YAML::EndMap;
    }
    out << YAML::EndSeq << YAML::EndMap;
    return std::string(out.c_str()) + "\n";
}

void read_state(const YAML::Node& root, SessionContent& content) {
    if (!root.IsMap()) {
        throw Fault{"it is not a map"};
    }
    content.noise_px = positive(root["noise_px"], "noise_px");
    const YAML::Node list = root["decisions"];
    if (!list || !list.IsSequence()) {
        throw Fault{"decisions is not a list"};
    }
    for (const YAML::Node& item : list) {
        bool kept = false;
        if (!item.IsMap() || !item["kept"] || !item["kept"].IsScalar() ||
            !YAML::convert<bool>::decode(item["kept"], kept)) {
            throw Fault{"a decision does not say whether the shot is kept"};
        }
        content.decisions.push_back(
            {static_cast<int>(positive(item["shot"], "a decision's shot")), kept});
    }
}

std::string name_of(int number, const char* ending) {
    char text[32];
    std::snprintf(text, sizeof text, "%04d%s", number, ending);
    return text;
}

Result<Done> make_folder(const fs::path& folder) {
    std::error_code code;
    fs::create_directories(folder, code);
    if (code) {
        return Error{"The folder " + folder.string() + " can't be made: " + code.message() + ".",
                     "Choose a place that can be written to."};
    }
    return Done{};
}

Result<Done> read_shots(const fs::path& folder, SessionContent& content) {
    const int corners = static_cast<int>(corners_in_target_mm(content.setup.target).size());
    std::vector<fs::path> files;
    std::error_code code;
    for (fs::directory_iterator entry(folder / "shots", code), end; !code && entry != end;
         entry.increment(code)) {
        if (entry->path().extension() == ".yaml") {
            files.push_back(entry->path());
        }
    }
    std::sort(files.begin(), files.end());
    for (const fs::path& file : files) {
        const auto text = read_text_file(file);
        if (!text) {
            return text.error();
        }
        auto shot = shot_from_text(*text, corners);
        if (!shot) {
            return Error{file.string() + ": " + shot.error().cause, shot.error().remedy};
        }
        content.shots.push_back(std::move(*shot));
    }
    std::sort(content.shots.begin(), content.shots.end(),
              [](const Shot& a, const Shot& b) { return a.number < b.number; });
    for (std::size_t i = 1; i < content.shots.size(); ++i) {
        if (content.shots[i - 1].number == content.shots[i].number) {
            return Error{
                "The session has shot " + std::to_string(content.shots[i].number) + " twice.",
                "Move one of them out of its folder and resume again."};
        }
    }
    return Done{};
}

// A rig that is there only at times.
Result<Done> read_rig_if_any(const fs::path& path, std::optional<Rig>& rig) {
    std::error_code code;
    if (!fs::exists(path, code)) {
        return Done{};
    }
    auto read = read_rig_file(path);
    if (!read) {
        return read.error();
    }
    rig = std::move(*read);
    return Done{};
}

}  // namespace

Result<Done> begin_session_folder(const fs::path& folder, const SessionSetup& setup) {
    std::error_code code;
    if (fs::exists(folder / "session.yaml", code)) {
        return Error{folder.string() + " holds a calibration session already.",
                     "Resume it, or choose another folder."};
    }
    for (const fs::path& made : {folder, folder / "shots"}) {
        if (auto done = make_folder(made); !done) {
            return done;
        }
    }
    for (std::size_t c = 0; c < most_cameras; ++c) {
        if (setup.cameras[c]) {
            if (auto done = make_folder(folder / camera_names[c]); !done) {
                return done;
            }
        }
    }
    if (setup.expected) {
        if (auto done = write_rig_file(folder / "expected.yaml", *setup.expected); !done) {
            return done;
        }
    }
    if (auto done = write_target_file(folder / "target.yaml", setup.target); !done) {
        return done;
    }
    if (auto done = write_session_state(folder, {}); !done) {
        return done;
    }
    return write_text_file_atomically(folder / "session.yaml", setup_text(setup));
}

fs::path shot_picture_file(const fs::path& folder, std::size_t camera, int shot) {
    return folder / camera_names[camera] / name_of(shot, ".png");
}

Result<Done> write_shot(const fs::path& folder, const Shot& shot, const PictureSet& pictures,
                        const PictureWriter& write_picture) {
    for (std::size_t c = 0; c < most_cameras; ++c) {
        if (pictures[c] == nullptr || !write_picture) {
            continue;
        }
        const fs::path path = shot_picture_file(folder, c, shot.number);
        if (auto done = write_picture(path, *pictures[c]); !done) {
            return done;
        }
    }
    return write_text_file_atomically(folder / "shots" / name_of(shot.number, ".yaml"),
                                      shot_to_text(shot));
}

Result<Done> write_session_state(const fs::path& folder, const SessionContent& content) {
    return write_text_file_atomically(folder / "state.yaml", state_text(content));
}

Result<Done> write_session_rig(const fs::path& folder, const Rig& rig) {
    return write_rig_file(folder / "rig.yaml", rig);
}

Result<SessionContent> read_session_folder(const fs::path& folder) {
    SessionContent content;
    if (auto done = read_yaml(folder / "session.yaml",
                              [&](const YAML::Node& root) { read_setup(root, content.setup); });
        !done) {
        return done.error();
    }
    auto target = read_target_file(folder / "target.yaml");
    if (!target) {
        return target.error();
    }
    content.setup.target = std::move(*target);
    if (auto done = read_yaml(folder / "state.yaml",
                              [&](const YAML::Node& root) { read_state(root, content); });
        !done) {
        return done.error();
    }
    if (auto done = read_rig_if_any(folder / "expected.yaml", content.setup.expected); !done) {
        return done.error();
    }
    if (auto done = read_rig_if_any(folder / "rig.yaml", content.solved); !done) {
        return done.error();
    }
    if (auto done = read_shots(folder, content); !done) {
        return done.error();
    }
    return content;
}

}  // namespace kambara
