#pragma once

#include "sensor_session.h"

#include <QDialog>
#include <QPointer>

class QFrame;
class QLabel;
class QProgressBar;
class QPushButton;
class QTableView;
class QVBoxLayout;

namespace lds::ui {

class ReviewTableModel;

/// Old and new of every pending edit before anything is written; then the writing, with progress; then,
/// if something did not go as wanted, what and why, with the rest still here to apply again.
class ReviewDialog final : public QDialog {
    Q_OBJECT

public:
    explicit ReviewDialog(sensor::SensorSession& session, QWidget* parent = nullptr);
    QSize sizeHint() const override { return {760, 480}; }

    void done(int result) override; ///< Not while writing: a person stops that first.

Q_SIGNALS:
    void jumpRequested(lds::catalog::ItemId item);
    void applied(const QString& message); ///< Everything was written; the dialog has closed.

private:
    QWidget* buildTable();
    void buildButtons(QVBoxLayout* column);
    void refresh();
    void showProblems();
    void addProblem(const QString& sentence, catalog::ItemId jumpTo);
    void addConflicts();
    void showOrder();
    void start();
    void progress(int done, int total);
    void finished(const sensor::ApplyReport& report);
    void setApplying(bool applying);

    QPointer<sensor::SensorSession> m_session;
    ReviewTableModel* m_model;
    QTableView* m_table = nullptr;
    QLabel* m_title;
    QLabel* m_summary;
    QWidget* m_problems;
    QLabel* m_why; ///< Why nothing can be written now.
    QLabel* m_order;
    QProgressBar* m_progress;
    QLabel* m_progressText;
    QPushButton* m_apply = nullptr;
    QPushButton* m_stop = nullptr;
    QPushButton* m_close = nullptr;
};

} // namespace lds::ui
