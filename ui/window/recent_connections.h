#pragma once

#include "connection_url.h"

#include <QList>
#include <QString>

class QSettings;

namespace lds::ui {

struct RecentConnection {
    ports::ConnectionUrl url;
    QString name; ///< Empty when the person gave none.
};

/// The connections made last, newest first, one for each sensor (sensor::isSameSensor).
class RecentConnections final {
public:
    explicit RecentConnections(QSettings& settings);

    QList<RecentConnection> list() const; ///< Entries that cannot be read are left out.
    void add(const RecentConnection& connection);

    static constexpr int most = 8;

private:
    QSettings& m_settings;
};

} // namespace lds::ui
