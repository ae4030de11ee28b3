#pragma once

#include "line_settings.h"
#include "modbus_responder.h"
#include "modbus_rtu_framing.h"
#include "server_faults.h"
#include "standing_faults.h"
#include "virtual_sensor.h"

#include <functional>
#include <optional>
#include <QHash>
#include <QObject>

namespace lds::emulator {

/// A virtual sensor on an RS-485 line: hears the requests to its Device Address at its own speed and parity,
/// as they were at the last communication reset or power cycle (§6.2), and answers them. While an answer of
/// its own is outstanding it hears nothing else.
class RtuUnit final : public QObject, public FaultyServer {
    Q_OBJECT

public:
    /// An answer on its way to the line.
    struct Answer {
        QByteArray frame;
        LineSettings settings;
        qint64 startNs = 0; ///< Of its first character.
    };

    explicit RtuUnit(VirtualSensor& sensor);

    quint8 address() const { return m_address; } ///< It hears this one.
    LineSettings settings() const { return m_settings; }
    /// From the end of a request, the silence included, to the answer.
    void setAnsweringTime(int milliseconds) { m_answeringMs = milliseconds; }
    int answeringTime() const { return m_answeringMs; }
    ModbusResponder& responder() { return m_responder; }
    /// Runs before each request is carried out.
    void setBefore(std::function<void()> before) { m_before = std::move(before); }

    /// A frame that was complete at `completeNs`; now it is `nowNs`. Nothing when it does not answer.
    std::optional<Answer> hear(const modbus::RtuFrame& frame, LineSettings settings, qint64 completeNs,
                               qint64 nowNs);
    void answerGone(); ///< The answer is over, or will never be.

    // Faults on purpose, and counts.
    void setStandingFaults(const StandingFaults& faults) override;
    /// Spoils the answers to the next `times` requests of that kind.
    void injectFault(Fault fault, FaultOn on = FaultOn::AnyRequest, int times = 1);
    int requestCount(quint8 functionCode) const { return m_requestCounts.value(functionCode); }
    int totalRequestCount() const; ///< Those it heard and took.

Q_SIGNALS:
    void fellSilent(); ///< In the middle of its answer, if there was one.

private:
    bool takes(const modbus::RtuFrame& frame, LineSettings settings) const;
    void takeOverSettings();

    VirtualSensor& m_sensor;
    ModbusResponder m_responder;
    quint8 m_address = 0;
    LineSettings m_settings;
    int m_answeringMs = 0;
    bool m_answering = false; ///< From the request on until the answer is over.
    std::function<void()> m_before;
    StandingFaults m_standing;
    ServerFaults m_faults;
    QHash<quint8, int> m_requestCounts;
};

} // namespace lds::emulator
