#pragma once

#include "control_language.h"
#include "sensor_station.h"

#include <QByteArray>
#include <QJsonObject>
#include <QList>

namespace lds::app {

/// Carries control lines out on running stations and answers each with one line of JSON:
/// {"ok":true, …the sensor's state…} or {"ok":false,"error":"…"}. The stations must outlive it.
class ControlDesk {
public:
    static constexpr int longestLine = 4096; ///< Bytes.

    explicit ControlDesk(QList<emulator::SensorStation*> stations);

    /// `line` without its end, anything at all; the answer ends with a newline.
    QByteArray answer(const QByteArray& line);
    static QByteArray answerToOverlongLine();

private:
    using Done = tl::expected<QJsonObject, QString>;

    Done carryOut(const QByteArray& line);
    tl::expected<int, QString> indexOf(const ControlCommand& command) const;
    QJsonObject describe(int index);

    const QList<emulator::SensorStation*> m_stations;
};

} // namespace lds::app
