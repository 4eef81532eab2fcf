// SPDX-License-Identifier: GPL-3.0-or-later
// Sets of views with something wrong: none may pass unsaid; and sets with nothing wrong: they pass.
// One set of each kind; the slow ones fifty, and four times as many good ones.
#include <gtest/gtest.h>

#include <algorithm>
#include <functional>

#include "tests/core/calibration/rig_samples.h"

namespace kambara {
namespace {

using testing_support::options_for;
using testing_support::Showing;
using testing_support::views_of;

constexpr double noise_px = 0.08;

class Adversarial : public testing::Test {
  protected:
    explicit Adversarial(int sets) : sets_(sets) {}

    void good_sets_pass();
    void mirrored_pictures();
    void both_sides_mirrored_chessboards();
    void shuffled_pictures();
    void one_mismatched_pair();
    void one_picture_repeated();
    void one_pair_twice();
    void narrow_depth();
    void wrong_size_of_the_boxes();
    void only_the_gaps_are_wrong();
    void blurred_pictures();
    void two_targets();

  private:
    // One good set: boxes before the nominal rig, a baseline by tape.
    std::vector<RigView> good(unsigned seed, Showing how = {}) {
        random_.seed(seed);
        how.views = 14;
        how.noise_px = noise_px;
        how.pan_tilt = false;
        return views_of(rig_, target_, how, random_);
    }

    CalibrationReport calibrated(const std::vector<RigView>& views) {
        RigCalibratorOptions options = options_for(rig_, false);
        options.baseline = KnownBaseline{450.0, 0.5};
        return calibrate_rig(views, target_, options);
    }

    // Spoils sets and expects each to be refused or warned of with one of the given words.
    void expect_said(const std::vector<std::string>& words,
                     const std::function<void(std::vector<RigView>&)>& spoil,
                     const Showing& how = {}) {
        int wrong = 0;
        int refused = 0;
        for (int i = 0; i < sets_; ++i) {
            const Target shown = target_;
            auto views = good(1000U + static_cast<unsigned>(i), how);
            spoil(views);  // the target, too, perhaps
            const auto report = calibrated(views);
            target_ = shown;
            refused += report.verdict == Verdict::refused ? 1 : 0;
            std::string all;
            for (const std::string& reason : report.reasons) {
                all += reason + "\n";
            }
            const bool said = std::any_of(words.begin(), words.end(), [&](const auto& word) {
                return all.find(word) != std::string::npos;
            });
            const bool passed = report.verdict == Verdict::good || !said;
            wrong += passed ? 1 : 0;
            EXPECT_FALSE(passed) << "set " << i << ": " << to_string(report.verdict) << " " << all;
        }
        std::printf("%d of %d refused, %d warned of, %d wrong\n", refused, sets_,
                    sets_ - refused - wrong, wrong);
    }

    const int sets_;  // of each kind
    const Rig rig_ = nominal_rig();
    Target target_ = two_plane_24();
    std::mt19937 random_;
};

void mirror(RigView& view, std::size_t camera) {
    for (DetectedCorner& corner : view.sights[camera].corners) {
        corner.px.x() = 639.0 - corner.px.x();
    }
}

void Adversarial::good_sets_pass() {
    const int sets = 4 * sets_;
    int accepted = 0;
    int without_a_word = 0;
    for (int i = 0; i < sets; ++i) {
        const auto report = calibrated(good(5000U + static_cast<unsigned>(i)));
        accepted += report.verdict != Verdict::refused ? 1 : 0;
        without_a_word += report.verdict == Verdict::good ? 1 : 0;
        if (report.verdict != Verdict::good) {
            std::printf("set %d: %s\n", i, report.reasons.at(0).c_str());
        }
    }
    std::printf("%d of %d accepted, %d good\n", accepted, sets, without_a_word);
    EXPECT_GE(accepted, 0.95 * sets);
    EXPECT_GE(without_a_word, 0.85 * sets);
}

void Adversarial::mirrored_pictures() {
    expect_said({"mirrored"}, [](auto& views) {
        for (RigView& view : views) {
            mirror(view, 0);
        }
    });
}

void Adversarial::both_sides_mirrored_chessboards() {
    // The corners of a mirrored chessboard are found in an order that looks right.
    target_ = ChessboardTarget{9, 6, 40.0};
    Showing how;
    how.nearest_mm = 550.0;
    how.farthest_mm = 1200.0;
    how.turn_deg = 30.0;
    how.across = 0.2;
    expect_said(
        {"exchanged", "mirrored"},
        [](auto& views) {
            for (RigView& view : views) {
                for (const std::size_t camera : {std::size_t{0}, std::size_t{1}}) {
                    mirror(view, camera);
                    // Rows from the other end: the mirrored board read left to right.
                    DetectedCorners& corners = view.sights[camera].corners;
                    for (DetectedCorner& corner : corners) {
                        corner.id = corner.id / 9 * 9 + 8 - corner.id % 9;
                    }
                    std::sort(corners.begin(), corners.end(),
                              [](const auto& a, const auto& b) { return a.id < b.id; });
                }
            }
        },
        how);
}

void Adversarial::shuffled_pictures() {
    expect_said({"do not belong together", "fit each other"}, [this](auto& views) {
        std::vector<CameraSight> right;
        for (const RigView& view : views) {
            right.push_back(view.sights[1]);
        }
        std::rotate(right.begin(), right.begin() + 1 + random_() % (right.size() - 1), right.end());
        for (std::size_t i = 0; i < views.size(); ++i) {
            views[i].sights[1] = right[i];
        }
    });
}

void Adversarial::one_mismatched_pair() {
    expect_said({"not fit the others"}, [](auto& views) {
        std::swap(views[2].sights[1], views[9].sights[1]);
        views.pop_back();
    });
}

void Adversarial::one_picture_repeated() {
    expect_said({"Only 1 views", "repeat"}, [](auto& views) {
        const RigView first = views[0];
        std::fill(views.begin(), views.end(), first);
    });
}

void Adversarial::one_pair_twice() {
    expect_said({"repeats a picture"}, [](auto& views) { views[5] = views[1]; });
}

void Adversarial::narrow_depth() {
    // A flat board straight ahead, always as far away.
    target_ = ChessboardTarget{9, 6, 40.0};
    Showing how;
    how.nearest_mm = 1000.0;
    how.farthest_mm = 1030.0;
    how.turn_deg = 4.0;
    expect_said(
        {"depth is narrow"}, [](auto&) {}, how);
}

void Adversarial::wrong_size_of_the_boxes() {
    expect_said({"deviations from the measured"}, [this](auto&) {
        BoxTarget larger = two_plane_24();
        larger.box_width_mm *= 1.02;
        larger.box_height_mm *= 1.02;
        larger.pitch_across_mm *= 1.02;
        larger.pitch_down_mm *= 1.02;
        larger.planes[0].gap_after_mm *= 1.02;
        larger.planes[1].gap_before_mm *= 1.02;
        target_ = larger;
    });
}

void Adversarial::only_the_gaps_are_wrong() {
    expect_said({"hang together over the target"}, [this](auto&) {
        BoxTarget other = two_plane_24();
        other.planes[0].gap_after_mm = 20.0;
        target_ = other;
    });
}

void Adversarial::blurred_pictures() {
    expect_said({"blur", "Blur"}, [this](auto& views) {
        std::normal_distribution<double> noise(0.0, 0.12);
        for (RigView& view : views) {
            for (CameraSight& sight : view.sights) {
                for (DetectedCorner& corner : sight.corners) {
                    corner.px += Eigen::Vector2d(noise(random_), noise(random_));
                    corner.sigma_px = 0.15;
                    corner.blur_px = 7.0;
                }
            }
        }
    });
}

// In some pictures another target of the same kind is found, which lies elsewhere.
void Adversarial::two_targets() {
    expect_said({"not fit", "do not belong together"}, [this](auto& views) {
        Showing how;
        how.views = static_cast<int>(views.size());
        how.noise_px = noise_px;
        how.pan_tilt = false;
        const auto others = views_of(rig_, target_, how, random_);
        for (std::size_t i = 0; i < views.size(); i += 4) {
            views[i].sights[1] = others[i].sights[1];
        }
    });
}

class AdversarialTest : public Adversarial {
  protected:
    AdversarialTest() : Adversarial(1) {}
};

class AdversarialSlow : public Adversarial {
  protected:
    AdversarialSlow() : Adversarial(50) {}
};

TEST_F(AdversarialTest, GoodSetsPass) {
    good_sets_pass();
}
TEST_F(AdversarialTest, MirroredPictures) {
    mirrored_pictures();
}
TEST_F(AdversarialTest, BothSidesMirroredChessboards) {
    both_sides_mirrored_chessboards();
}
TEST_F(AdversarialTest, ShuffledPictures) {
    shuffled_pictures();
}
TEST_F(AdversarialTest, OneMismatchedPair) {
    one_mismatched_pair();
}
TEST_F(AdversarialTest, OnePictureRepeated) {
    one_picture_repeated();
}
TEST_F(AdversarialTest, OnePairTwice) {
    one_pair_twice();
}
TEST_F(AdversarialTest, NarrowDepth) {
    narrow_depth();
}
TEST_F(AdversarialTest, WrongSizeOfTheBoxes) {
    wrong_size_of_the_boxes();
}
TEST_F(AdversarialTest, OnlyTheGapsAreWrong) {
    only_the_gaps_are_wrong();
}
TEST_F(AdversarialTest, BlurredPictures) {
    blurred_pictures();
}
TEST_F(AdversarialTest, TwoTargets) {
    two_targets();
}

TEST_F(AdversarialSlow, GoodSetsPass) {
    good_sets_pass();
}
TEST_F(AdversarialSlow, MirroredPictures) {
    mirrored_pictures();
}
TEST_F(AdversarialSlow, BothSidesMirroredChessboards) {
    both_sides_mirrored_chessboards();
}
TEST_F(AdversarialSlow, ShuffledPictures) {
    shuffled_pictures();
}
TEST_F(AdversarialSlow, OneMismatchedPair) {
    one_mismatched_pair();
}
TEST_F(AdversarialSlow, OnePictureRepeated) {
    one_picture_repeated();
}
TEST_F(AdversarialSlow, OnePairTwice) {
    one_pair_twice();
}
TEST_F(AdversarialSlow, NarrowDepth) {
    narrow_depth();
}
TEST_F(AdversarialSlow, WrongSizeOfTheBoxes) {
    wrong_size_of_the_boxes();
}
TEST_F(AdversarialSlow, OnlyTheGapsAreWrong) {
    only_the_gaps_are_wrong();
}
TEST_F(AdversarialSlow, BlurredPictures) {
    blurred_pictures();
}
TEST_F(AdversarialSlow, TwoTargets) {
    two_targets();
}

}  // namespace
}  // namespace kambara
