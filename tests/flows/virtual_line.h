#pragma once

#include "rtu_port.h"
#include "sensor_station.h"
#include "system_clock.h"

#include <memory>
#include <QTemporaryDir>
#include <QThread>
#include <vector>

namespace lds::flows {

/// Virtual sensors on an RS-485 line behind a pseudo-terminal, in a thread of their own.
class VirtualLine {
public:
    /// A sensor for each Device Address, in this order; two of one address are two sensors.
    explicit VirtualLine(const QList<quint8>& units)
    {
        m_thread.start();
        m_context.moveToThread(&m_thread);
        onLine([this, units] { build(units); });
    }
    ~VirtualLine()
    {
        onLine([this] {
            m_stations.clear();
            m_port.reset();
            m_clock.reset();
        });
        m_thread.quit();
        m_thread.wait();
    }
    VirtualLine(const VirtualLine&) = delete;
    VirtualLine& operator=(const VirtualLine&) = delete;

    QString port() const { return m_folder.filePath(QStringLiteral("line")); }

    /// Asks the sensor at that place of the list, in its thread.
    template <typename Work>
    auto ask(std::size_t index, Work work) -> std::invoke_result_t<Work, emulator::SensorStation&>
    {
        std::invoke_result_t<Work, emulator::SensorStation&> answer{};
        onLine([&] { answer = work(*m_stations.at(index)); });
        return answer;
    }

    /// The adapter is pulled out: the port is gone, and whoever has it open is told so. The sensors go on.
    void unplug()
    {
        onLine([this] { m_port.reset(); });
    }
    /// The adapter is back under its name, with the same sensors on its line.
    void plugIn()
    {
        onLine([this] {
            openPort();
            for (const auto& station : m_stations)
                m_port->line().attach(station->rtuUnit());
        });
    }

private:
    void openPort()
    {
        auto opened = emulator::RtuPort::open(port(), *m_clock);
        if (!opened)
            qFatal("no line: %s", qPrintable(opened.error()));
        m_port = std::move(*opened);
    }
    void build(const QList<quint8>& units)
    {
        m_clock = std::make_unique<emulator::SystemClock>();
        openPort();
        for (const quint8 unit : units) {
            emulator::StationOptions options;
            options.unit = unit;
            auto station = emulator::SensorStation::start(options, *m_clock);
            if (!station)
                qFatal("no sensor: %s", qPrintable(station.error().message));
            m_port->line().attach((*station)->rtuUnit());
            m_stations.push_back(std::move(*station));
        }
    }
    template <typename Work>
    void onLine(Work work)
    {
        QMetaObject::invokeMethod(&m_context, work, Qt::BlockingQueuedConnection);
    }

    QTemporaryDir m_folder;
    QThread m_thread;
    QObject m_context;
    std::unique_ptr<emulator::SystemClock> m_clock;
    std::unique_ptr<emulator::RtuPort> m_port;
    std::vector<std::unique_ptr<emulator::SensorStation>> m_stations;
};

} // namespace lds::flows
