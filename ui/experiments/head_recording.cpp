// SPDX-License-Identifier: GPL-3.0-or-later
// How the head's window comes by its views: from the live pictures, or from a record.
#include <QTableWidget>

#include "core/camera/rig_file.h"
#include "ui/base/core_text.h"
#include "ui/experiments/background.h"
#include "ui/experiments/head_window.h"

namespace kambara::ui {

void HeadWindow::record(const SnapshotPtr& snapshot, const HeadApproach& approach) {
    const auto shown = target();
    if (!shown) {
        stop();
        return;
    }
    if (recorded_.empty()) {
        recorded_by_ = rig_;
    } else if (rig_to_text(recorded_by_) != rig_to_text(rig_)) {
        stop();
        say_failure(tr("The views so far were recorded with another rig. Clear them first."));
        return;
    }
    HeadRecorded recorded;
    recorded.encoder = snapshot->head->angles;
    recorded.approach = approach;
    recorded.pictures = {snapshot->pictures.stereo.left.picture,
                         snapshot->pictures.stereo.right.picture,
                         snapshot->pictures.pan_tilt.picture};
    background_->run(
        [rig = rig_, shown = *shown, recorded] {
            HeadRecorded done = recorded;
            auto view = head_view_from(rig, shown, done.pictures, done.encoder, done.approach);
            if (view) {
                done.view = std::move(*view);
            } else {
                done.reason = view.error().cause;
            }
            return done;
        },
        [this, run = run_](const HeadRecorded& done) {
            add(done);
            if (run != run_ || doing_ != Doing::going) {
                return;
            }
            sequence_.next();
            if (!sequence_.going()) {
                stop();
                solve();
            }
        });
}

void HeadWindow::add(const HeadRecorded& recorded) {
    recorded_.push_back(recorded);
    record_saved_ = false;
    clear_result();
    table_->insertRow(table_->rowCount());
    fill_row(table_->rowCount() - 1);
    table_->scrollToBottom();
    changed();
}

void HeadWindow::load(const QString& file) {
    const auto shown = target();
    if (!shown) {
        return;
    }
    if (!rig_.right || !rig_.pan_tilt) {
        say_failure(
            tr("The rig in use does not hold all three cameras: open the source with the "
               "rig file that belongs to the record."));
        return;
    }
    if (!recorded_.empty() && rig_to_text(recorded_by_) != rig_to_text(rig_)) {
        say_failure(tr("The views so far were recorded with another rig. Clear them first."));
        return;
    }
    say(tr("Looking for the target in the record's pictures\u2026"));
    background_->run([read = ports_.read_head_record, path = file.toStdString(), rig = rig_,
                      shown = *shown] { return read(path, rig, shown); },
                     [this, rig = rig_](const Result<HeadRecordRead>& record) {
                         if (!record) {
                             say_failure(record.error());
                             return;
                         }
                         const bool were_saved = recorded_.empty() || record_saved_;
                         if (recorded_.empty()) {
                             recorded_by_ = rig;
                         }
                         for (const HeadView& view : record->views) {
                             HeadRecorded read;
                             read.encoder = view.encoder;
                             read.approach = view.approach;
                             read.view = view;
                             add(read);
                         }
                         record_saved_ = were_saved;  // what was read is on disk
                         QString text = tr("Views read: %1.").arg(record->views.size());
                         if (!record->rejected.empty()) {
                             text +=
                                 QLatin1Char(' ') + tr("Of no use: %1 rows; the first: %2")
                                                        .arg(record->rejected.size())
                                                        .arg(translated(record->rejected.front()));
                         }
                         say(text);
                         changed();
                     });
}

}  // namespace kambara::ui
