#pragma once

#include "banner_area.h"
#include "sensor_session.h"

#include <QPointer>

namespace lds::ui {

/// Keeps the lines above the pages in step with one sensor: what is the matter and what can be done.
class SessionNotices final : public QObject {
    Q_OBJECT

public:
    explicit SessionNotices(BannerArea& area);
    void setSession(sensor::SensorSession* session);
    /// A command or an apply that failed: stays until closed or until something succeeds.
    void showFailure(const QString& sentence);
    void hideFailure();
    void showInformation(const QString& text); ///< What the person did not ask for but should know.

Q_SIGNALS:
    void laserOnRequested();
    void typeRequested();
    void reviewRequested();
    void itemRequested(lds::catalog::ItemId item);

private:
    void showConnection();
    void showReadiness();
    void showLaser();
    void showModel();
    void showConflicts();
    void showExternal(const QList<sensor::ExternalChange>& changes);

    BannerArea& m_area;
    QPointer<sensor::SensorSession> m_session;
};

/// True when the beam is off, by what is measured or else by the setting.
bool isLaserStopped(const sensor::SensorSession& session);

} // namespace lds::ui
