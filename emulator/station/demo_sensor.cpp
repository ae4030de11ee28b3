#include "demo_sensor.h"

#include "system_clock.h"

namespace lds::emulator {

/// Everything the thread owns. Deleted there, after the event loop has ended.
struct DemoSensor::Inside : QObject {
    SystemClock clock;
    std::unique_ptr<SensorStation> station;
};

DemoSensor::DemoSensor(catalog::SensorModel model, QObject* parent)
    : QObject(parent)
{
    m_options.model = model;
    m_options.modbusPort = 0;
    m_thread.setObjectName(QStringLiteral("virtual sensor"));
}

DemoSensor::~DemoSensor()
{
    m_thread.quit();
    m_thread.wait();
}

void DemoSensor::start()
{
    if (m_inside)
        return;
    m_inside = new Inside;
    m_inside->clock.setParent(nullptr);
    m_inside->moveToThread(&m_thread);
    m_inside->clock.moveToThread(&m_thread);
    connect(&m_thread, &QThread::finished, m_inside, &QObject::deleteLater);
    m_thread.start();
    QMetaObject::invokeMethod(m_inside, [this, inside = m_inside, options = m_options] {
        auto station = SensorStation::start(options, inside->clock);
        if (!station) {
            QMetaObject::invokeMethod(this,
                                      [this, reason = station.error().message] { Q_EMIT failed(reason); });
            return;
        }
        inside->station = std::move(*station);
        QMetaObject::invokeMethod(this, [this, port = inside->station->modbusPort().value_or(0)] {
            m_port = port;
            Q_EMIT ready(port);
        });
    });
}

void DemoSensor::post(std::function<void(SensorStation&)> work)
{
    if (!m_inside)
        return;
    QMetaObject::invokeMethod(m_inside, [inside = m_inside, run = std::move(work)] {
        if (inside->station)
            run(*inside->station);
    });
}

void DemoSensor::runAndWait(const std::function<void(SensorStation&)>& work)
{
    Q_ASSERT(m_inside);
    QMetaObject::invokeMethod(
        m_inside,
        [inside = m_inside, &work] {
            if (inside->station)
                work(*inside->station);
        },
        Qt::BlockingQueuedConnection);
}

} // namespace lds::emulator
