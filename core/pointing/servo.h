// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>

#include "core/base/angles.h"

namespace kambara {

/// Makes one aim of two: the stereo pair's, which is led and free of the head's own motion but as
/// wrong as the head's mount is known, and the pan-tilt camera's own picture of the target, which
/// is right but late. The difference of the two is what is wrong with the mount; it changes slowly,
/// so that it is a mean over time and no loop can swing. Where the pair does not see the target,
/// what the picture said goes on by itself (an alpha-beta filter: Kalata, The tracking index, IEEE
/// Trans. AES 20, 1984). Angles are those that put the target onto the optical axis. Times in ns on
/// the pictures' clock. Used by one thread at a time.
class ServoAim {
  public:
    struct Options {
        double settle_s = 0.25;  ///< of the mean of the difference
        /// Where they differ by more, they do not speak of the same target.
        double widest_rad = rad_from_deg(5.0);
        double alpha = 0.6;
        double beta = 0.2;
        double gap_s = 0.5;  ///< after so long without the picture, its motion begins anew
    };

    ServoAim() : ServoAim(Options{}) {}
    explicit ServoAim(const Options& options) : options_(options) {}

    /// What the pan-tilt camera's picture says.
    void see(const HeadAngles& seen, std::int64_t time_ns);
    /// What both say of one instant; false where that is not the same target, and nothing is taken.
    bool compare(const HeadAngles& by_stereo, const HeadAngles& seen, std::int64_t time_ns);
    void forget();

    /// What is to be added to the stereo pair's angles; empty before the first comparison.
    const std::optional<HeadAngles>& correction() const { return correction_; }
    /// By the picture alone at a time at or after the last one, led by a tenth of a second at most,
    /// with the rate; empty before the first.
    struct Alone {
        HeadAngles angles;
        HeadAngles rate_rad_s;
    };
    std::optional<Alone> alone(std::int64_t time_ns) const;

  private:
    const Options options_;
    std::optional<HeadAngles> correction_;
    std::int64_t compared_ns_ = 0;
    std::optional<HeadAngles> seen_;
    HeadAngles rate_rad_s_;
    std::int64_t seen_ns_ = 0;
};

}  // namespace kambara
