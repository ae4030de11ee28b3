#pragma once

#include "sensor_station.h"

#include <functional>
#include <QObject>
#include <QThread>

namespace lds::emulator {

/// A virtual sensor in a thread of its own, reached by Modbus TCP at a free port of 127.0.0.1: for the
/// desktop program's demo and for tests of whole flows.
///
///     DemoSensor demo(catalog::SensorModel::HlG205);
///     connect(&demo, &DemoSensor::ready, …, [](quint16 port) { connect to modbus-tcp://127.0.0.1:<port> });
///     demo.start();
///     demo.post([](SensorStation& station) { station.sensor().setInMenu(true); });
class DemoSensor : public QObject {
    Q_OBJECT

public:
    explicit DemoSensor(catalog::SensorModel model, QObject* parent = nullptr);
    ~DemoSensor() override; ///< Ends the sensor and waits for its thread.

    void start();
    catalog::SensorModel model() const { return m_options.model; }
    quint16 port() const { return m_port; }               ///< 0 until ready().
    const StationState& state() const { return m_state; } ///< As stateChanged() told last; no faults: never.

    /// A file, or an example's key; empty = the workpiece that moves gently. stateChanged() follows, or
    /// sceneRefused() and everything stays as it is.
    void loadScene(const QString& pathOrExample);

    /// Runs `work` with the sensor, in the sensor's thread, later and in order. Captures go by value.
    /// Before ready() and after a failure it is dropped.
    void post(std::function<void(SensorStation&)> work);

    /// The same, waiting for the answer: for tests, which may block. Only after ready().
    template <typename Work>
    auto ask(Work work) -> std::invoke_result_t<Work, SensorStation&>
    {
        std::invoke_result_t<Work, SensorStation&> answer{};
        runAndWait([&answer, &work](SensorStation& station) { answer = work(station); });
        return answer;
    }
    /// Waits until `work` is done: for tests.
    void runAndWait(const std::function<void(SensorStation&)>& work);

Q_SIGNALS:
    void ready(quint16 port);
    void failed(const QString& reason);
    /// What a person can change there, as it is now: at the start and, a little later, after each change.
    void stateChanged(const lds::emulator::StationState& state);
    void sceneRefused(const QString& reason); ///< Names file and field.

private:
    struct Inside; ///< What lives in the thread.
    void watch(Inside* inside);
    void take(const StationState& state);

    StationOptions m_options;
    QThread m_thread;
    Inside* m_inside = nullptr;
    quint16 m_port = 0;
    StationState m_state;
};

} // namespace lds::emulator
