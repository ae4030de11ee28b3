#pragma once

#include "workspace.h"

#include <QObject>
#include <QPointer>

class QWidget;

namespace lds::ui {

/// Runs switches and commands for a person: asks first where something is lost, says why it cannot be
/// done now, and reports how it ended.
class CommandDesk final : public QObject {
    Q_OBJECT

public:
    CommandDesk(sensor::Workspace& workspace, QWidget* window);

    void run(sensor::SensorSession* session, catalog::ItemId item, catalog::Value value);

Q_SIGNALS:
    void started(const QString& text);
    void succeeded(const QString& text);
    void failed(lds::sensor::SensorSession* session, const QString& sentence);

private:
    void watch(sensor::SensorSession* session);
    void ask(sensor::SensorSession* session, catalog::ItemId item, catalog::Value value);
    void runNow(sensor::SensorSession* session, catalog::ItemId item, catalog::Value value);

    QWidget* m_window;
};

} // namespace lds::ui
