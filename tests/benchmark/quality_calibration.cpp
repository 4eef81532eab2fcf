// SPDX-License-Identifier: GPL-3.0-or-later
// Fits the table in core/matching/match_quality.cpp to the first halves of real recordings, and
// shows on the second halves how far it can be trusted.
//   quality_calibration DATA_DIR [--csv SAMPLES.csv] [--report PAGE.html]
#include <algorithm>
#include <cstdio>
#include <cstring>
#include <exception>
#include <optional>
#include <string>
#include <utility>

#include "app/cli/compare_run.h"
#include "core/base/text_file.h"
#include "core/report/html_report.h"
#include "tests/benchmark/quality_study.h"

namespace kambara {
namespace {

using testing_support::MatchSample;
using testing_support::Reliability;

constexpr int searches_per_half = 800;

template <class... Values>
std::string written(const char* format, Values... values) {
    char text[256];
    std::snprintf(text, sizeof text, format, values...);
    return text;
}

const char* enumerator_of(Transform transform) {
    switch (transform) {
        case Transform::gaussian:
            return "gaussian";
        case Transform::rank3:
            return "rank3";
        case Transform::rank5:
            return "rank5";
        case Transform::census:
            return "census";
        case Transform::sdog:
            return "sdog";
        case Transform::gradient:
            return "gradient";
        case Transform::none:
            break;
    }
    return "none";
}

std::string label_of(const MatchMethod& method) {
    return to_string(method.measure) + " " + to_string(method.transform);
}

std::string row_of(const QualityModel& model) {
    return written("{{%.2f, %.2f, %.2f, %.2f}, %.3f}", model.weights[0], model.weights[1],
                   model.weights[2], model.weights[3], model.usual_rival);
}

// What to paste into match_quality.cpp.
void print_rows(const std::vector<MethodStudy>& studies) {
    bool same = true;
    const auto compare = [&same](const QualityModel& model, const QualityModel& compiled) {
        same =
            same && model.weights == compiled.weights && model.usual_rival == compiled.usual_rival;
    };
    for (const MethodStudy& study : studies) {
        std::printf("    {Measure::%s, Transform::%s, %s},\n",
                    to_string(study.method.measure).c_str(), enumerator_of(study.method.transform),
                    row_of(study.model).c_str());
        compare(study.model, quality_model(study.method));
    }
    const QualityModel pooled = pooled_model(studies);
    std::printf("constexpr QualityModel of_all_methods%s;\n", row_of(pooled).c_str());
    compare(pooled, quality_model({Measure::hamming, Transform::none}));  // which has none
    std::printf("%s\n\n", same ? "The library has these rows."
                               : "The library has OTHER rows: paste these in.");
}

std::vector<std::vector<std::string>> summary_rows(const std::vector<MethodStudy>& studies) {
    std::vector<std::vector<std::string>> rows;
    for (const MethodStudy& study : studies) {
        rows.push_back({label_of(study.method), written("%d", study.held_out.count),
                        written("%.1f", 100.0 * study.held_out.share_true),
                        written("%.3f", study.held_out.calibration_error),
                        written("%.3f", study.held_out.brier_score)});
        for (const double error : study.unseen_calibration) {
            rows.back().push_back(written("%.3f", error));
        }
    }
    return rows;
}

std::vector<std::string> summary_header(const std::vector<MethodStudy>& studies) {
    std::vector<std::string> header{"method", "matches", "right %", "calibration error", "Brier"};
    for (const RecordingSamples& recording : studies.front().recordings) {
        header.push_back("unseen " + recording.name);
    }
    return header;
}

std::vector<std::vector<std::string>> bin_rows(const Reliability& reliability) {
    std::vector<std::vector<std::string>> rows;
    for (std::size_t i = 0; i < reliability.bins.size(); ++i) {
        const auto& bin = reliability.bins[i];
        rows.push_back({written("%.1f to %.1f", 0.1 * static_cast<double>(i),
                                0.1 * static_cast<double>(i + 1)),
                        bin.count > 0 ? written("%.3f", bin.mean_probability) : "-",
                        bin.count > 0 ? written("%.3f", bin.share_true) : "-",
                        written("%d", bin.count)});
    }
    return rows;
}

std::vector<std::vector<std::string>> recording_rows(const MethodStudy& study) {
    std::vector<std::vector<std::string>> rows;
    for (const RecordingSamples& recording : study.recordings) {
        rows.push_back({recording.name});
        for (const auto* half : {&recording.fit, &recording.held_out}) {
            const auto right = std::count_if(
                half->begin(), half->end(), [](const MatchSample& sample) { return sample.right; });
            rows.back().push_back(written("%d", static_cast<int>(right)));
            rows.back().push_back(
                written("%d", static_cast<int>(half->size()) - static_cast<int>(right)));
        }
    }
    return rows;
}

const std::vector<std::string> bin_header{"quality", "mean", "right", "matches"};
const std::vector<std::string> recording_header{"recording", "fitted: right", "wrong",
                                                "shown: right", "wrong"};

void print_table(const std::vector<std::string>& header,
                 const std::vector<std::vector<std::string>>& rows) {
    const auto print = [](const std::vector<std::string>& cells) {
        for (std::size_t i = 0; i < cells.size(); ++i) {
            std::printf(i == 0 ? "%-18s" : " %17s", cells[i].c_str());
        }
        std::printf("\n");
    };
    print(header);
    for (const auto& row : rows) {
        print(row);
    }
    std::printf("\n");
}

std::string page_of(const std::vector<MethodStudy>& studies) {
    HtmlReport report("Calibrated match quality");
    report.paragraph(
        "A match of quality q should be right, within 2 px of the truth, with probability q. "
        "Fitted to the first half of each recording, shown on the second. The columns \"unseen\" "
        "give the calibration error on a recording by a model of the others alone.");
    report.table(summary_header(studies), summary_rows(studies));
    for (const MethodStudy& study : studies) {
        report.heading(label_of(study.method));
        std::vector<HtmlReport::Point> points;
        for (const auto& bin : study.held_out.bins) {
            if (bin.count > 0) {
                points.push_back({bin.mean_probability, bin.share_true,
                                  static_cast<double>(bin.count) / study.held_out.count});
            }
        }
        report.unit_square("Reliability", "mean quality", "share right", points);
        report.table(bin_header, bin_rows(study.held_out));
        report.table(recording_header, recording_rows(study));
    }
    return report.text();
}

std::string csv_of(const std::vector<MethodStudy>& studies) {
    std::string text = "measure,transform,recording,half,likeness,runner_up,quality,right\n";
    for (const MethodStudy& study : studies) {
        const std::string method =
            to_string(study.method.measure) + "," + to_string(study.method.transform) + ",";
        for (const RecordingSamples& recording : study.recordings) {
            for (const auto* half : {&recording.fit, &recording.held_out}) {
                for (const auto& [evidence, right] : *half) {
                    text += method + recording.name +
                            (half == &recording.fit ? ",first," : ",second,") +
                            written("%.5f,", evidence.likeness) +
                            (evidence.runner_up ? written("%.5f", *evidence.runner_up) : "") +
                            written(",%.4f,%d\n", match_probability(study.model, evidence),
                                    right ? 1 : 0);
                }
            }
        }
    }
    return text;
}

int fail(const Error& error) {
    std::fprintf(stderr, "%s\n%s\n", error.cause.c_str(), error.remedy.c_str());
    return 1;
}

int run(const std::string& data, const std::optional<std::string>& csv,
        const std::optional<std::string>& report) {
    const auto sets = testing_support::real_searches(data, searches_per_half);
    if (!sets) {
        return fail(sets.error());
    }
    std::vector<MethodStudy> studies;
    for (const MatchMethod& method : cli::all_methods()) {
        studies.push_back(study_of(method, *sets));
    }
    print_rows(studies);
    print_table(summary_header(studies), summary_rows(studies));
    for (const MethodStudy& study : studies) {
        std::printf("%s\n", label_of(study.method).c_str());
        print_table(bin_header, bin_rows(study.held_out));
        print_table(recording_header, recording_rows(study));
    }
    for (const auto& [file, text] : {std::pair(csv, &csv_of), std::pair(report, &page_of)}) {
        const auto done = file ? write_text_file_atomically(*file, text(studies)) : Done{};
        if (!done) {
            return fail(done.error());
        }
    }
    return 0;
}

}  // namespace
}  // namespace kambara

int main(int count, char** words) {
    std::optional<std::string> csv;
    std::optional<std::string> report;
    bool understood = count >= 2 && count % 2 == 0;
    for (int i = 2; understood && i < count; i += 2) {
        const bool is_csv = std::strcmp(words[i], "--csv") == 0;
        understood = is_csv || std::strcmp(words[i], "--report") == 0;
        (is_csv ? csv : report) = words[i + 1];
    }
    if (!understood) {
        std::fprintf(
            stderr,
            "usage: quality_calibration DATA_DIR [--csv SAMPLES.csv] [--report PAGE.html]\n");
        return 2;
    }
    try {
        return kambara::run(words[1], csv, report);
    } catch (const std::exception& fault) {
        std::fprintf(stderr, "%s\n", fault.what());
        return 1;
    }
}
