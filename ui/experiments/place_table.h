// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <QTableWidget>
#include <optional>
#include <vector>

namespace kambara::ui {

/// Known places, typed or read, and beside each what was measured there. The first columns are for
/// the operator; what is no number there is marked.
class PlaceTable : public QTableWidget {
    Q_OBJECT
  public:
    /// A place's numbers as they are shown; lengths in mm.
    struct Difference {
        Eigen::Vector3d off_mm;  ///< estimate less truth
        double range_pct = 0.0;
    };

    explicit PlaceTable(QWidget* parent = nullptr);

    int add_place(const std::optional<Eigen::Vector3d>& known_mm = {});
    void remove_chosen();
    void remove_all();
    std::optional<Eigen::Vector3d> known_mm(int row) const;
    const std::vector<Eigen::Vector3d>& readings(int row) const;
    void set_readings(int row, std::vector<Eigen::Vector3d> readings_in_left_mm);
    /// What is left between both, where the frame of the known place is known.
    void show_difference(int row, const std::optional<Difference>& difference);
    int measured() const;  ///< rows
    /// Rows that were typed, if only in part, and have no readings.
    int typed_only() const;
    /// The first row after `row`, and then from the top, that has no readings; -1 where all have.
    int next_to_measure(int row) const;

  signals:
    void known_changed();
    /// Into a coordinate; `wrong` where that is no number, else empty.
    void typed(const QString& wrong);

  protected:
    void keyPressEvent(QKeyEvent* event) override;

  private:
    void mark(QTableWidgetItem* item);
    void set_cell(int row, int column, const QString& text);

    std::vector<std::vector<Eigen::Vector3d>> readings_;
    bool filling_ = false;
};

}  // namespace kambara::ui
