#pragma once

#include "workspace.h"

#include <QWidget>

class QListView;

namespace lds::ui {

class SensorListModel;
class WindowActions;

/// The sensors on the table. Its context menu acts on the current one.
class SensorsPanel final : public QWidget {
    Q_OBJECT

public:
    SensorsPanel(sensor::Workspace& workspace, const WindowActions& actions, QWidget* parent = nullptr);
    QSize sizeHint() const override { return {232, 400}; }

private:
    void showMenu(const QPoint& position);

    sensor::Workspace& m_workspace;
    const WindowActions& m_actions;
    SensorListModel* m_model;
    QListView* m_list;
};

} // namespace lds::ui
